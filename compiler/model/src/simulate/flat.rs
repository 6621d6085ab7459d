//! M1: macro-steps are compiled away from the arcs; only their activity `XM` remains.

use super::Activity;
use crate::chart::{Chart, GrafcetId, MacroId, Node, StepId, TransitionId};
use index_vec::IndexVec;

/// The arcs between steps and transitions.
#[derive(Clone, Debug)]
pub(super) struct Flat {
    /// `pre(t)`: arcs out of a macro-step start at its exit.
    pub pre: IndexVec<TransitionId, Vec<StepId>>,
    /// `post(t)`: arcs into a macro-step lead to its entry.
    pub post: IndexVec<TransitionId, Vec<StepId>>,
}

impl Flat {
    pub fn new(chart: &Chart) -> Self {
        let exit = |node: &Node| match *node {
            Node::Step(step) => step,
            Node::Macro(id) => chart.exit(id),
        };
        let entry = |node: &Node| match *node {
            Node::Step(step) => step,
            Node::Macro(id) => chart.entry(id),
        };
        Flat {
            pre: chart.transitions.iter().map(|t| t.pre.iter().map(exit).collect()).collect(),
            post: chart.transitions.iter().map(|t| t.post.iter().map(entry).collect()).collect(),
        }
    }
}

/// `XM` of every macro-step: a step of its expansion, or of an expansion within, is active.
pub(super) fn active_macro_steps(chart: &Chart, active: &Activity) -> IndexVec<MacroId, bool> {
    let mut result: IndexVec<MacroId, bool> = chart.macro_steps.iter().map(|_| false).collect();
    for (step, _) in active.iter_enumerated().filter(|(_, active)| **active) {
        let mut outer = chart.steps[step].expansion_of;
        while let Some(id) = outer.filter(|&id| !result[id]) {
            result[id] = true;
            outer = chart.macro_steps[id].expansion_of;
        }
    }
    result
}

/// `XG` of every grafcet: one of its steps is active.
pub(super) fn active_grafcets(chart: &Chart, active: &Activity) -> IndexVec<GrafcetId, bool> {
    chart.grafcets.iter().map(|grafcet| grafcet.steps.iter().any(|&step| active[step])).collect()
}
