//! E0321: a chart has steps.
//!
//! Without a step there is no situation, and nothing to evolve (IEC 60848, 4.2).
//!
//! Wrong: `input a : bool`
//! Right: `input a : bool  initial step 1`

use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};

/// Applies the rule.
pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    if resolved.parts.steps.is_empty() {
        let span = resolved.parts.grafcets.first().map(|grafcet| grafcet.span).unwrap_or_default();
        diagnostics.push(
            Diagnostic::new(Code::E0321, span, "the chart has no steps")
                .help("begin with `initial step 1`, the step that is active at the start"),
        );
    }
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{breaks, passes};

    #[test]
    fn without_steps() {
        breaks("E0321", "");
        breaks("E0321", "input a : bool");
        breaks("E0321", "grafcet G1 { }");
    }

    #[test]
    fn with_a_step() {
        passes("initial step 1");
    }
}
