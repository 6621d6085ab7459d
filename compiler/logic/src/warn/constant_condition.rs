//! W0417: a condition that always holds, or never.
//!
//! It says nothing: what is meant is most often another operand or another operator. A transition that is always true is
//! written with the condition `1` or `true`. A constant of the chart counts as unknown, since it may be set otherwise.
//!
//! Warned of: `transition 1 -> 2 : a and not a`, `… : 0`, `V if a or not a`
//! Not warned of: `transition 1 -> 2 : 1`

use crate::analysis::Analysis;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};
use grafc_model::chart::ExprId;

/// One warning per condition.
pub(super) fn check(analysis: &Analysis, diagnostics: &mut Diagnostics) {
    let net = analysis.net();
    // What is made for an automaton has no place.
    let has_place = |condition: &ExprId| !net.exprs[*condition].span.range().is_empty();
    for found in analysis.liveness().constant.iter().filter(|found| has_place(&found.condition)) {
        let (message, help) = match (found.value, found.transition.is_some()) {
            (false, true) => (
                "this condition never holds, so the transition is never cleared",
                "correct the condition, or leave the transition out",
            ),
            (false, false) => ("this condition never holds", "correct the condition, or leave the action out"),
            (true, true) => ("this condition always holds", "correct the condition, or write `1`"),
            (true, false) => ("this condition always holds", "correct the condition, or leave it out"),
        };
        diagnostics.push(Diagnostic::new(Code::W0417, net.exprs[found.condition].span, message).help(help));
    }
}
