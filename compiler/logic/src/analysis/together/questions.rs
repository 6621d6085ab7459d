//! Questions about conditions and values that the analysis has not lowered itself.
//!
//! Further formulas go to a copy of the lowering, which is made when the first of them is asked for: the analysis stays as
//! it is, so that the program does not depend on what a warning has looked at.

use crate::analysis::{Analysis, Conditions};
use grafc_formula::{Formula, FormulaId, Pool};
use grafc_model::chart::{ExprId, ExprKind, VariableKind};

/// An analysis, and what is asked beyond it.
pub(in crate::analysis) struct Questions<'a> {
    pub(in crate::analysis) analysis: &'a Analysis,
    more: Option<Box<Conditions>>,
}

impl<'a> Questions<'a> {
    pub(in crate::analysis) fn new(analysis: &'a Analysis) -> Self {
        Questions { analysis, more: None }
    }

    fn more(&mut self) -> &mut Conditions {
        self.more.get_or_insert_with(|| Box::new(self.analysis.conditions.clone()))
    }

    fn pool(&self) -> &Pool {
        &self.more.as_deref().unwrap_or(&self.analysis.conditions).lowering.pool
    }

    /// The formula of a condition or value in a micro-step: equal formulas have equal values.
    pub(in crate::analysis) fn formula(&mut self, expr: ExprId) -> FormulaId {
        let Conditions { lowering, cx, .. } = self.more();
        lowering.expr(cx, expr)
    }

    /// The formula of a value, in which a constant of the chart is its value.
    pub(super) fn value(&mut self, expr: ExprId) -> FormulaId {
        let net = &self.analysis.net;
        if let ExprKind::Variable(v) = net.exprs[expr].kind
            && net.variables[v].kind == VariableKind::Constant
        {
            return self.more().lowering.pool.constant(net.variables[v].initial(), net.exprs[expr].ty);
        }
        self.formula(expr)
    }

    /// A condition that is denied, or as it is.
    pub(in crate::analysis) fn literal(&mut self, condition: FormulaId, asserted: bool) -> FormulaId {
        if asserted { condition } else { self.more().lowering.pool.not(condition) }
    }

    /// The constant that a condition is, if it is one.
    pub(in crate::analysis) fn truth(&self, condition: FormulaId) -> Option<bool> {
        self.pool().as_truth(condition)
    }

    pub(super) fn get(&self, condition: FormulaId) -> &Formula {
        self.pool().get(condition)
    }

    /// Whether two conditions never hold in the same micro-step.
    pub(in crate::analysis) fn exclude(&self, a: FormulaId, b: FormulaId) -> bool {
        self.analysis.facts.exclude(self.pool(), a, b)
    }
}
