//! R7: stored actions.

use super::context::Values;
use super::{Activity, State};
use crate::chart::{Chart, Event, Stored, TransitionId, Value, VariableId};
use index_vec::IndexVec;
use std::collections::BTreeMap;

/// The class of what is done each scan: the last of R7's.
const EACH_SCAN: usize = 4;

/// What happened in a micro-step, as far as stored actions ask.
pub(super) struct Happened<'a> {
    /// The situation that the events occur in.
    pub before: &'a Activity,
    /// The situation that the micro-step leads to.
    pub after: &'a Activity,
    /// The transitions that were cleared.
    pub cleared: &'a IndexVec<TransitionId, bool>,
    /// By stored action, whether its event expression holds with all edges replaced by 0.
    pub levels: &'a [bool],
    /// Whether this is the first micro-step after a change of inputs.
    pub input_event: bool,
}

impl Happened<'_> {
    /// The actions that were triggered: on event, deactivation, clearing, activation, each in order of declaration.
    pub fn triggered<'c>(&self, chart: &'c Chart, values: &Values) -> Vec<&'c Stored> {
        let mut classes: [Vec<&Stored>; EACH_SCAN] = Default::default();
        for (stored, &level) in chart.stored.iter().zip(self.levels) {
            if let Some(class) = self.class(stored, level, values).filter(|class| *class < EACH_SCAN) {
                classes[class].push(stored);
            }
        }
        classes.into_iter().flatten().collect()
    }

    /// The actions that are done each scan, of those whose step is active and whose condition holds (R15).
    pub fn each_scan<'c>(&self, chart: &'c Chart, values: &Values) -> Vec<&'c Stored> {
        let is_done = |stored: &&Stored| self.class(stored, false, values) == Some(EACH_SCAN);
        chart.stored.iter().filter(is_done).collect()
    }

    /// The class of an action, if it was triggered.
    pub fn class(&self, stored: &Stored, level: bool, values: &Values) -> Option<usize> {
        let (class, happened) = match stored.event {
            // A level occurs once at an input event; an edge whenever it is seen.
            Event::Event(step, expression) => {
                (0, self.before[step] && values.holds(expression) && (!level || self.input_event))
            }
            Event::Deactivation(step) => (1, self.before[step] && !self.after[step]),
            Event::Clearing(transition) => (2, self.cleared[transition]),
            Event::Activation(step) => (3, self.after[step] && !self.before[step]),
            Event::EachScan(step, condition) => {
                (EACH_SCAN, self.after[step] && condition.is_none_or(|condition| values.holds(condition)))
            }
        };
        happened.then_some(class)
    }
}

/// What the allocations of one micro-step come to.
#[must_use]
pub(super) struct Allocated {
    /// Some variable has another value than before.
    pub changed: bool,
    /// Some variable was given different values.
    pub conflict: bool,
}

/// Allocates in order, so that the last one wins. The right sides have all been evaluated before.
pub(super) fn allocate(triggered: &[&Stored], values: &Values, state: &mut State) -> Allocated {
    let mut new: BTreeMap<VariableId, Value> = BTreeMap::new();
    let mut conflict = false;
    for stored in triggered {
        let value = values.of(stored.value);
        conflict |= new.insert(stored.target, value).is_some_and(|earlier| earlier != value);
    }
    let mut changed = false;
    for (id, value) in new {
        changed |= state.variables[id] != value;
        state.variables[id] = value;
    }
    Allocated { changed, conflict }
}
