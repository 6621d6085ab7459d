//! E0309: each enclosure of an initial enclosing step has an initial step.
//!
//! Activation links act when the enclosing step becomes active, and an initial one does not become active: it is (IEC 60848,
//! table 10, symbol 5). Without an initial step its enclosure would start empty.
//!
//! Wrong: `initial enclosing step 2`, `grafcet X2/G2 { activated step 20 }`
//! Right: `initial enclosing step 2`, `grafcet X2/G2 { initial activated step 20 }`

use super::children;
use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};

pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    let chart = &resolved.chart;
    let below_child = children::below(chart);
    for grafcet in &chart.grafcets {
        let Some(enclosing) = grafcet.enclosing_step.map(|id| &chart.steps[id]) else { continue };
        // An enclosure without steps is E0310.
        let starts_empty = !grafcet.steps.is_empty() && !grafcet.steps.iter().any(|&id| chart.steps[id].initial);
        // Below a child the links act: nothing of it is active at the start.
        if enclosing.initial && starts_empty && !below_child[enclosing.grafcet] {
            let message = format!(
                "`{}` has no initial step, but step `{}`, which encloses it, is initial",
                grafcet.name, enclosing.label
            );
            diagnostics.push(
                Diagnostic::new(Code::E0309, grafcet.span, message)
                    .also(enclosing.span, "initial")
                    .note("IEC 60848, table 10, symbol 5: each enclosure of an initial enclosing step has an initial step")
                    .note("activation links do not act at the start")
.help("mark the steps that are active at the start as `initial`"),
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{breaks, passes};

    #[test]
    fn no_initial_step_in_one_of_two_enclosures() {
        breaks(
            "E0309",
            "grafcet G1 { initial enclosing step 2 } grafcet X2/G2 { initial activated step 20 }
             grafcet X2/G3 { activated step 30 }",
        );
    }

    #[test]
    fn the_example_of_table_10() {
        passes(
            "input p, m, a, b, c, d : bool
             grafcet G1 { initial enclosing step 9 step 8 transition 9 -> 8 : p transition 8 -> 9 : m }
             grafcet X9/G4 { initial step 42 step 43 activated step 44
                             transition 42 -> 43 : a transition 43 -> 44 : b }
             grafcet X9/G3 { initial activated step 65 step 66 step 67
                             transition 65 -> 66 : c transition 66 -> 67 : d }",
        );
    }

    #[test]
    fn an_enclosing_step_that_starts_inactive() {
        passes("grafcet G1 { initial step 1 enclosing step 2 } grafcet X2/G2 { activated step 20 }");
    }
}
