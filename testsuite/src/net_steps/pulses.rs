//! R15: pulse orders on the grafcets of a net, from the top of the hierarchy down.

use super::expressions::Memory;
use grafc_model::chart::{Event, GrafcetId, PulseKind, StepId};
use grafc_net::net::{CommandsOn, Net};
use index_vec::IndexVec;

type Active = IndexVec<StepId, bool>;

/// The grafcets that are children, or enclosed in one, however deep.
pub(super) fn below_children(net: &Net) -> IndexVec<GrafcetId, bool> {
    let mut below: IndexVec<GrafcetId, bool> = net.grafcets.iter().map(|grafcet| grafcet.child).collect();
    for g in &net.hierarchy {
        below[*g] |= net.around(*g).is_some_and(|around| below[around]);
    }
    below
}

/// What they do in a micro-step.
pub(super) struct Pulses<'a> {
    net: &'a Net,
    /// By pulse, whether its event or its clearing has occurred.
    given: &'a [bool],
    on: IndexVec<GrafcetId, CommandsOn>,
    below: IndexVec<GrafcetId, Vec<GrafcetId>>,
    stopped: IndexVec<GrafcetId, bool>,
    killed_from_above: IndexVec<GrafcetId, bool>,
    frozen_from_above: IndexVec<GrafcetId, bool>,
    resumed: Active,
}

impl<'a> Pulses<'a> {
    pub fn new(net: &'a Net, given: &'a [bool]) -> Self {
        let none = || net.grafcets.iter().map(|_| false).collect::<IndexVec<GrafcetId, bool>>();
        Pulses {
            net,
            given,
            on: net.commands_on(),
            below: net.commanded_below(),
            stopped: none(),
            killed_from_above: none(),
            frozen_from_above: none(),
            resumed: net.places.iter().map(|_| false).collect(),
        }
    }

    /// Nothing is saved any more.
    pub fn forget(&mut self, g: GrafcetId, memory: &mut Memory) {
        self.stopped[g] |= self.net.around(g).is_some_and(|around| self.stopped[around]);
        self.net.grafcets[g].steps.iter().for_each(|s| memory.saved[*s] = false);
        memory.frozen[g] = false;
    }

    /// Whether a kind is given by a pulse.
    fn is_given(&self, g: GrafcetId, kind: PulseKind, before: &Active, next: &Active) -> bool {
        let net = self.net;
        let occurs = |place: usize, event: Event| {
            let goes_on = !self.stopped[net.commander(event)];
            match event {
                Event::Activation(s) => next[s] && !before[s],
                Event::Deactivation(s) => before[s] && !next[s] && goes_on,
                Event::Event(..) | Event::Clearing(_) => self.given[place] && goes_on,
                Event::EachScan(..) => false,
            }
        };
        let pulses = net.pulses.iter().enumerate().filter(|(_, pulse)| pulse.grafcet == g && pulse.kind == kind);
        let by_pulse = pulses.into_iter().any(|(place, pulse)| occurs(place, pulse.event));
        let steps = &self.on[g].runs;
        let any = |set: &Active| steps.iter().any(|s| set[*s]);
        let begins = !any(before) && any(next);
        let by_run = match kind {
            PulseKind::Start => begins && !any(&self.resumed),
            PulseKind::Resume => begins && any(&self.resumed),
            PulseKind::Kill => !any(next) && steps.iter().any(|s| before[*s] && !self.stopped[net.places[*s].grafcet]),
            PulseKind::Freeze => false,
        };
        by_pulse || by_run
    }

    /// What is made of a grafcet; says whether kinds disagree.
    pub fn act(&mut self, g: GrafcetId, before: &Active, next: &mut Active, memory: &mut Memory) -> bool {
        self.stopped[g] |= self.net.around(g).is_some_and(|around| self.stopped[around]);
        if self.on[g].is_empty() {
            return false;
        }
        let steps = &self.net.grafcets[g].steps;
        let [own_kill, resume, start, own_freeze] = PulseKind::ALL.map(|kind| self.is_given(g, kind, before, next));
        let kill = own_kill || self.killed_from_above[g];
        let freeze = (own_freeze || self.frozen_from_above[g]) && !kill;
        if kill {
            steps.iter().for_each(|s| next[*s] = false);
            self.stopped[g] = true;
            self.below[g].iter().for_each(|below| self.killed_from_above[*below] = true);
        }
        let resumes = resume && !kill && memory.frozen[g];
        for s in steps.iter().filter(|s| resumes && memory.saved[**s]) {
            next[*s] = true;
            self.resumed[*s] = true;
        }
        if kill || resumes || start {
            self.forget(g, memory);
        }
        if start {
            steps.iter().filter(|s| self.net.places[**s].started).for_each(|s| next[*s] = true);
        }
        if freeze && !memory.frozen[g] && steps.iter().any(|s| next[*s]) {
            steps.iter().for_each(|s| memory.saved[*s] = std::mem::replace(&mut next[*s], false));
            memory.frozen[g] = true;
            self.stopped[g] = true;
        }
        if freeze {
            self.below[g].iter().for_each(|below| self.frozen_from_above[*below] = true);
        }
        let given = [own_kill, resume, start, own_freeze];
        given != [true, false, true, false] && given.iter().filter(|given| **given).count() > 1
    }
}
