//! What a program shows of its micro-steps is what the rules say of them, one by one: enabled, satisfied and cleared
//! transitions (R3), frozen grafcets, orders in force and forced steps (R2), actions (R7, R11). The simulator says it from
//! the chart alone.

#![allow(clippy::print_stdout, reason = "how much was compared")]

use grafc_logic::scan::evaluate::Evaluator;
use grafc_logic::scan::{Observed, Program, VarId};
use grafc_logic::{Encoding, Options};
use grafc_model::chart::{Chart, Node, StepId, Value};
use grafc_model::reaction::{Evolution, LivelockOutputs, Profile, Stimulus};
use grafc_model::simulate::Simulator;
use grafc_testsuite::charts::{self, Case};
use grafc_testsuite::executors::jobs::Job;
use grafc_testsuite::executors::js;
use grafc_testsuite::random::{ChartKind, checked, low_bound, profile, trace};
use grafc_testsuite::runs::{caught, compile_observed, overlapping};
use grafc_testsuite::ways::exact;
use std::collections::BTreeSet;

/// What is seen after a micro-step.
#[derive(Clone, PartialEq, Debug)]
struct Sight {
    reaction: usize,
    situation: Vec<StepId>,
    enabled: Vec<bool>,
    cleared: Vec<bool>,
    /// If all is shown.
    rest: Option<Rest>,
}

#[derive(Clone, PartialEq, Debug)]
struct Rest {
    satisfied: Vec<bool>,
    frozen: Vec<bool>,
    orders: Vec<bool>,
    forced: Vec<bool>,
    /// Stored actions.
    done: Vec<bool>,
}

/// A run: after each micro-step, and after each call the continuous actions.
#[derive(PartialEq, Debug, Default)]
struct Run {
    sights: Vec<Sight>,
    acting: Vec<Vec<bool>>,
}

fn simulated(chart: &Chart, profile: Profile, stimuli: &[Stimulus], all: bool) -> Run {
    let mut run = Run::default();
    let mut simulator = Simulator::new(chart, profile);
    simulator.look_on();
    for (reaction, stimulus) in stimuli.iter().enumerate() {
        simulator.react_observed(stimulus, &mut |s| {
            if s.is_at_start() {
                return;
            }
            let seen = s.seen().expect("somebody looks on");
            let rest = all.then(|| Rest {
                satisfied: seen.satisfied.iter().copied().collect(),
                frozen: s.frozen().into_iter().collect(),
                orders: s.in_force(),
                forced: s.forced().into_iter().collect(),
                done: seen.done.clone(),
            });
            run.sights.push(Sight {
                reaction,
                situation: active(s.state().situation().iter_enumerated().map(|(s, active)| (s, *active))),
                enabled: seen.enabled.iter().copied().collect(),
                cleared: seen.cleared.iter().copied().collect(),
                rest,
            });
        });
        run.acting.push(if all { simulator.acting(stimulus.t_ms) } else { Vec::new() });
    }
    run
}

fn active(steps: impl Iterator<Item = (StepId, bool)>) -> Vec<StepId> {
    steps.filter_map(|(s, active)| active.then_some(s)).collect()
}

fn evaluated(chart: &Chart, program: &Program, stimuli: &[Stimulus], all: bool) -> Run {
    let observing = program.observing.as_ref().expect("a program that shows what it does");
    let mut run = Run::default();
    let mut evaluator = Evaluator::new(program);
    evaluator.look_on();
    let holds = |e: &Evaluator, v: VarId| e.value_of(v) == Value::Bool(true);
    // Orders and actions are numbered in the order of the text.
    let orders = by_text(chart.orders.iter().map(|order| order.span.start));
    let spans = chart.continuous.iter().map(|a| a.span.start).chain(chart.stored.iter().map(|a| a.span.start));
    let actions = by_text(spans);
    let listed = |e: &Evaluator, list: &[(usize, VarId)], places: &[usize]| -> Vec<bool> {
        let shown = |place: &usize| list.iter().find(|(at, _)| at == place).is_some_and(|(_, v)| holds(e, *v));
        places.iter().map(shown).collect()
    };
    for (reaction, stimulus) in stimuli.iter().enumerate() {
        let mut first = true;
        evaluator.react_observed(stimulus, |e| {
            if std::mem::take(&mut first) {
                return;
            }
            let rest = all.then(|| {
                let mut frozen = vec![false; chart.grafcets.len()];
                observing.frozen.iter().for_each(|(g, v)| frozen[g.index()] = holds(e, *v));
                let mut forced = vec![false; chart.steps.len()];
                observing.forced.iter().for_each(|(s, v)| forced[s.index()] = holds(e, *v));
                Rest {
                    satisfied: observing.transitions.iter().filter_map(|t| Some(holds(e, t.satisfied?))).collect(),
                    frozen,
                    orders: listed(e, &observing.orders, &orders),
                    forced,
                    done: listed(e, &observing.actions, &actions[chart.continuous.len()..]),
                }
            });
            run.sights.push(Sight {
                reaction,
                situation: e.situation(),
                enabled: observing.transitions.iter().map(|t| holds(e, t.enabled)).collect(),
                cleared: observing.transitions.iter().map(|t| holds(e, t.cleared)).collect(),
                rest,
            });
        });
        let acting = listed(&evaluator, &observing.actions, &actions[..chart.continuous.len()]);
        run.acting.push(if all { acting } else { Vec::new() });
    }
    run
}

/// Of each start its place among all, in order.
fn by_text(starts: impl Iterator<Item = u32>) -> Vec<usize> {
    let starts: Vec<u32> = starts.collect();
    let mut sorted = starts.clone();
    sorted.sort_unstable();
    sorted.dedup();
    starts.iter().map(|start| sorted.binary_search(start).expect("it is one of them")).collect()
}

fn differ(chart: &Chart, expected: &Run, actual: &Run) -> Option<String> {
    let places = 0..expected.sights.len().max(actual.sights.len());
    if let Some(place) = places.into_iter().find(|i| expected.sights.get(*i) != actual.sights.get(*i)) {
        let labels: Vec<&str> = chart.steps.iter().map(|step| step.label.as_str()).collect();
        let (expected, actual) = (expected.sights.get(place), actual.sights.get(place));
        return Some(format!("micro-step {place} of {labels:?}\n  simulator {expected:?}\n  program   {actual:?}"));
    }
    let row = (0..expected.acting.len()).find(|row| expected.acting[*row] != actual.acting[*row])?;
    Some(format!("row {row}\n  simulator {:?}\n  program   {:?}", expected.acting[row], actual.acting[row]))
}

#[derive(Default, Debug)]
struct Counts {
    programs: usize,
    micro_steps: usize,
    clearings: usize,
    overlapping: usize,
}

fn compare(chart: &Chart, profile: Profile, stimuli: &[Stimulus], counts: &mut Counts) -> Result<(), String> {
    let profile = Profile { livelock_outputs: LivelockOutputs::Computed, ..profile };
    for (observed, all) in [(Observed::All, true), (Observed::Transitions, false)] {
        let expected = simulated(chart, profile, stimuli, all);
        for (way, options) in exact(profile) {
            let made = caught(|| compile_observed(chart, &options, observed));
            let program = made.map_err(|fault| format!("{way}: {fault}"))?;
            let actual = evaluated(chart, &program, stimuli, all);
            if let Some(fault) = differ(chart, &expected, &actual) {
                return Err(format!("{way}, {observed:?}: {fault}"));
            }
            counts.programs += 1;
            counts.micro_steps += actual.sights.len();
        }
        let cleared = |sight: &Sight| sight.cleared.iter().filter(|cleared| **cleared).count();
        counts.clearings += expected.sights.iter().map(cleared).sum::<usize>();
    }
    overlap(chart, profile, stimuli, counts)
}

/// Where steps overlap, the transitions that clear are the same, one after the other, as far as the overlap cannot be seen
/// and no token comes back at once.
fn overlap(chart: &Chart, profile: Profile, stimuli: &[Stimulus], counts: &mut Counts) -> Result<(), String> {
    if chart.options.over(profile).evolution == Evolution::Scan || has_short_rings(chart) {
        return Ok(());
    }
    let expected = simulated(chart, profile, stimuli, false);
    let clearing = |run: &Run| -> Vec<(usize, Vec<bool>, Vec<bool>)> {
        let clears = |sight: &&Sight| sight.cleared.contains(&true);
        run.sights.iter().filter(clears).map(|s| (s.reaction, s.enabled.clone(), s.cleared.clone())).collect()
    };
    for encoding in Encoding::ALL.into_iter().filter(|encoding| encoding.overlaps()) {
        let options = Options { profile, encoding, simplify: true };
        if overlapping(chart, &options)?.1 || expected.sights.len() > 100 * stimuli.len() {
            continue;
        }
        let program = compile_observed(chart, &options, Observed::Transitions)?;
        let actual = evaluated(chart, &program, stimuli, false);
        let (expected, actual) = (clearing(&expected), clearing(&actual));
        if expected != actual {
            let place = (0..).find(|i| expected.get(*i) != actual.get(*i)).unwrap_or_default();
            let (expected, actual) = (expected.get(place), actual.get(place));
            return Err(format!(
                "{}: clearing {place}\n  simulator {expected:?}\n  program   {actual:?}",
                encoding.name()
            ));
        }
        counts.overlapping += 1;
    }
    Ok(())
}

/// Whether some token can come back in two or three micro-steps.
fn has_short_rings(chart: &Chart) -> bool {
    let mut successors = vec![Vec::new(); chart.steps.len()];
    for transition in &chart.transitions {
        let entries = transition.post.iter().map(|after| match *after {
            Node::Step(s) => s,
            Node::Macro(m) => chart.entry(m),
        });
        let entries: Vec<StepId> = entries.collect();
        for before in &transition.pre {
            let before = match *before {
                Node::Step(s) => s,
                Node::Macro(m) => chart.exit(m),
            };
            successors[before.index()].extend(entries.iter().copied().filter(|after| *after != before));
        }
    }
    let after = |s: StepId| successors[s.index()].iter().copied();
    (0..successors.len())
        .map(StepId::new)
        .any(|s| after(s).flat_map(after).any(|second| second == s || after(second).any(|third| third == s)))
}

fn each(cases: &[Case]) -> Counts {
    let (mut counts, mut faults) = (Counts::default(), Vec::new());
    for case in cases {
        for evolution in [Evolution::Stable, Evolution::Scan] {
            let mut run = || {
                let chart = charts::check(&case.name, &case.text)?;
                let stimuli = charts::stimuli(&case.name, &case.trace, &chart)?;
                compare(&chart, Profile { evolution, ..case.profile }, &stimuli, &mut counts)
            };
            faults.extend(run().err().map(|fault| format!("{}, {evolution:?}, {fault}", case.name)));
        }
    }
    println!("{counts:?}");
    assert!(faults.is_empty(), "{} fail\n{}", faults.len(), faults.join("\n"));
    counts
}

#[test]
fn vectors_are_seen_as_they_run() {
    let counts = each(&charts::cases(&charts::vectors_folder()));
    assert!(counts.clearings > 200 && counts.overlapping >= 10, "{counts:?}");
}

#[test]
fn charts_are_seen_as_they_run() {
    let counts = each(&charts::cases(&charts::charts_folder()));
    assert!(counts.clearings > 200 && counts.overlapping >= 2, "{counts:?}");
}

fn random(kind: ChartKind, seeds: std::ops::Range<u64>) -> Counts {
    let mut counts = Counts::default();
    for seed in seeds {
        let drawn = checked(seed, kind);
        let stimuli = trace(seed, &drawn.chart, 20);
        if let Err(fault) = compare(&drawn.chart, low_bound(profile(seed)), &stimuli, &mut counts) {
            panic!("{kind:?}, seed {}: {fault}\n{}", drawn.seed, drawn.text);
        }
    }
    println!("{kind:?}: {counts:?}");
    counts
}

#[test]
fn random_charts_are_seen_as_they_run() {
    let counts = [
        random(ChartKind::Hierarchical, 7000..7120),
        random(ChartKind::Flat, 7000..7060),
        random(ChartKind::Plain, 7000..7060),
    ];
    assert!(counts.iter().all(|counts| counts.clearings > 1000), "{counts:?}");
}

/// The modules tell the same.
#[test]
fn modules_tell_what_is_seen() {
    let Some(tools) = js::Tools::find_or_skip() else { return };
    let mut jobs = Vec::new();
    let mut expected = Vec::new();
    let mut add = |chart: &Chart, profile: Profile, stimuli: Vec<Stimulus>, turn: usize| {
        let ways = exact(profile);
        let observed = if turn / ways.len() % 2 == 0 { Observed::Transitions } else { Observed::All };
        let program = compile_observed(chart, &ways[turn % ways.len()].1, observed).expect("a program");
        let run = simulated(chart, profile, &stimuli, false);
        let mut known = BTreeSet::new();
        let repeated =
            !chart.transitions.iter().filter_map(|t| t.designation.as_ref()).all(|name| known.insert(name.text()));
        let name = |(t, transition): (usize, &grafc_model::chart::Transition)| match &transition.designation {
            Some(designation) if !repeated => designation.to_string(),
            Some(_) | None => format!("#{}", t + 1),
        };
        let names: Vec<String> = chart.transitions.iter().enumerate().map(name).collect();
        let labels: Vec<String> = chart.steps.iter().map(|step| step.label.to_string()).collect();
        expected.push((run, names, labels, drawn_text(chart)));
        jobs.push(Job { program, stimuli });
    };
    for (turn, case) in charts::cases(&charts::charts_folder()).iter().enumerate() {
        let chart = charts::check(&case.name, &case.text).expect("a chart without errors");
        let stimuli = charts::stimuli(&case.name, &case.trace, &chart).expect("a trace without errors");
        add(&chart, case.profile, stimuli, turn);
    }
    for seed in 8000..8120 {
        let kinds = [ChartKind::Hierarchical, ChartKind::Flat, ChartKind::Hierarchical, ChartKind::Plain];
        let drawn = checked(seed, kinds[seed as usize % 4]);
        let profile = Profile { bound: Some(12), ..profile(seed) };
        add(&drawn.chart, profile, trace(seed, &drawn.chart, 20), seed as usize);
    }
    let told = js::watch(&tools, &jobs).unwrap_or_else(|fault| panic!("{fault}"));
    for ((run, names, labels, text), told) in expected.iter().zip(&told) {
        let of = |holds: &[bool]| -> Vec<String> {
            names.iter().zip(holds).filter(|(_, holds)| **holds).map(|(name, _)| name.clone()).collect()
        };
        assert_eq!(run.sights.len(), told.len(), "{text}");
        for (place, (sight, told)) in run.sights.iter().zip(told).enumerate() {
            let situation: Vec<&String> = sight.situation.iter().map(|s| &labels[s.index()]).collect();
            let last = run.sights.get(place + 1).is_none_or(|next| next.reaction != sight.reaction);
            assert_eq!(told.row, sight.reaction, "{text}");
            assert_eq!(told.enabled, of(&sight.enabled), "row {}, {text}", told.row);
            assert_eq!(told.cleared, of(&sight.cleared), "row {}, {text}", told.row);
            assert_eq!(told.situation.iter().collect::<Vec<_>>(), situation, "row {}, {text}", told.row);
            assert_eq!(told.stable, last, "row {}, {text}", told.row);
        }
    }
}

fn drawn_text(chart: &Chart) -> String {
    grafc_model::dump(chart)
}
