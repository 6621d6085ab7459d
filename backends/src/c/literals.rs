//! Types and constants.

use crate::types::shortest;
use ecow::{EcoString, eco_format};
use grafc_formula::{Type, Value};

/// A type of the chart in C.
pub fn type_name(ty: Type) -> &'static str {
    match ty {
        Type::Bool => "bool",
        Type::Int => "int16_t",
        Type::Dint => "int32_t",
        Type::Uint => "uint16_t",
        Type::Udint => "uint32_t",
        Type::Real => "float",
        Type::Lreal => "double",
        // A whole number of milliseconds.
        Type::Time => "int64_t",
    }
}

/// What functions of a type of whole numbers have in their names.
pub(super) fn word(ty: Type) -> &'static str {
    match ty {
        Type::Int => "int",
        Type::Dint => "dint",
        Type::Uint => "uint",
        Type::Udint => "udint",
        Type::Time => "time",
        Type::Bool | Type::Real | Type::Lreal => "",
    }
}

/// The least and the greatest whole number of a type; times are numbers of 64 bits.
pub(super) fn range(ty: Type) -> Option<(i64, i64)> {
    match ty {
        Type::Time => Some((i64::MIN, i64::MAX)),
        _ => ty.whole_range(),
    }
}

/// A constant.
pub(super) fn literal(value: Value, ty: Type) -> EcoString {
    match (value, ty) {
        (Value::Bool(b), _) => eco_format!("{b}"),
        (Value::Int(n), Type::Real | Type::Lreal) => real(n as f64, ty),
        (Value::Int(n) | Value::Time(n), _) => whole(n, ty),
        (Value::Real(x), _) => real(x, ty),
    }
}

/// The least numbers of 32 and 64 bits are no literals: a literal has no sign.
fn whole(n: i64, ty: Type) -> EcoString {
    match ty {
        Type::Uint | Type::Udint => eco_format!("{n}u"),
        Type::Bool | Type::Int | Type::Dint | Type::Real | Type::Lreal | Type::Time => match n {
            i64::MIN => "INT64_MIN".into(),
            n if n == i64::from(i32::MIN) && ty == Type::Dint => "INT32_MIN".into(),
            n if n == i64::from(i16::MIN) && ty == Type::Int => "INT16_MIN".into(),
            n if i32::try_from(n).is_ok() && n != i64::from(i32::MIN) => eco_format!("{n}"),
            n if n < 0 => eco_format!("-INT64_C({})", n.unsigned_abs()),
            n => eco_format!("INT64_C({n})"),
        },
    }
}

/// A number as a literal of its type.
fn real(x: f64, ty: Type) -> EcoString {
    let suffix = if ty == Type::Real { "f" } else { "" };
    eco_format!("{}{suffix}", shortest(x, ty))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers() {
        for (value, ty, expected) in [
            (Value::Int(-3), Type::Dint, "-3"),
            (Value::Int(-2_147_483_648), Type::Dint, "INT32_MIN"),
            (Value::Int(65_535), Type::Uint, "65535u"),
            (Value::Time(90_000), Type::Time, "90000"),
            (Value::Time(2_147_483_648), Type::Time, "INT64_C(2147483648)"),
            (Value::Time(-2_147_483_648), Type::Time, "-INT64_C(2147483648)"),
            (Value::Time(i64::MIN), Type::Time, "INT64_MIN"),
            (Value::Real(f64::from(0.1f32)), Type::Real, "0.1f"),
            (Value::Real(1e-7), Type::Lreal, "1e-7"),
            (Value::Int(3), Type::Real, "3.0f"),
        ] {
            assert_eq!(literal(value, ty), expected);
        }
    }
}
