//! The steps that a transition leaves and enters, macro-steps expanded (M1).

use crate::chart::{Node, StepId, Tables, Transition};

/// The steps that clearing deactivates: of a macro-step its exit.
pub fn left(chart: &Tables, transition: &Transition) -> impl Iterator<Item = StepId> {
    transition.pre.iter().filter_map(|&node| match node {
        Node::Step(step) => Some(step),
        Node::Macro(id) => chart.macro_steps[id].exit,
    })
}

/// The steps that clearing activates: of a macro-step its entry.
pub fn entered(chart: &Tables, transition: &Transition) -> impl Iterator<Item = StepId> {
    transition.post.iter().filter_map(|&node| match node {
        Node::Step(step) => Some(step),
        Node::Macro(id) => chart.macro_steps[id].entry,
    })
}

/// The steps that clearing activates and does not leave: a self-loop changes nothing (rule 5).
pub fn entered_anew(chart: &Tables, transition: &Transition) -> impl Iterator<Item = StepId> {
    let mut before: Vec<StepId> = left(chart, transition).collect();
    before.sort_unstable();
    entered(chart, transition).filter(move |step| before.binary_search(step).is_err())
}
