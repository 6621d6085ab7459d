//! Types and constants.

use crate::types::shortest;
use ecow::{EcoString, eco_format};
use grafc_formula::{Type, Value};

/// A type of the chart.
pub(super) fn type_name(ty: Type) -> &'static str {
    match ty {
        Type::Bool => "bool",
        Type::Int => "i16",
        Type::Dint => "i32",
        Type::Uint => "u16",
        Type::Udint => "u32",
        Type::Real => "f32",
        Type::Lreal => "f64",
        // A whole number of milliseconds.
        Type::Time => "i64",
    }
}

/// A constant where its type is known from what stands around it.
pub(super) fn literal(value: Value, ty: Type) -> EcoString {
    match (value, ty) {
        (Value::Bool(b), _) => eco_format!("{b}"),
        (Value::Int(n), Type::Real | Type::Lreal) => shortest(n as f64, ty),
        (Value::Int(n) | Value::Time(n), _) => whole(n),
        (Value::Real(x), _) => shortest(x, ty),
    }
}

/// The zero of a type.
pub(super) fn zero(ty: Type) -> &'static str {
    match ty {
        Type::Bool => "false",
        Type::Int | Type::Dint | Type::Uint | Type::Udint | Type::Time => "0",
        Type::Real | Type::Lreal => "0.0",
    }
}

/// A whole number, its thousands apart from five digits on.
fn whole(n: i64) -> EcoString {
    let digits = n.unsigned_abs().to_string();
    let mut out = EcoString::from(if n < 0 { "-" } else { "" });
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && digits.len() > 4 && (digits.len() - place) % 3 == 0 {
            out.push('_');
        }
        out.push(digit);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers() {
        for (value, ty, expected) in [
            (Value::Int(-3), Type::Dint, "-3"),
            (Value::Int(9999), Type::Dint, "9999"),
            (Value::Int(-1_234_567), Type::Dint, "-1_234_567"),
            (Value::Time(90_000), Type::Time, "90_000"),
            (Value::Real(f64::from(0.1f32)), Type::Real, "0.1"),
            (Value::Real(0.1), Type::Lreal, "0.1"),
            (Value::Real(1e-7), Type::Lreal, "1e-7"),
            (Value::Int(3), Type::Lreal, "3.0"),
        ] {
            assert_eq!(literal(value, ty), expected);
        }
    }
}
