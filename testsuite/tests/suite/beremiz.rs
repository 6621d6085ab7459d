//! PLCopen projects with every kind of body, through the generator of Beremiz, MATIEC and a C compiler: they do what the
//! chart means.
//!
//! Needs `BEREMIZ`, a Python with lxml (`PYTHON`), `iec2c` and `gcc`; without them each test says so and does nothing.

use grafc_backends::plcopen::Body;
use grafc_logic::{Encoding, Options};
use grafc_model::chart::Chart;
use grafc_model::reaction::{Evolution, Profile, Stimulus};
use grafc_testsuite::charts::{Case, cases, charts_folder, check, spell, stimuli, vectors_folder};
use grafc_testsuite::executors::beremiz::{Source, Tools, run};
use grafc_testsuite::executors::jobs::Job;
use grafc_testsuite::executors::{Outcome, Task, find_or_skip};
use grafc_testsuite::random::{ChartKind, checked, trace};
use grafc_testsuite::runs::{self, compile, simulate};

fn prepared(case: &Case) -> (Chart, Vec<Stimulus>) {
    let chart = check(&case.name, &case.text).unwrap_or_else(|fault| panic!("{fault}"));
    let stimuli = stimuli(&case.name, &case.trace, &chart).unwrap_or_else(|fault| panic!("{fault}"));
    (chart, stimuli)
}

/// Runs the vectors and the charts, the encodings in turn; at least so many of them must run.
fn vectors_and_charts_agree(name: &str, least: usize) {
    let Some(executor) = find_or_skip(name) else { return };
    let all: Vec<Case> = [vectors_folder(), charts_folder()].iter().flat_map(|folder| cases(folder)).collect();
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
    assert!(ran >= least, "only {ran} ran");
}

#[test]
fn structured_text() {
    vectors_and_charts_agree("plcopen:st", 100);
}

#[test]
fn instruction_lists() {
    vectors_and_charts_agree("plcopen:il", 100);
}

#[test]
fn ladders() {
    vectors_and_charts_agree("plcopen:ld", 100);
}

#[test]
fn sequential_function_charts() {
    vectors_and_charts_agree("plcopen:sfc", 5);
}

/// The r- and s-trigger are written as they are evaluated, and do what is expected where nothing overlaps.
#[test]
fn overlapping_encodings() {
    let Some(tools) = Tools::find_or_skip() else { return };
    let all = cases(&charts_folder()).into_iter().chain(cases(&vectors_folder()).into_iter().filter(|c| c.overlapping));
    let mut jobs = Vec::new();
    let mut expected = Vec::new();
    for case in all {
        for encoding in Encoding::ALL.into_iter().filter(|encoding| encoding.overlaps()) {
            let (chart, stimuli) = prepared(&case);
            let options = Options { profile: case.profile, encoding, simplify: true };
            let program = compile(&chart, &options).unwrap_or_else(|fault| panic!("{fault}"));
            let evaluated = runs::run(&program, &stimuli);
            if case.overlapping {
                assert_eq!(spell(&chart, &stimuli, &evaluated), case.expected, "{}", case.name);
            }
            expected.push((format!("{}, {}", case.name, encoding.name()), evaluated));
            jobs.push(Job { program, stimuli });
        }
    }
    for body in [Body::St, Body::Il, Body::Ld] {
        for ((name, expected), actual) in expected.iter().zip(run(&tools, &Source::Programs(body), &jobs)) {
            assert_eq!(actual.as_ref(), Ok(expected), "{name}, {body:?}");
        }
    }
}

/// Runs random charts of a kind and compares them with the simulator; at least so many of them must run.
fn random_charts_agree(
    name: &str,
    seeds: std::ops::Range<u64>,
    kind: ChartKind,
    edit: fn(String) -> String,
    least: usize,
) {
    let Some(executor) = find_or_skip(name) else { return };
    let charts: Vec<(String, Chart, Vec<Stimulus>, Profile)> = seeds
        .map(|seed| {
            let text = edit(checked(seed, kind).text);
            let chart = check("random", &text).unwrap_or_else(|fault| panic!("{fault}\n{text}"));
            let evolution = if seed % 2 == 0 { Evolution::Stable } else { Evolution::Scan };
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
            Outcome::Failed(said) => panic!("{said}"),
            Outcome::Ran(actual) => {
                ran += 1;
                let difference = executor.difference(&expected, &actual);
                let runs = || [&expected, &actual].map(|run| spell(task.chart, task.stimuli, run)).join("\n");
                assert!(difference.is_none(), "call {difference:?} of\n{text}\n{}", runs());
            }
        }
    }
    assert!(ran >= least, "only {ran} ran");
}

/// To stability and scan by scan.
#[test]
fn random_ladders() {
    random_charts_agree("plcopen:ld", 1000..1010, ChartKind::Hierarchical, |text| text, 5);
}

/// Of the whole language hardly any chart is one. Of the plain ones many are, also with
/// delays and falling edges, and with those of steps.
#[test]
fn random_sequential_function_charts() {
    let delays = |text: String| {
        let conditions = text.replace(": a\n", ": 500ms/a\n").replace(": not b\n", ": 300ms/(not b)/1s\n");
        conditions.replace("↑d", "↓d").replace("↑e", "↓(d and not e)").replace(" if c }", " if c/700ms }")
    };
    let of_steps = |text: String| {
        let conditions = text.replace(": a\n", ": a or ↑X101\n").replace(": b\n", ": b and not 300ms/X100/500ms\n");
        conditions.replace(": c\n", ": 200ms/(X101 and c)\n").replace(": d\n", ": d or ↑([n > 1])\n")
    };
    random_charts_agree("plcopen:sfc", 0..200, ChartKind::Plain, |text| text, 30);
    random_charts_agree("plcopen:sfc", 200..500, ChartKind::Plain, delays, 30);
    random_charts_agree("plcopen:sfc", 500..900, ChartKind::Plain, of_steps, 30);
}
