//! W0416: a situation without a way out, in a grafcet that is meant to go round.
//!
//! In this situation no transition of the grafcet has all the steps before it active, and no order, no enclosing step
//! and no source transition brings it further: it stays so for good. Told only if the arcs lead from an initial step
//! back to it; a sequence that is drawn with an end may end.
//!
//! Warned of: `1 -> 2, 3 : a`, `2 -> 4 : b`, `2, 3 -> 1 : c`: with steps 3 and 4 active
//! Not warned of: `1 -> 2 : a`, `2 -> 3 : b`, which nothing leads back

use super::wording;
use crate::analysis::Analysis;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};

/// More transitions that wait are not shown.
const SHOWN: usize = 4;

/// One warning per grafcet.
pub(super) fn check(analysis: &Analysis, diagnostics: &mut Diagnostics) {
    let net = analysis.net();
    for end in &analysis.liveness().situations.dead_ends {
        let grafcet = &net.grafcets[end.grafcet];
        let waits = |step: &&grafc_model::chart::StepId| !analysis.arcs.leaving(**step).is_empty();
        let step = end.situation.iter().find(waits).or(end.situation.first());
        let place = step.map_or(grafcet.span, |step| net.places[*step].span);
        let message = match end.situation.is_empty() {
            true => format!("the grafcet `{}` may end with no active step", grafcet.name),
            false => format!("nothing leads on from {}", wording::steps(net, &end.situation)),
        };
        let mut diagnostic = Diagnostic::new(Code::W0416, place, message);
        if end.situation.len() > 1 {
            diagnostic = diagnostic.here("with the others named, and no other active");
        }
        let waiting = end.situation.iter().flat_map(|step| analysis.arcs.leaving(*step)).copied();
        let mut shown = Vec::new();
        for t in waiting {
            let missing: Vec<_> =
                net.transitions[t].pre.iter().copied().filter(|step| !end.situation.contains(step)).collect();
            if shown.len() < SHOWN && !missing.is_empty() && !shown.contains(&t) {
                shown.push(t);
                let text = format!("this waits for {} as well", wording::steps(net, &missing));
                diagnostic = diagnostic.also(net.transitions[t].span, text);
            }
        }
        if !end.way.is_empty() {
            diagnostic = diagnostic.note(format!("the way there: {}", wording::way(net, &end.way)));
        }
        diagnostics.push(diagnostic.note("no order and no enclosing step ends it").help(
            "add a transition that leads on; where the chart is to end there, allow the warning with the reason",
        ));
    }
}
