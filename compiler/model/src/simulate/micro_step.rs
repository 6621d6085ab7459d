//! R1, R3, R4, R6, R8: one micro-step. R2, R5 and R7 have files of their own.

use super::context::{DividedByZero, evaluate, levels};
use super::flat::entered;
use super::plan::{Memory, Plan, Valued};
use super::pulses::{Occurred, Pulses};
use super::seen::Seen;
use super::settle::{Conflict, Phase, settle};
use super::stored::{Happened, allocate};
use super::{Activity, Simulator};
use crate::chart::{Event, TransitionId};

impl Simulator<'_> {
    /// One micro-step at the instant; says whether something changed. In the first of a reaction, inputs may have.
    pub(super) fn micro_step(&mut self, t: i64, is_first: bool, input_event: bool) -> bool {
        // R1
        let nodes = |plan: &mut Plan| std::mem::take(if is_first { &mut plan.context } else { &mut plan.moving });
        let context = nodes(&mut self.plan);
        self.evaluate(&context, Memory::Update, t);
        *(if is_first { &mut self.plan.context } else { &mut self.plan.moving }) = context;
        let edge = self.plan.edges.iter().any(|&(edge, operand)| self.values.holds(operand) != self.state.edges[edge]);
        let levels = self.levels(t);

        // R3, R4
        let enabled = self.seen.is_some().then(|| self.enabled());
        let cleared = self.clearable();
        let before = self.state.active.clone();
        let mut next = before.clone();
        for &transition in &cleared {
            for &step in &self.flat.pre[transition] {
                next[step] = false;
            }
        }
        for &transition in &cleared {
            for &step in &self.flat.post[transition] {
                next[step] = true;
            }
        }
        self.cleared.iter_mut().for_each(|cleared| *cleared = false);
        for &transition in &cleared {
            self.cleared[transition] = true;
        }

        // R5
        let events = self.pulse_events(&before, input_event);
        // What is read until the end of the micro-step is read of the state before it.
        let (mut saved, mut frozen) = (self.state.saved.clone(), self.state.frozen.clone());
        let occurred = Occurred { cleared: &self.cleared, events: &events };
        let pulses = Pulses::new(self.chart, &self.commands, occurred, &mut saved, &mut frozen);
        let Conflict(conflict) = settle(self.chart, &self.orders, pulses, Phase::Evolution, &before, &mut next);
        self.flags.force_conflict |= conflict;

        // R6, R7: events are what changed from `before` to `next`, whatever the cause.
        let (after, cleared) = (&next, &self.cleared);
        let happened = Happened { before: &before, after, cleared, levels: &levels, input_event };
        let triggered = happened.triggered(self.chart, &self.values);
        let each_scan = happened.each_scan(self.chart, &self.values);
        if let Some(enabled) = enabled {
            let seen = Seen::new(self.chart, enabled, &happened, &self.values);
            self.see(seen);
        }
        let mut changed = false;
        if !triggered.is_empty() {
            let right_sides = self.plan.beyond_context(self.chart, triggered.iter().map(|stored| stored.value));
            self.evaluate(&right_sides, Memory::Hold, t);
            let allocated = allocate(&triggered, &self.values, &mut self.state);
            self.flags.alloc_conflict |= allocated.conflict;
            changed = allocated.changed;
        }

        // R15: what is done each scan sees what the others have left, and has no conflict with them.
        // Whether a continuously assigned name is read there does not hang on whether the action is done (X6).
        let context = (!each_scan.is_empty() || !self.plan.read_each_scan.is_empty()).then(|| self.values.clone());
        let wires = std::mem::take(&mut self.plan.read_each_scan);
        self.evaluate(&wires, Memory::Hold, t);
        self.plan.read_each_scan = wires;
        if !each_scan.is_empty() {
            let right_sides = self.plan.after_actions(self.chart, each_scan.iter().map(|stored| stored.value));
            self.evaluate(&right_sides, Memory::Hold, t);
            let allocated = allocate(&each_scan, &self.values, &mut self.state);
            self.flags.alloc_conflict |= allocated.conflict;
            changed |= allocated.changed;
        }
        if let Some(context) = context {
            self.values = context;
        }

        // R8
        let moved = before != next || saved != self.state.saved || frozen != self.state.frozen;
        for step in entered(&before, &next) {
            self.state.since[step] = t;
        }
        self.state.active = next;
        (self.state.saved, self.state.frozen) = (saved, frozen);
        self.begins = false;
        for &(edge, operand) in &self.plan.edges {
            self.state.edges[edge] = self.values.holds(operand);
        }
        moved || changed || edge
    }

    /// By pulse order, whether its event has occurred (R7, kind E).
    fn pulse_events(&self, before: &Activity, input_event: bool) -> Vec<bool> {
        let occurs = |event| match event {
            Event::Event(step, expression) => {
                let level = self.level_values.holds(expression);
                before[step] && self.values.holds(expression) && (!level || input_event)
            }
            Event::Deactivation(_) | Event::Clearing(_) | Event::Activation(_) | Event::EachScan(..) => false,
        };
        self.chart.pulses.iter().map(|pulse| occurs(pulse.event)).collect()
    }

    /// R15: whether pulse orders leave a transition as it is: its grafcet is not frozen by one, and a source transition of a
    /// child waits until that is active.
    pub(super) fn is_left_to_clear(&self, id: TransitionId) -> bool {
        let grafcet = self.chart.transitions[id].grafcet;
        let is_active = || self.chart.grafcets[grafcet].steps.iter().any(|&step| self.state.active[step]);
        !self.state.frozen[grafcet]
            && (!self.chart.grafcets[grafcet].child || !self.flat.pre[id].is_empty() || is_active())
    }

    /// R3: all transitions that are enabled, neither frozen nor in an inactive enclosure, and whose condition holds.
    fn clearable(&self) -> Vec<TransitionId> {
        let active: &Activity = &self.state.active;
        let frozen = self.orders.frozen(self.chart, active);
        let is_clearable = |id: &TransitionId| {
            let transition = &self.chart.transitions[*id];
            !frozen[transition.grafcet]
                && self.is_left_to_clear(*id)
                && self.chart.grafcets[transition.grafcet].enclosing_step.is_none_or(|step| active[step])
                && self.values.holds(transition.condition)
        };
        self.flat.enabled(active).filter(is_clearable).collect()
    }

    /// By stored action, whether its event expression holds with all edges replaced by 0 (R7): with the delays of the
    /// context that has just been evaluated, and into values of its own.
    fn levels(&mut self, t: i64) -> Vec<bool> {
        let DividedByZero(div0) = evaluate(
            self.chart,
            &self.plan,
            &self.plan.levels,
            Memory::Hold,
            &mut self.state,
            t,
            &mut self.level_values,
        );
        self.flags.div0 |= div0;
        levels(self.chart, &self.level_values)
    }

    /// Evaluates into the simulator's own values and flags.
    pub(super) fn evaluate(&mut self, nodes: &[Valued], memory: Memory, t: i64) {
        let DividedByZero(div0) = evaluate(self.chart, &self.plan, nodes, memory, &mut self.state, t, &mut self.values);
        self.flags.div0 |= div0;
    }
}
