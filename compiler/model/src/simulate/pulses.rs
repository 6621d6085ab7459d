//! R15: pulse orders, for one grafcet after the other from the top of the hierarchy.

use super::Activity;
use crate::chart::{Chart, Event, GrafcetId, PulseKind, StepId, TransitionId};
use index_vec::IndexVec;

/// Who commands whom.
#[derive(Clone, Debug)]
pub(super) struct Commands {
    /// The pulses on each grafcet, as places in the chart's list.
    pulses: IndexVec<GrafcetId, Vec<usize>>,
    /// The steps that each grafcet runs with.
    runs: IndexVec<GrafcetId, Vec<StepId>>,
    /// What the steps of each grafcet command, and those of its enclosures, however deep.
    below: IndexVec<GrafcetId, Vec<GrafcetId>>,
    /// The situation before R5 at the start: what is initial, and neither in a child nor enclosed in one.
    pub initial: Activity,
}

/// What has occurred in a micro-step before the situation is settled.
pub(super) struct Occurred<'a> {
    /// The transitions that were cleared.
    pub cleared: &'a IndexVec<TransitionId, bool>,
    /// By pulse order, whether its event has occurred; false of those that wait for none.
    pub events: &'a [bool],
}

/// What pulse orders have done in a micro-step so far.
pub(super) struct Pulses<'a> {
    commands: &'a Commands,
    occurred: Occurred<'a>,
    saved: &'a mut Activity,
    frozen: &'a mut IndexVec<GrafcetId, bool>,
    /// Killed or frozen in this micro-step, or enclosed in what is.
    stopped: IndexVec<GrafcetId, bool>,
    /// Given by the kill, and by the freezing, of what is above.
    inherited: IndexVec<GrafcetId, (bool, bool)>,
    /// The steps that were resumed.
    resumed: Activity,
}

impl Commands {
    pub fn new(chart: &Chart) -> Self {
        let lists = || chart.grafcets.iter().map(|_| Vec::new()).collect::<IndexVec<GrafcetId, Vec<GrafcetId>>>();
        let mut pulses: IndexVec<GrafcetId, Vec<usize>> = chart.grafcets.iter().map(|_| Vec::new()).collect();
        for (place, pulse) in chart.pulses.iter().enumerate() {
            pulses[pulse.grafcet].push(place);
        }
        let mut runs: IndexVec<GrafcetId, Vec<StepId>> = chart.grafcets.iter().map(|_| Vec::new()).collect();
        for run in &chart.runs {
            runs[run.grafcet].push(run.step);
        }
        let mut own = lists();
        for (above, below, _) in chart.commands() {
            own[above].push(below);
        }
        // Whatever is enclosed comes after what encloses it.
        let mut below = own.clone();
        let mut in_child: IndexVec<GrafcetId, bool> = chart.grafcets.iter().map(|grafcet| grafcet.child).collect();
        for &id in &chart.hierarchy {
            if let Some(around) = around(chart, id) {
                in_child[id] |= in_child[around];
            }
        }
        for &id in chart.hierarchy.iter().rev() {
            below[id].sort_unstable();
            below[id].dedup();
            if let Some(around) = around(chart, id) {
                let inside = below[id].clone();
                below[around].extend(inside);
            }
        }
        let initial = chart.steps.iter().map(|step| step.initial && !in_child[step.grafcet]).collect();
        Commands { pulses, runs, below, initial }
    }
}

/// The grafcet of the step that encloses one.
fn around(chart: &Chart, id: GrafcetId) -> Option<GrafcetId> {
    chart.grafcets[id].enclosing_step.map(|step| chart.steps[step].grafcet)
}

impl<'a> Pulses<'a> {
    pub fn new(
        chart: &Chart,
        commands: &'a Commands,
        occurred: Occurred<'a>,
        saved: &'a mut Activity,
        frozen: &'a mut IndexVec<GrafcetId, bool>,
    ) -> Self {
        Pulses {
            commands,
            occurred,
            saved,
            frozen,
            stopped: chart.grafcets.iter().map(|_| false).collect(),
            inherited: chart.grafcets.iter().map(|_| (false, false)).collect(),
            resumed: chart.steps.iter().map(|_| false).collect(),
        }
    }

    /// 6: nothing of the grafcet is saved any more, and it is not frozen.
    pub fn forget(&mut self, chart: &Chart, id: GrafcetId) {
        for &step in &chart.grafcets[id].steps {
            self.saved[step] = false;
        }
        self.frozen[id] = false;
    }

    /// What is enclosed stops with what is around it.
    pub fn stop_with_enclosing(&mut self, chart: &Chart, id: GrafcetId) {
        if let Some(around) = around(chart, id) {
            self.stopped[id] |= self.stopped[around];
        }
    }

    /// 1: the kinds of pulse that are given to the grafcet, but for inherited ones.
    fn given(&self, chart: &Chart, id: GrafcetId, before: &Activity, next: &Activity) -> [bool; 4] {
        let mut given = [false; 4];
        for &place in &self.commands.pulses[id] {
            let pulse = &chart.pulses[place];
            // What was killed or frozen gives nothing but what its new steps give.
            let is_stopped = chart.commander(pulse.event).is_some_and(|commander| self.stopped[commander]);
            let occurs = match pulse.event {
                Event::Event(..) => self.occurred.events[place] && !is_stopped,
                Event::Deactivation(step) => before[step] && !next[step] && !is_stopped,
                Event::Clearing(transition) => self.occurred.cleared[transition] && !is_stopped,
                Event::Activation(step) => next[step] && !before[step],
                Event::EachScan(..) => false,
            };
            given[pulse.kind as usize] |= occurs;
        }
        let runs = &self.commands.runs[id];
        let (was, is) = (runs.iter().any(|step| before[*step]), runs.iter().any(|step| next[*step]));
        if !was && is {
            let kind = if runs.iter().any(|step| self.resumed[*step]) { PulseKind::Resume } else { PulseKind::Start };
            given[kind as usize] = true;
        }
        let is_left = |step: &StepId| before[*step] && !self.stopped[chart.steps[*step].grafcet];
        if was && !is && runs.iter().any(is_left) {
            given[PulseKind::Kill as usize] = true;
        }
        given
    }

    /// What pulses make of the grafcet, between (a) and (b) of R5; says whether those that are given disagree.
    pub fn act(&mut self, chart: &Chart, id: GrafcetId, before: &Activity, next: &mut Activity) -> bool {
        if self.commands.pulses[id].is_empty() && self.commands.runs[id].is_empty() {
            return false;
        }
        let steps = &chart.grafcets[id].steps;
        let given = self.given(chart, id, before, next);
        let [kill, resume, start, freeze] = given;
        let count = given.iter().filter(|given| **given).count();
        let conflict = count > 1 && !(count == 2 && kill && start);
        let (kill, freeze) = (kill || self.inherited[id].0, freeze || self.inherited[id].1);
        // 2
        if kill {
            steps.iter().for_each(|&step| next[step] = false);
            self.forget(chart, id);
            self.stopped[id] = true;
            self.commands.below[id].iter().for_each(|&below| self.inherited[below].0 = true);
        }
        // 3
        if resume && !kill && self.frozen[id] {
            for &step in steps.iter().filter(|&&step| self.saved[step]) {
                next[step] = true;
                self.resumed[step] = true;
            }
            self.forget(chart, id);
        }
        // 4
        if start {
            self.forget(chart, id);
            steps.iter().filter(|&&step| chart.steps[step].initial).for_each(|&step| next[step] = true);
        }
        // 5
        if freeze && !kill {
            if !self.frozen[id] && steps.iter().any(|&step| next[step]) {
                for &step in steps {
                    self.saved[step] = next[step];
                    next[step] = false;
                }
                self.frozen[id] = true;
                self.stopped[id] = true;
            }
            self.commands.below[id].iter().for_each(|&below| self.inherited[below].1 = true);
        }
        conflict
    }
}
