//! E0321: a chart has steps.
//!
//! Without a step there is no situation, and nothing to evolve (IEC 60848, 4.2).
//!
//! Wrong: `input a : bool`
//! Right: `input a : bool  initial step 1`

use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, Fix};

pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    if resolved.parts.steps.is_empty() {
        let span = resolved.parts.grafcets.first().map(|grafcet| grafcet.span).unwrap_or_default();
        let diagnostic = Diagnostic::new(Code::E0321, span, "the chart has no steps")
            .help("begin with `initial step 1`, the step that is active at the start");
        // Where there are blocks, the author has to say in which of them it belongs.
        let is_implied = resolved.parts.grafcets.iter().all(|grafcet| grafcet.ast.is_none());
        diagnostics.push(match is_implied && resolved.parts.transitions.is_empty() {
            true => {
                diagnostic.fix(Fix::maybe("add `initial step 1`").replace(resolved.parts.end, "\ninitial step 1\n"))
            }
            false => diagnostic,
        });
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
