//! What an executor makes of programs against what charts must do: cases against what stands beside them, random charts
//! against the simulator.

use crate::charts::{Case, cases, charts_folder, check, spell, stimuli};
use crate::compare::{first_difference, report};
use crate::executors::jobs::Job;
use crate::random::{ChartKind, Drawn, checked, profile, trace};
use crate::runs::{compile_saved, simulate};
use crate::share::share;
use crate::ways::exact;
use grafc_logic::scan::Program;
use grafc_logic::scan::evaluate::Evaluator;
use grafc_logic::{Encoding, Options};
use grafc_model::chart::Chart;
use grafc_model::reaction::{Evolution, Profile, Response};
use std::ops::Range;

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

    /// Cases, each in so many of the ways that must agree: a compiler takes a while for each program, so the ways take turns.
    pub fn cases(
        &mut self,
        cases: &'c [Case],
        ways: usize,
        compile: impl Fn(&Chart, &Options) -> Result<Program, String>,
    ) {
        for (turn, case) in cases.iter().enumerate() {
            let all = case.ways();
            let count = all.len();
            for (way, options) in all.into_iter().cycle().skip(turn * ways % count).take(ways.min(count)) {
                self.case(case, &way, |chart| compile(chart, &options));
            }
        }
    }

    /// A random chart, with its program and its trace.
    pub fn drawn(&mut self, drawn: Drawn, profile: Profile, job: Job) {
        self.jobs.push(job);
        self.truths.push(Truth::Drawn(drawn, profile));
    }

    /// Random charts of each kind, from these seeds, each in one way that must agree, called so often.
    ///
    /// # Panics
    /// A program cannot be made.
    pub fn random(&mut self, seeds: Range<u64>, calls: usize) {
        let kinds = [ChartKind::Hierarchical, ChartKind::Flat, ChartKind::Hierarchical, ChartKind::Plain];
        for seed in seeds {
            let drawn = checked(seed, kinds[seed as usize % 4]);
            let ways = exact(profile(seed));
            let (_, options) = &ways[seed as usize % ways.len()];
            let program = compile_saved(&drawn.chart, options).unwrap_or_else(|e| panic!("{seed}: {e}"));
            let stimuli = trace(seed, &drawn.chart, calls);
            self.drawn(drawn, profile(seed), Job { program, stimuli });
        }
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

    /// Runs the programs that are this tool's share, so many at once.
    ///
    /// # Panics
    /// Some do what they must not, with all of these.
    pub fn hold(mut self, turn: usize, batch: usize, run: impl Fn(&[Job]) -> Vec<Result<Vec<Response>, String>>) {
        (self.jobs, self.truths) = share(turn, self.jobs.into_iter().zip(self.truths)).into_iter().unzip();
        for (jobs, truths) in self.jobs.chunks(batch).zip(self.truths.chunks(batch)) {
            for ((job, truth), result) in jobs.iter().zip(truths).zip(run(jobs)) {
                self.faults.extend(truth.fault(job, result));
            }
        }
        let (wrong, count) = (self.faults.len(), self.jobs.len());
        assert!(self.faults.is_empty(), "{wrong} of {count} fail\n{}", self.faults.join("\n"));
    }
}

/// Programs that are not to do what charts mean, but what the evaluator makes of them: the r- and s-trigger.
pub struct AsEvaluated {
    jobs: Vec<Job>,
    expected: Vec<Vec<Response>>,
}

impl AsEvaluated {
    /// All charts, each in the way that its place asks for.
    ///
    /// # Panics
    /// A program cannot be made.
    pub fn charts(
        options: impl Fn(usize, Profile) -> Options,
        compile: impl Fn(&Chart, &Options) -> Result<Program, String>,
    ) -> Self {
        let mut evaluated = AsEvaluated { jobs: Vec::new(), expected: Vec::new() };
        for (place, case) in cases(&charts_folder()).iter().enumerate() {
            let chart = check(&case.name, &case.text).expect("a chart without errors");
            let stimuli = stimuli(&case.name, &case.trace, &chart).expect("a trace without errors");
            let program = compile(&chart, &options(place, case.profile)).expect("a scan program");
            let mut evaluator = Evaluator::new(&program);
            evaluated.expected.push(stimuli.iter().map(|stimulus| evaluator.react(stimulus)).collect());
            evaluated.jobs.push(Job { program, stimuli });
        }
        evaluated
    }

    /// Runs all of them.
    ///
    /// # Panics
    /// One does something else.
    pub fn hold(&self, run: impl Fn(&[Job]) -> Vec<Result<Vec<Response>, String>>) {
        for ((job, expected), actual) in self.jobs.iter().zip(&self.expected).zip(run(&self.jobs)) {
            assert_eq!(actual.as_ref(), Ok(expected), "{}", job.program.name);
        }
    }
}

/// The r- and s-trigger by turns.
pub fn triggers(place: usize, profile: Profile) -> Options {
    let encoding = if place % 2 == 0 { Encoding::RTrigger } else { Encoding::STrigger };
    Options { profile, encoding, simplify: true }
}

/// The same, with one micro-step a call in every other pair, and now and then as lowered.
pub fn triggers_in_all_ways(place: usize, profile: Profile) -> Options {
    let evolution = if place % 4 < 2 { Evolution::Stable } else { Evolution::Scan };
    Options { simplify: place % 3 > 0, ..triggers(place, Profile { evolution, ..profile }) }
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
