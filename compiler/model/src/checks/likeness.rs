//! Which expressions are written alike: the same operators over the same operands, those of `and`, `or` and `xor` in
//! either order.

use crate::chart::{Expr, ExprId, ExprKind, Value};
use index_vec::IndexVec;
use rustc_hash::FxHashMap;

/// An expression by what it is and the numbers of its operands.
type Key = (std::mem::Discriminant<ExprKind>, u8, u64, u64, u64);

/// A number for each expression; equal numbers are alike.
pub fn likeness(exprs: &IndexVec<ExprId, Expr>) -> IndexVec<ExprId, usize> {
    let mut known: FxHashMap<Key, usize> = FxHashMap::default();
    let mut numbers: IndexVec<ExprId, usize> = IndexVec::with_capacity(exprs.len());
    for expr in exprs {
        let of = |e: ExprId| numbers[e] as u64;
        let (a, b, c) = match expr.kind {
            ExprKind::Literal(Value::Bool(value)) => (0, u64::from(value), 0),
            ExprKind::Literal(Value::Int(value)) => (1, value as u64, 0),
            ExprKind::Literal(Value::Real(value)) => (2, value.to_bits(), 0),
            ExprKind::Literal(Value::Time(value)) => (3, value as u64, 0),
            ExprKind::Variable(v) => (v.index() as u64, 0, 0),
            ExprKind::StepActive(s) | ExprKind::StepTime(s) => (s.index() as u64, 0, 0),
            ExprKind::MacroActive(m) => (m.index() as u64, 0, 0),
            ExprKind::GrafcetActive(g) => (g.index() as u64, 0, 0),
            ExprKind::GrafcetFrozen(g) => (g.index() as u64, 1, 0),
            ExprKind::Not(a) | ExprKind::Rise(a) | ExprKind::Fall(a) | ExprKind::Negate(a) | ExprKind::Widen(a) => {
                (of(a), 0, 0)
            }
            ExprKind::And(a, b) | ExprKind::Or(a, b) | ExprKind::Xor(a, b) => (of(a).min(of(b)), of(a).max(of(b)), 0),
            ExprKind::Delay { on, operand, off } => (of(operand), on.ms as u64, off.ms as u64),
            ExprKind::Compare(op, a, b) => (of(a), of(b), op as u64),
            ExprKind::Arithmetic(op, a, b) => (of(a), of(b), op as u64),
        };
        let key = (std::mem::discriminant(&expr.kind), expr.ty as u8, a, b, c);
        let next = known.len();
        numbers.push(*known.entry(key).or_insert(next));
    }
    numbers
}
