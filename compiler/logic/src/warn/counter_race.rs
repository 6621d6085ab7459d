//! W0410: two assignments count with one variable in the same micro-step.
//!
//! All right sides are computed from the old values (R7), so of two that read the variable that they write only the last
//! takes effect: `C := C + 1` twice at once adds 1.
//!
//! Warned of: `C := C + 1` on activation of two steps of parallel sequences
//! Not warned of: the same in two steps of one sequence

use super::known::Known;
use super::pairs;
use super::together::{meet, ways};
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};
use grafc_model::chart::{ExprKind, Stored};
use grafc_net::Net;

/// Applies the rule: one warning a variable.
pub(super) fn check(known: &mut Known, diagnostics: &mut Diagnostics) {
    let net = known.net;
    for (variable, actions) in known.writers() {
        let counting: Vec<usize> = actions.into_iter().filter(|a| counts(net, &net.stored[*a])).collect();
        let ways: Vec<_> = counting.iter().map(|action| ways(known, *action)).collect();
        let found = pairs::first(counting.len(), |a, b| meet(known, &ways[a], &ways[b]));
        if let Some((a, b)) = found {
            let name = &net.variables[variable].name;
            let (first, second) = (&net.stored[counting[a]], &net.stored[counting[b]]);
            diagnostics.push(
                Diagnostic::new(
                    Code::W0410,
                    second.span,
                    format!("this and another assignment may count with `{name}` at once, and one of them is lost"),
                )
                .also(first.span, "may be done in the same micro-step")
                .note("all right sides are computed from the old values, and the last assignment wins"),
            );
        }
    }
}

/// Whether an action computes a value from the one that it replaces.
pub(super) fn counts(net: &Net, action: &Stored) -> bool {
    let mut open = vec![action.value];
    while let Some(e) = open.pop() {
        if net.exprs[e].kind == ExprKind::Variable(action.target) {
            return true;
        }
        open.extend(net.exprs[e].kind.operands());
    }
    false
}
