//! W0403: an edge is negated.
//!
//! An edge is there for one evaluation only (IEC 60848, 4.6.1), so `not ↑a` holds nearly always, at every instant at which `a` does
//! not rise just then. What is meant is most often `not a`, or `↓a`.
//!
//! Warned of: `transition 1 -> 2 : b and not ↑a`
//! Not warned of: `transition 1 -> 2 : b and not a`

use crate::chart::{ExprId, ExprKind};
use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, Span};
use index_vec::IndexVec;

/// Of several negations around one edge, only the innermost is reported.
pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    let exprs = &resolved.chart.exprs;
    // The first edge in each expression that no negation in it holds.
    let mut edges: IndexVec<ExprId, Option<ExprId>> = IndexVec::with_capacity(exprs.len());
    for (id, expr) in exprs.iter_enumerated() {
        let below = expr.kind.operands().find_map(|operand| edges[operand]);
        edges.push(match expr.kind {
            ExprKind::Rise(_) | ExprKind::Fall(_) => Some(id),
            ExprKind::Not(_) => {
                // What is made for an automaton has no place.
                if let Some(edge) = below.filter(|_| !expr.span.range().is_empty()) {
                    diagnostics.push(report(expr.span, exprs[edge].span));
                }
                None
            }
            ExprKind::Literal(_)
            | ExprKind::Variable(_)
            | ExprKind::StepActive(_)
            | ExprKind::StepTime(_)
            | ExprKind::MacroActive(_)
            | ExprKind::GrafcetActive(_)
            | ExprKind::GrafcetFrozen(_)
            | ExprKind::And(..)
            | ExprKind::Or(..)
            | ExprKind::Xor(..)
            | ExprKind::Delay { .. }
            | ExprKind::Compare(..)
            | ExprKind::Arithmetic(..)
            | ExprKind::Negate(_)
            | ExprKind::Widen(_) => below,
        });
    }
}

fn report(negation: Span, edge: Span) -> Diagnostic {
    Diagnostic::new(Code::W0403, negation, "the negation of an edge holds nearly always")
        .also(edge, "the edge")
        .note("IEC 60848, 4.6.1: an edge is an event and has no duration")
        .note("the opposite edge is written `↓a`, the absence of the variable `not a`")
        .help("write the opposite edge, or negate what the edge is of")
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{passes, passes_with};

    #[test]
    fn negated() {
        passes_with(&["W0403"], "input a, b : bool initial step 1 step 2 transition 1 -> 2 : b and not ↑a");
        passes_with(&["W0403"], "input a, b : bool initial step 1 step 2 transition 1 -> 2 : not (b or ↓a)");
        passes_with(&["W0403"], "input a, b : bool initial step 1 step 2 transition 1 -> 2 : not (b or not ↓a)");
    }

    #[test]
    fn the_edge_of_a_negation() {
        passes("input a, b : bool initial step 1 step 2 transition 1 -> 2 : ↑(not a) and not b");
    }

    #[test]
    fn the_delay_of_an_edge_is_another_matter() {
        passes("input a : bool initial step 1 step 2 transition 1 -> 2 : not (3s/a)");
    }
}
