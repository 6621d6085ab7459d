//! Arithmetic that wraps around at the width of its type in every target.
//!
//! Compilers of PLCs compute intermediate results at different widths; only the store wraps. So every intermediate
//! result is stored in a variable of its type, and every division is guarded.

use super::{Context, Lowering};
use crate::scan::{Division, Flag, Role, Statement, VarId};
use ecow::eco_format;
use grafc_formula::number::is_zero;
use grafc_formula::{Arithmetic, Formula, FormulaId, Type, Value};

impl Lowering {
    /// The value itself if it is a variable or a constant, else a variable that holds it.
    pub(super) fn latch(&mut self, cx: &mut Context, value: FormulaId) -> FormulaId {
        if !matches!(self.pool.get(value), Formula::Arithmetic(..) | Formula::Negate(_)) {
            return value;
        }
        let target = match cx.latched.get(&value) {
            Some(known) => *known,
            None => {
                let target = self.intermediate(cx, self.pool.ty(value));
                cx.statements.push(Statement::assign(cx.origin, target, value));
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
        match (op, self.pool.as_constant(b)) {
            (Arithmetic::Add | Arithmetic::Subtract | Arithmetic::Multiply, _) => self.pool.arithmetic(op, ty, a, b),
            // The least whole number has no negative in its type, and a processor may stop at the attempt.
            (Arithmetic::Divide, Some(Value::Int(-1))) => self.pool.negate(a),
            (Arithmetic::Modulo, Some(Value::Int(-1))) => self.pool.constant(grafc_formula::number::zero(ty), ty),
            (Arithmetic::Divide | Arithmetic::Modulo, Some(divisor)) if !is_zero(divisor) => {
                self.pool.arithmetic(op, ty, a, b)
            }
            (Arithmetic::Divide | Arithmetic::Modulo, _) => self.division(cx, op == Arithmetic::Modulo, ty, a, b),
        }
    }

    /// A division by what may be zero.
    fn division(&mut self, cx: &mut Context, modulo: bool, ty: Type, a: FormulaId, b: FormulaId) -> FormulaId {
        if let Some(known) = cx.divided.get(&(modulo, a, b)) {
            return self.symbols.read(&mut self.pool, *known);
        }
        let target = self.intermediate(cx, ty);
        let (dividend, divisor) = (self.operand(cx, a), self.operand(cx, b));
        let flag = self.symbols.flag(Flag::Div0);
        let origin = cx.origin;
        cx.statements.push(Statement::Divide(Division { target, modulo, dividend, divisor, flag, origin }));
        cx.divided.insert((modulo, a, b), target);
        cx.divided_in_order.push((modulo, a, b));
        self.symbols.read(&mut self.pool, target)
    }

    /// The value without operators: a division reads it more than once.
    fn operand(&mut self, cx: &mut Context, value: FormulaId) -> FormulaId {
        if self.pool.is_leaf(value) {
            return value;
        }
        let target = self.intermediate(cx, self.pool.ty(value));
        cx.statements.push(Statement::assign(cx.origin, target, value));
        self.symbols.read(&mut self.pool, target)
    }

    fn intermediate(&mut self, cx: &Context, ty: Type) -> VarId {
        let name = eco_format!("value_{}", self.origin_word(cx.origin));
        self.symbols.fresh(Role::Temporary, name, ty, None)
    }
}
