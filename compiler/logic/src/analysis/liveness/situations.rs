//! The situations that a grafcet can come to: those without a way out, steps that are entered while they are active, and
//! joins whose steps are never active all at once.
//!
//! They are looked at twice, each time within bounds. What *may* happen is looked for with one transition at a time, and
//! those that clear whenever it does: it is told with the way that leads there, and only transitions on which inputs and
//! time decide are on that way, so that nothing is told that another grafcet or a variable may prevent. What *never*
//! happens is concluded from all situations, with any transitions clearing at once that are not proved to exclude each
//! other; if there are too many situations, nothing is concluded.

use super::possible::{Never, Why};
use super::region::{Marking, Region};
use crate::analysis::together::questions::Questions;
use grafc_model::chart::{GrafcetId, StepId, TransitionId};
use grafc_net::Net;
use grafc_net::net::Steps;
use index_vec::IndexVec;
use indexmap::IndexMap;
use rustc_hash::{FxBuildHasher, FxHashSet};

/// So much is looked at in a grafcet beyond a share for each of its arcs: steps of situations and transitions after them.
const LOOKED_AT: usize = 20_000;

/// The share of each transition.
const SHARE: usize = 16;

/// Where more transitions than this may clear, not all that may clear at once are looked at.
const AT_ONCE: usize = 6;

/// Initial steps that are asked whether they lie on a circle.
const ASKED: usize = 4;

/// A step that is entered while it is active.
#[derive(Clone, Debug)]
pub(crate) struct Reentry {
    pub(crate) step: StepId,
    /// The transition that leads to it.
    pub(crate) by: TransitionId,
    /// The situation in which that clears.
    pub(crate) situation: Vec<StepId>,
    /// What clears before, one after the other.
    pub(crate) way: Vec<TransitionId>,
}

/// A situation without a way out.
#[derive(Clone, Debug)]
pub(crate) struct DeadEnd {
    pub(crate) grafcet: GrafcetId,
    pub(crate) situation: Vec<StepId>,
    /// What clears before, one after the other.
    pub(crate) way: Vec<TransitionId>,
}

/// What was found.
#[derive(Clone, Default, Debug)]
pub(crate) struct Situations {
    /// At most one a step.
    pub(crate) reentries: Vec<Reentry>,
    /// At most one a grafcet.
    pub(crate) dead_ends: Vec<DeadEnd>,
}

/// Joins that never come about are added to what never happens.
pub(super) fn find(asked: &mut Questions, never: &mut Never) -> Situations {
    let net = asked.analysis.net();
    let mut of_grafcet: IndexVec<GrafcetId, Vec<TransitionId>> = net.grafcets.iter().map(|_| Vec::new()).collect();
    for (t, transition) in net.transitions.iter_enumerated() {
        of_grafcet[transition.grafcet].push(t);
    }
    let refuted: FxHashSet<GrafcetId> = never.transitions.iter().map(|(t, _)| net.transitions[*t].grafcet).collect();
    let mut found = Situations::default();
    let mut joins = Vec::new();
    for (grafcet, transitions) in of_grafcet.iter_enumerated() {
        let mut region = Region::new(asked, never, grafcet, transitions);
        let mut never_at_once = never_at_once(&mut region);
        let (reentries, dead_end) = may_happen(&mut region, &never_at_once);
        // Where a transition is never cleared, the tokens that wait for it are not told of one by one.
        let is_told = never_at_once.is_empty() && !refuted.contains(&grafcet);
        found.reentries.extend(reentries.into_iter().filter(|_| is_told));
        // A transition that is never cleared for another reason is the cause, and told.
        found.dead_ends.extend(dead_end.filter(|_| !refuted.contains(&grafcet)));
        joins.append(&mut never_at_once);
    }
    for t in joins {
        never.clears[t] = true;
        never.transitions.push((t, Why::AtOnce));
    }
    never.transitions.sort_by_key(|(t, _)| *t);
    found
}

/// Situations, each with the one before it and what cleared there.
type Seen = IndexMap<Marking, Option<(usize, TransitionId)>, FxBuildHasher>;

fn effort(region: &Region) -> usize {
    LOOKED_AT + SHARE * region.transitions.len()
}

/// Joins of which each step may be active, but never all of them at once.
fn never_at_once(region: &mut Region) -> Vec<TransitionId> {
    let net = region.net;
    let joins = |t: &&TransitionId| net.transitions[**t].pre.len() > 1;
    if !region.transitions.iter().any(|t| joins(&t)) {
        return Vec::new();
    }
    let mut left = effort(region);
    let mut seen: Seen = region.starts().into_iter().map(|start| (start, None)).collect();
    let mut cleared: FxHashSet<TransitionId> = FxHashSet::default();
    let mut active: FxHashSet<StepId> = FxHashSet::default();
    let mut at = 0;
    while let Some((marking, _)) = seen.get_index(at) {
        let marking = marking.clone();
        let enabled = region.enabled(&marking);
        cleared.extend(&enabled);
        active.extend(marking.iter());
        if enabled.len() > AT_ONCE {
            return Vec::new();
        }
        for set in sets(region, &enabled) {
            let Some(rest) = left.checked_sub(1 + marking.len() + set.len()) else { return Vec::new() };
            left = rest;
            seen.entry(region.after(&marking, &set)).or_insert(None);
        }
        at += 1;
    }
    let is_dead = |t: &&TransitionId| {
        let before = &net.transitions[**t].pre;
        joins(t) && !cleared.contains(*t) && before.iter().all(|step| active.contains(step))
    };
    let told = |t: &&TransitionId| !region.is_never(**t) && region.may_stand(**t);
    region.transitions.iter().filter(is_dead).filter(told).copied().collect()
}

/// The sets of transitions that may clear at once, none of them empty.
fn sets(region: &mut Region, enabled: &[TransitionId]) -> Vec<Vec<TransitionId>> {
    let mut sets: Vec<Vec<TransitionId>> = vec![Vec::new()];
    for t in enabled {
        for index in 0..sets.len() {
            if !sets[index].iter().any(|u| region.excludes(*t, *u)) {
                let with = sets[index].iter().copied().chain([*t]).collect();
                sets.push(with);
            }
        }
    }
    sets.swap_remove(0);
    sets
}

/// Steps entered while they are active, and a situation without a way out, each by a shortest way.
fn may_happen(region: &mut Region, dead: &[TransitionId]) -> (Vec<Reentry>, Option<DeadEnd>) {
    let net = region.net;
    let mut left = effort(region);
    let starts: Vec<Marking> = region.starts().into_iter().filter(|start| !start.is_empty()).collect();
    let mut seen: Seen = starts.iter().map(|start| (start.clone(), None)).collect();
    let ends_count = region.is_alone() && !region.has_sources() && starts.iter().any(|start| comes_back(region, start));
    let mut reentries: Vec<Reentry> = Vec::new();
    let mut entered: FxHashSet<StepId> = FxHashSet::default();
    let mut dead_end = None;
    let mut at = 0;
    while let Some((marking, _)) = seen.get_index(at) {
        let marking = marking.clone();
        let mut enabled = region.enabled(&marking);
        // In order of declaration.
        enabled.retain(|t| dead.binary_search(t).is_err());
        if enabled.is_empty() && ends_count && dead_end.is_none() {
            let (situation, way) = (marking.to_vec(), way(&seen, at));
            dead_end = Some(DeadEnd { grafcet: region.grafcet, situation, way });
        }
        for t in enabled.iter().copied() {
            if !region.is_free(t) {
                continue;
            }
            let cleared = region.with_implied(t, &enabled);
            let Some(rest) = left.checked_sub(1 + marking.len() + enabled.len()) else { return (reentries, dead_end) };
            left = rest;
            let mut leaves: Steps = cleared.iter().flat_map(|t| &net.transitions[*t].pre).copied().collect();
            leaves.sort_unstable();
            let stays = |step: &StepId| marking.binary_search(step).is_ok() && leaves.binary_search(step).is_err();
            for by in cleared.iter().copied().filter(|by| !net.transitions[*by].pre.is_empty()) {
                for step in &net.transitions[by].post {
                    if stays(step) && entered.insert(*step) {
                        let (situation, way) = (marking.to_vec(), way(&seen, at));
                        reentries.push(Reentry { step: *step, by, situation, way });
                    }
                }
            }
            let next = region.after(&marking, &cleared);
            seen.entry(next).or_insert(Some((at, t)));
        }
        at += 1;
    }
    (reentries, dead_end)
}

/// What cleared on the way to a situation.
fn way(seen: &Seen, at: usize) -> Vec<TransitionId> {
    let before = |at: usize| seen.get_index(at).and_then(|(_, before)| *before);
    let mut way: Vec<TransitionId> = std::iter::successors(before(at), |(at, _)| before(*at)).map(|(_, t)| t).collect();
    way.reverse();
    way
}

/// Whether the arcs lead from one of these steps back to it, so that the chart is meant to go round.
fn comes_back(region: &Region, start: &[StepId]) -> bool {
    start.iter().take(ASKED).any(|step| leads_back(region.net, region, *step))
}

fn leads_back(net: &Net, region: &Region, start: StepId) -> bool {
    let mut seen: FxHashSet<StepId> = FxHashSet::default();
    let mut gone_along: FxHashSet<TransitionId> = FxHashSet::default();
    let mut open = vec![start];
    while let Some(step) = open.pop() {
        for t in region.asked.analysis.arcs.leaving(step).iter().filter(|t| gone_along.insert(**t)) {
            for next in &net.transitions[*t].post {
                if *next == start {
                    return true;
                }
                if seen.insert(*next) {
                    open.push(*next);
                }
            }
        }
    }
    false
}
