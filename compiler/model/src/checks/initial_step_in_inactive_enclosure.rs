//! E0308: a step of an enclosure is initial only if the enclosing step is.
//!
//! What is enclosed is active only while its enclosing step is (IEC 60848, 7.4), so an initial step in an enclosure that starts
//! inactive could not be active at the start (table 10, symbols 5 and 41).
//!
//! Wrong: `initial step 1  enclosing step 2`, `grafcet X2/G2 { initial activated step 20 }`
//! Right: `initial step 1  enclosing step 2`, `grafcet X2/G2 { activated step 20 }`

use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};

pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    let chart = &resolved.chart;
    for step in chart.steps.iter().filter(|step| step.initial) {
        let Some(enclosing) = chart.grafcets[step.grafcet].enclosing_step.map(|id| &chart.steps[id]) else { continue };
        if !enclosing.initial {
            let message =
                format!("step `{}` is initial, but step `{}`, which encloses it, is not", step.label, enclosing.label);
            diagnostics.push(
                Diagnostic::new(Code::E0308, step.span, message)
                    .also(enclosing.span, "not initial")
                    .note("IEC 60848, table 10, symbol 5: initial steps stand in the enclosures of initial enclosing steps")
                    .note("`activated` marks the steps that the enclosing step activates")
.help("write `activated` in place of `initial`, or make the enclosing step initial as well"),
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{breaks, passes};

    #[test]
    fn the_enclosing_step_is_not_initial() {
        breaks("E0308", "grafcet G1 { initial step 1 enclosing step 2 } grafcet X2/G2 { initial activated step 20 }");
    }

    #[test]
    fn the_enclosing_step_is_initial() {
        passes("grafcet G1 { initial enclosing step 2 } grafcet X2/G2 { initial activated step 20 }");
    }
}
