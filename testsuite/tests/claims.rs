//! Claims: what a scan program computes of them is what the simulator says, reaction by reaction; and who does not ask for
//! them has the same program as without them.

#![allow(clippy::print_stdout, reason = "how much was compared")]

use grafc_logic::Extras;
use grafc_logic::scan::evaluate::Evaluator;
use grafc_logic::scan::{Claimed, Program, SeenBody, VarId, dump};
use grafc_model::chart::{Chart, ClaimBody, ClaimKind, ExprId, Value};
use grafc_model::reaction::{Profile, Stimulus};
use grafc_model::simulate::Simulator;
use grafc_testsuite::random::{ChartKind, checked, profile, trace, with_claims};
use grafc_testsuite::runs::{compile, compile_with};
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
