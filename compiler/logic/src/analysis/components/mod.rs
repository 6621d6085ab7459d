//! Sets of steps of which at most one is active at any time.
//!
//! A set of steps of one grafcet is such a *component* if
//! 1. at most one of its steps is initial, once the start is settled;
//! 2. every transition that leads into the set has exactly one step of the set before it and one after it, and every
//!    transition that leads out of the set or within it has exactly one before and at most one after it;
//! 3. where several transitions leave a step of the set, their conditions exclude each other;
//! 4. if the grafcet is within a step, at most one step of the set has an activation link;
//! 5. each situation that an order forces on the grafcet holds at most one step of the set.
//!
//! Proof, by induction over micro-steps. The start puts at most one token into the set by 1. If no step of the set is
//! active, then by 2 no transition that leads into it clears (R3), and none comes. If one is, then by 3 at most one
//! transition after it clears, by 2 no other transition around the set does, and that one moves the token or takes it
//! away (R4). Then R5: an enclosure that is emptied harms nothing. One that starts was empty, since its enclosing step
//! was inactive, and nothing in it has cleared: by 4 the links bring at most one token. An order leaves what it finds
//! or makes the situation the forced one, and then 5 holds.
//!
//! What follows is used to keep formulas short: where nothing but clearings acts on a step, the step that the token
//! comes to was inactive, and a clearing that does not lead back changes the situation. What does not follow: that the
//! token moves along transitions. A link and an order bring one from nowhere, and an order also from any step to any
//! step that it forces.
//!
//! The search is greedy and its work is bounded by the size of the net: what it does not find stays unproved, and the
//! formulas stay longer.

mod cover;
mod family;
mod reason;
mod search;
#[cfg(test)]
mod tests;

pub(crate) use reason::Reason;

use crate::lower::cover::Cover;

use cover::Arranged;
use grafc_formula::exclusion::EdgeFacts;
use grafc_formula::{FormulaId, Pool};
use grafc_model::chart::{StepId, TransitionId};
use grafc_net::net::{Forced, Grafcet};
use grafc_net::{Arcs, Net};
use index_vec::IndexVec;
use search::Search;

/// More transitions than this out of one step are not compared pair by pair.
const COMPARED: usize = 12;

/// No more components than this are remembered for one step.
const REMEMBERED: usize = 8;

/// Components are written out for the steps that they share with others until this many steps for each step of the net
/// have been looked at.
const WRITTEN: usize = 32;

/// The components that were found.
#[derive(Clone)]
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

/// What has been found.
pub(crate) struct FoundComponents {
    pub(crate) components: Components,
    pub(crate) cover: Cover,
    /// Why each step that the cover leaves out stays a bit.
    pub(crate) reasons: Vec<(StepId, Reason)>,
}

/// Finds components that cover as many steps as possible.
pub(crate) fn find(
    net: &Net,
    arcs: &Arcs,
    facts: &EdgeFacts,
    pool: &Pool,
    conditions: &IndexVec<TransitionId, FormulaId>,
) -> FoundComponents {
    let arranged = search(net, arcs, facts, pool, conditions);
    let mut components = Components { of_step: net.places.iter().map(|_| Vec::new()).collect() };
    for (number, set) in arranged.cover.sets.iter().enumerate() {
        set.steps.iter().for_each(|s| components.of_step[*s].push(number));
    }
    let mut work = WRITTEN * net.places.len();
    for number in 0..arranged.cover.sets.len() {
        arranged.rest(number, &mut work, |s| {
            let list = &mut components.of_step[s];
            if list.len() < REMEMBERED {
                list.push(number);
            }
        });
    }
    FoundComponents { components, cover: arranged.cover, reasons: arranged.reasons }
}

fn search(
    net: &Net,
    arcs: &Arcs,
    facts: &EdgeFacts,
    pool: &Pool,
    conditions: &IndexVec<TransitionId, FormulaId>,
) -> Arranged {
    let around = Surroundings::new(net, arcs);
    let undecided = net.places.indices().map(|s| {
        let leaving = arcs.leaving(s);
        if leaving.len() > COMPARED {
            return Some(Reason::Many(leaving.len()));
        }
        let mut pairs = leaving.iter().enumerate().flat_map(|(i, a)| leaving[i + 1..].iter().map(move |b| (*a, *b)));
        let together = pairs.find(|(a, b)| !facts.exclude(pool, conditions[*a], conditions[*b]));
        together.map(|(a, b)| Reason::Together(a, b))
    });
    let undecided = undecided.collect();
    let mut search = Search::new(net, &around, undecided);
    search.run();
    cover::arrange(net, &around, search)
}

/// What lies around each step.
struct Surroundings<'a> {
    arcs: &'a Arcs,
    /// The orders that force a step, numbered through the net.
    forced_by: IndexVec<StepId, Vec<usize>>,
    /// How many orders there are that force a set of steps.
    orders: usize,
}

impl<'a> Surroundings<'a> {
    fn new(net: &Net, arcs: &'a Arcs) -> Self {
        let forced_by = net.places.iter().map(|_| Vec::new()).collect();
        let mut around = Surroundings { arcs, forced_by, orders: 0 };
        for grafcet in &net.grafcets {
            for steps in forced(grafcet) {
                steps.iter().for_each(|s| around.forced_by[*s].push(around.orders));
                around.orders += 1;
            }
        }
        around
    }

    fn entering(&self, s: StepId) -> &'a [TransitionId] {
        self.arcs.entering(s)
    }

    fn leaving(&self, s: StepId) -> &'a [TransitionId] {
        self.arcs.leaving(s)
    }
}

/// The sets of steps that orders force on a grafcet.
fn forced(grafcet: &Grafcet) -> impl Iterator<Item = &[StepId]> {
    grafcet.orders.iter().filter_map(|order| match &order.forced {
        Forced::Steps(steps) => Some(steps.as_slice()),
        Forced::Current => None,
    })
}
