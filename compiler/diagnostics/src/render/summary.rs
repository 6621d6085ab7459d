//! How many messages there are.

use crate::{Diagnostics, Severity};

/// A last line for people, `2 errors, 1 warning`; nothing if there are no messages.
pub fn summary(diagnostics: &Diagnostics) -> String {
    let count = |severity| diagnostics.iter().filter(|d| d.severity() == severity).count();
    let counted: Vec<String> = [(count(Severity::Error), "error"), (count(Severity::Warning), "warning")]
        .into_iter()
        .filter(|(n, _)| *n > 0)
        .map(|(n, word)| format!("{n} {word}{}", if n == 1 { "" } else { "s" }))
        .collect();
    if counted.is_empty() { String::new() } else { counted.join(", ") + "\n" }
}
