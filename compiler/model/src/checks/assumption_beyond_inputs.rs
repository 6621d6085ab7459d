//! E0417: an assumption reads something else than inputs and constants.
//!
//! What is assumed is what the plant does. What the chart does follows from it, and is proved and not assumed.
//!
//! Wrong: `assume not (X5 and a)`
//! Right: `assert not (X5 and V)`, `assume not (a and b)`

use crate::chart::{ClaimKind, ExprKind, VariableKind};
use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};

pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    let chart = &resolved.chart;
    for claim in chart.claims.of(ClaimKind::Assume) {
        for id in claim.nodes() {
            let expr = &chart.claims.exprs[id];
            let (what, declared) = match expr.kind {
                ExprKind::Variable(id) => match chart.variables[id].kind {
                    VariableKind::Input | VariableKind::Constant => continue,
                    VariableKind::Output => ("an output", Some(chart.variables[id].span)),
                    VariableKind::Internal => ("a variable of the chart", Some(chart.variables[id].span)),
                },
                ExprKind::StepActive(_) => ("the activity of a step", None),
                ExprKind::StepTime(_) => ("the duration of a step", None),
                ExprKind::MacroActive(_) => ("the activity of a macro-step", None),
                ExprKind::GrafcetActive(_) | ExprKind::GrafcetFrozen(_) => ("the activity of a grafcet", None),
                ExprKind::Literal(_)
                | ExprKind::Not(_)
                | ExprKind::And(..)
                | ExprKind::Or(..)
                | ExprKind::Xor(..)
                | ExprKind::Rise(_)
                | ExprKind::Fall(_)
                | ExprKind::Delay { .. }
                | ExprKind::Compare(..)
                | ExprKind::Arithmetic(..)
                | ExprKind::Negate(_)
                | ExprKind::Widen(_) => continue,
            };
            let mut fault = Diagnostic::new(Code::E0417, expr.span, format!("an assumption about {what}"));
            if let Some(declared) = declared {
                fault = fault.also(declared, "declared here");
            }
            diagnostics.push(
                fault
                    .note("assumptions are about inputs, which the plant gives; what the chart does is asserted")
                    .help("write `assert`, or name inputs and constants only"),
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{breaks, breaks_all, passes};

    const CHART: &str = "input a, b : bool input n : int const k : int := 7 var m : int output V : bool
        initial step 1 { V m := 2 on activation } step 2 transition 1 -> 2 : a and [n > m]
        transition 2 -> 1 : b macro step M5 expansion M5 { step E5 step S5 } ";

    #[test]
    fn what_the_chart_does() {
        breaks("E0417", &format!("{CHART} assume not (X1 and a)"));
        breaks("E0417", &format!("{CHART} assume a or V"));
        breaks_all(&["E0417"; 4], &format!("{CHART} assume [n > m] or [T1 > 3s] or XM5 or XG1"));
    }

    #[test]
    fn what_the_plant_does() {
        passes(&format!("{CHART} assume a or not b or [n < k] assert not (X1 and V) or [m = 2]"));
    }
}
