//! W0401: an output of continuous actions is read.
//!
//! Outputs go to the process; what is said about them by reading them again is said better by the steps that give them
//! (IEC 60848, 4.8.2: a condition is about inputs and internal variables). The value read is that of the current
//! situation, steps passed through in one reaction included, and may differ from what is published.
//!
//! Warned of: `step 2 { K }`, `transition 10 -> 11 : K`
//! Not warned of: `transition 10 -> 11 : X2`; a stored output, which has a value of its own: `C := C + 1 on activation`

use crate::chart::{ExprKind, Mode, VariableId, VariableKind};
use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};
use index_vec::{IndexVec, index_vec};

/// One warning per output.
pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    let chart = &resolved.chart;
    let mut told: IndexVec<VariableId, bool> = index_vec![false; chart.variables.len()];
    for expr in &chart.exprs {
        let ExprKind::Variable(id) = expr.kind else { continue };
        let variable = &chart.variables[id];
        if variable.kind == VariableKind::Output
            && variable.mode == Mode::Wire
            && !std::mem::replace(&mut told[id], true)
        {
            diagnostics.push(
                Diagnostic::new(Code::W0401, expr.span, format!("the output `{}` is read", variable.name))
                    .also(variable.span, "declared here")
                    .note("its value is that of the current situation, even if transient, and not the published one")
                    .help("if the published value is meant, read a variable that stored actions set"),
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{passes, passes_with};

    #[test]
    fn a_continuous_output_in_a_condition() {
        passes_with(
            &["W0401"],
            "output K : bool initial step 1 { K } step 2 transition 1 -> 2 : K transition 2 -> 1 : not K",
        );
    }

    #[test]
    fn a_counter() {
        passes("input a : bool output C : int initial step 1 { C := C + 1 on event ↑a }");
    }

    #[test]
    fn an_internal_variable() {
        passes("input a : bool var K : bool initial step 1 { K } step 2 transition 1 -> 2 : a and K");
    }
}
