//! What an executor makes of programs against what charts must do: cases against what stands beside them, random charts
//! against the simulator.

use crate::charts::{Case, check, spell, stimuli};
use crate::compare::{first_difference, report};
use crate::executors::jobs::Job;
use crate::random::Drawn;
use crate::runs::simulate;
use grafc_logic::scan::Program;
use grafc_model::chart::Chart;
use grafc_model::reaction::{Profile, Response};

/// Programs with what must come of them.
#[derive(Default)]
pub struct Agreement<'c> {
    jobs: Vec<Job>,
    truths: Vec<Truth<'c>>,
    faults: Vec<String>,
}

enum Truth<'c> {
    /// A case in one way, by its name.
    Case(String, &'c Case, Chart),
    /// A random chart that evolves so.
    Drawn(Drawn, Profile),
}

impl<'c> Agreement<'c> {
    /// A case in one way, which makes a program of its chart.
    pub fn case(&mut self, case: &'c Case, way: &str, compile: impl FnOnce(&Chart) -> Result<Program, String>) {
        let name = format!("{}, {way}", case.name);
        let prepared = check(&case.name, &case.text).and_then(|chart| {
            let stimuli = stimuli(&case.name, &case.trace, &chart)?;
            let program = compile(&chart)?;
            Ok((chart, Job { program, stimuli }))
        });
        match prepared {
            Err(fault) => self.faults.push(format!("{name}:\n{fault}")),
            Ok((chart, job)) => {
                self.jobs.push(job);
                self.truths.push(Truth::Case(name, case, chart));
            }
        }
    }

    /// A random chart, with its program and its trace.
    pub fn drawn(&mut self, drawn: Drawn, profile: Profile, job: Job) {
        self.jobs.push(job);
        self.truths.push(Truth::Drawn(drawn, profile));
    }

    /// How many programs there are.
    pub fn count(&self) -> usize {
        self.jobs.len()
    }

    /// Leaves out what is not for the executor.
    pub fn retain(&mut self, keep: impl Fn(&Job) -> bool) {
        let (jobs, truths) = (std::mem::take(&mut self.jobs), std::mem::take(&mut self.truths));
        let kept = jobs.into_iter().zip(truths).filter(|(job, _)| keep(job));
        (self.jobs, self.truths) = kept.unzip();
    }

    /// Runs all programs, so many at once.
    ///
    /// # Panics
    /// Some do what they must not, with all of these.
    pub fn hold(mut self, batch: usize, run: impl Fn(&[Job]) -> Vec<Result<Vec<Response>, String>>) {
        for (jobs, truths) in self.jobs.chunks(batch).zip(self.truths.chunks(batch)) {
            for ((job, truth), result) in jobs.iter().zip(truths).zip(run(jobs)) {
                self.faults.extend(truth.fault(job, result));
            }
        }
        let (wrong, count) = (self.faults.len(), self.jobs.len());
        assert!(self.faults.is_empty(), "{wrong} of {count} fail\n{}", self.faults.join("\n"));
    }
}

impl Truth<'_> {
    /// What is wrong with a run.
    fn fault(&self, job: &Job, result: Result<Vec<Response>, String>) -> Option<String> {
        match (self, result) {
            (Truth::Case(name, ..), Err(fault)) => Some(format!("{name}:\n{fault}")),
            (Truth::Case(name, case, chart), Ok(responses)) => {
                let actual = spell(chart, &job.stimuli, &responses);
                (actual != case.expected).then(|| format!("{name}:\nexpected\n{}actual\n{actual}", case.expected))
            }
            (Truth::Drawn(drawn, _), Err(fault)) => Some(format!("seed {}: {fault}\n{}", drawn.seed, drawn.text)),
            (Truth::Drawn(drawn, profile), Ok(actual)) => {
                let expected = simulate(&drawn.chart, *profile, &job.stimuli);
                first_difference(&expected, &actual).map(|_| {
                    let report = report(&drawn.chart, *profile, &job.stimuli, &expected, &actual);
                    format!("seed {}\n{}\n{report}", drawn.seed, drawn.text)
                })
            }
        }
    }
}
