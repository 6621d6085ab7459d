//! What is seen of micro-steps by the rules as they stand, on the chart itself: what `grafc verify` is held against.

use grafc_model::chart::{Chart, Node, StepId, TransitionId};
use grafc_model::reaction::{Flags, Stimulus};
use grafc_model::simulate::{Activity, Simulator};
use std::collections::BTreeSet;

/// What was seen in any micro-step.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Sights {
    /// A reaction did not end (R9).
    pub livelock: bool,
    /// Stored actions disagreed (R7).
    pub alloc_conflict: bool,
    /// Orders disagreed (R2).
    pub force_conflict: bool,
    /// Steps that were active.
    pub active: BTreeSet<usize>,
    /// Transitions that were cleared.
    pub cleared: BTreeSet<usize>,
    /// Steps of which two transitions after them were cleared together.
    pub selection: BTreeSet<usize>,
    /// Steps that a clearing activated while they were active, and that were not deactivated in that micro-step.
    pub reentry: BTreeSet<usize>,
}

/// The steps before a transition, and those after it (M1).
pub fn arcs(chart: &Chart, t: TransitionId) -> (BTreeSet<StepId>, BTreeSet<StepId>) {
    let before = chart.transitions[t].pre.iter().map(|node| match *node {
        Node::Step(s) => s,
        Node::Macro(m) => chart.exit(m),
    });
    let after = chart.transitions[t].post.iter().map(|node| match *node {
        Node::Step(s) => s,
        Node::Macro(m) => chart.entry(m),
    });
    (before.collect(), after.collect())
}

impl Sights {
    /// A reaction, looked at from within; it is the initial one if the simulator has not reacted yet.
    pub fn react(&mut self, chart: &Chart, simulator: &mut Simulator, stimulus: &Stimulus, is_initial: bool) {
        let Flags { livelock, alloc_conflict, force_conflict, div0: _ } = simulator.flags();
        let mut before = (!is_initial).then(|| simulator.state().situation().clone());
        simulator.react_observed(stimulus, &mut |simulator| {
            let after = simulator.state().situation().clone();
            self.active.extend(after.iter_enumerated().filter(|(_, active)| **active).map(|(s, _)| s.index()));
            if let Some(before) = before.replace(after.clone()) {
                let cleared = simulator.cleared().iter_enumerated().filter(|(_, cleared)| **cleared);
                self.micro_step(chart, &before, &cleared.map(|(t, _)| t).collect::<Vec<_>>(), &after);
            }
        });
        let now = simulator.flags();
        self.livelock |= now.livelock && !livelock;
        self.alloc_conflict |= now.alloc_conflict && !alloc_conflict;
        self.force_conflict |= now.force_conflict && !force_conflict;
    }

    fn micro_step(&mut self, chart: &Chart, before: &Activity, cleared: &[TransitionId], after: &Activity) {
        self.cleared.extend(cleared.iter().map(|t| t.index()));
        let arcs: Vec<_> = cleared.iter().map(|t| arcs(chart, *t)).collect();
        for s in chart.steps.indices() {
            let left = arcs.iter().filter(|(before, _)| before.contains(&s)).count();
            let is_entered = arcs.iter().any(|(_, after)| after.contains(&s));
            if left > 1 {
                self.selection.insert(s.index());
            }
            if is_entered && left == 0 && before[s] && after[s] {
                self.reentry.insert(s.index());
            }
        }
    }
}
