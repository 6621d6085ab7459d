//! A `CASE` over a state, put together step by step.

use crate::lower::Lowering;
use crate::lower::situation::Holder;
use crate::scan::{Arm, Origin, Statement, Told, VarId};
use grafc_model::chart::StepId;

/// A `CASE` under construction.
#[derive(Default)]
pub(crate) struct StateCase {
    arms: Vec<Arm>,
}

impl StateCase {
    /// What is done where the state is at a step; no arm if that is nothing.
    pub(crate) fn add(&mut self, lowering: &Lowering, s: StepId, body: Vec<Statement>) {
        let Holder::State { value, .. } = lowering.situation.holder(s) else { return };
        if body.is_empty() {
            return;
        }
        self.arms.push(Arm { value, origin: Origin::Step(s), told: Told::All, body });
    }

    /// The statement; none if no arm does anything.
    pub(crate) fn case(self, of: VarId) -> Option<Statement> {
        (!self.arms.is_empty()).then_some(Statement::Case { of, arms: self.arms })
    }
}
