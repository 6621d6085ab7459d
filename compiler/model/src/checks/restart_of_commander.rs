//! W0428: a restart may leave dead what the initial step of the grafcet commands.
//!
//! Killed and started at once, a grafcet begins anew (R15), and what it commands is killed with it. An initial step that was
//! active before remains so without an event: its pulse on activation, and its `run`, are not given again.
//!
//! Warned of: `kill P on activation  start P on activation`, where the initial step of P has `start Q on activation`
//! Not warned of: the same where a later step of P starts Q

use crate::chart::{Event, GrafcetId, PulseKind, StepId};
use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, Span};
use rustc_hash::FxHashMap;

pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    let chart = &resolved.chart;
    if chart.pulses.is_empty() {
        return;
    }
    // The order in an initial step that waits for its activation, by grafcet.
    let mut waits: FxHashMap<GrafcetId, Span> = FxHashMap::default();
    let mut at = |step: StepId, span: Span| {
        if chart.steps[step].initial {
            waits.entry(chart.steps[step].grafcet).or_insert(span);
        }
    };
    for pulse in &chart.pulses {
        if let Event::Activation(step) = pulse.event {
            at(step, pulse.span);
        }
    }
    chart.runs.iter().for_each(|run| at(run.step, run.span));
    let of = |kind: PulseKind| chart.pulses.iter().filter(move |pulse| pulse.kind == kind);
    let mut kills: FxHashMap<(GrafcetId, Event), Span> = FxHashMap::default();
    for kill in of(PulseKind::Kill) {
        kills.entry((kill.grafcet, kill.event)).or_insert(kill.span);
    }
    for start in of(PulseKind::Start) {
        let kill = kills.get(&(start.grafcet, start.event));
        if let (Some(kill), Some(order)) = (kill, waits.get(&start.grafcet)) {
            let name = &chart.grafcets[start.grafcet].name;
            let message = format!("restarting `{name}` does not start again what its initial step commands");
            diagnostics.push(
                Diagnostic::new(Code::W0428, start.span, message)
                    .also(*kill, "it is killed at once, and what it commands with it")
                    .also(*order, "this waits for an activation that an active initial step has not")
                    .help("give this order in a step after the initial one, or start the grafcet a micro-step later"),
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{passes, passes_with};

    fn chart(restart: &str, of_initial: &str, of_later: &str) -> String {
        format!(
            "input a : bool grafcet M {{ initial step 1 {{ start P on activation }} step 2 {{ {restart} }}
             transition 1 -> 2 : a }}
             child grafcet P of M {{ initial step 10 {{ {of_initial} }} step 11 {{ {of_later} }} transition 10 -> 11 : a }}
             child grafcet Q of P {{ initial step 20 }}"
        )
    }

    #[test]
    fn of_the_initial_step() {
        let restart = "kill P on activation start P on activation";
        passes_with(&["W0428"], &chart(restart, "start Q on activation", ""));
        passes_with(&["W0428"], &chart(restart, "run Q", ""));
    }

    #[test]
    fn of_another_step() {
        passes(&chart("kill P on activation start P on activation", "", "run Q"));
        passes(&chart("kill P on activation", "run Q", ""));
    }
}
