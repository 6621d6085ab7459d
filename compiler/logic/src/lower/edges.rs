//! Edges (X4) by explicit memory of their operand.
//!
//! `↑e` is true in the one micro-step in which `e` is true and was false in the context before. Function blocks such as
//! R_TRIG are of no use here: they see an edge at power-up and lose edges when they are not called in every context.

use super::{Context, Lowering, Moment};
use crate::scan::{Origin, Role, Statement};
use ecow::eco_format;
use grafc_formula::exclusion::EdgeOperand;
use grafc_formula::{FormulaId, Type};
use grafc_model::chart::{ExprId, ExprKind};

impl Lowering {
    pub(super) fn edge(&mut self, cx: &mut Context, operand: ExprId, rising: bool) -> FormulaId {
        match cx.moment {
            // No edge is true at the start (R10), and the checks allow none in continuous actions.
            Moment::First | Moment::After | Moment::Restored => return self.pool.truth(false),
            Moment::MicroStep => {}
        }
        let formula = cx.exprs[operand];
        let index = match self.edge_of.get(&formula) {
            Some(known) => *known,
            None => self.remember(cx, operand, formula),
        };
        let (slot, word) = match (&mut self.edges[index], rising) {
            (edge, true) => (&mut edge.rise, "rise"),
            (edge, false) => (&mut edge.fall, "fall"),
        };
        if let Some(known) = *slot {
            return self.symbols.read(&mut self.pool, known);
        }
        let base = self.operand_word(self.edge_operands[index]);
        let target = self.symbols.fresh(Role::Temporary, eco_format!("{word}_{base}"), Type::Bool, None);
        let edge = &mut self.edges[index];
        *(if rising { &mut edge.rise } else { &mut edge.fall }) = Some(target);
        let (now, old) = (edge.now, self.symbols.read(&mut self.pool, edge.old));
        let value = if rising {
            let before = self.pool.not(old);
            self.pool.and([now, before])
        } else {
            let gone = self.pool.not(now);
            self.pool.and([gone, old])
        };
        cx.statements.push(Statement::assign(self.edge_origins[index], target, value));
        self.symbols.read(&mut self.pool, target)
    }

    fn remember(&mut self, cx: &mut Context, operand: ExprId, formula: FormulaId) -> usize {
        let base = self.operand_word(operand);
        // Of a name, many conditions may ask for an edge; what else an operand is made of, the first that asks has written.
        let origin = match self.net.exprs[operand].kind {
            ExprKind::Variable(v) => Origin::Declaration(v),
            ExprKind::StepActive(s) => Origin::Step(s),
            _ => cx.origin,
        };
        // The activity of a step is short, whatever holds it.
        let now = if self.pool.is_leaf(formula) || matches!(self.net.exprs[operand].kind, ExprKind::StepActive(_)) {
            formula
        } else {
            let target = self.symbols.fresh(Role::Temporary, eco_format!("now_{base}"), Type::Bool, None);
            cx.statements.push(Statement::assign(origin, target, formula));
            self.symbols.read(&mut self.pool, target)
        };
        let old = self.symbols.fresh(Role::Memory, eco_format!("old_{base}"), Type::Bool, None);
        let index = self.edges.len();
        self.edges.push(EdgeOperand { now, old, rise: None, fall: None });
        self.edge_operands.push(operand);
        self.edge_origins.push(origin);
        self.edge_of.insert(formula, index);
        index
    }

    /// Whether some operand has changed since the context before.
    pub(crate) fn edges_changed(&mut self) -> FormulaId {
        let mut changed = Vec::with_capacity(self.edges.len());
        for edge in &self.edges {
            let old = self.symbols.read(&mut self.pool, edge.old);
            changed.push(self.pool.xor(edge.now, old));
        }
        self.pool.or(changed)
    }

    /// The memory for the next micro-step.
    pub(crate) fn remember_operands(&self) -> Vec<Statement> {
        let edges = self.edges.iter().zip(&self.edge_origins);
        edges.map(|(edge, origin)| Statement::assign(*origin, edge.old, edge.now)).collect()
    }
}
