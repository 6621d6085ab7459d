//! E0413: the operand of an edge holds no edge (X4).
//!
//! An edge is an event and has no duration (IEC 60848, 4.6.1); it cannot rise or fall in turn.
//!
//! Wrong: `transition 1 -> 2 : ↑(a and ↑b)`
//! Right: `transition 1 -> 2 : a and ↑b`

use super::edges::first_edges;
use crate::chart::ExprKind;
use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};

pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    let exprs = &resolved.chart.exprs;
    let edges = first_edges(exprs);
    for expr in exprs {
        if let ExprKind::Rise(operand) | ExprKind::Fall(operand) = expr.kind
            && let Some(inner) = edges[operand]
        {
            diagnostics.push(
                Diagnostic::new(Code::E0413, exprs[inner].span, "an edge inside an edge")
                    .also(expr.span, "the edge around it")
                    .note("IEC 60848, 4.6.1: an edge is an event, of a Boolean variable or expression")
                    .help("leave out one of the two"),
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{breaks, passes};

    #[test]
    fn nested() {
        breaks("E0413", "input a, b : bool initial step 1 transition 1 -> 1 : ↑(a and ↓b)");
    }

    #[test]
    fn side_by_side() {
        passes("input a, b : bool initial step 1 transition 1 -> 1 : ↑(a and b) and ↓b");
    }

    #[test]
    fn of_a_delay() {
        passes("input a : bool initial step 1 transition 1 -> 1 : ↑(3s/a)");
    }
}
