//! Literals: numbers in other bases, typed numbers, durations.

use super::tree::ExprKind;

/// The longest duration of a chart.
const LONGEST_MS: u64 = 2_147_483_647;

/// A whole number, perhaps in another base.
pub fn integer(text: &str) -> ExprKind {
    let digits = text.replace('_', "");
    let (base, digits) = match digits.split_once('#') {
        Some((base, digits)) => (base.parse().unwrap_or(10), digits.to_string()),
        None => (10, digits),
    };
    match i64::from_str_radix(&digits, base) {
        Ok(number) => ExprKind::Integer(number),
        Err(_) => ExprKind::Unknown(format!("the number `{text}` is too large")),
    }
}

/// A number with a fraction.
pub fn real(text: &str) -> ExprKind {
    let digits = text.replace('_', "");
    let fraction = if digits.contains('.') { digits } else { digits.replacen(['e', 'E'], ".0e", 1) };
    ExprKind::Real(fraction)
}

/// What stands behind the name of a type: `T#2s`, `BOOL#1`, `INT#16#F`, `Colour#Red`.
pub fn typed(text: &str) -> ExprKind {
    let (name, value) = text.split_once('#').unwrap_or((text, ""));
    match name.to_ascii_uppercase().as_str() {
        "T" | "TIME" | "LTIME" | "LT" => match duration(value) {
            Some(ms) if ms <= LONGEST_MS => ExprKind::Duration(ms),
            Some(_) => ExprKind::Unknown(format!("`{text}` is longer than 24 days")),
            None => ExprKind::Unknown(format!("`{text}` is no duration in whole milliseconds")),
        },
        "BOOL" => match value.to_ascii_uppercase().as_str() {
            "1" | "TRUE" => ExprKind::Bool(true),
            "0" | "FALSE" => ExprKind::Bool(false),
            _ => ExprKind::Unknown(format!("`{text}` is no Boolean")),
        },
        "SINT" | "INT" | "DINT" | "LINT" | "USINT" | "UINT" | "UDINT" | "ULINT" | "BYTE" | "WORD" | "DWORD"
        | "LWORD" => match value.strip_prefix('-').map_or_else(|| integer(value), integer) {
            ExprKind::Integer(number) if value.starts_with('-') => ExprKind::Integer(-number),
            other => other,
        },
        "REAL" | "LREAL" => real(value.trim_start_matches('+')),
        "TOD" | "DT" | "D" | "DATE" | "TIME_OF_DAY" | "DATE_AND_TIME" => {
            ExprKind::Unknown(format!("`{text}`: charts have no dates"))
        }
        _ => ExprKind::Path(format!("{name}.{value}")),
    }
}

/// The milliseconds of `1h_30m`, `2.5s`, `500ms`; none if it is no whole number of them.
pub fn duration(text: &str) -> Option<u64> {
    let text = text.replace('_', "").to_ascii_lowercase();
    let mut rest = text.as_str();
    let mut microseconds: u64 = 0;
    while !rest.is_empty() {
        let number = rest.len() - rest.trim_start_matches(|c: char| c.is_ascii_digit() || c == '.').len();
        let (digits, behind) = rest.split_at(number);
        let unit = behind.len() - behind.trim_start_matches(|c: char| c.is_ascii_lowercase()).len();
        let (unit, behind) = behind.split_at(unit);
        let scale: u64 = match unit {
            "d" => 86_400_000_000,
            "h" => 3_600_000_000,
            "m" => 60_000_000,
            "s" => 1_000_000,
            "ms" => 1_000,
            "us" => 1,
            _ => return None,
        };
        microseconds = microseconds.checked_add(scaled(digits, scale)?)?;
        rest = behind;
    }
    (microseconds % 1_000 == 0 && !text.is_empty()).then_some(microseconds / 1_000)
}

/// A decimal times a whole number, if that is a whole number.
fn scaled(digits: &str, scale: u64) -> Option<u64> {
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    if whole.is_empty() || fraction.len() > 12 || fraction.contains('.') {
        return None;
    }
    let whole = whole.parse::<u64>().ok()?.checked_mul(scale)?;
    if fraction.is_empty() {
        return Some(whole);
    }
    let tenth = 10_u128.pow(u32::try_from(fraction.len()).ok()?);
    let part = fraction.parse::<u128>().ok()? * u128::from(scale);
    if part % tenth != 0 {
        return None;
    }
    whole.checked_add(u64::try_from(part / tenth).ok()?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn durations_are_whole_milliseconds() {
        let cases = [
            ("2s", Some(2_000)),
            ("1h_30m", Some(5_400_000)),
            ("2.5S", Some(2_500)),
            ("1d2h3m4s5ms", Some(93_784_005)),
            ("0.0001s", None),
            ("2", None),
            ("s", None),
            ("", None),
            ("1.2.3s", None),
            ("99999999999999999999d", None),
        ];
        for (text, expected) in cases {
            assert_eq!(duration(text), expected, "{text}");
        }
    }

    #[test]
    fn typed_literals() {
        assert_eq!(typed("T#1500ms"), ExprKind::Duration(1_500));
        assert_eq!(typed("BOOL#1"), ExprKind::Bool(true));
        assert_eq!(typed("INT#-5"), ExprKind::Integer(-5));
        assert_eq!(typed("WORD#16#FF"), ExprKind::Integer(255));
        assert_eq!(typed("Colour#Red"), ExprKind::Path("Colour.Red".into()));
        assert!(matches!(typed("T#25d"), ExprKind::Unknown(_)));
        assert!(matches!(typed("D#2020"), ExprKind::Unknown(_)));
        assert_eq!(real("1e3"), ExprKind::Real("1.0e3".into()));
    }
}
