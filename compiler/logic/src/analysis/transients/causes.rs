//! The graph of causes: what can happen in a micro-step, and what can have brought it about.

use grafc_model::chart::{Event, ExprId, GrafcetId, MacroId, StepId, TransitionId, VariableId};
use grafc_net::Net;
use indexmap::IndexSet;
use rustc_hash::FxBuildHasher;

/// Something that can happen in a micro-step k, said of k > 1; in the first micro-step anything counts that is so at
/// all.
///
/// Values of expressions, wires, macro-steps and grafcets are compared with those of the context before: what a
/// micro-step does to a step or a stored variable shows in them in the next one.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) enum Change {
    /// The transition clears and did not in the micro-step before; if it waits for an edge, just that it clears.
    Clears(TransitionId),
    /// The transition does not clear and did in the micro-step before, although its grafcet is neither frozen nor
    /// within an inactive step.
    Stops(TransitionId),
    /// The step is active after the micro-step and was not before.
    Activated(StepId),
    /// The same, and an activation link or an order did it.
    Placed(StepId),
    /// The step is not active after the micro-step and was before.
    Deactivated(StepId),
    /// The order of that rank comes into force, or its grafcet comes within an active step while it is in force.
    Obeyed(GrafcetId, usize),
    /// The step of an order that wins over the one of that rank is deactivated.
    Overruled(GrafcetId, usize),
    /// An order that forces certain steps of the grafcet comes into force.
    Forced(GrafcetId),
    /// The step of an order on the grafcet, or on one that it is frozen with, is activated.
    Frozen(GrafcetId),
    /// An order on the grafcet that forced certain steps ends.
    Released(GrafcetId),
    /// Another order that froze the grafcet ends.
    Thawed(GrafcetId),
    /// The value of an expression.
    Expr(ExprId, Way),
    /// A stored variable is given another value; or the value of a wire.
    Variable(VariableId, Way),
    /// The activity of a macro-step.
    Macro(MacroId, Way),
    /// The activity of a grafcet.
    Grafcet(GrafcetId, Way),
    /// The event of a stored action, the one of that number, occurs.
    Occurs(usize),
    /// A stored action on clearing, done in the micro-step before, is done again with another outcome.
    Differs(usize),
    /// A stored action on the variable, done in the micro-step before, is not done any more.
    Subsides(VariableId),
}

/// Which way a value changes. Numbers that may change at all may change either way.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) enum Way {
    Up,
    Down,
}

impl Way {
    pub(super) const BOTH: [Way; 2] = [Way::Up, Way::Down];

    pub(super) fn other(self) -> Way {
        match self {
            Way::Up => Way::Down,
            Way::Down => Way::Up,
        }
    }
}

/// Changes by number, and which can cause which.
pub(super) struct Causes {
    changes: IndexSet<Change, FxBuildHasher>,
    /// Cause, effect, and whether the effect comes in the next micro-step or in the same one.
    pub(super) edges: Vec<(u32, u32, bool)>,
    /// Changes that need no cause in the first micro-step.
    pub(super) at_start: Vec<u32>,
}

impl Causes {
    /// With room for what a net of this size usually has.
    pub(super) fn new(net: &Net) -> Causes {
        let size = 4 * (net.places.len() + net.transitions.len());
        let changes = IndexSet::with_capacity_and_hasher(size, FxBuildHasher);
        Causes { changes, edges: Vec::with_capacity(size), at_start: Vec::new() }
    }

    /// `cause` can cause `effect` in the same micro-step.
    pub(super) fn at_once(&mut self, cause: Change, effect: Change) {
        self.edge(cause, effect, false);
    }

    /// `cause` can cause `effect` in the next micro-step.
    pub(super) fn next(&mut self, cause: Change, effect: Change) {
        self.edge(cause, effect, true);
    }

    /// What is new at the start of the reaction can cause it in the first micro-step.
    pub(super) fn start(&mut self, change: Change) {
        let number = self.number(change);
        self.at_start.push(number);
    }

    /// How many changes there are.
    pub(super) fn len(&self) -> usize {
        self.changes.len()
    }

    /// The change of a number.
    pub(super) fn change(&self, number: u32) -> Change {
        self.changes[number as usize]
    }

    /// The changes in the order of their numbers.
    pub(super) fn changes(&self) -> impl Iterator<Item = Change> + '_ {
        self.changes.iter().copied()
    }

    fn edge(&mut self, cause: Change, effect: Change, next: bool) {
        let (cause, effect) = (self.number(cause), self.number(effect));
        self.edges.push((cause, effect, next));
    }

    fn number(&mut self, change: Change) -> u32 {
        self.changes.insert_full(change).0 as u32
    }
}

impl Change {
    /// The transition that clears, whether it cleared before or not.
    pub(super) fn transition(self, net: &Net) -> Option<TransitionId> {
        match self {
            Change::Clears(t) => Some(t),
            Change::Differs(action) => match net.stored[action].event {
                Event::Clearing(t) => Some(t),
                Event::Event(..) | Event::Deactivation(_) | Event::Activation(_) => None,
            },
            Change::Stops(_)
            | Change::Activated(_)
            | Change::Placed(_)
            | Change::Deactivated(_)
            | Change::Obeyed(..)
            | Change::Overruled(..)
            | Change::Forced(_)
            | Change::Frozen(_)
            | Change::Released(_)
            | Change::Thawed(_)
            | Change::Expr(..)
            | Change::Variable(..)
            | Change::Macro(..)
            | Change::Grafcet(..)
            | Change::Occurs(_)
            | Change::Subsides(_) => None,
        }
    }
}
