//! Types: their names, their ranges, and which converts to which without loss.

use crate::chart::{Type, Value};
use grafc_syntax::ast::BinaryOp;

/// The keyword of a type.
pub fn name(ty: Type) -> &'static str {
    ty.keyword()
}

/// Whether one can do arithmetic with it, `time` left aside.
pub fn is_number(ty: Type) -> bool {
    ty.is_whole() || matches!(ty, Type::Real | Type::Lreal)
}

/// The smallest and the greatest `time`, in milliseconds: what 32 bits hold on every target.
pub const TIME_RANGE: (i64, i64) = (i32::MIN as i64, i32::MAX as i64);

/// The narrowest type that both widen to; whole numbers stay whole if they can.
pub fn join(a: Type, b: Type) -> Option<Type> {
    const NARROW_FIRST: [Type; 8] =
        [Type::Bool, Type::Time, Type::Int, Type::Uint, Type::Dint, Type::Udint, Type::Real, Type::Lreal];
    NARROW_FIRST.into_iter().find(|&ty| a.widens_to(ty) && b.widens_to(ty))
}

/// The value of a variable that was given none (IEC 60848, 4.8.3).
pub fn zero(ty: Type) -> Value {
    match ty {
        Type::Bool => Value::Bool(false),
        Type::Int | Type::Dint | Type::Uint | Type::Udint => Value::Int(0),
        Type::Real | Type::Lreal => Value::Real(0.0),
        Type::Time => Value::Time(0),
    }
}

/// A real number as its type holds it; none if it is too great.
pub fn real(ty: Type, value: f64) -> Option<f64> {
    let held = if ty == Type::Real { f64::from(value as f32) } else { value };
    held.is_finite().then_some(held)
}

/// An operator as messages write it.
pub fn operator(op: BinaryOp) -> &'static str {
    match op {
        BinaryOp::And => "and",
        BinaryOp::Or => "or",
        BinaryOp::Xor => "xor",
        BinaryOp::Equal => "=",
        BinaryOp::NotEqual => "<>",
        BinaryOp::Less => "<",
        BinaryOp::LessEqual => "<=",
        BinaryOp::Greater => ">",
        BinaryOp::GreaterEqual => ">=",
        BinaryOp::Add => "+",
        BinaryOp::Subtract => "-",
        BinaryOp::Multiply => "*",
        BinaryOp::Divide => "/",
        BinaryOp::Modulo => "mod",
    }
}

/// What helps where a value does not fit a type.
pub fn larger(ty: Type) -> String {
    match ty {
        Type::Int | Type::Uint => "declare it with a larger type, `dint` or `udint`".to_owned(),
        Type::Dint | Type::Udint => "a larger value has place in a `lreal`, not exactly".to_owned(),
        Type::Real => "declare it with a larger type, `lreal`".to_owned(),
        Type::Bool | Type::Lreal | Type::Time => "there is no larger type: give it a smaller value".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_join_is_the_narrowest_type_above_both() {
        assert_eq!(join(Type::Int, Type::Int), Some(Type::Int));
        assert_eq!(join(Type::Int, Type::Uint), Some(Type::Dint));
        assert_eq!(join(Type::Uint, Type::Udint), Some(Type::Udint));
        assert_eq!(join(Type::Int, Type::Real), Some(Type::Real));
        assert_eq!(join(Type::Dint, Type::Real), Some(Type::Lreal));
        assert_eq!(join(Type::Dint, Type::Udint), Some(Type::Lreal));
        assert_eq!(join(Type::Time, Type::Int), None);
        assert_eq!(join(Type::Bool, Type::Int), None);
    }

    #[test]
    fn nothing_widens_with_a_loss() {
        assert!(!Type::Dint.widens_to(Type::Real), "a single holds 24 bits");
        assert!(!Type::Int.widens_to(Type::Udint), "a negative number has no place there");
        assert!(!Type::Lreal.widens_to(Type::Real));
    }
}
