//! E0414: the condition of a continuous action holds no edge.
//!
//! A continuous action lasts; an edge has no duration (IEC 60848, table 5, symbol 22).
//!
//! Wrong: `step 1 { V if ↑a }`
//! Right: `step 1 { V := 1 on event ↑a }`

use super::edges::first_edges;
use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};

pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    let chart = &resolved.chart;
    let edges = first_edges(&chart.exprs);
    for action in &chart.continuous {
        if let Some(edge) = action.condition.and_then(|condition| edges[condition]) {
            let name = &chart.variables[action.target].name;
            let message = format!("the condition of the continuous action on `{name}` contains an edge");
            diagnostics.push(
                Diagnostic::new(Code::E0414, chart.exprs[edge].span, message)
                    .also(action.span, "the action")
                    .note("IEC 60848, symbol 22: an assignment condition contains no edge, because it has to last")
                    .help(format!("a stored action follows an event: `{name} := 1 on event …`")),
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{breaks, passes};

    #[test]
    fn an_edge() {
        breaks("E0414", "input a, b : bool output V : bool initial step 1 { V if a and ↑b }");
    }

    #[test]
    fn a_level() {
        passes("input a, b : bool output V : bool initial step 1 { V if a and not b }");
    }
}
