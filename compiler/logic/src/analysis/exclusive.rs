//! Steps that are never active together, conditions that never hold together.

use super::Analysis;
use grafc_formula::FormulaId;
use grafc_model::chart::{StepId, TransitionId};
use grafc_net::net::Forced;

/// No more enclosing steps than this are looked at for one step, nor more orders for one grafcet.
const LOOKED_AT: usize = 8;

impl Analysis {
    /// Whether two conditions of the net never hold in the same micro-step.
    pub(crate) fn exclude(&self, a: FormulaId, b: FormulaId) -> bool {
        self.facts.exclude(&self.conditions.lowering.pool, a, b)
    }

    /// Whether it is proved that no situation holds both steps: one token serves both or what encloses them, or one forces
    /// the other away.
    pub fn never_together(&self, a: StepId, b: StepId) -> bool {
        a != b
            && (self.around(a).any(|a| self.around(b).any(|b| a != b && self.share_a_token(a, b)))
                || self.forces_away(a, b)
                || self.forces_away(b, a))
    }

    fn share_a_token(&self, a: StepId, b: StepId) -> bool {
        self.reachable.together(a, b).map_or_else(|| self.components.share(a, b), |together| !together)
    }

    /// Whether it is known that no situation holds all of these steps.
    pub(crate) fn never_all(&self, steps: &[StepId]) -> bool {
        !self.reachable.all_active(steps)
    }

    /// Whether it is known that two transitions after one step never clear together, whatever their conditions are.
    pub(crate) fn never_clear_together(&self, a: TransitionId, b: TransitionId) -> bool {
        let part = self.net.transitions[a].pre.first().and_then(|s| self.reachable.part(*s));
        part.is_some_and(|part| !part.meet(a, b))
    }

    /// A step and the steps around it, which are active whenever it is (I1).
    fn around(&self, step: StepId) -> impl Iterator<Item = StepId> {
        std::iter::successors(Some(step), |s| self.net.places[*s].encloser()).take(LOOKED_AT)
    }

    /// Whether an order of one step, or one that wins over it, keeps the other step inactive (R2, I2).
    fn forces_away(&self, forcing: StepId, step: StepId) -> bool {
        let orders = &self.net.grafcets[self.net.places[step].grafcet].orders;
        for order in orders.iter().take(LOOKED_AT) {
            match &order.forced {
                Forced::Steps(steps) if steps.binary_search(&step).is_err() => {
                    if order.step == forcing {
                        return true;
                    }
                }
                Forced::Steps(_) | Forced::Current => return false,
            }
        }
        false
    }
}
