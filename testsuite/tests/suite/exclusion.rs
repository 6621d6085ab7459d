//! Steps that are said to exclude each other are never active together: in no micro-step of any random chart, whatever
//! inputs, enclosing steps and forcing orders do.

#![allow(clippy::print_stdout, reason = "how much was compared")]

use grafc_diagnostics::Diagnostics;
use grafc_logic::{Analysis, Method, exclusion};
use grafc_model::chart::{Chart, StepId};
use grafc_model::reaction::{Evolution, Profile};
use grafc_model::simulate::Simulator;
use grafc_testsuite::random::{ChartKind, Draw, checked_draw, low_bound, profile, trace};
use std::collections::BTreeSet;

fn analysis(chart: &Chart) -> Analysis {
    let mut net = grafc_net::build(chart);
    grafc_net::passes::run(&mut net, false, &mut Diagnostics::new());
    Analysis::new(net)
}

/// The pairs of steps that are active together after some micro-step.
fn together(chart: &Chart, profile: Profile, seed: u64, rows: usize) -> BTreeSet<(StepId, StepId)> {
    let mut simulator = Simulator::new(chart, low_bound(profile));
    let mut found = BTreeSet::new();
    for stimulus in trace(seed, chart, rows) {
        simulator.react_observed(&stimulus, &mut |s| {
            let active: Vec<StepId> = chart.steps.indices().filter(|step| s.state().situation()[*step]).collect();
            let pairs = active.iter().enumerate().flat_map(|(i, a)| active[i + 1..].iter().map(|b| (*a, *b)));
            found.extend(pairs);
        });
    }
    found
}

#[test]
fn steps_that_exclude_each_other_are_never_active_together() {
    let (mut apart, mut seen, mut methods) = (0, 0, [0; 3]);
    for kind in [ChartKind::Plain, ChartKind::Flat, ChartKind::Hierarchical] {
        for size in [1, 2] {
            for seed in 31_000..31_120 {
                let drawn = checked_draw(seed, Draw { kind, size });
                let chart = &drawn.chart;
                let analysis = analysis(chart);
                let mut met = BTreeSet::new();
                for evolution in [Evolution::Stable, Evolution::Scan] {
                    met.extend(together(chart, Profile { evolution, ..profile(seed) }, seed, 40));
                }
                for (a, b) in &met {
                    let labels = (&chart.steps[*a].label, &chart.steps[*b].label);
                    assert!(
                        !analysis.never_together(*a, *b),
                        "{kind:?}, seed {}: {labels:?}\n{}",
                        drawn.seed,
                        drawn.text
                    );
                }
                seen += met.len();
                let pairs = chart.steps.indices().flat_map(|a| chart.steps.indices().map(move |b| (a, b)));
                apart += pairs.filter(|(a, b)| a < b && analysis.never_together(*a, *b)).count();
                for (method, steps) in exclusion(&analysis) {
                    let place = match method {
                        Method::OneToken => 0,
                        Method::AllSituations => 1,
                        Method::Search => 2,
                    };
                    methods[place] += steps;
                }
            }
        }
    }
    println!("{apart} pairs apart, {seen} seen together; steps by method {methods:?}");
    assert!(apart > 5_000 && seen > 5_000 && methods[0] > 300 && methods[1] > 5_000, "{apart}, {seen}, {methods:?}");
}
