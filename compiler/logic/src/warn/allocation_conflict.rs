//! W0412: two assignments may give a variable different values in the same micro-step.
//!
//! The last one wins and the flag ALLOC_CONFLICT is raised (R7); that they do not meet is up to the designer (IEC 60848,
//! 4.10.5). Of assignments that both read the variable W0410 says more.
//!
//! Warned of: `V := 1 on activation` in one sequence and `V := 0 on activation` in a parallel one
//! Not warned of: the same in two steps of one sequence, or twice the same value

use super::counter_race::counts;
use super::known::Known;
use super::pairs;
use super::together::{meet, ways};
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};

/// Applies the rule: one warning a variable.
pub(super) fn check(known: &mut Known, diagnostics: &mut Diagnostics) {
    let net = known.net;
    for (variable, actions) in known.writers() {
        if actions.len() < 2 {
            continue;
        }
        let values: Vec<_> = actions.iter().map(|a| known.value(net.stored[*a].value)).collect();
        let counting: Vec<bool> = actions.iter().map(|a| counts(net, &net.stored[*a])).collect();
        let ways: Vec<_> = actions.iter().map(|a| ways(known, *a)).collect();
        let found = pairs::first(actions.len(), |a, b| {
            values[a] != values[b] && !(counting[a] && counting[b]) && meet(known, &ways[a], &ways[b])
        });
        if let Some((a, b)) = found {
            let name = &net.variables[variable].name;
            let (first, second) = (&net.stored[actions[a]], &net.stored[actions[b]]);
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
}
