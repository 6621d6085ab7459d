//! Whether two stored actions can be triggered in one micro-step (R7).
//!
//! An action is triggered in one of several ways: a step is activated by this transition or by that, or in a way of which
//! nothing is known. Two actions cannot meet if no way of one is possible together with a way of the other.

use crate::analysis::Analysis;
use grafc_formula::FormulaId;
use grafc_model::chart::{Event, StepId, TransitionId};
use grafc_net::Net;
use grafc_net::net::Forced;

/// More transitions than this into or out of a step are not told apart, nor more steps before a transition.
const TOLD_APART: usize = 8;

/// One way in which an action is triggered.
#[derive(Default)]
pub(super) struct Way {
    /// Steps that are active before the micro-step.
    before: Vec<StepId>,
    /// The step that becomes active in it.
    activated: Option<StepId>,
    /// What must be true in it.
    condition: Option<FormulaId>,
    /// Whether it is the initial reaction, before any micro-step (R10).
    at_start: bool,
}

/// All ways in which a stored action is triggered.
pub(super) fn ways(analysis: &Analysis, action: usize) -> Vec<Way> {
    let net = &analysis.net;
    match net.stored[action].event {
        Event::Event(step, _) => {
            vec![Way { before: vec![step], condition: Some(analysis.conditions.of_event[&action]), ..Way::default() }]
        }
        // Of two of them, both steps are active after the micro-step, as if both had been activated in it.
        Event::EachScan(step, _) => {
            let condition = analysis.conditions.of_event.get(&action).copied();
            vec![Way { activated: Some(step), condition, ..Way::default() }]
        }
        Event::Clearing(t) => vec![clearing(analysis, t)],
        Event::Deactivation(step) => {
            let out_of = analysis.arcs.out_of_step(step);
            let is_commanded = analysis.commanded[net.places[step].grafcet];
            let is_otherwise = !net.places[step].within.is_empty() || is_emptied(net, step) || is_commanded;
            if is_otherwise || out_of.len() > TOLD_APART {
                return vec![Way { before: vec![step], ..Way::default() }];
            }
            out_of.iter().map(|t| clearing(analysis, *t)).collect()
        }
        Event::Activation(step) => {
            let into = analysis.arcs.into_step(step);
            let activated = Some(step);
            let is_commanded = analysis.commanded[net.places[step].grafcet];
            let is_otherwise = net.places[step].activated || is_forced(net, step) || is_commanded;
            let mut ways: Vec<Way> = if is_otherwise || into.len() > TOLD_APART {
                vec![Way { activated, ..Way::default() }]
            } else {
                into.iter().map(|t| Way { activated, ..clearing(analysis, *t) }).collect()
            };
            if net.places[step].initial {
                ways.push(Way { activated, at_start: true, ..Way::default() });
            }
            ways
        }
    }
}

fn clearing(analysis: &Analysis, t: TransitionId) -> Way {
    let before = analysis.net.transitions[t].pre.iter().copied().take(TOLD_APART).collect();
    Way { before, condition: Some(analysis.conditions.of_transition[t]), ..Way::default() }
}

/// Whether an order may activate a step.
fn is_forced(net: &Net, step: StepId) -> bool {
    let orders = &net.grafcets[net.places[step].grafcet].orders;
    orders.iter().any(|order| matches!(&order.forced, Forced::Steps(steps) if steps.binary_search(&step).is_ok()))
}

/// Whether an order may deactivate a step.
fn is_emptied(net: &Net, step: StepId) -> bool {
    let orders = &net.grafcets[net.places[step].grafcet].orders;
    orders.iter().any(|order| matches!(&order.forced, Forced::Steps(steps) if steps.binary_search(&step).is_err()))
}

/// Whether actions that are triggered in these ways can be triggered in the same micro-step, as far as is known.
pub(super) fn meet(analysis: &Analysis, a: &[Way], b: &[Way]) -> bool {
    a.iter().any(|a| b.iter().any(|b| !apart(analysis, a, b)))
}

fn apart(analysis: &Analysis, a: &Way, b: &Way) -> bool {
    let never = |a: &StepId, b: &StepId| analysis.never_together(*a, *b);
    // A step that is activated was inactive before.
    a.at_start != b.at_start
        || a.activated.is_some_and(|s| b.before.contains(&s))
        || b.activated.is_some_and(|s| a.before.contains(&s))
        || a.activated.zip(b.activated).is_some_and(|(a, b)| never(&a, &b))
        || a.before.iter().any(|a| b.before.iter().any(|b| never(a, b)))
        || analysis.never_all(&[a.before.as_slice(), &b.before].concat())
        || a.condition.zip(b.condition).is_some_and(|(a, b)| analysis.exclude(a, b))
}
