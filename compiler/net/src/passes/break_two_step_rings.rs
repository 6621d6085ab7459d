//! Puts a place into each ring of two places (Shalyto, 12.1).
//!
//! Before:  `1 -t1-> 2 -t2-> 1`      After:  `1 -t1-> 2 -t2-> 2_1 -1-> 1`
//!
//! Where a place is reset by the activity of the one that it hands its token to, two places that hand over to each other
//! never do: the one that still has the token keeps the other from being set. With a third place in the ring the token
//! gets around. The place serves all transitions that lead back to one place; it is no step of the chart.
//!
//! A transition hands over from the places that it deactivates to those that it activates. One that it keeps, before it
//! as well as after, is neither.

use super::Pass;
use crate::Labels;
use crate::net::{Fact, Net, Place, Transition};
use grafc_diagnostics::Diagnostics;
use grafc_model::chart::{Expr, ExprId, ExprKind, StepId, TransitionId, Type, Value};
use index_vec::IndexVec;
use smallvec::smallvec;

pub const PASS: Pass = Pass {
    name: "break-two-step-rings",
    requires: &[Fact::NoMacroSteps],
    ensures: &[Fact::NoTwoStepRings],
    for_overlap: true,
    run,
};

/// The search looks at at most this many places for each place and arc of the net. What it has not looked at then is
/// taken for a ring: a place too many does no harm.
const EFFORT: usize = 64;

fn run(net: &mut Net, _diagnostics: &mut Diagnostics) {
    let found = rings(net);
    if found.is_empty() {
        return;
    }
    let span = net.transitions[found[0].back[0]].span;
    let always = net.exprs.push(Expr { kind: ExprKind::Literal(Value::Bool(true)), ty: Type::Bool, span });
    let mut labels = Labels::of(net);
    let mut made: IndexVec<StepId, Option<StepId>> = net.places.iter().map(|_| None).collect();
    for ring in &found {
        made[ring.first] = Some(insert(net, ring, always, &mut labels));
    }
    redirect(net, &found, &made);
    // The new place counts as the one after it where activity is asked for.
    for m in &mut net.macro_steps {
        let added: Vec<StepId> = m.places.iter().filter_map(|s| made[*s]).collect();
        m.places.extend(added);
    }
}

/// Places that a place hands over to and that hand over to it.
struct Ring {
    /// The place, declared before the others.
    first: StepId,
    /// One of the others.
    other: StepId,
    /// The transitions that hand over to the first.
    back: Vec<TransitionId>,
}

fn rings(net: &Net) -> Vec<Ring> {
    let flow = Flow::new(net);
    let mut effort = EFFORT * flow.size;
    let mut work = |places: &[StepId]| {
        effort = effort.saturating_sub(places.len());
        effort > 0
    };
    let mut found = Vec::new();
    // The place whose successors were marked last, by successor.
    let mut follows: IndexVec<StepId, Option<StepId>> = net.places.iter().map(|_| None).collect();
    for first in net.places.indices() {
        let mut known = true;
        for t in &flow.out_of[first] {
            known = known && work(&flow.gives[*t]);
            if known {
                flow.gives[*t].iter().for_each(|s| follows[*s] = Some(first));
            }
        }
        let mut other = None;
        let mut back = Vec::new();
        for t in flow.into[first].iter().filter(|_| !flow.out_of[first].is_empty()) {
            let takes = &flow.takes[*t];
            known = known && work(takes);
            let partner =
                takes.iter().rev().take_while(|s| **s > first).find(|s| !known || follows[**s] == Some(first));
            if let Some(partner) = partner {
                other.get_or_insert(*partner);
                back.push(*t);
            }
        }
        found.extend(other.map(|other| Ring { first, other, back }));
    }
    found
}

/// Makes the place between the others and the first, and the transition from it to the first.
fn insert(net: &mut Net, ring: &Ring, always: ExprId, labels: &mut Labels) -> StepId {
    let Place { grafcet, ref within, .. } = net.places[ring.first];
    let within = within.clone();
    let span = net.transitions[ring.back[0]].span;
    let joined = format!("{}_{}", net.places[ring.other].label, net.places[ring.first].label);
    let label = labels.unused(joined.into());
    let between = net.places.push(Place { within: within.clone(), ..Place::auxiliary(label, grafcet, span) });
    net.grafcets[grafcet].steps.push(between);
    let onwards = Transition::auxiliary(grafcet, smallvec![between], smallvec![ring.first], always, span);
    net.transitions.push(Transition { within, ..onwards });
    between
}

/// Makes the transitions back lead to the new places. Each transition is gone through once, however wide it is.
fn redirect(net: &mut Net, rings: &[Ring], made: &IndexVec<StepId, Option<StepId>>) {
    let mut back: IndexVec<TransitionId, Vec<StepId>> = net.transitions.iter().map(|_| Vec::new()).collect();
    for ring in rings {
        ring.back.iter().for_each(|t| back[*t].push(ring.first));
    }
    let mut redirected: IndexVec<StepId, Option<TransitionId>> = made.iter().map(|_| None).collect();
    for (t, firsts) in back.iter_enumerated().filter(|(_, firsts)| !firsts.is_empty()) {
        firsts.iter().for_each(|s| redirected[*s] = Some(t));
        for s in &mut net.transitions[t].post {
            if redirected[*s] == Some(t)
                && let Some(between) = made[*s]
            {
                *s = between;
            }
        }
    }
}

/// Which transitions hand over from where to where.
struct Flow {
    /// The places before a transition that it deactivates, in order of declaration.
    takes: IndexVec<TransitionId, Vec<StepId>>,
    /// The places after a transition that it activates.
    gives: IndexVec<TransitionId, Vec<StepId>>,
    /// The transitions that deactivate a place.
    out_of: IndexVec<StepId, Vec<TransitionId>>,
    /// The transitions that activate a place.
    into: IndexVec<StepId, Vec<TransitionId>>,
    /// Places and arcs.
    size: usize,
}

impl Flow {
    fn new(net: &Net) -> Self {
        let none = || -> IndexVec<StepId, Vec<TransitionId>> { net.places.iter().map(|_| Vec::new()).collect() };
        let mut flow = Flow {
            takes: IndexVec::with_capacity(net.transitions.len()),
            gives: IndexVec::with_capacity(net.transitions.len()),
            out_of: none(),
            into: none(),
            size: net.places.len(),
        };
        // The last transition that touched a place, to tell what it keeps in one pass.
        let mut before: IndexVec<StepId, Option<TransitionId>> = net.places.iter().map(|_| None).collect();
        let mut after = before.clone();
        for (t, transition) in net.transitions.iter_enumerated() {
            transition.pre.iter().for_each(|s| before[*s] = Some(t));
            transition.post.iter().for_each(|s| after[*s] = Some(t));
            let mut takes: Vec<StepId> = transition.pre.iter().copied().filter(|s| after[*s] != Some(t)).collect();
            let gives: Vec<StepId> = transition.post.iter().copied().filter(|s| before[*s] != Some(t)).collect();
            takes.sort_unstable();
            takes.iter().for_each(|s| flow.out_of[*s].push(t));
            gives.iter().for_each(|s| flow.into[*s].push(t));
            flow.size += transition.pre.len() + transition.post.len();
            flow.takes.push(takes);
            flow.gives.push(gives);
        }
        flow
    }
}
