//! W0406: a source transition can hold by level.
//!
//! A source transition is always enabled, so while its condition holds, the steps after it are held active (IEC 60848, 6.3.3,
//! note 1). What is meant is most often an edge.
//!
//! Warned of: `transition -> 1 : a`
//! Not warned of: `transition -> 1 : ↑a`

use super::truth::{Edges, Truth, truths};
use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};

/// Applies the rule.
pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    let chart = &resolved.chart;
    let truths = truths(chart, Edges::Never);
    for transition in chart.transitions.iter().filter(|transition| transition.pre.is_empty()) {
        if truths[transition.condition] != Truth::Never {
            let span = chart.exprs[transition.condition].span;
            diagnostics.push(
                Diagnostic::new(Code::W0406, span, "while this holds, the source transition holds its steps active")
                    .note("IEC 60848, 6.3.3, note 1: a source transition is always enabled; it is best given an edge"),
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{passes, passes_with};

    #[test]
    fn a_level() {
        passes_with(&["W0406"], "input a : bool step 1 transition -> 1 : a");
    }

    #[test]
    fn an_edge() {
        passes("input a, p : bool step 1 transition -> 1 : ↑a and p");
    }

    #[test]
    fn another_transition() {
        passes("input a : bool initial step 1 step 2 transition 1 -> 2 : a");
    }
}
