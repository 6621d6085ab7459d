//! The components that have been found, each as the difference to another one.
//!
//! Where a token is divided, the branches are alike except for themselves: with the first in a component, the others
//! differ from it in their own steps.
//!
//! ```text
//!        ┌─ 2 ─ 3 ─┐        a = {1, 2, 3, 6}
//!  1 ────┤         ├── 6    b = a without {2, 3} and with {4, 5}
//!        └─ 4 ─ 5 ─┘
//! ```
//!
//! So each step has one component that it was first found in, its owner, and all of them together take no more room than
//! the net.

use grafc_model::chart::{StepId, TransitionId};
use grafc_net::Net;
use index_vec::IndexVec;
use rustc_hash::{FxHashMap, FxHashSet};
use std::cell::Cell;

/// A side of a transition.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Side {
    Before,
    After,
}

/// A component.
pub(super) struct Component {
    /// The steps that it was the first to hold.
    pub(super) own: Vec<StepId>,
    /// The component that the other steps come from, and the region that is left out of it.
    pub(super) base: Option<(usize, usize)>,
    /// Its initial step.
    pub(super) initial: Option<StepId>,
    /// Its step with an activation link that counts.
    pub(super) link: Option<StepId>,
    /// Of its own steps, those that orders force, by order.
    pub(super) forced: FxHashMap<usize, StepId>,
}

/// Steps of a component that others leave out.
pub(super) struct Region {
    pub(super) steps: Vec<StepId>,
    /// The transitions around them, and those around a component that leaves them out and the rest of its base.
    pub(super) zone: Vec<TransitionId>,
}

/// All components.
pub(super) struct Family {
    pub(super) components: Vec<Component>,
    pub(super) regions: Vec<Region>,
    left_out: FxHashSet<(usize, StepId)>,
    owner: IndexVec<StepId, Option<usize>>,
    /// The first component with a step of its own at a side of a transition, and that step: there is at most one.
    first_at: IndexVec<TransitionId, [Option<(u32, StepId)>; 2]>,
    /// The same of the other components.
    at: FxHashMap<(TransitionId, Side, usize), StepId>,
    /// The steps of the way that questions have gone so far.
    work: Cell<usize>,
}

impl Family {
    pub(super) fn new(net: &Net) -> Self {
        Family {
            components: Vec::new(),
            regions: Vec::new(),
            left_out: FxHashSet::default(),
            owner: net.places.iter().map(|_| None).collect(),
            first_at: net.transitions.iter().map(|_| [None; 2]).collect(),
            at: FxHashMap::default(),
            work: Cell::new(0),
        }
    }

    /// The work since the last question for it.
    pub(super) fn work(&self) -> usize {
        self.work.replace(0)
    }

    /// The component that a step was first found in.
    pub(super) fn owner(&self, s: StepId) -> Option<usize> {
        self.owner[s]
    }

    /// Whether a step is left out where a region is.
    pub(super) fn leaves_out(&self, region: usize, s: StepId) -> bool {
        self.left_out.contains(&(region, s))
    }

    /// Whether some step at a side of a transition is in some component.
    pub(super) fn is_known(&self, t: TransitionId, side: Side) -> bool {
        self.first_at[t][side as usize].is_some()
    }

    /// Whether a component holds a step.
    pub(super) fn holds(&self, component: usize, s: StepId) -> bool {
        let Some(owner) = self.owner[s] else { return false };
        for (c, left_out) in self.line(component) {
            if c == owner {
                return true;
            }
            if left_out.is_some_and(|region| self.leaves_out(region, s)) {
                return false;
            }
        }
        false
    }

    /// The step of a component at a side of a transition.
    pub(super) fn step_at(&self, t: TransitionId, side: Side, component: usize) -> Option<StepId> {
        let (first, step) = self.first_at[t][side as usize]?;
        let own_of = |c: usize| if c == first as usize { Some(step) } else { self.at.get(&(t, side, c)).copied() };
        let mut own = self.line(component).filter_map(|(c, _)| own_of(c));
        own.find(|s| self.holds(component, *s))
    }

    /// The step of a component that an order forces.
    pub(super) fn forced(&self, order: usize, component: usize) -> Option<StepId> {
        let mut own = self.line(component).filter_map(|(c, _)| self.components[c].forced.get(&order));
        own.find(|s| self.holds(component, **s)).copied()
    }

    /// A component, its base, the base of that and so on, each with the region that it leaves out of the next.
    pub(super) fn line(&self, component: usize) -> impl Iterator<Item = (usize, Option<usize>)> + '_ {
        let mut next = Some(component);
        std::iter::from_fn(move || {
            let here = next?;
            self.work.set(self.work.get() + 1);
            let base = self.components[here].base;
            next = base.map(|(base, _)| base);
            Some((here, base.map(|(_, region)| region)))
        })
    }

    pub(super) fn add_region(&mut self, region: Region) -> usize {
        let number = self.regions.len();
        self.left_out.extend(region.steps.iter().map(|s| (number, *s)));
        self.regions.push(region);
        number
    }

    pub(super) fn add(&mut self, component: Component, around: &super::Surroundings) {
        let number = self.components.len();
        for s in &component.own {
            self.owner[*s] = Some(number);
            let sides = [(around.leaving(*s), Side::Before), (around.entering(*s), Side::After)];
            for (transitions, side) in sides {
                for t in transitions {
                    let (first, _) = *self.first_at[*t][side as usize].get_or_insert((number as u32, *s));
                    if first as usize != number {
                        self.at.insert((*t, side, number), *s);
                    }
                }
            }
        }
        self.components.push(component);
    }
}
