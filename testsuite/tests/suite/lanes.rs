//! 64 scenarios at once: each lane does what the program does alone.

use grafc_lanes::{Lanes, run};
use grafc_model::chart::Chart;
use grafc_model::reaction::{Profile, Response, Stimulus};
use grafc_testsuite::charts::{cases, charts_folder, check, stimuli, vectors_folder};
use grafc_testsuite::compare::{first_difference, report};
use grafc_testsuite::differential::long_run::{self, Plan};
use grafc_testsuite::executors::select;
use grafc_testsuite::random::{ChartKind, checked, profile, trace};
use grafc_testsuite::runs::{self, compile};
use grafc_testsuite::ways::exact;

/// All traces at once, and one by one.
fn agree(name: &str, chart: &Chart, profile: Profile, traces: &[&[Stimulus]]) {
    for (way, options) in exact(profile) {
        let Ok(program) = compile(chart, &options) else { continue };
        for (stimuli, actual) in traces.iter().zip(run(&program, traces)) {
            let expected = runs::run(&program, stimuli);
            assert!(
                first_difference(&expected, &actual).is_none(),
                "{name}, {way}\n{}",
                report(chart, profile, stimuli, &expected, &actual)
            );
        }
    }
}

#[test]
fn vectors_and_charts() {
    let mut calls = 0;
    for case in cases(&vectors_folder()).into_iter().chain(cases(&charts_folder())) {
        let chart = check(&case.name, &case.text).expect("a chart without errors");
        let own = stimuli(&case.name, &case.trace, &chart).expect("a trace without errors");
        let drawn: Vec<Vec<Stimulus>> = (1..12).map(|seed| trace(seed, &chart, 20 + seed as usize)).collect();
        let traces: Vec<&[Stimulus]> = std::iter::once(own.as_slice()).chain(drawn.iter().map(Vec::as_slice)).collect();
        calls += traces.iter().map(|trace| trace.len()).sum::<usize>();
        agree(&case.name, &chart, case.profile, &traces);
    }
    assert!(calls > 5_000, "{calls}");
}

/// Numbers, delays, divisions by zero, livelocks, restarts: of lengths that differ, in all 64 lanes.
#[test]
fn random_charts() {
    for seed in 0..6 {
        let kind = if seed % 3 == 0 { ChartKind::Flat } else { ChartKind::Hierarchical };
        let drawn = checked(seed, kind);
        let own: Vec<Vec<Stimulus>> =
            (0..64).map(|lane| trace(64 * seed + lane, &drawn.chart, 4 + lane as usize % 9)).collect();
        let traces: Vec<&[Stimulus]> = own.iter().map(Vec::as_slice).collect();
        agree(&format!("seed {seed}"), &drawn.chart, profile(seed), &traces);
    }
}

/// As the long run has it: all exact encodings with 64 traces, and the simulator with one of them.
#[test]
fn the_executor_agrees_with_the_simulator() {
    let plan = Plan { charts: 10, seed: 0, size: 1, kind: None, scans: 12, threads: None };
    let executors = select("lanes").expect("it is built in");
    let summary = long_run::run(&plan, &executors, |_, _| ());
    assert_eq!((summary.mismatches(), summary.tallies[1].charts), (0, 10));
}

/// Where the calls of two programs differ is where their responses do: here of one program that is given other inputs in
/// every third lane.
#[test]
fn lanes_that_differ_are_told() {
    let mut told = 0;
    for seed in 0..6 {
        let drawn = checked(seed, ChartKind::Hierarchical);
        let program = compile(&drawn.chart, &exact(profile(seed))[0].1).expect("a scan program");
        let [mine, theirs] = [0, 1].map(|other| -> Vec<Vec<Stimulus>> {
            let of =
                |lane: u64| trace(64 * seed + lane + if lane % 3 == 0 { 1000 * other } else { 0 }, &drawn.chart, 12);
            (0..64).map(of).collect()
        });
        let (mut one, mut two) = (Lanes::new(&program), Lanes::new(&program));
        for row in 0..12 {
            one.react(&mine.iter().map(|trace| &trace[row]).collect::<Vec<_>>());
            two.react(&theirs.iter().map(|trace| &trace[row]).collect::<Vec<_>>());
            let differs = |(a, b): (Response, Response)| first_difference(&[a], &[b]).is_some();
            let expected: Vec<bool> = one.responses(64).into_iter().zip(two.responses(64)).map(differs).collect();
            let word = one.differing(&mut two);
            let actual: Vec<bool> = (0..64).map(|lane| word >> lane & 1 == 1).collect();
            assert_eq!(actual, expected, "seed {seed}, row {row}");
            told += word.count_ones();
        }
    }
    assert!(told > 200, "{told} lanes that differ");
}
