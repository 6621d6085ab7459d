//! Claims: what a scan program computes of them is what the simulator says, reaction by reaction; and who does not ask for
//! them has the same program as without them.

#![allow(clippy::print_stdout, reason = "how much was compared")]

use grafc_logic::Extras;
use grafc_logic::scan::evaluate::Evaluator;
use grafc_logic::scan::{Claimed, Program, SeenBody, VarId, dump};
use grafc_model::chart::{Chart, ClaimBody, ClaimKind, ControlNames, ExprId, Value};
use grafc_model::reaction::{Profile, Response, Stimulus};
use grafc_model::simulate::Simulator;
use grafc_testsuite::executors::jobs::Job;
use grafc_testsuite::executors::{matiec, rust};
use grafc_testsuite::random::{ChartKind, checked, profile, trace, with_claims};
use grafc_testsuite::runs::{compile, compile_saved, compile_with, simulate};
use grafc_testsuite::share::share;
use grafc_testsuite::ways::exact;

/// The conditions of all claims, each with its place among them.
fn conditions(chart: &Chart) -> Vec<(usize, ExprId)> {
    let of = |body: ClaimBody| match body {
        ClaimBody::Condition(id) => vec![id],
        ClaimBody::Leads(from, to) => vec![from, to],
    };
    let claims = chart.claims.list.iter().enumerate();
    claims.flat_map(|(place, claim)| of(claim.body).into_iter().map(move |id| (place, id))).collect()
}

fn variables(program: &Program) -> Vec<(usize, VarId)> {
    let of = |body: SeenBody| match body {
        SeenBody::Condition(v) => vec![v],
        SeenBody::Leads(from, to) => vec![from, to],
    };
    program.claims.iter().flat_map(|claim| of(claim.body).into_iter().map(|v| (claim.place, v))).collect()
}

/// By reaction, whether each condition holds.
fn simulated(chart: &Chart, profile: Profile, stimuli: &[Stimulus]) -> Vec<Vec<(usize, bool)>> {
    let mut simulator = Simulator::new(chart, profile);
    simulator.watch_claims();
    let conditions = conditions(chart);
    let one = |stimulus: &Stimulus| {
        simulator.react(stimulus);
        conditions.iter().map(|(place, id)| (*place, simulator.claimed(*id))).collect()
    };
    stimuli.iter().map(one).collect()
}

fn evaluated(program: &Program, stimuli: &[Stimulus]) -> Vec<Vec<(usize, bool)>> {
    let mut evaluator = Evaluator::new(program);
    let variables = variables(program);
    let one = |stimulus: &Stimulus| {
        evaluator.react(stimulus);
        variables.iter().map(|(place, v)| (*place, evaluator.value_of(*v) == Value::Bool(true))).collect()
    };
    stimuli.iter().map(one).collect()
}

#[test]
fn programs_and_the_simulator_agree_on_claims() {
    let extras = Extras { claims: Claimed::All, ..Extras::default() };
    let (mut programs, mut seen) = (0, std::collections::BTreeSet::new());
    for seed in 0..150 {
        let kind = if seed % 3 == 0 { ChartKind::Flat } else { ChartKind::Hierarchical };
        let (text, chart) = with_claims(&checked(seed, kind));
        let (profile, stimuli) = (profile(seed), trace(seed, &chart, 40));
        let expected = simulated(&chart, profile, &stimuli);
        for (way, options) in exact(profile) {
            let program = compile_with(&chart, &options, extras).unwrap_or_else(|fault| panic!("{fault}"));
            let actual = evaluated(&program, &stimuli);
            let row = (0..expected.len()).find(|row| expected[*row] != actual[*row]);
            if let Some(row) = row {
                panic!("{way}, row {row}:\n  simulator {:?}\n  program   {:?}\n{text}", expected[row], actual[row]);
            }
            programs += 1;
        }
        for (place, holds) in expected.iter().flatten() {
            seen.insert((chart.claims.list[*place].kind, *holds));
        }
    }
    println!("{programs} programs");
    // Each kind was true, and was false.
    let kinds = [ClaimKind::Assume, ClaimKind::Assert, ClaimKind::Reach, ClaimKind::Final];
    assert!(kinds.iter().all(|kind| seen.contains(&(*kind, true)) && seen.contains(&(*kind, false))), "{seen:?}");
}

#[test]
fn claims_change_nothing_in_programs() {
    for seed in 0..150 {
        let drawn = checked(seed, ChartKind::Hierarchical);
        let (text, chart) = with_claims(&drawn);
        for (way, options) in exact(profile(seed)) {
            let without = compile(&drawn.chart, &options).unwrap_or_else(|fault| panic!("{fault}"));
            let with = compile(&chart, &options).unwrap_or_else(|fault| panic!("{fault}"));
            assert!(dump(&with) == dump(&without), "{way}:\n{text}");
        }
    }
}

/// Random charts whose assertions are checked, with the option and its output, in all executors of generated code at hand.
#[test]
fn generated_code_checks_assertions() {
    let names = ControlNames { check_assertions: true, clear_flags: Some("ack".into()), ..ControlNames::default() };
    let (mut jobs, mut charts) = (Vec::new(), Vec::new());
    for seed in 300..345 {
        let (text, mut chart) = with_claims(&checked(seed, ChartKind::Hierarchical));
        chart.control(&names).unwrap_or_else(|_| panic!("{text}"));
        let ways = exact(profile(seed));
        let (way, options) = &ways[seed as usize % ways.len()];
        let stimuli = trace(seed, &chart, 30);
        let program = compile_saved(&chart, options).unwrap_or_else(|fault| panic!("{fault}"));
        let expected = simulate(&chart, options.profile, &stimuli);
        let mut evaluator = Evaluator::new(&program);
        let actual: Vec<Response> = stimuli.iter().map(|stimulus| evaluator.react(stimulus)).collect();
        assert!(actual == expected, "{way}\n{text}");
        charts.push((text, chart, expected));
        jobs.push(Job { program, stimuli });
    }
    let told = |(_, chart, expected): &(String, Chart, Vec<Response>)| {
        chart.controls.assertion.is_some()
            && expected.iter().any(|response| !matches!(response.outputs.last(), Some(Value::Int(0))))
    };
    assert!(charts.iter().filter(|chart| told(chart)).count() > 10, "too few assertions came out false");
    if let Some(tools) = rust::Tools::find_or_skip() {
        let (charts, jobs): (Vec<_>, Vec<Job>) =
            share(0, charts.iter().zip(&jobs)).into_iter().map(|(chart, job)| (chart, job.clone())).unzip();
        for (((text, _, expected), job), made) in charts.iter().zip(&jobs).zip(rust::run(&tools, &jobs)) {
            let made = made.unwrap_or_else(|fault| panic!("{fault}\n{text}"));
            assert!(made == *expected, "{}\n{text}", job.program.name);
        }
    }
    if let Some(tools) = matiec::Tools::find_or_skip() {
        let (charts, jobs): (Vec<_>, Vec<Job>) = share(1, charts.iter().zip(jobs)).into_iter().unzip();
        let made = matiec::run(&tools, matiec::Language::St, &jobs);
        for (((text, chart, expected), job), made) in charts.iter().zip(&jobs).zip(made) {
            if !matiec::miscalculates(chart) {
                let made = made.unwrap_or_else(|fault| panic!("{fault}\n{text}"));
                assert!(made == *expected, "{}\n{text}", job.program.name);
            }
        }
    }
}
