//! What of a chart tests have made happen, as somebody sees it who looks on at the reference simulator.
//!
//! Steps, transitions, actions, orders and activation links count; of each condition, where it matters, both values of
//! each atom, and whether that atom has decided it. A condition of a transition matters while that is enabled, one of an
//! action while its step is active. A link of the drawing is taken when its transition is cleared, and has no count of its
//! own.

mod condition;
mod items;
mod lcov;
mod summary;

pub use condition::{Atom, Condition, MOST_ATOMS};
pub use items::{Item, Kind};
pub use lcov::lcov;
pub use summary::summary;

use condition::Classes;
use grafc_model::chart::{Chart, Event, GrafcetId, StepId, TransitionId};
use grafc_model::simulate::{Observer, Simulator};
use index_vec::IndexVec;

/// What has happened in a chart.
#[derive(Clone, Debug)]
pub struct Coverage<'a> {
    chart: &'a Chart,
    steps: IndexVec<StepId, u64>,
    transitions: IndexVec<TransitionId, u64>,
    continuous: Vec<u64>,
    stored: Vec<u64>,
    orders: Vec<u64>,
    /// By step: how often its activation link, if it has one, has activated it.
    links: IndexVec<StepId, u64>,
    of_transitions: IndexVec<TransitionId, Condition>,
    of_continuous: Vec<Option<Condition>>,
    of_stored: Vec<Option<Condition>>,
    /// The situation before the micro-step that comes next.
    before: IndexVec<StepId, bool>,
}

impl<'a> Coverage<'a> {
    /// Nothing has happened yet.
    pub fn new(chart: &'a Chart) -> Coverage<'a> {
        let classes = Classes::new(chart);
        let condition = |root| Condition::new(chart, root, &classes);
        let event = |event: Event| match event {
            Event::Event(_, event) | Event::EachScan(_, Some(event)) => Some(condition(event)),
            Event::EachScan(_, None) | Event::Activation(_) | Event::Deactivation(_) | Event::Clearing(_) => None,
        };
        Coverage {
            chart,
            steps: chart.steps.iter().map(|_| 0).collect(),
            transitions: chart.transitions.iter().map(|_| 0).collect(),
            continuous: vec![0; chart.continuous.len()],
            stored: vec![0; chart.stored.len()],
            orders: vec![0; chart.orders.len()],
            links: chart.steps.iter().map(|_| 0).collect(),
            of_transitions: chart.transitions.iter().map(|t| condition(t.condition)).collect(),
            of_continuous: chart.continuous.iter().map(|action| action.condition.map(condition)).collect(),
            of_stored: chart.stored.iter().map(|action| event(action.event)).collect(),
            before: chart.steps.iter().map(|_| false).collect(),
        }
    }

    /// The chart.
    pub fn chart(&self) -> &'a Chart {
        self.chart
    }

    /// Another run begins.
    pub(crate) fn begin(&mut self) {
        self.before.iter_mut().for_each(|active| *active = false);
    }

    /// How often a transition was cleared.
    pub fn cleared(&self, id: TransitionId) -> u64 {
        self.transitions[id]
    }

    /// Adds what has happened in other tests of the same chart.
    pub fn add(&mut self, other: &Coverage) {
        fn sum<'n>(mine: impl IntoIterator<Item = &'n mut u64>, theirs: impl IntoIterator<Item = &'n u64>) {
            mine.into_iter().zip(theirs).for_each(|(mine, theirs)| *mine += theirs);
        }
        sum(&mut self.steps, &other.steps);
        sum(&mut self.transitions, &other.transitions);
        sum(&mut self.continuous, &other.continuous);
        sum(&mut self.stored, &other.stored);
        sum(&mut self.orders, &other.orders);
        sum(&mut self.links, &other.links);
        self.of_transitions.iter_mut().zip(&other.of_transitions).for_each(|(mine, theirs)| mine.add(theirs));
        let mine = self.of_continuous.iter_mut().chain(&mut self.of_stored).flatten();
        let theirs = other.of_continuous.iter().chain(&other.of_stored).flatten();
        mine.zip(theirs).for_each(|(mine, theirs)| mine.add(theirs));
    }
}

impl Observer for Coverage<'_> {
    fn micro_step(&mut self, simulator: &Simulator) {
        let active = simulator.state().situation();
        let in_force = simulator.in_force();
        for (count, is) in self.orders.iter_mut().zip(&in_force) {
            *count += u64::from(*is);
        }
        for (count, is) in self.steps.iter_mut().zip(active) {
            *count += u64::from(*is);
        }
        if let Some(seen) = simulator.seen().filter(|_| !simulator.is_at_start()) {
            for (id, condition) in self.of_transitions.iter_mut_enumerated() {
                if seen.enabled[id] {
                    condition.ask(simulator);
                }
                self.transitions[id] += u64::from(seen.cleared[id]);
            }
            for (place, done) in seen.done.iter().enumerate() {
                self.stored[place] += u64::from(*done);
                let is_asked = match self.chart.stored[place].event {
                    Event::Event(step, _) => self.before[step],
                    Event::EachScan(step, _) => active[step],
                    Event::Deactivation(_) | Event::Clearing(_) | Event::Activation(_) => false,
                };
                if let Some(condition) = self.of_stored[place].as_mut().filter(|_| is_asked) {
                    condition.ask(simulator);
                }
            }
            let grafcets = &self.chart.grafcets;
            let mut is_forced: IndexVec<GrafcetId, bool> = grafcets.iter().map(|_| false).collect();
            for (order, _) in self.chart.orders.iter().zip(&in_force).filter(|(_, is)| **is) {
                is_forced[order.grafcet] = true;
            }
            for (id, step) in self.chart.steps.iter_enumerated().filter(|(id, step)| step.activated && active[*id]) {
                let entered = grafcets[step.grafcet].enclosing_step.is_some_and(|e| active[e] && !self.before[e]);
                if entered && !is_forced[step.grafcet] {
                    self.links[id] += 1;
                }
            }
        }
        self.before.clone_from(active);
    }

    fn rested(&mut self, simulator: &mut Simulator, t_ms: i64) {
        let acting = simulator.acting(t_ms);
        for (place, acts) in acting.into_iter().enumerate() {
            self.continuous[place] += u64::from(acts);
            if let Some(condition) = &mut self.of_continuous[place]
                && simulator.state().situation()[self.chart.continuous[place].step]
            {
                condition.ask(simulator);
            }
        }
    }
}
