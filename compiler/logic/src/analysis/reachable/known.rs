//! Situations that are known before: of a network that was made so that it has just these.

use super::sets::{NONE, Sets};
use super::{Reached, together};
use crate::analysis::rivals::Rivals;
use grafc_model::chart::{StepId, TransitionId};
use rustc_hash::{FxHashMap, FxHashSet};

/// All situations of some steps, and what may happen in them.
pub(crate) struct Known {
    pub(crate) steps: Vec<StepId>,
    pub(crate) situations: Vec<Vec<StepId>>,
    /// Transitions that may clear while a step after them is active that they do not leave.
    pub(crate) entering_active: Vec<(TransitionId, StepId)>,
    /// Transitions that may be enabled at once and whose conditions are not made to exclude each other.
    pub(crate) enabled_at_once: Vec<(TransitionId, TransitionId)>,
}

impl Known {
    /// The same as if it had been found; none if that takes too much work.
    pub(super) fn reached(&self, places: usize, rivals: &Rivals) -> Option<Reached> {
        let mut steps = self.steps.clone();
        steps.sort_unstable();
        let number: FxHashMap<StepId, u16> = steps.iter().copied().zip(0..).collect();
        let mut sets = Sets::new(places.max(1) * (self.situations.len() + 1) * (steps.len() + 1));
        let mut all = NONE;
        for situation in &self.situations {
            let mut active: Vec<u16> = situation.iter().map(|s| number[s]).collect();
            active.sort_unstable();
            let one = sets.one(&active);
            all = sets.union(all, one)?;
        }
        let situations = sets.only(all);
        let together = together(&situations, steps.len());
        let entering_active: FxHashSet<_> = self.entering_active.iter().copied().collect();
        let is_open = |(a, b): &&(TransitionId, TransitionId)| rivals.of(*a).contains(b);
        let ordered = |(a, b): &(TransitionId, TransitionId)| (*a.min(b), *a.max(b));
        let meeting = self.enabled_at_once.iter().filter(is_open).map(ordered).collect();
        Some(Reached { steps, situations, together, entering_active, meeting })
    }
}
