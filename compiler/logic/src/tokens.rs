//! Sets of steps of which at most one is active at any time.
//!
//! A set of steps of one grafcet is such a *component* if
//! 1. at most one of its steps is initial, once the start is settled;
//! 2. every transition that leads into the set has exactly one step of the set before it and one after it, and every
//!    transition that leads out of the set or within it has exactly one before and at most one after it;
//! 3. where several transitions leave a step of the set, their conditions exclude each other;
//! 4. if the grafcet is within a step, at most one step of the set bears an activation link;
//! 5. each situation that an order forces on the grafcet holds at most one step of the set.
//!
//! Proof, by induction over micro-steps. The start puts at most one token into the set by 1. If no step of the set is
//! active, then by 2 no transition that leads into it clears (R3), and none comes. If one is, then by 3 at most one
//! transition after it clears, by 2 no other transition around the set does, and that one moves the token or takes it
//! away (R4). Then R5: an enclosure that is emptied harms nothing. One that starts was empty, for its enclosing step was
//! inactive, and nothing in it has cleared: by 4 the links bring at most one token. An order leaves what it finds or
//! makes the situation the forced one, and then 5 holds.
//!
//! What follows is used to keep formulas short: where nothing but clearings acts on a step, the step that the token
//! comes to was inactive, and a clearing that does not lead back changes the situation. What does not follow: that the
//! token moves along transitions. A link and an order bring one from nowhere, and an order also from any step to any
//! step that it forces.
//!
//! The search is greedy and its work is bounded by the size of the net: what it does not find stays unproved, and the
//! formulas stay longer.

use crate::exclusion::EdgeFacts;
use crate::formula::{FormulaId, Pool};
use crate::lower::EdgeOperand;
use grafc_model::chart::{StepId, TransitionId};
use grafc_net::Net;
use grafc_net::net::Forced;
use index_vec::IndexVec;
use rustc_hash::FxHashMap;

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
    /// No component at all.
    pub(crate) fn none(net: &Net) -> Self {
        Components { of_step: net.places.iter().map(|_| Vec::new()).collect() }
    }

    /// Components that hold a step, by number; not all of them if there are many.
    pub(crate) fn of(&self, step: StepId) -> &[usize] {
        &self.of_step[step]
    }

    /// Whether a step lies in a component.
    pub(crate) fn covers(&self, step: StepId) -> bool {
        !self.of_step[step].is_empty()
    }
}

/// A partition of steps into sets that exclude each other; what is in none stays a bit.
#[derive(Clone, Debug)]
pub(crate) struct Cover {
    /// By their first step.
    pub(crate) sets: Vec<CoverSet>,
    /// The set that holds a step.
    pub(crate) of_step: IndexVec<StepId, Option<usize>>,
}

/// Steps of one component.
#[derive(Clone, Debug)]
pub(crate) struct CoverSet {
    /// In order of declaration.
    pub(crate) steps: Vec<StepId>,
    /// Whether exactly one of them is active, always.
    pub(crate) always_marked: bool,
}

/// What has been found.
pub(crate) struct Analysis {
    pub(crate) components: Components,
    pub(crate) cover: Cover,
}

/// Finds components that cover as many steps as possible.
pub(crate) fn analyse(
    net: &Net,
    pool: &Pool,
    edges: &[EdgeOperand],
    conditions: &IndexVec<TransitionId, FormulaId>,
) -> Analysis {
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
    let cover = cover(net, &found);
    Analysis { components: found, cover }
}

/// Each step goes to the first component that holds it.
fn cover(net: &Net, found: &Components) -> Cover {
    let mut number: FxHashMap<usize, usize> = FxHashMap::default();
    let mut sets: Vec<CoverSet> = Vec::new();
    let of_step = net.places.indices().map(|s| {
        let component = *found.of(s).first()?;
        let set = *number.entry(component).or_insert_with(|| {
            sets.push(CoverSet { steps: Vec::new(), always_marked: false });
            sets.len() - 1
        });
        sets[set].steps.push(s);
        Some(set)
    });
    let of_step = of_step.collect();
    Cover { sets, of_step }
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

    /// Conditions 1, 2, 4 and 5, word for word.
    fn holds(&self, component: &[StepId], mark: usize) -> bool {
        let members = |steps: &[StepId]| steps.iter().filter(|s| self.member[**s] == mark).count();
        let fits = |t: &TransitionId| {
            let transition = &self.net.transitions[*t];
            members(&transition.pre) == 1 && members(&transition.post) <= 1
        };
        let places = || component.iter().map(|s| &self.net.places[*s]);
        let orders = places().next().map_or(&[][..], |place| &self.net.grafcets[place.grafcet].orders);
        places().filter(|place| place.initial).count() <= 1
            && places().filter(|place| place.activated && place.within.is_some()).count() <= 1
            && orders.iter().all(|order| match &order.forced {
                Forced::Steps(steps) => members(steps) <= 1,
                Forced::Current => true,
            })
            && component
                .iter()
                .all(|s| self.arcs.entering[*s].iter().all(fits) && self.arcs.leaving[*s].iter().all(fits))
    }
}
