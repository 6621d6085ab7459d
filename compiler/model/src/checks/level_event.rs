//! W0402: the event of a stored action holds without any edge.
//!
//! The expression after `on event` is to name events, edges that is (IEC 60848, symbol 29). Where a part of it holds by level, the
//! action is done again with every input event as long as it does (R7).
//!
//! Warned of: `C := C + 1 on event a`
//! Not warned of: `C := C + 1 on event ↑a`, `… on event ↑a and b`

use super::truth::{Edges, Truth, truths};
use crate::chart::Event;
use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};

pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    let chart = &resolved.chart;
    let truths = truths(&chart.exprs, &chart.variables, Edges::Never);
    for action in &chart.stored {
        match action.event {
            Event::Event(_, event) if truths[event] != Truth::Never => diagnostics.push(
                Diagnostic::new(Code::W0402, chart.exprs[event].span, "this event can hold without an edge")
                    .note("the action is done with every input event while it holds")
                    .note("IEC 60848, symbol 29: the expression of an event should have one or more edges")
                    .help("write the edge that is meant, with `↑` or `↓`"),
            ),
            Event::Event(..)
            | Event::Deactivation(_)
            | Event::Clearing(_)
            | Event::Activation(_)
            | Event::EachScan(..) => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{passes, passes_with};

    #[test]
    fn a_level() {
        passes_with(&["W0402"], "input a : bool var C : int initial step 1 { C := C + 1 on event a }");
        passes_with(&["W0402"], "input a, b : bool var C : int initial step 1 { C := C + 1 on event ↑a or b }");
    }

    #[test]
    fn an_edge() {
        passes("input a, b : bool var C : int initial step 1 { C := C + 1 on event ↑a and (b or ↓b) }");
        passes("const never : bool := 0 input a : bool var C : int initial step 1 { C := C + 1 on event ↑a or never }");
    }
}
