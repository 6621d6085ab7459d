//! Makes a child that does nothing but run with steps an enclosure of these steps (rule R15).
//!
//! Before:  steps 1 and 3 of MAIN run the child P, which holds 10, initial, 11 and `10 -t1-> 11`
//!
//! After:   10, 11 and t1 are within 1 or 3, 10 is activated with the first of them; nothing commands P
//!
//! `run` starts P where the first of its steps becomes active and kills it where the last no longer is, and only then: so
//! much do enclosures. Started and killed with one and the same step is run with it. This is all that happens to P if
//! - P is a child, so that it is not active before it is run, and no order sets its situation, which would activate it
//!   while nothing runs it;
//! - the steps are of one grafcet, and neither that nor what is around it is commanded otherwise. Killed anew, it would
//!   kill P and not start it; frozen, it would freeze P;
//! - what P commands, and what its enclosures do, is such a child as well: a kill of P reaches all of it, and what is
//!   enclosed goes the same way, but from another commander.
//!
//! Unlike an enclosure P is not frozen with what is around it (R2), and `frozen_with` stays as it is.

use super::Pass;
use crate::net::{CommandsOn, Fact, Forced, Net, Steps};
use grafc_diagnostics::Diagnostics;
use grafc_model::chart::{Event, GrafcetId, PulseKind, StepId};
use index_vec::IndexVec;

pub const PASS: Pass = Pass {
    name: "nest-children",
    requires: &[Fact::SettledStart, Fact::NoEnclosures],
    ensures: &[Fact::NestedChildren],
    for_overlap: false,
    run,
};

fn run(net: &mut Net, _diagnostics: &mut Diagnostics) {
    if !net.has_commands() {
        return;
    }
    let nested = nested(net);
    for place in &mut net.places {
        if let Some(steps) = &nested[place.grafcet] {
            place.within = steps.clone();
            place.activated = place.started;
        }
    }
    for transition in &mut net.transitions {
        if let Some(steps) = &nested[transition.grafcet] {
            transition.within = steps.clone();
        }
    }
    net.runs.retain(|run| nested[run.grafcet].is_none());
    net.pulses.retain(|pulse| nested[pulse.grafcet].is_none());
}

/// The children that can be nested, each with the steps that run it.
fn nested(net: &Net) -> IndexVec<GrafcetId, Option<Steps>> {
    let on = net.commands_on();
    let below = net.commanded_below();
    let mut nested: IndexVec<GrafcetId, Option<Steps>> =
        net.grafcets.indices().map(|g| run_by(net, g, &on[g])).collect();
    loop {
        let mut changed = false;
        // What commands comes before what it commands: top down for what is around, bottom up for what is below.
        let mut is_free: IndexVec<GrafcetId, bool> = net.grafcets.iter().map(|_| true).collect();
        for g in &net.hierarchy {
            let runs_in = nested[*g].as_ref().map(|steps| net.places[steps[0]].grafcet);
            if runs_in.is_some_and(|parent| !is_free[parent]) {
                nested[*g] = None;
                changed = true;
            }
            is_free[*g] = (on[*g].is_empty() || nested[*g].is_some()) && net.around(*g).is_none_or(|g| is_free[g]);
        }
        for g in net.hierarchy.iter().rev() {
            if nested[*g].is_some() && below[*g].iter().any(|below| nested[*below].is_none()) {
                nested[*g] = None;
                changed = true;
            }
        }
        if !changed {
            return nested;
        }
    }
}

/// The steps that run a child, if it is commanded in no other way and no order sets its situation.
fn run_by(net: &Net, g: GrafcetId, on: &CommandsOn) -> Option<Steps> {
    let grafcet = &net.grafcets[g];
    let is_forced = grafcet.orders.iter().any(|order| matches!(order.forced, Forced::Steps(_)));
    if !grafcet.child || is_forced {
        return None;
    }
    let mut steps: Steps = match on.pulses[..] {
        [] => on.runs.iter().copied().collect(),
        [a, b] if on.runs.is_empty() => started_and_killed_with(net, a, b).into_iter().collect(),
        _ => return None,
    };
    steps.sort_unstable();
    steps.dedup();
    let parent = net.places[*steps.first()?].grafcet;
    steps.iter().all(|s| net.places[*s].grafcet == parent).then_some(steps)
}

/// The step with which one of two pulses starts and the other kills.
fn started_and_killed_with(net: &Net, a: usize, b: usize) -> Option<StepId> {
    let of = |place: usize| (net.pulses[place].kind, net.pulses[place].event);
    match (of(a), of(b)) {
        ((PulseKind::Start, Event::Activation(begin)), (PulseKind::Kill, Event::Deactivation(end)))
        | ((PulseKind::Kill, Event::Deactivation(end)), (PulseKind::Start, Event::Activation(begin)))
            if begin == end =>
        {
            Some(begin)
        }
        _ => None,
    }
}
