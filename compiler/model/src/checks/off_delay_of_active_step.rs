//! W0422: an off-delay of the step that the condition waits in.
//!
//! `X3/5s` is true while step 3 is active and for 5 s afterwards (IEC 60848, symbol 17): after step 3 it is true at once.
//! What is meant is most often `5s/X3`, 5 s after the activation.
//!
//! Warned of: `transition 3 -> 4 : X3/5s`; `step 3 { V if X3/5s }`
//! Not warned of: `transition 3 -> 4 : 5s/X3`; `transition 4 -> 5 : X3/5s`

use crate::chart::{DelayTime, Event, ExprId, ExprKind, Node, Nodes, StepId, Tables, below};
use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, Fix};
use grafc_syntax::dump::plain_or_quoted;
use std::cell::OnceCell;

/// One warning per off-delay.
pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    let chart = &resolved.chart;
    for transition in &chart.transitions {
        let before = OnceCell::new();
        let is_before = |node| {
            let before = before.get_or_init(|| {
                let mut before: Nodes = transition.pre.clone();
                before.sort_unstable();
                before
            });
            before.binary_search(&node).is_ok()
        };
        look(chart, transition.condition, &is_before, diagnostics);
    }
    let own = |step: StepId| move |node| node == Node::Step(step);
    for action in &chart.continuous {
        if let Some(condition) = action.condition {
            look(chart, condition, &own(action.step), diagnostics);
        }
    }
    for action in &chart.stored {
        if let Event::Event(step, event) | Event::EachScan(step, Some(event)) = action.event {
            look(chart, event, &own(step), diagnostics);
        }
    }
}

fn look(chart: &Tables, root: ExprId, is_active: &dyn Fn(Node) -> bool, diagnostics: &mut Diagnostics) {
    for id in below(&chart.exprs, root) {
        let ExprKind::Delay { on, operand, off } = chart.exprs[id].kind else { continue };
        let (node, label) = if let ExprKind::StepActive(step) = chart.exprs[operand].kind {
            (Node::Step(step), &chart.steps[step].label)
        } else if let ExprKind::MacroActive(id) = chart.exprs[operand].kind {
            (Node::Macro(id), &chart.macro_steps[id].label)
        } else {
            continue;
        };
        if on.ms == 0 && off.ms > 0 && is_active(node) {
            let activity = plain_or_quoted(&format!("X{label}"));
            let time = spelt(chart, off);
            let span = chart.exprs[id].span;
            let meant = format!("{time}/{activity}");
            diagnostics.push(
                Diagnostic::new(Code::W0422, span, format!("this is true at once: step `{label}` is active here"))
                    .note(format!("an off-delay holds while the step is active and for {time} afterwards"))
                    .help(format!("{time} after its activation is written `{meant}`"))
                    .fix(Fix::maybe(format!("write `{meant}`")).replace(span, meant)),
            );
        }
    }
}

/// A delay as it may be written.
fn spelt(chart: &Tables, time: DelayTime) -> String {
    match time.constant {
        Some(constant) => plain_or_quoted(&chart.variables[constant].name),
        None if time.ms % 1000 == 0 => format!("{}s", time.ms / 1000),
        None => format!("{}ms", time.ms),
    }
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{help, passes, passes_with};

    const STEPS: &str = "input a : bool output V : bool initial step 3 step 4 step 5 ";

    #[test]
    fn of_the_step_before() {
        let text = format!("{STEPS} transition 3 -> 4 : X3/5s");
        passes_with(&["W0422"], &text);
        assert_eq!(help(&text).as_deref(), Some("5s after its activation is written `5s/X3`"));
        passes_with(&["W0422"], &format!("{STEPS} transition 3 -> 4 : a and not (X3/1500ms)"));
        passes_with(&["W0422"], &format!("{STEPS} const t : time := 1s transition 3, 4 -> 5 : X4/t"));
    }

    #[test]
    fn of_the_step_of_an_action() {
        passes_with(&["W0422"], &format!("{STEPS} step 6 {{ V if X6/5s }} transition 3 -> 6 : a"));
    }

    #[test]
    fn of_another_step() {
        passes(&format!("{STEPS} transition 3 -> 4 : a transition 4 -> 5 : X3/5s"));
        passes(&format!("{STEPS} transition 3 -> 4 : 5s/X3 transition 4 -> 5 : not (6s/X4)"));
    }
}
