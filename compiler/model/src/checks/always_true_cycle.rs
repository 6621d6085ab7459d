//! W0407: transitions that are always true lead in a circle.
//!
//! While some of its steps are active, not all, and no order freezes them, the situation changes in a circle without
//! end and is never stable (IEC 60848, 4.9.3): the reaction is stopped at its bound, and the flag LIVELOCK is raised.
//!
//! A transition counts only if each step before it is entered by another that counts: a circle that waits for a step from
//! outside stops. A self-loop changes nothing, and a source transition holds its steps active, so neither counts.
//!
//! Under `evolution scan` nobody looks for a stable situation: going round is what the chart does.
//!
//! Warned of: `transition 1 -> 2 : 1`, `transition 2 -> 1 : 1`
//! Not warned of: `transition 1 -> 2 : a`, `transition 2 -> 1 : 1`

use super::arcs;
use super::truth::{Edges, Truth, truths};
use crate::chart::{StepId, Tables, TransitionId};
use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};
use index_vec::{IndexVec, index_vec};

/// More transitions of a circle are not shown.
const SHOWN: usize = 8;

/// One warning per circle.
pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    let chart = &resolved.chart;
    // There each call is one micro-step, stable or not.
    if chart.options.is_scan() {
        return;
    }
    let counting = counting(chart);
    if !counting.contains(&true) {
        return;
    }
    // Every step before a counting transition is entered by another: going up ends in a circle.
    let mut entered_by: IndexVec<StepId, Option<TransitionId>> = index_vec![None; chart.steps.len()];
    for (id, transition) in chart.transitions.iter_enumerated().filter(|(id, _)| counting[*id]) {
        for step in arcs::entered_anew(chart, transition) {
            entered_by[step].get_or_insert(id);
        }
    }
    let mut walk_of: IndexVec<TransitionId, Option<TransitionId>> = index_vec![None; chart.transitions.len()];
    for start in chart.transitions.indices().filter(|&id| counting[id]) {
        let up = |id: TransitionId| {
            let step = arcs::left(chart, &chart.transitions[id]).next()?;
            entered_by[step]
        };
        let mut at = start;
        while walk_of[at].is_none() {
            walk_of[at] = Some(start);
            let Some(next) = up(at) else { break };
            at = next;
        }
        if walk_of[at] == Some(start) && up(at).is_some() {
            let circle: Vec<TransitionId> = std::iter::successors(up(at), |&id| up(id).filter(|_| id != at)).collect();
            diagnostics.push(report(chart, &circle));
        }
    }
}

/// The transitions that can be cleared again and again without anything from outside.
fn counting(chart: &Tables) -> IndexVec<TransitionId, bool> {
    let truths = truths(&chart.exprs, &chart.variables, Edges::Sometimes);
    let mut counting: IndexVec<TransitionId, bool> = chart
        .transitions
        .iter()
        .map(|transition| !transition.pre.is_empty() && truths[transition.condition] == Truth::Always)
        .collect();
    // As in most charts.
    if !counting.contains(&true) {
        return counting;
    }
    let mut entries: IndexVec<StepId, usize> = index_vec![0; chart.steps.len()];
    let mut leaving: IndexVec<StepId, Vec<TransitionId>> = index_vec![Vec::new(); chart.steps.len()];
    for (id, transition) in chart.transitions.iter_enumerated().filter(|(id, _)| counting[*id]) {
        for step in arcs::entered_anew(chart, transition) {
            entries[step] += 1;
        }
        for step in arcs::left(chart, transition) {
            leaving[step].push(id);
        }
    }
    // A step that nothing enters takes out the transitions after it, and so on.
    let mut starved: Vec<StepId> = entries.iter_enumerated().filter(|(_, n)| **n == 0).map(|(id, _)| id).collect();
    while let Some(step) = starved.pop() {
        for &id in &leaving[step] {
            if std::mem::replace(&mut counting[id], false) {
                for step in arcs::entered_anew(chart, &chart.transitions[id]) {
                    entries[step] -= 1;
                    if entries[step] == 0 {
                        starved.push(step);
                    }
                }
            }
        }
    }
    counting
}

/// `circle` goes against the arcs.
fn report(chart: &Tables, circle: &[TransitionId]) -> Diagnostic {
    let first = (0..circle.len()).min_by_key(|&i| chart.transitions[circle[i]].span).unwrap_or_default();
    let along = circle[..=first].iter().rev().chain(circle[first + 1..].iter().rev());
    // The step of the circle before each transition.
    let mut around = along.filter_map(|&id| {
        let transition = &chart.transitions[id];
        Some((transition.span, chart.steps[arcs::left(chart, transition).next()?].label.as_str()))
    });
    let (place, label) = around.next().unwrap_or_default();
    let message = format!("from step `{label}`, transitions that are always true lead in a circle");
    let mut diagnostic = Diagnostic::new(Code::W0407, place, message);
    for (place, label) in around.take(SHOWN) {
        diagnostic = diagnostic.also(place, format!("leaves step `{label}`"));
    }
    diagnostic
        .note("IEC 60848, 4.9.3: a token in it is never at rest; a reaction stops at its bound and raises LIVELOCK")
        .help("give one of these transitions a condition that is not always true")
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{labels, passes, passes_with};

    #[test]
    fn two_steps() {
        passes_with(&["W0407"], "initial step 1 step 2 transition 1 -> 2 : 1 transition 2 -> 1 : true");
    }

    #[test]
    fn the_others_are_shown_in_the_order_of_the_circle() {
        let shown = labels(
            "initial step 1 step 2 step 3
             transition 3 -> 1 : 1 transition 2 -> 3 : 1 transition 1 -> 2 : 1",
        );
        assert_eq!(shown, ["transition 1 -> 2 : 1: leaves step `1`", "transition 2 -> 3 : 1: leaves step `2`"]);
    }

    #[test]
    fn over_a_join() {
        passes_with(&["W0407"], "initial step 1 step 2 step 3 transition 1 -> 2, 3 : 1 transition 2, 3 -> 1 : 1");
    }

    #[test]
    fn two_circles() {
        passes_with(
            &["W0407", "W0407"],
            "initial step 1 step 2 initial step 3 step 4 transition 1 -> 2 : 1 transition 2 -> 1 : 1
             transition 3 -> 4 : 1 transition 4 -> 3 : 1",
        );
    }

    #[test]
    fn over_a_macro_step() {
        passes_with(
            &["W0407"],
            "initial step 1 macro step M2 transition 1 -> M2 : 1 transition M2 -> 1 : 1
             expansion M2 { step E2 step S2 transition E2 -> S2 : 1 }",
        );
    }

    #[test]
    fn a_condition_in_the_circle() {
        passes("input a : bool initial step 1 step 2 transition 1 -> 2 : a transition 2 -> 1 : 1");
    }

    #[test]
    fn a_join_that_waits() {
        passes(
            "input a : bool initial step 1 step 2 step 3 transition 1, 3 -> 2 : 1 transition 2 -> 1 : 1
             transition 2 -> 3 : a",
        );
    }

    #[test]
    fn a_self_loop_is_stable() {
        passes("initial step 1 transition 1 -> 1 : 1");
    }
}
