//! Which steps share a variable: given to the lowering, which holds the situation accordingly.

use grafc_model::chart::{GrafcetId, StepId};
use grafc_net::Net;
use grafc_net::net::Forced;
use index_vec::IndexVec;

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

impl Cover {
    /// Whether nothing has to wait: without enclosures, forced situations and stored actions, and with a set for every
    /// step, a transition moves its states and switches their outputs itself.
    pub(crate) fn moves_in_place(&self, net: &Net) -> bool {
        let enclosed = net.places.iter().any(|place| place.within.is_some());
        let covered = self.of_step.iter().all(Option::is_some);
        covered && !enclosed && net.stored.is_empty() && net.grafcets.indices().all(|g| !is_forced(net, g))
    }
}

/// Whether an order sets the situation of a grafcet.
pub(crate) fn is_forced(net: &Net, g: GrafcetId) -> bool {
    net.grafcets[g].orders.iter().any(|order| matches!(order.forced, Forced::Steps(_)))
}
