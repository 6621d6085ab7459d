//! E0415: the operand of a delay holds no edge (X5).
//!
//! A delay counts while its operand lasts, and an edge does not last (IEC 60848, symbol 17).
//!
//! Wrong: `transition 1 -> 2 : 3s/(↑a)`
//! Right: `transition 1 -> 2 : 3s/a`

use super::edges::first_edges;
use crate::chart::ExprKind;
use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};

pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    let exprs = &resolved.chart.exprs;
    let edges = first_edges(exprs);
    for expr in exprs {
        if let ExprKind::Delay { operand, .. } = expr.kind
            && let Some(edge) = edges[operand]
        {
            diagnostics.push(
                Diagnostic::new(Code::E0415, exprs[edge].span, "an edge inside a delay")
                    .also(expr.span, "the delay")
                    .note("IEC 60848, symbol 17: what is delayed is true for a time, and an edge is not")
                    .help("delay what the edge is of, without `↑` or `↓`"),
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{breaks, passes};

    #[test]
    fn an_edge() {
        breaks("E0415", "input a : bool initial step 1 transition 1 -> 1 : 3s/(↑a)");
        breaks("E0415", "input a, b : bool initial step 1 transition 1 -> 1 : (b and (3s/(a or ↓b)))/5s");
    }

    #[test]
    fn a_level() {
        passes("input a : bool initial step 1 transition 1 -> 1 : 3s/a/7s");
    }
}
