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
    /// By step, the transitions that it is the first one before.
    behind: IndexVec<StepId, Vec<TransitionId>>,
    /// The transitions that nothing is before.
    sources: Vec<TransitionId>,
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
        let pre: IndexVec<TransitionId, Vec<StepId>> =
            chart.transitions.iter().map(|t| t.pre.iter().map(exit).collect()).collect();
        let mut behind: IndexVec<StepId, Vec<TransitionId>> = chart.steps.iter().map(|_| Vec::new()).collect();
        let mut sources = Vec::new();
        for (transition, before) in pre.iter_enumerated() {
            match before.first() {
                Some(first) => behind[*first].push(transition),
                None => sources.push(transition),
            }
        }
        let post = chart.transitions.iter().map(|t| t.post.iter().map(entry).collect()).collect();
        Flat { pre, post, behind, sources }
    }

    /// The transitions that are enabled: each step before them is active.
    pub fn enabled(&self, active: &Activity) -> impl Iterator<Item = TransitionId> {
        let behind = active.iter_enumerated().filter(|(_, active)| **active).flat_map(|(id, _)| &self.behind[id]);
        let all = |transition: &TransitionId| self.pre[*transition].iter().all(|step| active[*step]);
        self.sources.iter().chain(behind).copied().filter(all)
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

/// The steps that are active in the second situation and not in the first.
pub(super) fn entered(before: &Activity, after: &Activity) -> Vec<StepId> {
    /// Parts of situations are compared at once: most steps stay as they are.
    const PART: usize = 64;
    let parts = before.as_raw_slice().chunks(PART).zip(after.as_raw_slice().chunks(PART)).enumerate();
    let changed = parts.filter(|(_, (before, after))| before != after);
    let within = changed.flat_map(|(part, (before, after))| {
        let steps = before.iter().zip(after).enumerate();
        steps.filter(|(_, (before, after))| **after && !**before).map(move |(step, _)| StepId::new(part * PART + step))
    });
    within.collect()
}
