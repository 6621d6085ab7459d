//! W0406: a source transition can hold by level.
//!
//! A source transition is always enabled, so while its condition holds, the steps after it are held active (IEC 60848, 6.3.3,
//! note 1). What is meant is most often an edge.
//!
//! Warned of: `transition -> 1 : a`
//! Not warned of: `transition -> 1 : ↑a`

use super::arcs;
use super::truth::{Edges, Truth, truths};
use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};

/// More steps of one transition are not shown.
const SHOWN: usize = 4;

pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    let chart = &resolved.chart;
    let truths = truths(&chart.exprs, &chart.variables, Edges::Never);
    for transition in chart.transitions.iter().filter(|transition| transition.pre.is_empty()) {
        if truths[transition.condition] != Truth::Never {
            let span = chart.exprs[transition.condition].span;
            let message = "while this holds, the source transition holds its steps active";
            let mut diagnostic = Diagnostic::new(Code::W0406, span, message);
            for step in arcs::entered(chart, transition).take(SHOWN) {
                let step = &chart.steps[step];
                diagnostic = diagnostic.also(step.span, format!("step `{}` is held active", step.label));
            }
            let note = "IEC 60848, 6.3.3, note 1: a source transition is always enabled; it is best given an edge";
            let help = "put `↑` before the variable whose change is meant";
            diagnostics.push(diagnostic.note(note).help(help));
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{labels, passes, passes_with};

    #[test]
    fn a_level() {
        passes_with(&["W0406"], "input a : bool step 1 transition -> 1 : a");
    }

    #[test]
    fn the_steps_are_shown() {
        let shown = labels("input a : bool step 1 step 2 transition -> 1, 2 : a");
        assert_eq!(shown, ["1: step `1` is held active", "2: step `2` is held active"]);
    }

    #[test]
    fn of_a_macro_step_the_entry() {
        let shown = labels("input a : bool macro step M3 transition -> M3 : a expansion M3 { step E3 step S3 }");
        assert_eq!(shown, ["E3: step `E3` is held active"]);
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
