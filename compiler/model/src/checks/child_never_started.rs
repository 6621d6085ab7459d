//! W0427: nothing ever starts a child.
//!
//! A child is not active at the start (R15). Without a `start`, a `run` or a forcing order nothing of it ever is.
//!
//! Warned of: `child grafcet P of MAIN { initial step 10 }` and no order on P
//! Not warned of: `grafcet MAIN { initial step 1 { run P } }` beside it

use crate::chart::{GrafcetId, PulseKind};
use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};
use rustc_hash::FxHashSet;

pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    let chart = &resolved.chart;
    let starts = chart.pulses.iter().filter(|pulse| pulse.kind == PulseKind::Start).map(|pulse| pulse.grafcet);
    let forced = chart.orders.iter().map(|order| order.grafcet);
    let started: FxHashSet<GrafcetId> = starts.chain(chart.runs.iter().map(|run| run.grafcet)).chain(forced).collect();
    for (id, grafcet) in chart.grafcets.iter_enumerated().filter(|(_, grafcet)| grafcet.child) {
        if !started.contains(&id) {
            let message = format!("nothing starts the child `{}`, so none of its steps is ever active", grafcet.name);
            let help = format!(
                "add `run {}` to the step that it belongs to, or `start {} on activation`",
                grafcet.name, grafcet.name
            );
            diagnostics.push(Diagnostic::new(Code::W0427, grafcet.span, message).help(help));
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{passes, passes_with};

    const CHILD: &str = "child grafcet P of MAIN { initial step 10 }";

    #[test]
    fn without_an_order() {
        passes_with(&["W0427"], &format!("grafcet MAIN {{ initial step 1 {{ kill P on activation }} }} {CHILD}"));
    }

    #[test]
    fn started_run_or_forced() {
        for order in ["start P on activation", "run P", "force P{INIT}"] {
            passes(&format!("grafcet MAIN {{ initial step 1 {{ {order} }} }} {CHILD}"));
        }
    }
}
