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
    /// A transition may clear while it is active, and leads to it.
    Entered(TransitionId),
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
    /// Pulse orders act in the chart.
    Commanded,
    /// The search has taken too much work.
    GivenUp,
}

impl Reason {
    /// The same by other ids.
    pub(super) fn named(self, s: impl Fn(StepId) -> StepId, t: impl Fn(TransitionId) -> TransitionId) -> Reason {
        match self {
            Reason::Together(a, b) => {
                let (a, b) = (t(a), t(b));
                Reason::Together(a.min(b), a.max(b))
            }
            Reason::Many(count) => Reason::Many(count),
            Reason::Source(a) => Reason::Source(t(a)),
            Reason::Entered(a) => Reason::Entered(t(a)),
            Reason::From(a) => Reason::From(t(a)),
            Reason::Origin(a) => Reason::Origin(t(a)),
            Reason::Before(a, x, y) => Reason::Before(t(a), s(x), s(y)),
            Reason::After(a, x, y) => Reason::After(t(a), s(x), s(y)),
            Reason::Initial(x, y) => Reason::Initial(s(x), s(y)),
            Reason::Links(x, y) => Reason::Links(s(x), s(y)),
            Reason::Forced(x, y) => Reason::Forced(s(x), s(y)),
            Reason::Commanded => Reason::Commanded,
            Reason::GivenUp => Reason::GivenUp,
        }
    }
}
