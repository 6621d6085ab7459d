//! How many micro-steps a reaction needs, as the compiler proves it, against the reference simulator.

mod explore;
mod tiny;

use explore::{ENDLESS, explore};
use fastrand::Rng;
use grafc_diagnostics::Diagnostics;
use grafc_logic::Transients;
use grafc_model::chart::{Chart, Expr, ExprKind, Tables, Type, VariableId, VariableKind};
use grafc_model::reaction::{Flags, Profile, Response};
use grafc_testsuite::charts;
use grafc_testsuite::compare::{first_difference, report};
use grafc_testsuite::random::{ChartKind, checked, trace};
use grafc_testsuite::runs::{caught, evaluate, simulate};
use grafc_testsuite::ways::exact;

fn transients(chart: &Chart) -> Transients {
    let mut net = grafc_net::build(chart);
    grafc_net::passes::run(&mut net, false, &mut Diagnostics::new());
    grafc_logic::Analysis::new(net).transients().clone()
}

/// The tiny charts of some seeds.
fn tiny_charts(seeds: std::ops::Range<u64>) -> impl Iterator<Item = (u64, String, Chart)> {
    seeds.filter_map(|seed| {
        let text = tiny::text(seed);
        charts::check("tiny", &text).ok().map(|chart| (seed, text, chart))
    })
}

#[test]
fn no_reaction_of_a_tiny_chart_needs_more_than_is_proved() {
    let (mut drawn, mut bounded, mut reached, mut single, mut but_delays) = (0, 0, 0, 0, 0);
    for (seed, text, chart) in tiny_charts(0..300) {
        drawn += 1;
        let proved = transients(&chart);
        let needs = explore(&chart, seed % 4 != 0, 100);
        if let Some(longest) = proved.longest {
            bounded += 1;
            reached += u32::from(needs.most == longest);
            assert!(needs.most <= longest, "seed {seed}: {} micro-steps, not {longest}\n{text}", needs.most);
        }
        if proved.single {
            single += 1;
            assert!(needs.single, "seed {seed}: a second micro-step did something\n{text}");
        }
        if proved.single_but_delays {
            but_delays += 1;
            assert!(needs.single_but_delays, "seed {seed}: a second micro-step changed more than memories\n{text}");
        }
        assert!(needs.most < ENDLESS || proved.longest.is_none(), "seed {seed}: it has no end\n{text}");
    }
    // The charts must be about something, and the bounds good enough to be worth their proof.
    let counts = [drawn, bounded, reached, single, but_delays];
    let least = [270, 150, 80, 50, 55];
    assert!(counts.iter().zip(least).all(|(count, least)| *count >= least), "{counts:?}, at least {least:?}");
}

#[test]
fn a_program_without_loop_or_limit_does_what_the_chart_does() {
    let (mut once, mut unlimited) = (0, 0);
    for (seed, text, chart) in tiny_charts(1000..1060) {
        let proved = transients(&chart);
        let profile = Profile::default();
        once += u32::from(proved.single);
        unlimited += u32::from(proved.longest.is_some());
        let stimuli = trace(seed, &chart, 30);
        let expected = simulate(&chart, profile, &stimuli);
        for (way, options) in exact(profile) {
            match caught(|| evaluate(&chart, &options, &stimuli)) {
                Err(fault) => panic!("seed {seed}, {way}: {fault}\n{text}"),
                Ok(actual) if first_difference(&expected, &actual).is_some() => {
                    panic!("seed {seed}, {way}\n{text}\n{}", report(&chart, profile, &stimuli, &expected, &actual));
                }
                Ok(_) => {}
            }
        }
    }
    assert!(once >= 8 && unlimited >= 24, "{once} without loop, {unlimited} without limit");
}

#[test]
fn no_reaction_of_a_random_chart_needs_more_than_is_proved() {
    let (mut bounded, mut reached, mut single) = (0, 0, 0);
    for kind in [ChartKind::Plain, ChartKind::Flat, ChartKind::Hierarchical] {
        for seed in 0..120 {
            let mut drawn = checked(seed, kind);
            if drawn.chart.options.is_scan() {
                continue;
            }
            // The bound is that of the test.
            drawn.chart.edit().options.bound = None;
            dampen(drawn.chart.edit(), seed);
            let chart = &drawn.chart;
            let proved = transients(chart);
            let stimuli = trace(seed, chart, 40);
            let with_bound = |bound| simulate(chart, Profile { bound: Some(bound), ..Profile::default() }, &stimuli);
            let Some(longest) = proved.longest else { continue };
            let full = with_bound(longest);
            assert!(!livelock(&full), "seed {seed}, {kind:?}: more than {longest} micro-steps\n{}", drawn.text);
            bounded += 1;
            reached += u32::from(longest == 1 || livelock(&with_bound(longest - 1)));
            if proved.single {
                single += 1;
                // The bound 1 stops after the first micro-step and raises the flag if there was anything to see.
                let mut one = with_bound(1);
                one.iter_mut().for_each(|response| response.flags = Flags { livelock: false, ..response.flags });
                assert_eq!(first_difference(&one, &full), None, "seed {seed}, {kind:?}\n{}", drawn.text);
            }
        }
    }
    let counts = [bounded, reached, single];
    let least = [40, 12, 1];
    assert!(counts.iter().zip(least).all(|(count, least)| *count >= least), "{counts:?}, at least {least:?}");
}

/// Many conditions of a random chart wait for an edge of an input as well, or for its value: without that hardly a
/// chart has a bound, since most can go round in a circle while all inputs are true.
fn dampen(chart: &mut Tables, seed: u64) {
    let mut rng = Rng::with_seed(seed ^ 0x6461_6d70);
    let inputs = chart.variables.iter_enumerated().filter(|(_, v)| v.kind == VariableKind::Input && v.ty == Type::Bool);
    let inputs: Vec<VariableId> = inputs.map(|(id, _)| id).collect();
    if inputs.is_empty() {
        return;
    }
    let (share, edges) = (rng.f32(), rng.f32());
    for transition in &mut chart.transitions {
        if rng.f32() > share {
            continue;
        }
        let mut push = |kind| chart.exprs.push(Expr { kind, ty: Type::Bool, span: transition.span });
        let input = push(ExprKind::Variable(inputs[rng.usize(0..inputs.len())]));
        let factor = match (rng.f32() < edges, rng.bool()) {
            (true, true) => push(ExprKind::Rise(input)),
            (true, false) => push(ExprKind::Fall(input)),
            (false, true) => input,
            (false, false) => push(ExprKind::Not(input)),
        };
        transition.condition = push(ExprKind::And(factor, transition.condition));
    }
}

#[test]
fn the_charts_of_the_suite_keep_to_their_bounds() {
    for folder in [charts::charts_folder(), charts::vectors_folder()] {
        for case in charts::cases(&folder) {
            let chart = charts::check(&case.name, &case.text).unwrap_or_else(|fault| panic!("{fault}"));
            let stimuli = charts::stimuli(&case.name, &case.trace, &chart).unwrap_or_else(|fault| panic!("{fault}"));
            let Some(longest) = transients(&chart).longest else { continue };
            let run = simulate(&chart, Profile { bound: Some(longest), ..case.profile }, &stimuli);
            assert!(!livelock(&run), "{}: more than {longest}", case.name);
        }
    }
}

/// Whether some reaction hit its bound.
fn livelock(run: &[Response]) -> bool {
    run.iter().any(|response| response.flags.livelock)
}
