//! W0408: a continuous action stands in a step that is left at once.
//!
//! The transition after the step is always true, so the step is passed through within one reaction, and continuous actions
//! of such a step are not done (IEC 60848, 4.9.4). Its stored actions are.
//!
//! Warned of: `step 2 { V }`, `transition 2 -> 3 : 1`
//! Not warned of: `step 2 { V }`, `transition 2, 5 -> 3 : 1`, which waits for step 5
//!
//! Nor of a step that may last all the same: because an order may freeze the transition (R2, closure included), or
//! because each call is one micro-step (`evolution scan`), or because a source transition may activate the step again as often as it is left (6.3.3).

use super::arcs;
use super::truth::{Edges, Truth, truths};
use crate::chart::{GrafcetId, StepId, Tables, TransitionId};
use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};
use index_vec::{IndexVec, index_vec};

/// One warning per step.
pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    let chart = &resolved.chart;
    if chart.options.is_scan() {
        return;
    }
    let truths = truths(&chart.exprs, &chart.variables, Edges::Sometimes);
    let freezable = freezable(chart);
    let mut left_by: IndexVec<StepId, Option<TransitionId>> = index_vec![None; chart.steps.len()];
    for (id, transition) in chart.transitions.iter_enumerated() {
        let mut before = arcs::left(chart, transition);
        if let (Some(step), None) = (before.next(), before.next())
            && truths[transition.condition] == Truth::Always
            && !freezable[transition.grafcet]
            && !arcs::entered(chart, transition).any(|after| after == step)
        {
            left_by[step].get_or_insert(id);
        }
    }
    for transition in chart.transitions.iter().filter(|transition| transition.pre.is_empty()) {
        for step in arcs::entered(chart, transition) {
            left_by[step] = None;
        }
    }
    for action in &chart.continuous {
        if let Some(transition) = left_by[action.step].take() {
            let label = &chart.steps[action.step].label;
            diagnostics.push(
                Diagnostic::new(
                    Code::W0408,
                    action.span,
                    format!("step `{label}` is left at once, so this action is not done"),
                )
                .also(chart.steps[action.step].span, "this step")
                .also(chart.transitions[transition].span, "always true, and after no other step")
                .note("IEC 60848, 4.9.4: a continuous action is not done in a step that is passed through")
                .help("wait in the step, by a condition or a delay; or make it a stored action, `:= 1 on activation`"),
            );
        }
    }
}

/// The grafcets that an order may freeze: those that one names, and what their steps enclose.
fn freezable(chart: &Tables) -> IndexVec<GrafcetId, bool> {
    let mut freezable: IndexVec<GrafcetId, bool> = index_vec![false; chart.grafcets.len()];
    for order in &chart.orders {
        freezable[order.grafcet] = true;
    }
    for &grafcet in &chart.hierarchy {
        if let Some(step) = chart.grafcets[grafcet].enclosing_step {
            freezable[grafcet] |= freezable[chart.steps[step].grafcet];
        }
    }
    freezable
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
    fn an_order_may_hold_it() {
        passes(
            "input a, b : bool output V : bool
             grafcet G1 { initial step 1 step 2 { force G2{11} } transition 1 -> 2 : a transition 2 -> 1 : b }
             grafcet G2 { initial step 10 step 11 { V } transition 10 -> 11 : a transition 11 -> 10 : 1 }",
        );
    }

    #[test]
    fn an_order_may_hold_what_is_around() {
        passes(
            "input a, b : bool output V : bool
             grafcet G1 { initial step 1 step 2 { force G2{*} } transition 1 -> 2 : a transition 2 -> 1 : b }
             grafcet G2 { initial step 10 enclosing step 11 transition 10 -> 11 : a transition 11 -> 10 : b }
             grafcet X11/G3 { activated step 20 { V } step 21 transition 20 -> 21 : 1 }",
        );
    }

    #[test]
    fn a_source_transition_may_hold_it() {
        // Left and entered in each micro-step, so never deactivated (rule 5).
        passes_with(
            &["W0406"],
            "input a : bool output V : bool step 1 { V } step 2 transition -> 1 : a transition 1 -> 2 : 1",
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
