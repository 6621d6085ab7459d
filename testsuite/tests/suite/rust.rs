//! Generated Rust, compiled by rustc and run: it does what the chart means.
//!
//! Every warning of rustc is a fault. Each chart is also saved and restored on the way, and its clock wraps around.

use grafc_logic::{Encoding, Options};
use grafc_model::chart::Chart;
use grafc_testsuite::agreement::{Agreement, AsEvaluated, triggers};
use grafc_testsuite::charts::{Case, cases, charts_folder, check, vectors_folder};
use grafc_testsuite::compare::{first_difference, report};
use grafc_testsuite::executors::jobs::Job;
use grafc_testsuite::executors::rust::{Tools, run};
use grafc_testsuite::random::profile;
use grafc_testsuite::random::trace;
use grafc_testsuite::runs::{compile_saved, simulate};
use grafc_testsuite::scaling::SHAPES;
use grafc_testsuite::share::share;

/// The share of rustc.
const TURN: usize = 0;

/// Charts in one program of rustc.
const BATCH: usize = 100;

/// Runs all cases, each in so many of the ways that must agree, and compares them with what is expected of them.
fn agree(cases: &[Case], ways: usize) {
    let Some(tools) = Tools::find_or_skip() else { return };
    let mut agreement = Agreement::default();
    agreement.cases(cases, ways, compile_saved);
    agreement.hold(TURN, BATCH, |jobs| run(&tools, jobs));
}

#[test]
fn vectors_agree() {
    agree(&cases(&vectors_folder()), 2);
}

#[test]
fn charts_agree() {
    agree(&cases(&charts_folder()), 4);
}

#[test]
fn random_charts_agree() {
    let Some(tools) = Tools::find_or_skip() else { return };
    let mut agreement = Agreement::default();
    agreement.random(3000..3080, 30);
    agreement.hold(TURN, BATCH, |jobs| run(&tools, jobs));
}

/// Large charts are parted into functions and tables, and of more than 1,000 steps runs are looked at. Each shape is large,
/// except the one whose size is that of its conditions, and every fourth very large.
#[test]
fn large_charts_agree() {
    let Some(tools) = Tools::find_or_skip() else { return };
    let options = Options { profile: profile(0), encoding: Encoding::Switch, simplify: true };
    let shapes = share(TURN, SHAPES.iter().filter(|shape| shape.name != "priorities"));
    let charts = shapes.iter().enumerate().map(|(place, shape)| {
        let size = if place % 4 == 0 { 1_100 } else { 220 };
        let chart = check(shape.name, &(shape.write)(size)).expect("a chart without errors");
        assert!(chart.steps.len() >= size, "{}: {} steps", shape.name, chart.steps.len());
        chart
    });
    let charts: Vec<Chart> = charts.collect();
    let job = |chart: &Chart| Job {
        program: compile_saved(chart, &options).expect("a scan program"),
        stimuli: trace(1, chart, 40),
    };
    let jobs: Vec<Job> = charts.iter().map(job).collect();
    for ((actual, job), (shape, chart)) in run(&tools, &jobs).into_iter().zip(&jobs).zip(shapes.iter().zip(&charts)) {
        // What rustc or the program says; the text behind it has a megabyte.
        let actual =
            actual.unwrap_or_else(|said| panic!("{}: {}", shape.name, said.lines().next().unwrap_or_default()));
        let expected = simulate(chart, options.profile, &job.stimuli);
        if first_difference(&expected, &actual).is_some() {
            panic!("{}\n{}", shape.name, report(chart, options.profile, &job.stimuli, &expected, &actual));
        }
    }
}

/// The r- and s-trigger too are written as they are evaluated.
#[test]
fn overlapping_encodings_are_written_as_they_are() {
    let Some(tools) = Tools::find_or_skip() else { return };
    AsEvaluated::charts(triggers, compile_saved).hold(|jobs| run(&tools, jobs));
}
