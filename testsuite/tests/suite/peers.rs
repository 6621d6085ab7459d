//! Generated Structured Text under IronPLC and STruC++: each does what is expected, scan by scan.
//!
//! Charts have their encoding by turns. Where a tool is missing its test says so and does nothing; what a tool is known
//! not to do is passed over, and only little may be.

use grafc_model::chart::Chart;
use grafc_model::reaction::{Profile, Response, Stimulus};
use grafc_testsuite::charts::{Case, cases, charts_folder, check, spell, stimuli, vectors_folder};
use grafc_testsuite::compare::report;
use grafc_testsuite::executors::{Outcome, Task, find_or_skip};
use grafc_testsuite::random::profile;
use grafc_testsuite::random::{ChartKind, checked, trace};
use grafc_testsuite::runs::simulate;

/// A chart, how it runs, what is done to it and what it must do.
struct Run {
    name: String,
    chart: Chart,
    profile: Profile,
    stimuli: Vec<Stimulus>,
    expected: Vec<Response>,
}

impl Run {
    fn task(&self, turn: usize) -> Task<'_> {
        Task { chart: &self.chart, profile: self.profile, stimuli: &self.stimuli, turn }
    }
}

/// What the simulator does is what is written by hand: `vectors.rs` sees to that.
fn run_of(case: &Case) -> Run {
    let chart = check(&case.name, &case.text).expect("a chart without errors");
    let stimuli = stimuli(&case.name, &case.trace, &chart).expect("a trace without errors");
    let expected = simulate(&chart, case.profile, &stimuli);
    assert_eq!(spell(&chart, &stimuli, &expected), case.expected, "{}", case.name);
    Run { name: case.name.clone(), chart, profile: case.profile, stimuli, expected }
}

fn random_run(seed: u64) -> Run {
    let drawn = checked(seed, if seed % 2 == 0 { ChartKind::Flat } else { ChartKind::Hierarchical });
    let stimuli = trace(seed, &drawn.chart, 30);
    let expected = simulate(&drawn.chart, profile(seed), &stimuli);
    Run { name: format!("seed {seed}\n{}", drawn.text), chart: drawn.chart, profile: profile(seed), stimuli, expected }
}

/// All runs are as expected, except a tenth that may be passed over.
fn agree(name: &str, runs: &[Run]) {
    let Some(executor) = find_or_skip(name) else { return };
    let tasks: Vec<Task> = runs.iter().enumerate().map(|(turn, run)| run.task(turn)).collect();
    let (mut faults, mut passed_over) = (Vec::new(), 0);
    for (run, outcome) in runs.iter().zip(executor.run(&tasks)) {
        match outcome {
            Outcome::Ran(actual) if executor.difference(&run.expected, &actual).is_none() => {}
            Outcome::Ran(actual) => {
                let report = report(&run.chart, run.profile, &run.stimuli, &run.expected, &actual);
                faults.push(format!("{}\n{report}", run.name));
            }
            Outcome::PassedOver(_) => passed_over += 1,
            Outcome::Failed(said) => faults.push(format!("{}\n{said}", run.name)),
        }
    }
    assert!(faults.is_empty(), "{} of {} charts fail\n{}", faults.len(), runs.len(), faults.join("\n"));
    assert!(passed_over * 10 <= runs.len(), "{passed_over} of {} charts are passed over", runs.len());
}

fn written() -> Vec<Run> {
    [vectors_folder(), charts_folder()].iter().flat_map(|folder| cases(folder)).map(|case| run_of(&case)).collect()
}

#[test]
fn vectors_and_charts_agree_under_ironplc() {
    agree("ironplc:st", &written());
}

#[test]
fn vectors_and_charts_agree_under_strucpp() {
    agree("strucpp:st", &written());
}

#[test]
fn random_charts_agree_under_ironplc() {
    agree("ironplc:st", &(3000..3024).map(random_run).collect::<Vec<_>>());
}

#[test]
fn random_charts_agree_under_strucpp() {
    agree("strucpp:st", &(4000..4024).map(random_run).collect::<Vec<_>>());
}
