//! Warnings of what may happen leave nothing out: whenever the simulator shows such a thing, there was a warning of it.
//!
//! | code | what is looked for in each micro-step |
//! | --- | --- |
//! | W0408 | a step with a continuous action left by a transition `1`; and a step warned of is in no stable situation |
//! | W0409 | two transitions after one step are cleared |
//! | W0410 | two assignments that read the variable that they write are done |
//! | W0411 | two steps are active that force one grafcet into different situations |
//! | W0412 | two assignments give one variable different values |
//! | W0414, W0415, W0417 | no step said never to be active is, no transition said never to be cleared is |
//! | W0413 | without a warning, code in which steps overlap publishes what the chart does |
//!
//! What each warning claims is on its page in `docs/errors`.

#![allow(clippy::print_stdout, reason = "how much was compared")]

mod enrich;
mod impossible;
mod probes;

use grafc_diagnostics::{Code, Diagnostic, Diagnostics, Span};
use grafc_logic::{Encoding, Options};
use grafc_model::chart::{
    Chart, ExprId, ExprKind, GrafcetId, Order, Situation, StepId, TransitionId, Value, VariableId,
};
use grafc_model::reaction::{Evolution, Profile, Stimulus};
use grafc_model::simulate::Activity;
use grafc_testsuite::compare::first_difference;
use grafc_testsuite::net_steps::same;
use grafc_testsuite::random::profile;
use grafc_testsuite::random::{ChartKind, checked, low_bound, trace};
use grafc_testsuite::runs::{caught, overlapping, run, simulate};
use grafc_testsuite::sights::arcs;
use probes::{Seen, Watched, watch};
use std::collections::{BTreeMap, BTreeSet};

/// The warnings on what a chart may do.
fn warnings(chart: &Chart) -> Diagnostics {
    let mut diagnostics = Diagnostics::new();
    let mut net = grafc_net::build(chart);
    grafc_net::passes::run(&mut net, false, &mut diagnostics);
    diagnostics.append(grafc_logic::warn(&grafc_logic::Analysis::new(net)));
    diagnostics
}

/// Whether a message of the code shows one of the places.
fn warned(diagnostics: &Diagnostics, code: Code, places: &[Span]) -> bool {
    let shows = |d: &Diagnostic| {
        places.contains(&d.primary.span) || d.secondary.iter().any(|label| places.contains(&label.span))
    };
    diagnostics.iter().any(|d| d.code == code && shows(d))
}

/// What was seen, by code: charts that showed it, and charts that were not warned of it.
#[derive(Default)]
struct Counts {
    shown: BTreeMap<Code, usize>,
    silent: BTreeMap<Code, usize>,
}

const CODES: [Code; 4] = [Code::W0409, Code::W0410, Code::W0411, Code::W0412];

/// Looks for all that the warnings on a flat net are about.
fn look(chart: &Chart, watched: &Watched, diagnostics: &Diagnostics, counts: &mut Counts) -> Result<(), String> {
    let mut shown = BTreeSet::new();
    for seen in &watched.seen {
        let found = [(Code::W0409, diverging(chart, seen)), (Code::W0411, contradicting(chart, seen))];
        let found = found.into_iter().flat_map(|(code, all)| all.into_iter().map(move |places| (code, places)));
        for (code, places) in found.chain(meeting(chart, seen)) {
            if !warned(diagnostics, code, &places) {
                let labels = |a: &Activity| -> Vec<&str> {
                    a.iter_enumerated().filter(|(_, on)| **on).map(|(s, _)| chart.steps[s].label.as_str()).collect()
                };
                let (before, after) = (labels(&seen.before), labels(&seen.after));
                return Err(format!("no {code:?} on {places:?}: reaction {}, {before:?} {after:?}", seen.reaction));
            }
            shown.insert(code);
        }
    }
    // Pulse orders that disagree raise the flag as well (R15.1); only of those that are certain to meet there is a warning.
    let is_of_orders = chart.commands().next().is_none();
    let is_raised = is_of_orders && watched.seen.iter().any(|seen| seen.force_conflict);
    if is_raised && diagnostics.iter().all(|d| d.code != Code::W0411) {
        return Err("FORCE_CONFLICT without W0411".to_owned());
    }
    for code in CODES {
        *counts.shown.entry(code).or_default() += usize::from(shown.contains(&code));
        *counts.silent.entry(code).or_default() += usize::from(diagnostics.iter().all(|d| d.code != code));
    }
    Ok(())
}

/// W0409: the steps that two transitions have left together, unless both lead from the same steps to the same.
fn diverging(chart: &Chart, seen: &Seen) -> Vec<Vec<Span>> {
    let mut found = Vec::new();
    for (i, a) in seen.cleared.iter().enumerate() {
        for b in &seen.cleared[i + 1..] {
            let (a, b) = (arcs(chart, *a), arcs(chart, *b));
            let shared: Vec<Span> = a.0.intersection(&b.0).map(|s| chart.steps[*s].span).collect();
            if !shared.is_empty() && a != b {
                found.push(shared);
            }
        }
    }
    found
}

/// W0410 and W0412: the actions on a variable of which two were done.
fn meeting(chart: &Chart, seen: &Seen) -> Vec<(Code, Vec<Span>)> {
    let mut found = Vec::new();
    for (i, (first, one)) in seen.done.iter().enumerate() {
        for (second, other) in &seen.done[i + 1..] {
            let (a, b) = (&chart.stored[*first], &chart.stored[*second]);
            if a.target != b.target {
                continue;
            }
            let places = chart.stored.iter().filter(|action| action.target == a.target).map(|action| action.span);
            if reads(chart, a.value, a.target) && reads(chart, b.value, b.target) {
                found.push((Code::W0410, places.collect()));
            } else if !same(*one, *other) {
                found.push((Code::W0412, places.collect()));
            }
        }
    }
    found
}

/// Whether an expression reads a variable.
fn reads(chart: &Chart, root: ExprId, variable: VariableId) -> bool {
    let mut open = vec![root];
    while let Some(e) = open.pop() {
        if chart.exprs[e].kind == ExprKind::Variable(variable) {
            return true;
        }
        open.extend(chart.exprs[e].kind.operands());
    }
    false
}

/// W0411: the orders on a grafcet of which two disagree.
fn contradicting(chart: &Chart, seen: &Seen) -> Vec<Vec<Span>> {
    let mut found = Vec::new();
    for (g, _) in chart.grafcets.iter_enumerated() {
        let on_it = || chart.orders.iter().filter(move |order| order.grafcet == g);
        let forced: BTreeSet<_> = on_it().filter(|o| seen.after[o.step]).map(|o| situation(chart, o)).collect();
        if forced.len() > 1 {
            found.push(on_it().map(|order| order.span).collect());
        }
    }
    found
}

/// The steps that an order forces; none if it is the current situation.
fn situation(chart: &Chart, order: &Order) -> Option<BTreeSet<StepId>> {
    match &order.situation {
        Situation::Steps(steps) => Some(steps.iter().copied().collect()),
        Situation::Initial => {
            let steps = chart.grafcets[order.grafcet].steps.iter().copied();
            Some(steps.filter(|s| chart.steps[*s].initial).collect())
        }
        Situation::Current => None,
    }
}

/// A restart leads to the initial situation without a transition, so it shows nothing of what clears at once.
fn without_restarts(mut stimuli: Vec<Stimulus>) -> Vec<Stimulus> {
    for stimulus in &mut stimuli {
        stimulus.restart = false;
    }
    stimuli
}

#[test]
fn what_happens_at_once_was_warned_of() {
    let mut counts = Counts::default();
    for kind in [ChartKind::Plain, ChartKind::Flat, ChartKind::Hierarchical] {
        for seed in 7000..7250 {
            let mut drawn = checked(seed, kind);
            // Of a chart that evolves by scans less is to be said.
            if drawn.chart.options.is_scan() {
                continue;
            }
            enrich::for_meetings(drawn.chart.edit(), seed);
            let chart = &drawn.chart;
            let watched = watch(chart, low_bound(profile(seed)), &without_restarts(trace(seed, chart, 40)));
            if let Err(fault) = look(chart, &watched, &warnings(chart), &mut counts) {
                panic!("{kind:?}, seed {}: {fault}\n{}\n{}", drawn.seed, drawn.text, grafc_model::dump(chart));
            }
        }
    }
    println!("of 750 charts shown {:?}, not warned {:?}", counts.shown, counts.silent);
    // Each must have been seen, and must not have been warned of everywhere.
    for code in CODES {
        assert!(counts.shown[&code] >= 20, "{code:?} was shown by {} charts", counts.shown[&code]);
        assert!(counts.silent[&code] >= 75, "{code:?} was not said of {} charts", counts.silent[&code]);
    }
}

/// W0408 says what is certain, so both ways: a step that is left at once is warned of, and one that is warned of never
/// lasts. A transition that clears without end keeps its reaction from being stable, and so does one that activates the
/// step again each time that it is left (see the page of the code).
#[test]
fn a_step_that_is_passed_through_was_warned_of() {
    let (mut left, mut warned_of) = (0, 0);
    for kind in [ChartKind::Flat, ChartKind::Hierarchical] {
        for seed in 8000..8300 {
            let mut drawn = checked(seed, kind);
            // The bound is that of the test.
            drawn.chart.edit().options.bound = None;
            let chart = &drawn.chart;
            // Where a call is one micro-step, a step that is left at once lasts a call.
            if chart.options.is_scan() {
                continue;
            }
            let diagnostics = grafc_model::check(&grafc_syntax::parse(Default::default(), &drawn.text).0, "random").1;
            let watched = watch(chart, low_bound(profile(seed)), &trace(seed, chart, 30));
            let acting: BTreeSet<StepId> = chart.continuous.iter().map(|action| action.step).collect();
            for s in acting {
                let spans: Vec<Span> = chart.continuous.iter().filter(|a| a.step == s).map(|a| a.span).collect();
                let is_warned = warned(&diagnostics, Code::W0408, &spans);
                warned_of += usize::from(is_warned);
                let lasts = watched.stable.iter().any(|active| active[s]);
                assert!(
                    !(is_warned && lasts),
                    "{kind:?}, seed {}: step {} lasts\n{}",
                    drawn.seed,
                    chart.steps[s].label,
                    drawn.text
                );
                let passed = watched.seen.iter().flat_map(|seen| &seen.cleared).any(|t| leaves_at_once(chart, *t, s));
                if passed && !may_be_held(chart, s) {
                    left += 1;
                    assert!(is_warned, "{kind:?}, seed {}: step {}\n{}", drawn.seed, chart.steps[s].label, drawn.text);
                }
            }
        }
    }
    println!("{left} steps were left at once, {warned_of} were warned of");
    assert!(left >= 20 && warned_of >= left, "{left} were left at once, {warned_of} were warned of");
}

/// Whether a transition is always true and leads away from this step alone.
fn leaves_at_once(chart: &Chart, t: TransitionId, s: StepId) -> bool {
    let (before, after) = arcs(chart, t);
    let always = chart.exprs[chart.transitions[t].condition].kind == ExprKind::Literal(Value::Bool(true));
    always && before == BTreeSet::from([s]) && !after.contains(&s)
}

/// Whether an order on its grafcet or on one around it, or a source transition, may keep a step active.
fn may_be_held(chart: &Chart, s: StepId) -> bool {
    let around = |g: &GrafcetId| chart.grafcets[*g].enclosing_step.map(|e| chart.steps[e].grafcet);
    let mut grafcets = std::iter::successors(Some(chart.steps[s].grafcet), around);
    grafcets.any(|g| chart.orders.iter().any(|order| order.grafcet == g))
        || chart.transitions.indices().map(|t| arcs(chart, t)).any(|(pre, post)| pre.is_empty() && post.contains(&s))
}

/// What is said never to happen does not: neither what the message is about nor what it says to follow from that.
#[test]
fn what_is_said_never_to_happen_does_not() {
    let mut said_of: BTreeMap<Code, usize> = BTreeMap::new();
    for kind in [ChartKind::Plain, ChartKind::Flat, ChartKind::Hierarchical] {
        for seed in 10_000..10_400 {
            let mut drawn = checked(seed, kind);
            impossible::change(drawn.chart.edit(), seed);
            let chart = &drawn.chart;
            let said = warnings(chart);
            let (mut idle, mut uncleared) = (BTreeSet::new(), BTreeSet::new());
            for message in &said {
                match message.code {
                    Code::W0414 => {
                        idle.insert(message.primary.span);
                        uncleared.extend(message.secondary.iter().map(|label| label.span));
                    }
                    Code::W0415 => _ = uncleared.insert(message.primary.span),
                    Code::W0417 if message.message.contains("never cleared") => {
                        let of =
                            |t: &&grafc_model::chart::Transition| chart.exprs[t.condition].span == message.primary.span;
                        // Conditions that were put in stand at one place: only what can be told apart is looked at.
                        let found: Vec<_> = chart.transitions.iter().filter(of).collect();
                        uncleared.extend(found.iter().map(|t| t.span).filter(|_| found.len() == 1));
                    }
                    _ => continue,
                }
                *said_of.entry(message.code).or_default() += 1;
            }
            if idle.is_empty() && uncleared.is_empty() {
                continue;
            }
            let watched = watch(chart, low_bound(profile(seed)), &trace(seed, chart, 40));
            for seen in &watched.seen {
                let active =
                    chart.steps.iter_enumerated().find(|(s, step)| seen.after[*s] && idle.contains(&step.span));
                let cleared = seen.cleared.iter().find(|t| uncleared.contains(&chart.transitions[**t].span));
                assert!(
                    active.is_none() && cleared.is_none(),
                    "{kind:?}, seed {seed} ({}): {:?} {cleared:?}\n{said:#?}\n{}",
                    drawn.seed,
                    active.map(|(_, step)| &step.label),
                    grafc_model::dump(chart)
                );
            }
        }
    }
    println!("of 1200 charts: {said_of:?}");
    for code in [Code::W0414, Code::W0415, Code::W0417] {
        assert!(said_of.get(&code).is_some_and(|count| *count >= 40), "{said_of:?}");
    }
}

#[test]
fn an_overlap_that_shows_was_warned_of() {
    let (mut silent, mut shown) = (0, 0);
    for seed in 9000..9400 {
        let mut drawn = checked(seed, ChartKind::Plain);
        enrich::for_overlap(drawn.chart.edit(), seed);
        let chart = &drawn.chart;
        let evolution = if seed % 16 == 0 { Evolution::Scan } else { Evolution::Stable };
        let profile = Profile { evolution, ..Profile::default() };
        let stimuli = trace(seed, chart, 30);
        let expected = simulate(chart, profile, &stimuli);
        for encoding in Encoding::ALL.into_iter().filter(|encoding| encoding.overlaps()) {
            let options = Options { profile, encoding, simplify: true };
            let (program, is_warned) = caught(|| overlapping(chart, &options)).expect("it can be lowered");
            let actual = run(&program, &stimuli);
            let row = first_difference(&expected, &actual);
            shown += usize::from(is_warned && row.is_some());
            silent += usize::from(!is_warned);
            if let (false, Some(row)) = (is_warned, row) {
                let name = encoding.name();
                let (here, there) = (&expected[row], &actual[row]);
                panic!("seed {}, {name}, row {row}:\n{here:?}\n{there:?}\n{}", drawn.seed, grafc_model::dump(chart));
            }
        }
    }
    println!("of 800 programs {silent} without warning, {shown} that showed the overlap");
    assert!(silent >= 100 && shown >= 30, "{silent} without warning, {shown} that showed the overlap");
}
