//! Numbers and durations as charts write them, for other texts that hold values: traces.

use crate::numeral::{self, Numeral};

/// A number or a duration.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Literal {
    /// `3`, `-2`, `16#FF`, `1_000`
    Whole(i64),
    /// `8.5`, `1.5e-3`
    Real(f64),
    /// `3s`, `T#1m30s`, in milliseconds
    Duration(i64),
}

/// Reads what may stand for a number or a duration in a chart, with a sign before it or not; `None` if it is neither.
pub fn literal(text: &str) -> Option<Literal> {
    let (negative, word) = match text.strip_prefix(['-', '+']) {
        Some(rest) => (text.starts_with('-'), rest),
        None => (false, text),
    };
    let begins = |prefix: &str| word.get(..prefix.len()).is_some_and(|start| start.eq_ignore_ascii_case(prefix));
    if !(word.starts_with(|c: char| c.is_ascii_digit()) || begins("T#") || begins("TIME#")) {
        return None;
    }
    Some(match numeral::read(word).ok()? {
        Numeral::Integer(number) => Literal::Whole(if negative { number.checked_neg()? } else { number }),
        Numeral::Real(number) => Literal::Real(if negative { -number } else { number }),
        Numeral::Duration(ms) => Literal::Duration(if negative { -ms } else { ms }),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_chart_may_hold_is_read() {
        let cases = [
            ("16#7F", Literal::Whole(127)),
            ("1_0", Literal::Whole(10)),
            ("-2#101", Literal::Whole(-5)),
            ("+8#17", Literal::Whole(15)),
            ("-1.5e3", Literal::Real(-1500.0)),
            ("1min30s", Literal::Duration(90_000)),
            ("t#1m30s", Literal::Duration(90_000)),
        ];
        for (text, value) in cases {
            assert_eq!(literal(text), Some(value), "{text}");
        }
    }

    #[test]
    fn nothing_else_is_read() {
        for text in ["", "-", "x", "16#", "16#G", "1__0", "--1", "- 1", "Q#1s", "1 0", "T#"] {
            assert_eq!(literal(text), None, "{text}");
        }
    }
}
