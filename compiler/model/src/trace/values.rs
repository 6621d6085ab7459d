//! The values in a trace: what charts write, and what programs write that make traces.

use crate::chart::{Type, Value};
use grafc_syntax::literal::{Literal, literal};

/// The value of a cell, or what was expected.
pub(super) fn parse_value(text: &str, ty: Type) -> Result<Value, String> {
    match ty {
        // Spreadsheets write `TRUE` in the language of their user.
        Type::Bool => {
            let is = |words: &[&str]| words.iter().any(|word| text.eq_ignore_ascii_case(word));
            match text {
                "0" => Ok(Value::Bool(false)),
                "1" => Ok(Value::Bool(true)),
                _ if is(&["FALSE", "FALSCH", "FAUX"]) => Ok(Value::Bool(false)),
                _ if is(&["TRUE", "WAHR", "VRAI"]) => Ok(Value::Bool(true)),
                _ => Err("`0`, `1`, `FALSE` or `TRUE`".to_string()),
            }
        }
        Type::Int | Type::Dint | Type::Uint | Type::Udint => whole(text, ty),
        Type::Real => real(text, true).ok_or_else(|| "a number that single precision can hold".to_string()),
        Type::Lreal => real(text, false).ok_or_else(|| "a number that double precision can hold".to_string()),
        Type::Time => time(text).ok_or_else(|| "whole milliseconds, or a duration such as `1s500ms`".to_string()),
    }
}

fn whole(text: &str, ty: Type) -> Result<Value, String> {
    let (least, greatest) = ty.whole_range().unwrap_or((i64::MIN, i64::MAX));
    integer(text)
        .filter(|number| (least..=greatest).contains(number))
        .map(Value::Int)
        .ok_or_else(|| format!("a whole number from {least} to {greatest}"))
}

fn integer(text: &str) -> Option<i64> {
    text.parse().ok().or_else(|| match literal(text)? {
        Literal::Whole(number) => Some(number),
        Literal::Real(_) | Literal::Duration(_) => None,
    })
}

fn time(text: &str) -> Option<Value> {
    let ms = text.parse().ok().or_else(|| match literal(text)? {
        Literal::Whole(ms) | Literal::Duration(ms) => Some(ms),
        Literal::Real(_) => None,
    });
    ms.map(Value::Time)
}

/// A number that the type holds, or what IEEE 754 has beside numbers, under the names that programs give it. A number
/// that is too large is not taken for infinity.
fn real(text: &str, single: bool) -> Option<Value> {
    if let Some(value) = beside_numbers(text) {
        return Some(Value::Real(value));
    }
    let number = number(text).or_else(|| {
        // Spreadsheets write the decimal sign of their country.
        number(&text.replacen(',', ".", 1))
    });
    let number = number.map(|number| if single { f64::from(number as f32) } else { number });
    number.filter(|number| number.is_finite()).map(Value::Real)
}

fn number(text: &str) -> Option<f64> {
    text.parse().ok().or_else(|| match literal(text)? {
        Literal::Whole(number) => Some(number as f64),
        Literal::Real(number) => Some(number),
        Literal::Duration(_) => None,
    })
}

/// `inf`, `-Infinity`, `NaN`, whatever the case and the sign; `1.#INF` and `1.#QNAN` as Microsoft's libraries print them.
fn beside_numbers(text: &str) -> Option<f64> {
    let (sign, word) = match text.strip_prefix(['-', '+']) {
        Some(rest) => (if text.starts_with('-') { -1.0 } else { 1.0 }, rest),
        None => (1.0, text),
    };
    match word.to_ascii_lowercase().as_str() {
        "inf" | "infinity" | "1.#inf" => Some(sign * f64::INFINITY),
        "nan" | "1.#qnan" | "1.#ind" => Some(f64::NAN),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_literal_of_a_chart_is_taken() {
        assert_eq!(parse_value("16#7F", Type::Int), Ok(Value::Int(127)));
        assert_eq!(parse_value("1_0", Type::Udint), Ok(Value::Int(10)));
        assert_eq!(parse_value("-1_0", Type::Dint), Ok(Value::Int(-10)));
        assert_eq!(parse_value("2#11", Type::Lreal), Ok(Value::Real(3.0)));
        assert_eq!(parse_value("1_0.5", Type::Real), Ok(Value::Real(10.5)));
        assert_eq!(parse_value("1_0,5", Type::Real), Ok(Value::Real(10.5)));
        assert_eq!(parse_value("1min30s", Type::Time), Ok(Value::Time(90_000)));
        assert_eq!(parse_value("T#1m30s", Type::Time), Ok(Value::Time(90_000)));
        assert_eq!(parse_value("16#10", Type::Time), Ok(Value::Time(16)));
    }

    #[test]
    fn of_another_type_or_too_large_is_refused() {
        let cases = [
            ("16#8000", Type::Int),
            ("-1", Type::Uint),
            ("1.5", Type::Int),
            ("1s", Type::Int),
            ("1s", Type::Real),
            ("1.5", Type::Time),
            ("1E39", Type::Real),
            ("1E999", Type::Lreal),
            ("inf", Type::Int),
            ("NaN", Type::Time),
            ("inf", Type::Bool),
        ];
        for (text, ty) in cases {
            assert!(parse_value(text, ty).is_err(), "{text} as {ty:?}");
        }
    }

    #[test]
    fn what_ieee_754_has_beside_numbers_is_read_as_it_is_written() {
        for ty in [Type::Real, Type::Lreal] {
            for value in [f64::INFINITY, f64::NEG_INFINITY] {
                assert_eq!(parse_value(&super::super::write::cell(ty, Value::Real(value)), ty), Ok(Value::Real(value)));
            }
            let written = super::super::write::cell(ty, Value::Real(f64::NAN));
            for text in [written.as_str(), "nan", "-nan", "+NaN", "1.#QNAN"] {
                assert!(matches!(parse_value(text, ty), Ok(Value::Real(x)) if x.is_nan()), "{text}");
            }
            assert_eq!(parse_value("+INF", ty), Ok(Value::Real(f64::INFINITY)));
            assert_eq!(parse_value("-Infinity", ty), Ok(Value::Real(f64::NEG_INFINITY)));
        }
    }
}
