//! W0408: a continuous action stands in a step that is left at once.
//!
//! The transition after the step is always true, so the step is passed through within one reaction, and continuous actions
//! of such a step are not done (IEC 60848, 4.9.4). Its stored actions are.
//!
//! Warned of: `step 2 { V }`, `transition 2 -> 3 : 1`
//! Not warned of: `step 2 { V }`, `transition 2, 5 -> 3 : 1`, which waits for step 5

use super::arcs;
use super::truth::{Edges, Truth, truths};
use crate::chart::{StepId, TransitionId};
use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};
use index_vec::{IndexVec, index_vec};

/// Applies the rule: one warning a step.
pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    let chart = &resolved.chart;
    let truths = truths(chart, Edges::Sometimes);
    let mut left_by: IndexVec<StepId, Option<TransitionId>> = index_vec![None; chart.steps.len()];
    for (id, transition) in chart.transitions.iter_enumerated() {
        let mut before = arcs::left(chart, transition);
        if let (Some(step), None) = (before.next(), before.next())
            && truths[transition.condition] == Truth::Always
            && !arcs::entered(chart, transition).any(|after| after == step)
        {
            left_by[step].get_or_insert(id);
        }
    }
    for action in &chart.continuous {
        if let Some(transition) = left_by[action.step].take() {
            let label = &chart.steps[action.step].label;
            diagnostics.push(
                Diagnostic::new(
                    Code::W0408,
                    action.span,
                    format!("step `{label}` is left at once, so this action is never done"),
                )
                .also(chart.steps[action.step].span, "this step")
                .also(chart.transitions[transition].span, "always true, and after no other step")
                .note("IEC 60848, 4.9.4: a continuous action is not done in a step that is passed through"),
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{labels, passes, passes_with};

    #[test]
    fn left_at_once() {
        passes_with(
            &["W0408"],
            "input a : bool output V : bool initial step 1 step 2 { V } step 3
             transition 1 -> 2 : a transition 2 -> 3 : 1",
        );
    }

    #[test]
    fn the_step_and_the_transition_are_shown() {
        let shown = labels("output V : bool initial step 1 { V } step 2 transition 1 -> 2 : 1");
        assert_eq!(shown, ["1: this step", "transition 1 -> 2 : 1: always true, and after no other step"]);
    }

    #[test]
    fn the_exit_of_an_expansion() {
        passes_with(
            &["W0408"],
            "input a : bool output V : bool macro step M2 initial step 3 transition M2 -> 3 : 1
             expansion M2 { step E2 step S2 { V } transition E2 -> S2 : a }",
        );
    }

    #[test]
    fn a_join_waits() {
        passes(
            "input a : bool output V : bool initial step 1 { V } step 2 step 3
             transition 1, 2 -> 3 : 1",
        );
    }

    #[test]
    fn a_stored_action_is_done() {
        passes(
            "input a : bool output V : bool initial step 1 step 2 { V := 1 on activation } step 3
             transition 1 -> 2 : a transition 2 -> 3 : 1",
        );
    }
}
