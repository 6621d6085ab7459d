//! Sets of steps of which at most one is active at any time.
//!
//! A set is such a *component* if
//! 1. at most one of its steps is initial;
//! 2. every transition that leads into the set has exactly one step of the set before it and one after it, and every
//!    transition that leads out of the set or within it has exactly one before and at most one after it;
//! 3. where several transitions leave a step of the set, their conditions exclude each other in plain sight.
//!
//! Then the start puts at most one token into it, by 3 at most one transition that has a step of the set before it clears
//! in a micro-step, and by 2 that clearing moves the token or takes it away. What follows is used to keep formulas
//! short: the step that the token comes to was inactive, and a clearing that does not lead back changes the situation.
//!
//! The search is greedy and its work is bounded by the size of the net: what it does not find stays unproved, and the
//! formulas stay longer.

use crate::exclusion::EdgeFacts;
use crate::formula::{FormulaId, Pool};
use crate::lower::EdgeOperand;
use grafc_model::chart::{StepId, TransitionId};
use grafc_net::Net;
use index_vec::IndexVec;

/// More transitions than this out of one step are not compared pair by pair.
const COMPARED: usize = 12;

/// No more components than this are remembered for one step.
const REMEMBERED: usize = 8;

/// The search looks at no more than this many steps for each step of the net.
const EFFORT: usize = 32;

/// The components that were found.
pub(crate) struct Components {
    of_step: IndexVec<StepId, Vec<usize>>,
}

impl Components {
    /// Components that hold a step, by number; not all of them if there are many.
    pub(crate) fn of(&self, step: StepId) -> &[usize] {
        &self.of_step[step]
    }

    /// Whether a step lies in a component.
    pub(crate) fn covers(&self, step: StepId) -> bool {
        !self.of_step[step].is_empty()
    }
}

/// Finds components that cover as many steps as possible.
pub(crate) fn analyse(
    net: &Net,
    pool: &Pool,
    edges: &[EdgeOperand],
    conditions: &IndexVec<TransitionId, FormulaId>,
) -> Components {
    let arcs = Arcs::new(net);
    let facts = EdgeFacts::new(edges);
    let decided: IndexVec<StepId, bool> = arcs
        .leaving
        .iter()
        .map(|transitions| {
            transitions.len() <= COMPARED
                && transitions.iter().enumerate().all(|(i, a)| {
                    transitions[i + 1..].iter().all(|b| facts.exclude(pool, conditions[*a], conditions[*b]))
                })
        })
        .collect();
    let mut found = Components { of_step: net.places.iter().map(|_| Vec::new()).collect() };
    let mut search = Search {
        net,
        arcs: &arcs,
        decided: &decided,
        member: net.places.iter().map(|_| usize::MAX).collect(),
        effort: EFFORT * net.places.len(),
    };
    for first in net.places.indices() {
        if found.covers(first) {
            continue;
        }
        if let Some(component) = search.from(first, &found) {
            for s in component {
                if found.of_step[s].len() < REMEMBERED {
                    found.of_step[s].push(first.index());
                }
            }
        }
    }
    found
}

/// The transitions around each step.
struct Arcs {
    entering: IndexVec<StepId, Vec<TransitionId>>,
    leaving: IndexVec<StepId, Vec<TransitionId>>,
}

impl Arcs {
    fn new(net: &Net) -> Self {
        let none = || -> IndexVec<StepId, Vec<TransitionId>> { net.places.iter().map(|_| Vec::new()).collect() };
        let mut arcs = Arcs { entering: none(), leaving: none() };
        for (t, transition) in net.transitions.iter_enumerated() {
            transition.post.iter().for_each(|s| arcs.entering[*s].push(t));
            transition.pre.iter().for_each(|s| arcs.leaving[*s].push(t));
        }
        arcs
    }
}

struct Search<'n> {
    net: &'n Net,
    arcs: &'n Arcs,
    /// Steps out of which at most one transition clears at a time.
    decided: &'n IndexVec<StepId, bool>,
    /// The search that a step was last taken into.
    member: IndexVec<StepId, usize>,
    effort: usize,
}

impl Search<'_> {
    /// A component that holds `first`: follows the token from it, choosing one branch where several start, then goes
    /// back to whatever could bring a token in.
    fn from(&mut self, first: StepId, found: &Components) -> Option<Vec<StepId>> {
        let mark = first.index();
        let mut component = Vec::new();
        let mut forward = vec![first];
        let mut backward = 0;
        self.member[first] = mark;
        loop {
            while let Some(s) = forward.pop() {
                self.effort = self.effort.checked_sub(1)?;
                if !self.decided[s] {
                    return None;
                }
                component.push(s);
                for t in &self.arcs.leaving[s] {
                    let after = &self.net.transitions[*t].post;
                    self.effort = self.effort.checked_sub(after.len())?;
                    if let Some(next) = self.choose(after, mark, found) {
                        self.member[next] = mark;
                        forward.push(next);
                    }
                }
            }
            // Every transition into the component needs one step of it before it.
            let s = *component.get(backward)?;
            for t in &self.arcs.entering[s] {
                let before = &self.net.transitions[*t].pre;
                self.effort = self.effort.checked_sub(before.len())?;
                if before.is_empty() {
                    return None;
                }
                if let Some(next) = self.choose(before, mark, found) {
                    self.member[next] = mark;
                    forward.push(next);
                }
            }
            backward += 1;
            if backward == component.len() && forward.is_empty() {
                break;
            }
        }
        self.holds(&component, mark).then_some(component)
    }

    /// The step to take in where one of `steps` must be a member and none is: one that no component holds yet.
    fn choose(&self, steps: &[StepId], mark: usize, found: &Components) -> Option<StepId> {
        if steps.iter().any(|s| self.member[*s] == mark) {
            return None;
        }
        steps.iter().find(|s| !found.covers(**s)).or(steps.first()).copied()
    }

    /// Conditions 1 and 2, word for word.
    fn holds(&self, component: &[StepId], mark: usize) -> bool {
        let members = |steps: &[StepId]| steps.iter().filter(|s| self.member[**s] == mark).count();
        let fits = |t: &TransitionId| {
            let transition = &self.net.transitions[*t];
            members(&transition.pre) == 1 && members(&transition.post) <= 1
        };
        component.iter().filter(|s| self.net.places[**s].initial).count() <= 1
            && component
                .iter()
                .all(|s| self.arcs.entering[*s].iter().all(fits) && self.arcs.leaving[*s].iter().all(fits))
    }
}
