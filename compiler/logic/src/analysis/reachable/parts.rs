//! The connected parts of a net: steps of one grafcet that transitions connect, whatever leads where.
//!
//! No transition touches two parts, so that the situation of each evolves by itself, except for what conditions read of
//! others.

use crate::analysis::canonical::Canonical;
use grafc_model::chart::{StepId, TransitionId};
use grafc_net::net::{Forced, Place};
use index_vec::IndexVec;

/// A part, its ids canonical.
pub(crate) struct Part {
    /// Its steps as a search along the transitions meets them, from those first where tokens start: what lies on one
    /// branch lies together.
    pub(crate) steps: Vec<StepId>,
    pub(crate) transitions: Vec<TransitionId>,
    /// Arcs of its transitions.
    pub(crate) arcs: usize,
}

/// All parts, by their first step.
pub(crate) fn parts(canonical: &Canonical) -> Vec<Part> {
    let net = &canonical.net;
    let mut linked: IndexVec<StepId, StepId> = net.places.indices().collect();
    for transition in &net.transitions {
        let mut around = transition.pre.iter().chain(&transition.post);
        let Some(first) = around.next() else { continue };
        for s in around {
            let (a, b) = (root(&mut linked, *first), root(&mut linked, *s));
            linked[a.max(b)] = a.min(b);
        }
    }
    let mut number: IndexVec<StepId, Option<usize>> = net.places.iter().map(|_| None).collect();
    let mut parts: Vec<Part> = Vec::new();
    let mut members: Vec<Vec<StepId>> = Vec::new();
    for s in net.places.indices() {
        let first = root(&mut linked, s);
        let part = *number[first].get_or_insert_with(|| {
            parts.push(Part { steps: Vec::new(), transitions: Vec::new(), arcs: 0 });
            members.push(Vec::new());
            parts.len() - 1
        });
        number[s] = Some(part);
        members[part].push(s);
    }
    for (t, transition) in net.transitions.iter_enumerated() {
        let Some(first) = transition.pre.iter().chain(&transition.post).next() else { continue };
        let Some(part) = number[*first] else { continue };
        parts[part].transitions.push(t);
        parts[part].arcs += transition.pre.len() + transition.post.len();
    }
    let mut met: IndexVec<StepId, bool> = net.places.iter().map(|_| false).collect();
    // How many of the steps after each transition have been met through it: what many steps come before is gone along once.
    let mut through: IndexVec<TransitionId, usize> = net.transitions.iter().map(|_| 0).collect();
    for (part, members) in parts.iter_mut().zip(members) {
        let starts = |s: &StepId| starts_active(&net.places[*s]) || net.places[*s].activated;
        let (first, others): (Vec<StepId>, Vec<StepId>) = members.into_iter().partition(starts);
        for start in first.into_iter().chain(others) {
            let mut next = Some(start);
            // Steps on the way, each with the number of the transition after it that is gone along.
            let mut way: Vec<(StepId, usize)> = Vec::new();
            loop {
                if let Some(s) = next.take().filter(|s| !met[*s]) {
                    met[s] = true;
                    part.steps.push(s);
                    way.push((s, 0));
                }
                let Some((s, at)) = way.last_mut() else { break };
                let Some(t) = canonical.arcs.leaving(*s).get(*at) else {
                    way.pop();
                    continue;
                };
                next = net.transitions[*t].post.get(through[*t]).copied();
                match next {
                    Some(_) => through[*t] += 1,
                    None => *at += 1,
                }
            }
        }
    }
    parts
}

/// Whether a step is active at the start.
fn starts_active(place: &Place) -> bool {
    place.initial
}

fn root(linked: &mut IndexVec<StepId, StepId>, mut s: StepId) -> StepId {
    while linked[s] != s {
        linked[s] = linked[linked[s]];
        s = linked[s];
    }
    s
}

impl Part {
    /// The situations that nothing but the start, an enclosing step or an order brings about, each as its active steps.
    pub(super) fn starts(&self, canonical: &Canonical) -> Vec<Vec<StepId>> {
        let net = &canonical.net;
        let Some(place) = self.steps.first().map(|s| &net.places[*s]) else { return Vec::new() };
        let those = |wanted: &dyn Fn(StepId) -> bool| self.steps.iter().copied().filter(|s| wanted(*s)).collect();
        let mut starts: Vec<Vec<StepId>> = vec![those(&|s| starts_active(&net.places[s]))];
        if !place.within.is_empty() {
            starts.push(Vec::new());
            starts.push(those(&|s| net.places[s].activated));
        }
        for order in &net.grafcets[place.grafcet].orders {
            match &order.forced {
                Forced::Steps(forced) => starts.push(those(&|s| forced.binary_search(&s).is_ok())),
                Forced::Current => {}
            }
        }
        starts
    }
}
