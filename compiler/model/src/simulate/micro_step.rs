//! R1, R3, R4, R6, R8: one micro-step. R2, R5 and R7 have files of their own.

use super::context::{DividedByZero, evaluate, levels};
use super::plan::{Memory, Valued};
use super::settle::{Conflict, Phase, settle};
use super::stored::{Happened, allocate};
use super::{Activity, Simulator};
use crate::chart::TransitionId;
use index_vec::IndexVec;

impl Simulator<'_> {
    /// One micro-step at the instant; says whether something changed.
    pub(super) fn micro_step(&mut self, t: i64, input_event: bool) -> bool {
        // R1
        let context = std::mem::take(&mut self.plan.context);
        self.evaluate(&context, Memory::Update, t);
        self.plan.context = context;
        let edge = self.plan.edges.iter().any(|&(edge, operand)| self.values.holds(operand) != self.state.edges[edge]);
        let levels = self.levels(t);

        // R3, R4
        let cleared = self.clearable();
        let mut next = self.state.active.clone();
        for (transition, _) in cleared.iter_enumerated().filter(|(_, cleared)| **cleared) {
            for &step in &self.flat.pre[transition] {
                next[step] = false;
            }
        }
        for (transition, _) in cleared.iter_enumerated().filter(|(_, cleared)| **cleared) {
            for &step in &self.flat.post[transition] {
                next[step] = true;
            }
        }

        // R5
        let before = self.state.active.clone();
        let Conflict(conflict) = settle(self.chart, &self.orders, Phase::Evolution, &before, &mut next);
        self.flags.force_conflict |= conflict;

        // R6, R7: events are what changed from `before` to `next`, whatever the cause.
        let happened = Happened { before: &before, after: &next, cleared: &cleared, levels: &levels, input_event };
        let triggered = happened.triggered(self.chart, &self.values);
        let right_sides = self.plan.beyond_context(self.chart, triggered.iter().map(|stored| stored.value));
        self.evaluate(&right_sides, Memory::Hold, t);
        let allocated = allocate(&triggered, &self.values, &mut self.state);
        self.flags.alloc_conflict |= allocated.conflict;

        // R8
        let moved = before != next;
        for (step, since) in self.state.since.iter_mut_enumerated() {
            if next[step] && !before[step] {
                *since = t;
            }
        }
        self.state.active = next;
        self.cleared = cleared;
        for &(edge, operand) in &self.plan.edges {
            self.state.edges[edge] = self.values.holds(operand);
        }
        moved || allocated.changed || edge
    }

    /// R3: all transitions that are enabled, neither frozen nor in an inactive enclosure, and whose condition holds.
    fn clearable(&self) -> IndexVec<TransitionId, bool> {
        let active: &Activity = &self.state.active;
        let frozen = self.orders.frozen(self.chart, active);
        let transitions = self.chart.transitions.iter_enumerated();
        transitions
            .map(|(id, transition)| {
                self.flat.pre[id].iter().all(|&step| active[step])
                    && !frozen[transition.grafcet]
                    && self.chart.grafcets[transition.grafcet].enclosing_step.is_none_or(|step| active[step])
                    && self.values.holds(transition.condition)
            })
            .collect()
    }

    /// By stored action, whether its event expression holds with all edges replaced by 0 (R7): with the delays of the
    /// context that has just been evaluated, and into values of its own.
    fn levels(&mut self, t: i64) -> Vec<bool> {
        let mut values = self.values.clone();
        let DividedByZero(div0) =
            evaluate(self.chart, &self.plan, &self.plan.levels, Memory::Hold, &mut self.state, t, &mut values);
        self.flags.div0 |= div0;
        levels(self.chart, &values)
    }

    /// Evaluates into the simulator's own values and flags.
    pub(super) fn evaluate(&mut self, nodes: &[Valued], memory: Memory, t: i64) {
        let DividedByZero(div0) = evaluate(self.chart, &self.plan, nodes, memory, &mut self.state, t, &mut self.values);
        self.flags.div0 |= div0;
    }
}
