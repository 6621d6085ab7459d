//! What is asked of an executor that runs some charts only: that these agree, and that they are not too few.

use grafc_model::chart::Chart;
use grafc_model::reaction::{Evolution, Profile, Stimulus};
use grafc_testsuite::charts::{Case, cases, charts_folder, check, spell, stimuli, vectors_folder};
use grafc_testsuite::executors::{Outcome, Task, find_or_skip};
use grafc_testsuite::random::{ChartKind, checked, trace};
use grafc_testsuite::runs::simulate;
use grafc_testsuite::share::{at_least, share, turn_of};
use std::ops::Range;

/// The chart of a case, and what it is given.
pub fn prepared(case: &Case) -> (Chart, Vec<Stimulus>) {
    let chart = check(&case.name, &case.text).unwrap_or_else(|fault| panic!("{fault}"));
    let stimuli = stimuli(&case.name, &case.trace, &chart).unwrap_or_else(|fault| panic!("{fault}"));
    (chart, stimuli)
}

/// Runs the vectors and the charts, the encodings in turn; at least so many of them must run.
pub fn vectors_and_charts_agree(name: &str, least: usize) {
    let Some(executor) = find_or_skip(name) else { return };
    let all: Vec<Case> = [vectors_folder(), charts_folder()].iter().flat_map(|folder| cases(folder)).collect();
    let all = share(turn_of(name), all);
    let prepared: Vec<(Chart, Vec<Stimulus>)> = all.iter().map(self::prepared).collect();
    let tasks: Vec<Task> = all
        .iter()
        .zip(&prepared)
        .enumerate()
        .map(|(turn, (case, (chart, stimuli)))| Task { chart, profile: case.profile, stimuli, turn })
        .collect();
    let (mut ran, mut faults) = (0, Vec::new());
    for ((case, (chart, stimuli)), outcome) in all.iter().zip(&prepared).zip(executor.run(&tasks)) {
        match outcome {
            Outcome::PassedOver(_) => {}
            Outcome::Failed(said) => faults.push(format!("{}:\n{said}", case.name)),
            Outcome::Ran(responses) => {
                ran += 1;
                let actual = spell(chart, stimuli, &responses);
                if actual != case.expected {
                    faults.push(format!("{}:\nexpected\n{}actual\n{actual}", case.name, case.expected));
                }
            }
        }
    }
    assert!(faults.is_empty(), "{} fail\n{}", faults.len(), faults.join("\n"));
    assert!(ran >= at_least(least), "only {ran} ran");
}

/// Runs random charts of a kind, to stability and scan by scan, and compares them with the simulator; at least so many of
/// them must run.
pub fn random_charts_agree(name: &str, seeds: Range<u64>, kind: ChartKind, edit: fn(String) -> String, least: usize) {
    let Some(executor) = find_or_skip(name) else { return };
    let charts: Vec<(String, Chart, Vec<Stimulus>, Profile)> = share(turn_of(name), seeds)
        .into_iter()
        .map(|seed| {
            let mut text = edit(checked(seed, kind).text);
            let each_scan = text.contains("each scan");
            if each_scan {
                text = text.replacen('\n', " evolution scan\n", 1);
            }
            let chart = check("random", &text).unwrap_or_else(|fault| panic!("{fault}\n{text}"));
            let evolution = if seed % 2 == 1 || each_scan { Evolution::Scan } else { Evolution::Stable };
            let stimuli = trace(seed, &chart, 30);
            (text, chart, stimuli, Profile { evolution, ..Profile::default() })
        })
        .collect();
    let tasks: Vec<Task> = charts
        .iter()
        .enumerate()
        .map(|(turn, (_, chart, stimuli, profile))| Task { chart, profile: *profile, stimuli, turn })
        .collect();
    let mut ran = 0;
    for ((task, (text, ..)), outcome) in tasks.iter().zip(&charts).zip(executor.run(&tasks)) {
        let expected = simulate(task.chart, task.profile, task.stimuli);
        match outcome {
            Outcome::PassedOver(_) => {}
            Outcome::Failed(said) => panic!("{said}\n{text}"),
            Outcome::Ran(actual) => {
                ran += 1;
                let difference = executor.difference(&expected, &actual);
                let runs = || [&expected, &actual].map(|run| spell(task.chart, task.stimuli, run)).join("\n");
                assert!(difference.is_none(), "call {difference:?} of\n{text}\n{}", runs());
            }
        }
    }
    assert!(ran >= at_least(least), "only {ran} ran");
}

/// A plain chart with delays and falling edges of inputs.
pub fn with_delays(text: String) -> String {
    let conditions = text.replace(": a\n", ": 500ms/a\n").replace(": not b\n", ": 300ms/(not b)/1s\n");
    conditions.replace("↑d", "↓d").replace("↑e", "↓(d and not e)").replace(" if c }", " if c/700ms }")
}

/// A plain chart with edges and delays of steps.
pub fn of_steps(text: String) -> String {
    let conditions = text.replace(": a\n", ": a or ↑X101\n").replace(": b\n", ": b and not 300ms/X100/500ms\n");
    conditions.replace(": c\n", ": 200ms/(X101 and c)\n").replace(": d\n", ": d or ↑([n > 1])\n")
}
