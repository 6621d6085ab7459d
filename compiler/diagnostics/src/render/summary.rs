//! How many messages there are.

use crate::{Diagnostics, Severity};

/// A last line for people, `2 errors, 1 warning`, with those that were counted alone; nothing if there are no messages.
pub fn summary(diagnostics: &Diagnostics) -> String {
    let count = |severity| diagnostics.iter().filter(|d| d.severity() == severity).count();
    let errors = count(Severity::Error) + diagnostics.left_out();
    let counted: Vec<String> = [(errors, "error"), (count(Severity::Warning), "warning")]
        .into_iter()
        .filter(|(n, _)| *n > 0)
        .map(|(n, word)| format!("{} {word}{}", grouped(n), if n == 1 { "" } else { "s" }))
        .collect();
    if counted.is_empty() { String::new() } else { counted.join(", ") + "\n" }
}

/// A number as people read it: `3,214`.
pub fn grouped(number: usize) -> String {
    let digits = number.to_string();
    let mut text = String::with_capacity(digits.len() + digits.len() / 3);
    for (place, digit) in digits.char_indices() {
        if place > 0 && (digits.len() - place) % 3 == 0 {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thousands_are_parted() {
        let cases = [(0, "0"), (7, "7"), (999, "999"), (1000, "1,000"), (123_456, "123,456"), (1_234_567, "1,234,567")];
        for (number, text) in cases {
            assert_eq!(grouped(number), text);
        }
    }
}
