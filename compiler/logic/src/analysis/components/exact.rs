//! The cover of parts of which all situations are known.
//!
//! Where the search for components has covered every step that any set can hold, its sets stay. Otherwise the steps are
//! shared out anew: each goes to the first set that it may be in, in the order of the part.

use super::Written;
use super::reason::Reason;
use crate::analysis::reachable::{Reachable, Reached};
use crate::analysis::rivals::Rivals;
use crate::lower::cover::CoverSet;
use grafc_model::chart::{StepId, TransitionId};
use grafc_net::{Arcs, Net};
use rustc_hash::{FxHashMap, FxHashSet};

/// Brings sets, and the reasons why others are in none, up to what the situations of parts show.
pub(super) fn refine(
    net: &Net,
    arcs: &Arcs,
    rivals: &Rivals,
    reachable: &Reachable,
    all: &mut Vec<Written>,
    reasons: &mut Vec<(StepId, Reason)>,
) {
    if reachable.parts().is_empty() {
        return;
    }
    reasons.retain(|(s, _)| reachable.part(*s).is_none());
    let covered: FxHashSet<StepId> = all.iter().flat_map(|written| &written.set.steps).copied().collect();
    let mut again: FxHashSet<StepId> = FxHashSet::default();
    let mut fresh = Vec::new();
    for part in reachable.parts() {
        let mut held = Vec::new();
        for (place, s) in part.steps.iter().enumerate() {
            match in_no_set(net, arcs, rivals, part, *s) {
                Some(reason) => {
                    debug_assert!(!covered.contains(s), "step {} is in a component", net.places[*s].label);
                    reasons.push((*s, reason));
                }
                None => held.push(place),
            }
        }
        if held.iter().any(|place| !covered.contains(&part.steps[*place])) {
            again.extend(&part.steps);
            fresh.extend(shared_out(arcs, reachable, part, &held));
        }
    }
    all.retain(|written| !written.set.steps.iter().any(|s| again.contains(s)));
    for written in all.iter_mut() {
        let Some(part) = written.set.steps.first().and_then(|s| reachable.part(*s)) else { continue };
        let place: FxHashMap<StepId, usize> = part.steps.iter().enumerate().map(|(place, s)| (*s, place)).collect();
        let places: Vec<usize> = written.set.steps.iter().map(|s| place[s]).collect();
        written.set.always_marked |= always_marked(arcs, part, &places);
    }
    all.extend(fresh);
}

/// Why no set can hold a step.
fn in_no_set(net: &Net, arcs: &Arcs, rivals: &Rivals, part: &Reached, s: StepId) -> Option<Reason> {
    for t in arcs.leaving(s) {
        let shares = |u: &&TransitionId| net.transitions[**u].pre.contains(&s);
        if let Some(u) = rivals.of(*t).iter().filter(shares).find(|u| part.meet(*t, **u)) {
            return Some(Reason::Together(*t.min(u), *t.max(u)));
        }
    }
    for t in arcs.entering(s) {
        if net.transitions[*t].pre.is_empty() {
            return Some(Reason::Source(*t));
        }
        if part.enters_active(*t, s) {
            return Some(Reason::Entered(*t));
        }
    }
    None
}

/// Sets for the steps at these places, none of which is ever active together with another of its set.
fn shared_out(arcs: &Arcs, reachable: &Reachable, part: &Reached, held: &[usize]) -> Vec<Written> {
    let apart = |a: usize, b: usize| reachable.together(part.steps[a], part.steps[b]) == Some(false);
    let mut sets: Vec<Vec<usize>> = Vec::new();
    for place in held {
        match sets.iter_mut().find(|set| set.iter().all(|other| apart(*place, *other))) {
            Some(set) => set.push(*place),
            None => sets.push(vec![*place]),
        }
    }
    let written = |set: Vec<usize>| {
        let mut component = set.clone();
        for place in held {
            if !set.contains(place) && component.iter().all(|other| apart(*place, *other)) {
                component.push(*place);
            }
        }
        let steps = |places: &[usize]| {
            let mut steps: Vec<StepId> = places.iter().map(|place| part.steps[*place]).collect();
            steps.sort_unstable();
            steps
        };
        let set_of = CoverSet { steps: steps(&set), always_marked: always_marked(arcs, part, &set) };
        Written { others: steps(&component[set.len()..]), set: set_of }
    };
    sets.into_iter().map(written).collect()
}

/// Whether one of the steps at these places is always active. A transition that never clears is written all the same, so
/// it must not lead out of the set either.
fn always_marked(arcs: &Arcs, part: &Reached, places: &[usize]) -> bool {
    let set: FxHashSet<StepId> = places.iter().map(|place| part.steps[*place]).collect();
    let into: FxHashSet<TransitionId> = set.iter().flat_map(|s| arcs.entering(*s)).copied().collect();
    let keeps = |t: &TransitionId| into.contains(t);
    set.iter().all(|s| arcs.leaving(*s).iter().all(keeps)) && part.always_one_of(places)
}
