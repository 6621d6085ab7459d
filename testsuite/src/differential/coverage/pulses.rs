//! What of R15 a micro-step exercises, by what can be seen of it: pulse orders on children and other grafcets.

use grafc_model::chart::{Chart, Event, GrafcetId, PulseKind, Situation, StepId, TransitionId};
use grafc_model::simulate::Activity;
use index_vec::IndexVec;

/// All that can be seen.
pub(super) const ALL: [&str; 14] = [
    "R15 killed",
    "R15 killed with what commands it",
    "R15 killed and started at once",
    "R15 resumed",
    "R15 started",
    "R15 started while active",
    "R15 frozen",
    "R15 frozen with what commands it",
    "R15 pulses of different kinds",
    "R15 a pulse of what is stopped is dropped",
    "R15 handed over from step to step",
    "R15 an order forgets what was saved",
    "R15 a source transition of a child waits",
    "R15 pulses act at the start",
];

/// What is remembered of a situation.
#[derive(Clone)]
pub(super) struct Remembered {
    pub active: Activity,
    pub saved: Activity,
    pub frozen: IndexVec<GrafcetId, bool>,
}

/// A micro-step: what was before it, what is after it, which transitions were cleared in it, and what that activates.
pub(super) struct Evolved<'a> {
    pub chart: &'a Chart,
    pub before: &'a Remembered,
    pub after: &'a Remembered,
    pub cleared: &'a IndexVec<TransitionId, bool>,
    pub entered: &'a Activity,
}

impl Evolved<'_> {
    /// Whether a pulse occurs, as far as steps and transitions tell; those on an event are left out.
    fn occurs(&self, event: Event) -> bool {
        let (before, after) = (&self.before.active, &self.after.active);
        match event {
            Event::Activation(s) => !before[s] && after[s],
            Event::Deactivation(s) => before[s] && !after[s],
            Event::Clearing(t) => self.cleared[t],
            Event::Event(..) | Event::EachScan(..) => false,
        }
    }

    fn any(&self, g: GrafcetId, set: &Activity) -> bool {
        self.chart.grafcets[g].steps.iter().any(|s| set[*s])
    }

    /// The grafcets whose steps and transitions command one.
    fn commanders(&self, g: GrafcetId) -> impl Iterator<Item = GrafcetId> {
        self.chart.commands().filter(move |(_, commanded, _)| *commanded == g).map(|(commander, ..)| commander)
    }

    /// What is seen of one grafcet.
    pub fn of(&self, g: GrafcetId) -> Vec<&'static str> {
        let chart = self.chart;
        let pulses = || chart.pulses.iter().filter(move |pulse| pulse.grafcet == g);
        let runs: Vec<StepId> = chart.runs.iter().filter(|run| run.grafcet == g).map(|run| run.step).collect();
        if pulses().next().is_none() && runs.is_empty() {
            return Vec::new();
        }
        let grafcet = &chart.grafcets[g];
        let (was, is) = (&self.before.active, &self.after.active);
        let (was_frozen, is_frozen) = (self.before.frozen[g], self.after.frozen[g]);
        let ordered = |order: &grafc_model::chart::Order| order.grafcet == g && is[order.step];
        let is_set = chart.orders.iter().any(|order| ordered(order) && order.situation != Situation::Current);
        let free = grafcet.enclosing_step.is_none_or(|e| was[e] && is[e]) && !is_set;
        let freezes = free && !was_frozen && is_frozen;
        let newly_frozen = |g: GrafcetId| self.after.frozen[g] && !self.before.frozen[g];
        let gone = |g: GrafcetId| self.any(g, was) && !self.any(g, is) && !self.after.frozen[g];
        let given = |kind: PulseKind| pulses().any(|pulse| pulse.kind == kind && self.occurs(pulse.event));
        // What has gone with no transition of its own cleared.
        let own = |(t, cleared): (TransitionId, &bool)| *cleared && chart.transitions[t].grafcet == g;
        let quiet = !self.cleared.iter_enumerated().any(own);
        let killed =
            free && quiet && !is_frozen && (self.any(g, was) && !self.any(g, is) || was_frozen && !self.any(g, is));
        let again = |s: &StepId| !was[*s] && is[*s] && !self.entered[*s];
        let resumed = free
            && was_frozen
            && grafcet.steps.iter().any(|s| again(s) && self.before.saved[*s] && !chart.steps[*s].initial);
        let started =
            free && grafcet.steps.iter().any(|s| again(s) && chart.steps[*s].initial && !self.before.saved[*s]);
        let kinds = PulseKind::ALL.map(given);
        let [kill, _, start, _] = kinds;
        let count = kinds.iter().filter(|given| **given).count();
        let inside = |s: &&StepId| is[**s] || was[**s];
        let stopped = |s: StepId| newly_frozen(chart.steps[s].grafcet) || gone(chart.steps[s].grafcet);
        let dropped = |event: Event| matches!(event, Event::Deactivation(s) if self.occurs(event) && stopped(s));
        let handed_over = runs.iter().any(|s| was[*s] && !is[*s]) && runs.iter().any(|s| !was[*s] && is[*s]);
        let waits = grafcet.child && !self.any(g, was);
        let is_source = |t: &grafc_model::chart::Transition| t.grafcet == g && t.pre.is_empty();
        let found = [
            (killed, "R15 killed"),
            (killed && self.commanders(g).any(gone), "R15 killed with what commands it"),
            (kill && start && free, "R15 killed and started at once"),
            (resumed, "R15 resumed"),
            (started, "R15 started"),
            (start && self.any(g, was) && !kill && free, "R15 started while active"),
            (freezes, "R15 frozen"),
            (freezes && self.commanders(g).any(newly_frozen), "R15 frozen with what commands it"),
            (count > 1 && !(count == 2 && kill && start), "R15 pulses of different kinds"),
            (pulses().any(|pulse| dropped(pulse.event)), "R15 a pulse of what is stopped is dropped"),
            (handed_over && runs.iter().filter(inside).count() > 1, "R15 handed over from step to step"),
            (was_frozen && !is_frozen && is_set, "R15 an order forgets what was saved"),
            (waits && chart.transitions.iter().any(is_source), "R15 a source transition of a child waits"),
        ];
        found.into_iter().filter_map(|(is, what)| is.then_some(what)).collect()
    }
}
