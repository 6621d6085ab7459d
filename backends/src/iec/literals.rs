//! Constants and types.

use ecow::{EcoString, eco_format};
use grafc_formula::{Type, Value};

/// The keyword of a type.
pub(crate) fn type_name(ty: Type) -> &'static str {
    match ty {
        Type::Bool => "BOOL",
        Type::Int => "INT",
        Type::Dint => "DINT",
        Type::Uint => "UINT",
        Type::Udint => "UDINT",
        Type::Real => "REAL",
        Type::Lreal => "LREAL",
        Type::Time => "TIME",
    }
}

/// A constant as the initial value of a variable, whose declaration says the type.
pub(crate) fn initial(value: Value, ty: Type) -> EcoString {
    match (value, ty) {
        (Value::Bool(true), _) => "TRUE".into(),
        (Value::Bool(false), _) => "FALSE".into(),
        (Value::Int(n), Type::Real | Type::Lreal) => real(n as f64, ty),
        (Value::Int(n), _) => eco_format!("{n}"),
        (Value::Real(x), _) => real(x, ty),
        (Value::Time(ms), _) => time(ms),
    }
}

/// A constant in a formula. `0.1` alone is of the type LREAL in CODESYS, TwinCAT and MATIEC, which then compute in
/// double precision, so that a constant of the type REAL says what it is. A sign stands before the type: STruC++ knows
/// no other place for it.
pub(crate) fn literal(value: Value, ty: Type) -> EcoString {
    let text = initial(value, ty);
    match ty {
        Type::Real => match text.strip_prefix('-') {
            Some(digits) => eco_format!("-REAL#{digits}"),
            None => eco_format!("REAL#{text}"),
        },
        Type::Bool | Type::Int | Type::Dint | Type::Uint | Type::Udint | Type::Lreal | Type::Time => text,
    }
}

/// A constant as the operand of an instruction, where nothing but a literal may stand: the sign is within it.
pub(crate) fn operand(value: Value, ty: Type) -> EcoString {
    let text = initial(value, ty);
    match ty {
        Type::Real => eco_format!("REAL#{text}"),
        Type::Bool | Type::Int | Type::Dint | Type::Uint | Type::Udint | Type::Lreal | Type::Time => text,
    }
}

/// The zero of a type.
pub(crate) fn zero(ty: Type) -> EcoString {
    match ty {
        Type::Bool => "FALSE".into(),
        Type::Int | Type::Dint | Type::Uint | Type::Udint => "0".into(),
        Type::Real => "REAL#0.0".into(),
        Type::Lreal => "0.0".into(),
        Type::Time => time(0),
    }
}

/// Whether a value is what its type starts from anyway.
pub(crate) fn is_zero(value: Value) -> bool {
    match value {
        Value::Bool(b) => !b,
        Value::Int(n) | Value::Time(n) => n == 0,
        Value::Real(x) => x == 0.0 && x.is_sign_positive(),
    }
}

/// The shortest form that is read back as the same number of the type: digits on both sides of the point, then an
/// exponent if need be.
fn real(x: f64, ty: Type) -> EcoString {
    let text = match ty {
        Type::Real => eco_format!("{:?}", x as f32),
        Type::Bool | Type::Int | Type::Dint | Type::Uint | Type::Udint | Type::Lreal | Type::Time => {
            eco_format!("{x:?}")
        }
    };
    match text.split_once('e') {
        Some((digits, exponent)) if digits.contains('.') => eco_format!("{digits}E{exponent}"),
        Some((digits, exponent)) => eco_format!("{digits}.0E{exponent}"),
        None => text,
    }
}

/// A duration in the largest unit that needs no fraction: compound literals are not taken everywhere.
pub(crate) fn time(ms: i64) -> EcoString {
    for (unit, length) in [("h", 3_600_000), ("m", 60_000), ("s", 1000)] {
        if ms != 0 && ms % length == 0 {
            return eco_format!("T#{}{unit}", ms / length);
        }
    }
    eco_format!("T#{ms}ms")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reals() {
        for (x, ty, expected) in [
            (0.0, Type::Real, "0.0"),
            (1.0, Type::Real, "1.0"),
            (f64::from(0.1f32), Type::Real, "0.1"),
            (0.1, Type::Lreal, "0.1"),
            (1e-7, Type::Lreal, "1.0E-7"),
            (-2.5e20, Type::Lreal, "-2.5E20"),
            (1e16, Type::Real, "1.0E16"),
        ] {
            assert_eq!(initial(Value::Real(x), ty), expected);
        }
        assert_eq!(initial(Value::Int(-3), Type::Lreal), "-3.0");
    }

    #[test]
    fn a_formula_says_which_constants_are_single() {
        let both = |x, ty| (literal(Value::Real(x), ty), operand(Value::Real(x), ty));
        assert_eq!(both(f64::from(0.1f32), Type::Real), ("REAL#0.1".into(), "REAL#0.1".into()));
        assert_eq!(both(f64::from(-1.5e-9f32), Type::Real), ("-REAL#1.5E-9".into(), "REAL#-1.5E-9".into()));
        assert_eq!(both(-0.1, Type::Lreal), ("-0.1".into(), "-0.1".into()));
        assert_eq!(literal(Value::Int(-3), Type::Real), "-REAL#3.0");
        assert_eq!(
            (literal(Value::Int(-3), Type::Int), operand(Value::Int(-3), Type::Int)),
            ("-3".into(), "-3".into())
        );
    }

    #[test]
    fn times() {
        for (ms, expected) in [
            (0, "T#0ms"),
            (1, "T#1ms"),
            (1500, "T#1500ms"),
            (3000, "T#3s"),
            (90_000, "T#90s"),
            (120_000, "T#2m"),
            (7_200_000, "T#2h"),
            (-5, "T#-5ms"),
        ] {
            assert_eq!(time(ms), expected);
        }
    }
}
