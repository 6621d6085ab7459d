//! Steps that a transition may lead to while they are active.

use crate::analysis::Analysis;
use grafc_model::chart::{StepId, TransitionId};

/// Transitions and steps after them that are not proved to be inactive whenever the transition clears.
pub(crate) fn may_reenter(analysis: &Analysis) -> Vec<(TransitionId, StepId)> {
    let mut found = Vec::new();
    for (t, transition) in analysis.net.transitions.iter_enumerated() {
        let inactive = |s: &StepId| match transition.pre.first().and_then(|p| analysis.reachable.part(*p)) {
            Some(part) => !part.enters_active(t, *s),
            None => transition.pre.iter().any(|p| analysis.never_together(*p, *s)),
        };
        found.extend(transition.entered().into_iter().filter(|s| !inactive(s)).map(|s| (t, s)));
    }
    found
}
