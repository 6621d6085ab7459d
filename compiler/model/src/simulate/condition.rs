//! Conditions of somebody who looks at a chart from outside after a reaction.

use super::arithmetic::{calculate, compare, convert, negate, truth};
use super::{Probe, Simulator};
use crate::chart::{Condition, ExprKind, Value};
use index_vec::IndexVec;

impl Condition {
    /// What it reads, with the expressions that do.
    pub fn probes(&self) -> Vec<Probe> {
        self.exprs.iter().filter_map(|expr| probe(&expr.kind)).collect()
    }
}

/// What an expression reads by itself.
fn probe(kind: &ExprKind) -> Option<Probe> {
    match *kind {
        ExprKind::Variable(id) => Some(Probe::Variable(id)),
        ExprKind::StepActive(id) => Some(Probe::Step(id)),
        ExprKind::StepTime(id) => Some(Probe::Duration(id)),
        ExprKind::MacroActive(id) => Some(Probe::Macro(id)),
        ExprKind::GrafcetActive(id) => Some(Probe::Grafcet(id)),
        ExprKind::GrafcetFrozen(id) => Some(Probe::Frozen(id)),
        ExprKind::Literal(_)
        | ExprKind::Not(_)
        | ExprKind::And(..)
        | ExprKind::Or(..)
        | ExprKind::Xor(..)
        | ExprKind::Rise(_)
        | ExprKind::Fall(_)
        | ExprKind::Delay { .. }
        | ExprKind::Compare(..)
        | ExprKind::Arithmetic(..)
        | ExprKind::Negate(_)
        | ExprKind::Widen(_) => None,
    }
}

impl Simulator<'_> {
    /// Whether a condition holds after the latest reaction, which was at `t`.
    pub fn is_met(&mut self, condition: &Condition, t: i64) -> bool {
        let mut looks = self.look(&condition.probes(), t).into_iter();
        let mut values: IndexVec<_, Value> = IndexVec::with_capacity(condition.exprs.len());
        for expr in &condition.exprs {
            let is = |operand| truth(values[operand]);
            // What is divided by zero is 0, and raises no flag: nobody but the test asks for it.
            let mut div0 = false;
            let value = match expr.kind {
                ExprKind::Literal(value) => value,
                ExprKind::Variable(_)
                | ExprKind::StepActive(_)
                | ExprKind::StepTime(_)
                | ExprKind::MacroActive(_)
                | ExprKind::GrafcetActive(_)
                | ExprKind::GrafcetFrozen(_) => looks.next().unwrap_or(Value::Bool(false)),
                ExprKind::Not(a) => Value::Bool(!is(a)),
                ExprKind::And(a, b) => Value::Bool(is(a) & is(b)),
                ExprKind::Or(a, b) => Value::Bool(is(a) | is(b)),
                ExprKind::Xor(a, b) => Value::Bool(is(a) ^ is(b)),
                // It holds none.
                ExprKind::Rise(_) | ExprKind::Fall(_) | ExprKind::Delay { .. } => Value::Bool(false),
                ExprKind::Compare(op, a, b) => Value::Bool(compare(op, values[a], values[b])),
                ExprKind::Arithmetic(op, a, b) => calculate(op, expr.ty, values[a], values[b], &mut div0),
                ExprKind::Negate(a) => negate(expr.ty, values[a]),
                ExprKind::Widen(a) => convert(expr.ty, values[a]),
            };
            values.push(value);
        }
        truth(values[condition.root])
    }
}
