//! W0405: a step with a self-loop has actions or times that the loop does not restart.
//!
//! A step that is activated and deactivated at once stays active (IEC 60848, 4.5.6, rule 5): its actions on activation and on
//! deactivation are not done, and its duration runs on.
//!
//! Warned of: `step 2 { C := C + 1 on activation }`, `transition 2 -> 2 : ↑a`
//! Not warned of: `transition 2 -> 2 : ↑a { C := C + 1 }`

use crate::chart::{Event, ExprKind, Node, StepId, Tables};
use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, Span};
use rustc_hash::{FxHashMap, FxHashSet};

/// One warning per transition.
pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    let chart = &resolved.chart;
    let sensitive = sensitive(chart);
    if sensitive.is_empty() {
        return;
    }
    let mut after = FxHashSet::default();
    for transition in &chart.transitions {
        after.clear();
        after.extend(transition.post.iter().copied());
        let found = transition.pre.iter().filter(|node| after.contains(node)).find_map(|node| match *node {
            Node::Step(step) => Some((step, *sensitive.get(&step)?)),
            Node::Macro(_) => None, // it leaves the exit and enters the entry
        });
        if let Some((step, (what, place))) = found {
            let step = &chart.steps[step];
            let message = format!("the transition leads from step `{}` to itself, which does not {what}", step.label);
            diagnostics.push(
                Diagnostic::new(Code::W0405, transition.span, message)
                    .also(step.span, "this step stays active")
                    .also(place, "this runs on, or is not done")
                    .note("IEC 60848, 4.5.6: a step that is activated and deactivated at once remains active")
                    .note("an assignment on clearing, in the braces of the transition, is done every time")
                    .help("lead the transition over another step, or put the action into its braces"),
            );
        }
    }
}

/// Of each step that does it, what a real activation or deactivation would do, and where that is written.
fn sensitive(chart: &Tables) -> FxHashMap<StepId, (&'static str, Span)> {
    let mut sensitive = FxHashMap::default();
    for action in &chart.stored {
        match action.event {
            Event::Activation(step) => _ = sensitive.entry(step).or_insert(("activate it again", action.span)),
            Event::Deactivation(step) => _ = sensitive.entry(step).or_insert(("deactivate it", action.span)),
            Event::Event(..) | Event::Clearing(_) | Event::EachScan(..) => {}
        }
    }
    for expr in &chart.exprs {
        let timed = if let ExprKind::StepTime(step) = expr.kind {
            Some(step)
        } else if let ExprKind::Delay { operand, .. } = expr.kind
            && let ExprKind::StepActive(step) = chart.exprs[operand].kind
        {
            Some(step)
        } else {
            None
        };
        if let Some(step) = timed {
            sensitive.entry(step).or_insert(("restart its time", expr.span));
        }
    }
    sensitive
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{labels, passes, passes_with};

    #[test]
    fn an_action_on_activation() {
        passes_with(
            &["W0405"],
            "input a : bool var C : int initial step 1 { C := C + 1 on activation } transition 1 -> 1 : ↑a",
        );
    }

    #[test]
    fn the_step_and_what_it_bears_are_shown() {
        let shown =
            labels("input a : bool var C : int initial step 7 { C := 1 on deactivation } transition 7 -> 7 : ↑a");
        assert_eq!(shown, ["7: this step stays active", "C := 1 on deactivation: this runs on, or is not done"]);
    }

    #[test]
    fn a_duration() {
        passes_with(
            &["W0405"],
            "input a : bool initial step 1 step 2 transition 1 -> 1 : ↑a transition 1 -> 2 : 3s/X1",
        );
        passes_with(
            &["W0405"],
            "input a : bool initial step 1 step 2 transition 1 -> 1 : ↑a transition 1 -> 2 : [T1 > 3s]",
        );
    }

    #[test]
    fn an_action_on_clearing() {
        passes("input a : bool var C : int output V : bool initial step 1 { V } transition 1 -> 1 : ↑a { C := C + 1 }");
    }
}
