//! W0412: two assignments may give a variable different values in the same micro-step.
//!
//! The last one wins and the flag ALLOC_CONFLICT is raised (R7); that they do not meet is up to the designer (IEC 60848,
//! 4.10.5). Of assignments that both read the variable W0410 says more.
//!
//! Warned of: `V := 1 on activation` in one sequence and `V := 0 on activation` in a parallel one
//! Not warned of: the same in two steps of one sequence, or twice the same value

use crate::analysis::Analysis;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};

/// One warning per variable.
pub(super) fn check(analysis: &Analysis, diagnostics: &mut Diagnostics) {
    let net = analysis.net();
    for found in &analysis.together().conflicts {
        let name = &net.variables[found.variable].name;
        let (first, second) = (&net.stored[found.first], &net.stored[found.second]);
        diagnostics.push(
            Diagnostic::new(
                Code::W0412,
                second.span,
                format!("this and another assignment may give `{name}` different values at once"),
            )
            .also(first.span, "may be done in the same micro-step")
            .note("the last assignment wins, and the flag ALLOC_CONFLICT is raised")
            .note("IEC 60848, 4.10.5: that two allocations do not contradict each other is up to the designer"),
        );
    }
}
