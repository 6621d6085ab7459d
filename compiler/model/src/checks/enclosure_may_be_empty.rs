//! W0404: an enclosure can become empty while its enclosing step is active.
//!
//! The activity of an enclosing step means that something in each of its enclosures is active (IEC 60848, 7.4 and table 10). A sink
//! transition takes the last active step away; an order can empty the enclosure too. The enclosing step stays active all
//! the same.
//!
//! A sink transition is sensible where several steps of the enclosure are active at once, so it is warned of only where
//! one step is activated and no transition activates more steps than it deactivates.
//!
//! Warned of: `grafcet X9/G4 { activated step 40  transition 40 -> : a }`
//! Not warned of: `grafcet X9/G4 { activated step 40  activated step 41  transition 41 -> : a }`

use crate::chart::{GrafcetId, Situation, Step, StepId, Tables, TransitionId};
use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};
use index_vec::{IndexVec, index_vec};

const MEANING: &str = "IEC 60848, 7.4: while an enclosing step is active, a step in each of its enclosures is";

pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    let chart = &resolved.chart;
    let is_enclosed = |grafcet: GrafcetId| chart.grafcets[grafcet].enclosing_step.is_some();
    for order in chart.orders.iter().filter(|order| is_enclosed(order.grafcet)) {
        let empties = match &order.situation {
            Situation::Steps(steps) => steps.is_empty(),
            Situation::Initial => !chart.grafcets[order.grafcet].steps.iter().any(|&step| chart.steps[step].initial),
            Situation::Current => false,
        };
        if empties && !excludes(chart, order.step, order.grafcet) {
            let name = &chart.grafcets[order.grafcet].name;
            let message = format!("the order empties the enclosure `{name}`, whose enclosing step stays active");
            diagnostics.push(
                Diagnostic::new(Code::W0404, order.span, message)
                    .note(MEANING)
                    .help("force at least one step, or force the enclosing step away"),
            );
        }
    }
    let mut sinks: IndexVec<GrafcetId, Option<TransitionId>> = index_vec![None; chart.grafcets.len()];
    let mut grows: IndexVec<GrafcetId, bool> = index_vec![false; chart.grafcets.len()];
    for (id, transition) in chart.transitions.iter_enumerated() {
        if transition.post.is_empty() {
            sinks[transition.grafcet].get_or_insert(id);
        }
        grows[transition.grafcet] |= transition.post.len() > transition.pre.len();
    }
    for (id, grafcet) in chart.grafcets.iter_enumerated().filter(|(id, _)| is_enclosed(*id)) {
        let count = |mark| marked(chart, id, mark);
        let one_at_a_time = !grows[id] && count(|step| step.activated) <= 1 && count(|step| step.initial) <= 1;
        if let Some(sink) = sinks[id].filter(|_| one_at_a_time) {
            let message =
                format!("the transition empties the enclosure `{}`, whose enclosing step stays active", grafcet.name);
            diagnostics.push(
                Diagnostic::new(Code::W0404, chart.transitions[sink].span, message)
                    .note(MEANING)
                    .help("let the transition lead to a step"),
            );
        }
    }
}

/// How many steps of a grafcet have a mark.
fn marked(chart: &Tables, grafcet: GrafcetId, mark: fn(&Step) -> bool) -> usize {
    chart.grafcets[grafcet].steps.iter().filter(|&&step| mark(&chart.steps[step])).count()
}

/// Whether the step with an order is never active while that is which encloses a grafcet: they are two of one grafcet in
/// which there is one token at most.
fn excludes(chart: &Tables, ordering: StepId, enclosed: GrafcetId) -> bool {
    let Some(enclosing) = chart.grafcets[enclosed].enclosing_step else { return false };
    let grafcet = chart.steps[ordering].grafcet;
    let of_it = || chart.transitions.iter().filter(|transition| transition.grafcet == grafcet);
    ordering != enclosing
        && chart.steps[enclosing].grafcet == grafcet
        && marked(chart, grafcet, |step| step.initial) <= 1
        && marked(chart, grafcet, |step| step.activated) == 0
        && of_it().all(|transition| !transition.pre.is_empty() && transition.post.len() <= 1)
        && chart.orders.iter().all(|order| order.grafcet != grafcet)
        && chart.pulses.iter().all(|pulse| pulse.grafcet != grafcet)
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{passes, passes_with};

    fn with(enclosure: &str) -> String {
        format!("input a, b : bool grafcet G1 {{ initial step 1 enclosing step 9 }} grafcet X9/G4 {{ {enclosure} }}")
    }

    #[test]
    fn a_sink_takes_the_only_active_step() {
        passes_with(&["W0404"], &with("activated step 40 transition 40 -> : a"));
    }

    #[test]
    fn a_sink_beside_other_active_steps() {
        passes(&with("activated step 40 activated step 41 transition 41 -> : a"));
        passes(&with("activated step 40 step 41 transition 40 -> 40, 41 : ↑a transition 41 -> : b"));
    }

    #[test]
    fn an_order() {
        let enclosure = with("activated step 40");
        passes_with(&["W0404"], &format!("{enclosure} grafcet G0 {{ initial step 90 {{ force G4{{}} }} }}"));
        passes(&format!("{enclosure} grafcet G0 {{ initial step 90 {{ force G4{{40}} }} }}"));
    }

    #[test]
    fn an_order_of_a_step_that_excludes_the_enclosing_one() {
        let with = |transitions: &str| {
            format!(
                "input a, b : bool grafcet G1 {{ initial step 1 {{ force G4{{}} }} enclosing step 9 {transitions} }}
                 grafcet X9/G4 {{ activated step 40 }}"
            )
        };
        passes(&with("transition 1 -> 9 : a transition 9 -> 1 : b"));
        passes_with(&["W0404"], &with("transition 1 -> 9, 1 : ↑a transition 9 -> 1 : b"));
    }
}
