//! W0410: two assignments count with one variable in the same micro-step.
//!
//! All right sides are computed from the old values (R7), so of two that read the variable that they write only the last
//! takes effect: `C := C + 1` twice at once adds 1.
//!
//! Warned of: `C := C + 1` on activation of two steps of parallel sequences
//! Not warned of: the same in two steps of one sequence

use crate::analysis::Analysis;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};

/// One warning per variable.
pub(super) fn check(analysis: &Analysis, diagnostics: &mut Diagnostics) {
    let net = analysis.net();
    for found in &analysis.together().races {
        let name = &net.variables[found.variable].name;
        let (first, second) = (&net.stored[found.first], &net.stored[found.second]);
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
