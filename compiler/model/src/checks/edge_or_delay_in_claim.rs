//! E0416: a claim holds a delay, or a claim about states an edge.
//!
//! A claim is about what stands after a reaction, and an edge is gone by then (X4). It keeps nothing from one reaction to
//! the next, and a delay would be such a memory. Assumptions may ask for edges of inputs: they are about what the plant
//! does between two reactions.
//!
//! Wrong: `assert not (5s/VA)`, `assert ↑a`
//! Right: `assert [T2 <= 5s]`, `assume not (↑a and ↑b)`

use super::edges::first_edges;
use crate::chart::{ClaimKind, ExprKind};
use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};

pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    let claims = &resolved.chart.claims;
    let edges = first_edges(&claims.exprs);
    for claim in &claims.list {
        for id in claim.nodes() {
            let span = claims.exprs[id].span;
            match claims.exprs[id].kind {
                ExprKind::Delay { .. } => diagnostics.push(
                    Diagnostic::new(Code::E0416, span, "a delay in a claim")
                        .note("a claim is about one state and remembers none before it")
                        .help("compare the duration of a step, as in `[T2 >= 5s]`"),
                ),
                ExprKind::Rise(operand) | ExprKind::Fall(operand) => {
                    if claim.kind != ClaimKind::Assume {
                        diagnostics.push(
                            Diagnostic::new(Code::E0416, span, "an edge in a claim about states")
                                .note("a state is what stands after a reaction, and by then no edge is there any more")
                                .help("claim what the edge leads to; only `assume` may ask for edges, of inputs"),
                        );
                    } else if let Some(inner) = edges[operand] {
                        diagnostics.push(
                            Diagnostic::new(Code::E0413, claims.exprs[inner].span, "an edge inside an edge")
                                .also(span, "the edge around it")
                                .note("IEC 60848, 4.6.1: an edge is an event, of a Boolean variable or expression")
                                .help("leave out one of the two"),
                        );
                    }
                }
                ExprKind::Literal(_)
                | ExprKind::Variable(_)
                | ExprKind::StepActive(_)
                | ExprKind::StepTime(_)
                | ExprKind::MacroActive(_)
                | ExprKind::GrafcetActive(_)
                | ExprKind::GrafcetFrozen(_)
                | ExprKind::Not(_)
                | ExprKind::And(..)
                | ExprKind::Or(..)
                | ExprKind::Xor(..)
                | ExprKind::Compare(..)
                | ExprKind::Arithmetic(..)
                | ExprKind::Negate(_)
                | ExprKind::Widen(_) => {}
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{breaks, breaks_all, passes};

    const CHART: &str = "input a, b : bool output V : bool initial step 1 { V } step 2 transition 1 -> 2 : a
        transition 2 -> 1 : b ";

    #[test]
    fn delays() {
        breaks("E0416", &format!("{CHART} assert not (5s/V)"));
        breaks("E0416", &format!("{CHART} assume not (5s/a)"));
        breaks("E0416", &format!("{CHART} reach X1/5s"));
    }

    #[test]
    fn edges() {
        breaks("E0416", &format!("{CHART} assert not ↑a"));
        breaks_all(&["E0416", "E0416"], &format!("{CHART} final ↑a or ↓X1"));
        breaks("E0413", &format!("{CHART} assume not ↑(a and ↑b)"));
        passes(&format!("{CHART} assume not (↑a and ↓(a or b))"));
    }
}
