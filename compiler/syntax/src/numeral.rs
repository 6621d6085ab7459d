//! Numbers and durations: their text to their value.
//!
//! The lexer takes any run that begins with a digit or `T#` as one word, so that a slip inside of it is one fault with
//! a reason, and not a row of puzzling tokens.

use crate::habits::words::{UNITS, ours};
use crate::habits::{Cure, named};
use crate::token::Token;
use grafc_diagnostics::{Code, Diagnostic, Span};

/// What a word that begins with a digit or with `T#` is.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) enum Numeral {
    /// `16#FF`, `1_000`
    Integer(i64),
    /// `8.5`
    Real(f64),
    /// `3s`, in milliseconds
    Duration(i64),
}

impl Numeral {
    /// Its token; the value is read again where it is needed.
    pub(crate) fn token(self) -> Token {
        match self {
            Numeral::Integer(_) => Token::Integer,
            Numeral::Real(_) => Token::Real,
            Numeral::Duration(_) => Token::Duration,
        }
    }
}

/// Why a number or a duration could not be read.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) enum Fault {
    /// Letters or marks where a number has none.
    Number,
    /// No digits after `16#`, or digits that the base does not have.
    Digits(u32),
    /// A base other than 2, 8, 16.
    Base,
    /// `_` not between two digits.
    Separator,
    /// Beyond 64 bits, or beyond double precision.
    TooLarge,
    /// A part of the duration has no unit, or an unknown one.
    Unit,
    /// Nothing after `T#`.
    NoDuration,
    /// Units not from large to small, each once.
    UnitOrder,
    /// A fraction in a part that is not the last.
    Fraction,
    /// Finer than a millisecond.
    TooFine,
    /// Beyond 2^31 - 1 milliseconds.
    TooLong,
}

/// The longest duration, in milliseconds: about 24 days and 20 hours, what a 32-bit `TIME` holds.
const LONGEST: u128 = i32::MAX as u128;

impl Fault {
    /// The message for a word.
    pub(crate) fn diagnostic(self, span: Span, word: &str) -> Diagnostic {
        let shown = crate::shown::shorten(word);
        let number = |message: String| Diagnostic::new(Code::E0105, span, message);
        let duration = |message: String| Diagnostic::new(Code::E0106, span, message);
        match self {
            Fault::Number => {
                let fault = number(format!("`{shown}` is not a number"))
                    .note("numbers are written `3`, `-2`, `8.5`, `1.5e-3`, `16#FF`; names begin with a letter");
                match based_of_c(word) {
                    Some(right) => rewritten(fault, span, &right),
                    None => with(fault, named(word, span)),
                }
            }
            Fault::Digits(base) => number(format!("`{shown}` is not a number in base {base}"))
                .help(format!("base {base} has the digits {}", digits_of(base))),
            Fault::Base => number(format!("`{shown}` has an unknown base"))
                .note("the bases are `2#`, `8#` and `16#`")
                .help("write the number in base 10, without `#`"),
            Fault::Separator => {
                let right = word.split('_').filter(|part| !part.is_empty()).collect::<Vec<_>>().join("_");
                let fault = number(format!("`_` in `{shown}` is not between two digits"));
                if read(&right).is_ok() { rewritten(fault, span, &right) } else { fault.help("leave the `_` out") }
            }
            Fault::TooLarge => number(format!("the number `{shown}` is too large")).help(
                if !word.contains('#') && word.contains(['.', 'e', 'E']) {
                    "a `real` goes to 3.4028235e38, an `lreal` to 1.7976931348623157e308"
                } else {
                    "a whole number has 64 bits here, and 32 at most in a variable"
                },
            ),
            Fault::Unit => {
                let fault = duration(format!("`{shown}` is not a duration"))
                    .note("each part of a duration has a unit: `d`, `h`, `min`, `s` or `ms`, as in `1min30s`; `T#1m30s` has `m` for minutes");
                match in_our_units(word) {
                    Some(right) => rewritten(fault, span, &right),
                    None => fault.help("give each part one of these units"),
                }
            }
            Fault::NoDuration => {
                duration(format!("`{shown}` has no value")).help("write the time behind it, as in `T#1m30s`")
            }
            Fault::UnitOrder => duration(format!("the units of `{shown}` are not in order"))
                .help("units go from large to small, each once, as in `1h5min2s`"),
            Fault::Fraction => duration(format!("`{shown}` has a fraction before its last part"))
                .help("only the last part may have a fraction, as in `1min2.5s`"),
            Fault::TooFine => duration(format!("the duration `{shown}` is finer than a millisecond"))
                .help("write whole milliseconds, `1ms` at least"),
            Fault::TooLong => duration(format!("the duration `{shown}` is too long"))
                .note("the longest is 2147483647 ms, about 24 days and 20 hours")
                .help("count the days in a variable"),
        }
    }
}

fn with(fault: Diagnostic, cure: Cure) -> Diagnostic {
    Diagnostic { fixes: cure.fix.into_iter().collect(), ..fault.help(cure.words) }
}

fn rewritten(fault: Diagnostic, span: Span, right: &str) -> Diagnostic {
    with(fault, Cure::guess(format!("write `{right}`"), span, right))
}

/// `0xFF` and `0b101` as `16#FF` and `2#101`.
fn based_of_c(word: &str) -> Option<String> {
    let lower = word.to_lowercase();
    let (prefix, base) =
        [("0x", "16#"), ("0b", "2#"), ("0o", "8#")].into_iter().find(|(prefix, _)| lower.starts_with(prefix))?;
    let right = format!("{base}{}", &word[prefix.len()..]);
    read(&right).is_ok().then_some(right)
}

fn digits_of(base: u32) -> &'static str {
    match base {
        2 => "`0` and `1`",
        8 => "`0` to `7`",
        _ => "`0` to `9` and `A` to `F`",
    }
}

/// `3sec` and `1m30s` as `3s` and `1min30s`: the same with our names of the units.
fn in_our_units(word: &str) -> Option<String> {
    let mut right = String::new();
    let mut rest = word;
    while !rest.is_empty() {
        let value_end = rest.find(|c: char| !c.is_ascii_digit() && c != '.')?;
        let (value, after) = rest.split_at(value_end);
        let unit_end = after.find(|c: char| c.is_ascii_digit()).unwrap_or(after.len());
        let (unit, after) = after.split_at(unit_end);
        right.push_str(value);
        right.push_str(ours(UNITS, unit.trim_end_matches(['_', '.']))?);
        rest = after;
    }
    read(&right).is_ok().then_some(right)
}

/// Reads a word that begins with a digit or with `T#`.
pub(crate) fn read(word: &str) -> Result<Numeral, Fault> {
    if let Some((before, after)) = word.split_once('#') {
        if before.starts_with(|c: char| c.is_ascii_alphabetic()) {
            return iec_duration(after);
        }
        return based(before, after).map(Numeral::Integer);
    }
    let digits_end = word.find(|c: char| !c.is_ascii_digit() && c != '_').unwrap_or(word.len());
    match word[digits_end..].chars().next() {
        None => whole(word).map(Numeral::Integer),
        Some('.') => {
            let fraction_end = word[digits_end + 1..]
                .find(|c: char| !c.is_ascii_digit() && c != '_')
                .map_or(word.len(), |n| digits_end + 1 + n);
            match word[fraction_end..].chars().next() {
                None | Some('e' | 'E') => real(word),
                Some(c) if begins_unit(c) => own_duration(word),
                Some(_) => Err(Fault::Number),
            }
        }
        Some('e' | 'E') => real(word),
        Some(c) if begins_unit(c) => own_duration(word),
        Some(_) => Err(Fault::Number),
    }
}

/// Whether a letter after digits suggests that a duration was meant: `3sec`, `20µs`.
fn begins_unit(c: char) -> bool {
    matches!(c.to_ascii_lowercase(), 'd' | 'h' | 'm' | 's' | 'u' | 'µ' | 'μ' | 'n')
}

/// A decimal whole number, `_` allowed between digits.
pub(crate) fn whole(word: &str) -> Result<i64, Fault> {
    accumulate(word, 10)
}

fn based(base: &str, digits: &str) -> Result<i64, Fault> {
    let base = match base {
        "2" => 2,
        "8" => 8,
        "16" => 16,
        _ => return Err(Fault::Base),
    };
    accumulate(digits, base)
}

fn accumulate(digits: &str, base: u32) -> Result<i64, Fault> {
    check_separators(digits)?;
    let mut value = Some(0i64);
    let mut any = false;
    for c in digits.chars().filter(|c| *c != '_') {
        let digit = c.to_digit(base).ok_or(if base == 10 { Fault::Number } else { Fault::Digits(base) })?;
        value = value.and_then(|v| v.checked_mul(i64::from(base))?.checked_add(i64::from(digit)));
        any = true;
    }
    if !any {
        return Err(if base == 10 { Fault::Number } else { Fault::Digits(base) });
    }
    value.ok_or(Fault::TooLarge)
}

/// `_` stands only between two digits (IEC 61131-3, 6.3.2).
fn check_separators(digits: &str) -> Result<(), Fault> {
    let mut before = '_';
    for c in digits.chars() {
        if c == '_' && !before.is_ascii_alphanumeric() {
            return Err(Fault::Separator);
        }
        before = c;
    }
    if before == '_' && !digits.is_empty() { Err(Fault::Separator) } else { Ok(()) }
}

fn real(word: &str) -> Result<Numeral, Fault> {
    for part in word.split(['.', 'e', 'E', '+', '-']) {
        check_separators(part)?;
        if part.chars().any(|c| !c.is_ascii_digit() && c != '_') {
            return Err(Fault::Number);
        }
    }
    let plain: String = word.chars().filter(|c| *c != '_').collect();
    let value: f64 = plain.parse().map_err(|_| Fault::Number)?;
    if value.is_finite() { Ok(Numeral::Real(value)) } else { Err(Fault::TooLarge) }
}

/// `1min30s`
fn own_duration(word: &str) -> Result<Numeral, Fault> {
    let read = duration(word, |unit| match unit {
        "d" => Some(DAY),
        "h" => Some(HOUR),
        "min" => Some(MINUTE),
        "s" => Some(SECOND),
        "ms" => Some(1),
        _ => None,
    });
    // `1M1` is what a valve is called on a drawing.
    let is_designation = word.contains(|c: char| c.is_ascii_uppercase()) && in_our_units(word).is_none();
    match read {
        Err(Fault::Unit) if is_designation => Err(Fault::Number),
        read => read,
    }
}

/// What follows `T#` or `TIME#`; letters of either case, `_` between the parts (IEC 61131-3, 6.3.5).
fn iec_duration(parts: &str) -> Result<Numeral, Fault> {
    if parts.is_empty() {
        return Err(Fault::NoDuration);
    }
    duration(parts, |unit| match unit.trim_end_matches('_').to_ascii_lowercase().as_str() {
        "d" => Some(DAY),
        "h" => Some(HOUR),
        "m" => Some(MINUTE),
        "s" => Some(SECOND),
        "ms" => Some(1),
        _ => None,
    })
}

const SECOND: u128 = 1_000;
const MINUTE: u128 = 60 * SECOND;
const HOUR: u128 = 60 * MINUTE;
const DAY: u128 = 24 * HOUR;

fn duration(word: &str, unit_of: impl Fn(&str) -> Option<u128>) -> Result<Numeral, Fault> {
    let mut total = 0u128;
    let mut last_unit = u128::MAX;
    let mut fraction_seen = false;
    let mut rest = word;
    while !rest.is_empty() {
        let value_end = rest.find(|c: char| !c.is_ascii_digit() && c != '_' && c != '.').unwrap_or(rest.len());
        let (value, after) = rest.split_at(value_end);
        let unit_end = after.find(|c: char| c.is_ascii_digit() || c == '.').unwrap_or(after.len());
        let (unit, after) = after.split_at(unit_end);
        let unit = unit_of(unit).ok_or(Fault::Unit)?;
        if after.is_empty() && word.ends_with('_') {
            return Err(Fault::Separator);
        }
        if unit >= last_unit {
            return Err(Fault::UnitOrder);
        }
        if fraction_seen {
            return Err(Fault::Fraction);
        }
        fraction_seen = value.contains('.');
        // A part cannot pull the total below what it is, so the bound can wait: no overflow in 128 bits.
        total += part(value, unit)?;
        if total > LONGEST {
            return Err(Fault::TooLong);
        }
        last_unit = unit;
        rest = after;
    }
    Ok(Numeral::Duration(total as i64))
}

/// The milliseconds of `1.5` of a unit, exactly.
fn part(value: &str, unit: u128) -> Result<u128, Fault> {
    let (whole, fraction) = value.split_once('.').unwrap_or((value, ""));
    if fraction.contains('.') || whole.is_empty() {
        return Err(Fault::Unit);
    }
    check_separators(whole)?;
    check_separators(fraction)?;
    let mut amount = 0u128;
    for digit in whole.chars().filter_map(|c| c.to_digit(10)) {
        amount = amount * 10 + u128::from(digit);
        if amount > LONGEST {
            return Err(Fault::TooLong);
        }
    }
    amount *= unit;
    let mut numerator = 0u128;
    let mut denominator = 1u128;
    for digit in fraction.trim_end_matches(['0', '_']).chars().filter_map(|c| c.to_digit(10)) {
        // The finest fraction of a day that is whole milliseconds has ten digits: a day is 2^10 * 84375 ms.
        if denominator > 10u128.pow(12) {
            return Err(Fault::TooFine);
        }
        numerator = numerator * 10 + u128::from(digit);
        denominator *= 10;
    }
    if (numerator * unit) % denominator != 0 {
        return Err(Fault::TooFine);
    }
    Ok(amount + numerator * unit / denominator)
}
