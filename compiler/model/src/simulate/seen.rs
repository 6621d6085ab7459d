//! What somebody who looks on sees of a micro-step and of the situation that it leads to: by the rules, as they stand.

use super::orders::Forced;
use super::plan::{Memory, Valued};
use super::stored::Happened;
use super::{Simulator, Values};
use crate::chart::{Chart, ExprId, GrafcetId, Mode, StepId, TransitionId};
use index_vec::IndexVec;

/// What is seen of a micro-step.
#[derive(Clone, Debug, Default)]
pub struct Seen {
    /// Whether each transition was enabled: all steps before it were active and what encloses it was, and nothing froze it.
    pub enabled: IndexVec<TransitionId, bool>,
    /// Whether its condition was true.
    pub satisfied: IndexVec<TransitionId, bool>,
    /// Whether both, so that it cleared (R3).
    pub cleared: IndexVec<TransitionId, bool>,
    /// Whether each stored action was done (R7).
    pub done: Vec<bool>,
}

impl Seen {
    /// What is seen before anything has happened.
    fn nothing(chart: &Chart) -> Seen {
        let none: IndexVec<TransitionId, bool> = chart.transitions.iter().map(|_| false).collect();
        let done = chart.stored.iter().map(|_| false).collect();
        Seen { enabled: none.clone(), satisfied: none.clone(), cleared: none, done }
    }

    /// What is seen of a micro-step, whose context has been evaluated.
    pub(super) fn new(
        chart: &Chart,
        enabled: IndexVec<TransitionId, bool>,
        happened: &Happened,
        values: &Values,
    ) -> Seen {
        let satisfied: IndexVec<TransitionId, bool> =
            chart.transitions.iter().map(|transition| values.holds(transition.condition)).collect();
        let cleared = enabled.iter().zip(&satisfied).map(|(enabled, satisfied)| *enabled && *satisfied).collect();
        let stored = chart.stored.iter().zip(happened.levels);
        let done = stored.map(|(stored, level)| happened.class(stored, *level, values).is_some()).collect();
        Seen { enabled, satisfied, cleared, done }
    }
}

impl Simulator<'_> {
    /// From here on somebody looks on.
    pub fn look_on(&mut self) {
        self.seen = Some(Box::new(Seen::nothing(self.chart)));
    }

    /// What was seen of the latest micro-step, if somebody looks on; of the first one, what was done at the start as well.
    pub fn seen(&self) -> Option<&Seen> {
        self.seen.as_deref()
    }

    /// R3, but for conditions: all transitions whose steps before are active, and that are neither frozen nor in an inactive
    /// enclosure.
    pub(super) fn enabled(&self) -> IndexVec<TransitionId, bool> {
        let active = &self.state.active;
        let frozen = self.orders.frozen(self.chart, active);
        let transitions = self.chart.transitions.iter_enumerated();
        transitions
            .map(|(id, transition)| {
                self.flat.pre[id].iter().all(|&step| active[step])
                    && !frozen[transition.grafcet]
                    && self.is_left_to_clear(id)
                    && self.chart.grafcets[transition.grafcet].enclosing_step.is_none_or(|step| active[step])
            })
            .collect()
    }

    /// A micro-step is seen; the first one with what was done at the start.
    pub(super) fn see(&mut self, mut seen: Seen) {
        if let Some(at_start) = self.seen.as_ref().filter(|_| self.begins) {
            seen.done.iter_mut().zip(&at_start.done).for_each(|(done, at_start)| *done |= *at_start);
        }
        self.seen = Some(Box::new(seen));
    }

    /// Nothing has been seen, since all begins anew.
    pub(super) fn forget(&mut self) {
        if self.seen.is_some() {
            self.look_on();
        }
    }

    /// Whether it has just started, and not done a micro-step since.
    pub fn is_at_start(&self) -> bool {
        self.begins
    }

    /// Whether each grafcet is frozen in the situation, by an order in force (R2) or by a pulse (R15).
    pub fn frozen(&self) -> IndexVec<GrafcetId, bool> {
        let mut frozen = self.orders.frozen(self.chart, &self.state.active);
        frozen.iter_mut().zip(&self.state.frozen).for_each(|(frozen, by_pulse)| *frozen |= by_pulse);
        frozen
    }

    /// Whether each order is in force in the situation (R2): its step is active, and of the orders on the same grafcet none
    /// whose step is active comes before it, by the level of that step's grafcet, then by declaration.
    pub fn in_force(&self) -> Vec<bool> {
        let orders = &self.chart.orders;
        let rank = |place: usize| {
            let level = self.chart.grafcets[self.chart.steps[orders[place].step].grafcet].level;
            (level, place)
        };
        let mut first: IndexVec<GrafcetId, Option<usize>> = self.chart.grafcets.iter().map(|_| None).collect();
        for place in (0..orders.len()).filter(|place| self.state.active[orders[*place].step]) {
            let best = &mut first[orders[place].grafcet];
            *best = best.filter(|other| rank(*other) < rank(place)).or(Some(place));
        }
        (0..orders.len()).map(|place| first[orders[place].grafcet] == Some(place)).collect()
    }

    /// Whether a condition holds in the latest context, if it is one of those that were evaluated in it.
    pub fn holds(&self, condition: ExprId) -> bool {
        self.values.holds(condition)
    }

    /// Whether each step is active because the order in force on its grafcet names or holds it.
    pub fn forced(&self) -> IndexVec<StepId, bool> {
        let active = &self.state.active;
        let steps = self.chart.steps.iter_enumerated();
        steps
            .map(|(id, step)| {
                let order = self.orders.in_force(step.grafcet, active);
                let acts = order.is_some_and(|order| match order.forced {
                    Forced::Current => true,
                    Forced::Steps(steps) => steps.contains(&id),
                });
                active[id] && acts
            })
            .collect()
    }

    /// Whether each continuous action assigns, and the value of each wire, after the latest reaction, which was at `t`.
    pub fn acting(&mut self, t: i64) -> Vec<bool> {
        let variables = self.chart.variables.iter_enumerated();
        let wires = variables.filter(|(_, variable)| variable.mode == Mode::Wire).map(|(id, _)| Valued::Wire(id));
        let nodes = self.plan.of_wires(self.chart, wires.collect());
        // What is only looked at raises no flag.
        let flags = self.flags;
        self.evaluate(&nodes, Memory::Hold, t);
        self.flags = flags;
        let acts = |action: &crate::chart::Continuous| {
            self.state.active[action.step] && action.condition.is_none_or(|condition| self.values.holds(condition))
        };
        self.chart.continuous.iter().map(acts).collect()
    }
}
