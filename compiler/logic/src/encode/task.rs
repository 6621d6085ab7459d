//! What an encoding is given, and what decides on a step.

use super::outputs::Followers;
use crate::analysis::components::Components;
use crate::options::Encoding;
use crate::scan::VarId;
use grafc_formula::FormulaId;
use grafc_model::chart::TransitionId;
use grafc_net::Arcs;
use index_vec::IndexVec;
use rustc_hash::FxHashMap;

/// What an encoding is given.
pub(crate) struct Task<'a> {
    /// The encoding.
    pub(crate) encoding: Encoding,
    /// Whether formulas are shortened by what has been proved.
    pub(crate) simplify: bool,
    /// The transitions around each step.
    pub(crate) arcs: &'a Arcs,
    /// The condition of each transition.
    pub(crate) conditions: &'a IndexVec<TransitionId, FormulaId>,
    /// The expression of each stored action on an event, by the number of the action.
    pub(crate) events: &'a FxHashMap<usize, FormulaId>,
    /// The expression of each pulse order on an event, by the number of the order.
    pub(crate) pulses: &'a FxHashMap<usize, FormulaId>,
    /// Sets of steps that exclude each other, as far as that may be used.
    pub(crate) components: &'a Components,
    /// Outputs that follow a state.
    pub(crate) followers: Option<&'a Followers>,
    /// Tells that another micro-step is needed, if there may be one.
    pub(crate) again: Option<VarId>,
}

/// What decides on the next activity of one step.
pub(crate) struct SetReset {
    /// Its activity.
    pub(crate) active: FormulaId,
    /// Whether a transition before it clears.
    pub(crate) set: FormulaId,
    /// What resets it: a transition after it that clears or, where steps overlap, a successor that is active.
    pub(crate) reset: FormulaId,
}
