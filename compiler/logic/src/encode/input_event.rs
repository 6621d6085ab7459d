//! Input events (IEC 60848, 3.1.5): whether an input has changed since the call before, seen by the first micro-step of
//! a call only. Kept only for charts with an action on an event that is not an edge alone.

use crate::lower::Lowering;
use crate::scan::{Origin, Role, Statement, VarId};
use grafc_formula::{FormulaId, Type};
use grafc_model::chart::{VariableId, VariableKind};

/// The memory of all inputs and the bit that says that one has changed.
#[derive(Default)]
pub(crate) struct InputEvent {
    changed: Option<VarId>,
    /// Each input and its value at the call before.
    memory: Vec<(VariableId, VarId)>,
}

impl InputEvent {
    /// The bit, which exists from its first use on.
    pub(crate) fn changed(&mut self, lowering: &mut Lowering) -> FormulaId {
        let variable = match self.changed {
            Some(known) => known,
            None => {
                for (v, input) in lowering.net.variables.iter_enumerated() {
                    if input.kind == VariableKind::Input && !lowering.net.controls.has(v) {
                        let old = lowering.symbols.fresh(Role::Memory, format!("last_{}", input.name), input.ty, None);
                        self.memory.push((v, old));
                    }
                }
                let changed = lowering.symbols.fresh(Role::Temporary, "input_event", Type::Bool, None);
                *self.changed.insert(changed)
            }
        };
        lowering.symbols.read(&mut lowering.pool, variable)
    }

    /// At the first call there is no event.
    pub(crate) fn start(&self, lowering: &mut Lowering) -> Vec<Statement> {
        self.remember(lowering)
    }

    /// Before the evolution: has an input changed?
    pub(crate) fn found(&self, lowering: &mut Lowering) -> Vec<Statement> {
        let Some(target) = self.changed else { return Vec::new() };
        let mut terms = Vec::with_capacity(self.memory.len());
        for (input, old) in &self.memory {
            let now = lowering.symbols.read(&mut lowering.pool, lowering.symbols.declared(*input));
            let old = lowering.symbols.read(&mut lowering.pool, *old);
            terms.push(lowering.pool.differs(now, old));
        }
        let value = lowering.pool.or(terms);
        let mut statements = vec![Statement::assign(Origin::Chart, target, value)];
        statements.extend(self.remember(lowering));
        statements
    }

    /// After the first micro-step the event is over.
    pub(crate) fn over(&self, lowering: &mut Lowering) -> Option<Statement> {
        let target = self.changed?;
        Some(Statement::assign(Origin::Chart, target, lowering.pool.truth(false)))
    }

    fn remember(&self, lowering: &mut Lowering) -> Vec<Statement> {
        self.memory
            .iter()
            .map(|(input, old)| {
                let value = lowering.symbols.read(&mut lowering.pool, lowering.symbols.declared(*input));
                Statement::assign(Origin::Declaration(*input), *old, value)
            })
            .collect()
    }
}
