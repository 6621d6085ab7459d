//! Arithmetic that wraps around at the width of its type in every target.
//!
//! Compilers of PLCs compute intermediate results at different widths; only the store wraps. So every intermediate
//! result is stored in a variable of its type, and every division is guarded.

use super::{Context, Lowering};
use crate::formula::{Arithmetic, Formula, FormulaId, Type};
use crate::scan::{Flag, Role, Statement, VarId};

impl Lowering<'_> {
    /// The value itself if it is a variable or a constant, else a variable that holds it.
    pub(super) fn latch(&mut self, cx: &mut Context, value: FormulaId) -> FormulaId {
        match self.pool.get(value) {
            Formula::Arithmetic(..) | Formula::Negate(_) => {}
            Formula::Constant(_)
            | Formula::Variable(_)
            | Formula::TimerDone(_)
            | Formula::TimerElapsed(_)
            | Formula::Not(_)
            | Formula::And(_)
            | Formula::Or(_)
            | Formula::Xor(..)
            | Formula::Compare(..)
            | Formula::Widen(_) => return value,
        }
        let target = match cx.latched.get(&value) {
            Some(known) => *known,
            None => {
                let target = self.intermediate(self.pool.ty(value));
                cx.statements.push(Statement::Assign { target, value, remark: None });
                cx.latch_in(value, target);
                target
            }
        };
        self.symbols.read(&mut self.pool, target)
    }

    pub(super) fn arithmetic(
        &mut self,
        cx: &mut Context,
        op: Arithmetic,
        ty: Type,
        a: FormulaId,
        b: FormulaId,
    ) -> FormulaId {
        let (a, b) = (self.latch(cx, a), self.latch(cx, b));
        match op {
            Arithmetic::Add | Arithmetic::Subtract | Arithmetic::Multiply => self.pool.arithmetic(op, ty, a, b),
            Arithmetic::Divide | Arithmetic::Modulo => {
                // The pool tells whether this very division was done already at this moment.
                let quotient = self.pool.arithmetic(op, ty, a, b);
                let target = match cx.latched.get(&quotient) {
                    Some(known) => *known,
                    None => {
                        let target = self.intermediate(ty);
                        let (dividend, divisor) = (self.operand(cx, a), self.operand(cx, b));
                        let modulo = op == Arithmetic::Modulo;
                        let flag = self.symbols.flag(Flag::Div0);
                        cx.statements.push(Statement::Divide { target, modulo, dividend, divisor, flag });
                        cx.latch_in(quotient, target);
                        target
                    }
                };
                self.symbols.read(&mut self.pool, target)
            }
        }
    }

    /// A variable or constant of this value: what a division reads more than once.
    fn operand(&mut self, cx: &mut Context, value: FormulaId) -> FormulaId {
        match self.pool.get(value) {
            Formula::Constant(_) | Formula::Variable(_) => value,
            Formula::TimerDone(_)
            | Formula::TimerElapsed(_)
            | Formula::Not(_)
            | Formula::And(_)
            | Formula::Or(_)
            | Formula::Xor(..)
            | Formula::Compare(..)
            | Formula::Arithmetic(..)
            | Formula::Negate(_)
            | Formula::Widen(_) => {
                let target = self.intermediate(self.pool.ty(value));
                cx.statements.push(Statement::Assign { target, value, remark: None });
                self.symbols.read(&mut self.pool, target)
            }
        }
    }

    fn intermediate(&mut self, ty: Type) -> VarId {
        self.latches += 1;
        self.symbols.fresh(Role::Temporary, format!("value_{}", self.latches), ty, None)
    }
}
