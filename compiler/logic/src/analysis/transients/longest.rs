//! The longest path through the graph of causes.

use super::causes::{Causes, Effects};
use crate::analysis::parts::Parts;
use grafc_model::chart::TransitionId;
use grafc_net::Net;
use rustc_hash::FxHashMap;
use std::collections::VecDeque;
use std::collections::hash_map::Entry;

/// The last micro-step in which each change can happen, by number, with the cause that comes last, of several the first
/// by number.
pub(super) struct Times {
    last: Vec<Last>,
}

#[derive(Clone, Copy)]
struct Last {
    /// From 1; 0 if it never can.
    time: u32,
    /// [`NONE`] if it can at the start.
    cause: u32,
}

/// No change has this number.
const NONE: u32 = u32::MAX;

/// Where changes can cause each other endlessly.
pub(super) struct Endless {
    /// Transitions that clear in such a circle, in order.
    pub(super) transitions: Vec<TransitionId>,
    /// Those of one way round, as far as transitions take part in it.
    pub(super) cycle: Vec<TransitionId>,
}

impl Times {
    /// Finds them, or that there is no last one. Transitions of which `never` is true do not clear.
    pub(super) fn find(
        net: &Net,
        causes: &Causes,
        effects: &Effects,
        never: &dyn Fn(TransitionId) -> bool,
    ) -> Result<Times, Endless> {
        let possible = |change: u32| !causes.transition(net, change).is_some_and(never);
        let follow = |change: u32, place: usize| effects.of(change).get(place).map(|effect| effect.change());
        let parts = Parts::of(causes.len(), causes.at_start.iter().copied(), follow, possible);
        let is_circle = |part: &[u32]| part.len() > 1 || effects.of(part[0]).iter().any(|e| e.change() == part[0]);
        let circles: Vec<&[u32]> = parts.in_order().filter(|part| is_circle(part)).collect();
        if let Some(first) = circles.first() {
            let all = circles.iter().copied().flatten();
            let mut transitions: Vec<TransitionId> = all.filter_map(|change| causes.transition(net, *change)).collect();
            transitions.sort_unstable();
            transitions.dedup();
            return Err(Endless { transitions, cycle: cycle(net, causes, effects, first) });
        }
        let mut last = vec![Last { time: 0, cause: NONE }; causes.len()];
        for start in causes.at_start.iter().filter(|start| possible(**start)) {
            last[*start as usize].time = 1;
        }
        for change in parts.in_order().flatten() {
            let time = last[*change as usize].time;
            if time == 0 {
                continue;
            }
            for effect in effects.of(*change).iter().filter(|effect| possible(effect.change())) {
                let reached = time + u32::from(effect.is_next());
                let known = &mut last[effect.change() as usize];
                let is_first = known.cause != NONE && *change < known.cause;
                if known.time < reached || known.time == reached && is_first {
                    *known = Last { time: reached, cause: *change };
                }
            }
        }
        Ok(Times { last })
    }

    /// The last micro-step in which a change can happen.
    pub(super) fn of(&self, change: u32) -> Option<u32> {
        Some(self.last[change as usize].time).filter(|time| *time > 0)
    }

    /// A change and what leads to it, the last first.
    pub(super) fn back_from(&self, change: u32) -> impl Iterator<Item = u32> + '_ {
        std::iter::successors(Some(change), |c| Some(self.last[*c as usize].cause).filter(|cause| *cause != NONE))
    }
}

/// The shortest way round within a part from its first transition back to itself.
fn cycle(net: &Net, causes: &Causes, effects: &Effects, part: &[u32]) -> Vec<TransitionId> {
    let transition = |change: u32| causes.transition(net, change);
    let Some(first) = part.iter().copied().filter(|c| transition(*c).is_some()).min_by_key(|c| (transition(*c), *c))
    else {
        return Vec::new();
    };
    let mut member = vec![false; causes.len()];
    part.iter().for_each(|change| member[*change as usize] = true);
    let mut from: FxHashMap<u32, u32> = FxHashMap::default();
    let mut open = VecDeque::from([first]);
    while let Some(change) = open.pop_front().filter(|_| !from.contains_key(&first)) {
        for next in effects.of(change).iter().map(|effect| effect.change()).filter(|next| member[*next as usize]) {
            if let Entry::Vacant(entry) = from.entry(next) {
                entry.insert(change);
                open.push_back(next);
            }
        }
    }
    let mut cycle: Vec<TransitionId> = transition(first).into_iter().collect();
    let mut at = first;
    while let Some(before) = from.get(&at).copied().filter(|change| *change != first) {
        cycle.extend(transition(before));
        at = before;
    }
    // The way was followed back: first, then the last before it, and so on.
    cycle[1..].reverse();
    cycle.dedup();
    cycle
}
