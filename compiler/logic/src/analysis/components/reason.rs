//! Why a step shares a state with none.

use grafc_model::chart::{StepId, TransitionId};

/// Why no component was found that holds a step.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Reason {
    /// Two transitions after it were not proved to exclude each other.
    Together(TransitionId, TransitionId),
    /// So many transitions leave it that they are not compared.
    Many(usize),
    /// A source transition leads to it.
    Source(TransitionId),
    /// A transition leads to it only from steps that stay bits.
    From(TransitionId),
    /// A transition leads to it from steps of which none goes together with it.
    Origin(TransitionId),
    /// Two steps before a transition would go together with it.
    Before(TransitionId, StepId, StepId),
    /// Two steps after a transition would go together with it.
    After(TransitionId, StepId, StepId),
    /// Two initial steps would go together with it.
    Initial(StepId, StepId),
    /// Two steps with activation links would go together with it.
    Links(StepId, StepId),
    /// Two steps that one order forces would go together with it.
    Forced(StepId, StepId),
    /// The search has taken too much work.
    GivenUp,
}
