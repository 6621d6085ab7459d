//! Makes `initial` mark the situation in which the chart starts (rules R5 and R10).
//!
//! Before:  `initial step 1` with the order `G2{11}`; `initial step 10` in G2
//!
//! After:   1 and 11 are initial, 10 is not
//!
//! From the top of the hierarchy down, an enclosure follows its enclosing step, then the order in force decides. Links
//! count only where the enclosing step is not itself marked as initial: otherwise the enclosed initial steps take their
//! place. Nothing in this depends on inputs, so that the start is known here once and for all, and whether orders
//! disagree in it as well.

use super::Pass;
use crate::net::{CommandsOn, Fact, Forced, Net};
use grafc_diagnostics::Diagnostics;
use grafc_model::chart::{Event, GrafcetId, PulseKind, StepId};
use index_vec::IndexVec;

pub const PASS: Pass = Pass {
    name: "settle-start",
    requires: &[Fact::NoMacroSteps, Fact::RankedOrders],
    ensures: &[Fact::SettledStart],
    for_overlap: false,
    run,
};

fn run(net: &mut Net, _diagnostics: &mut Diagnostics) {
    let mut in_child: IndexVec<GrafcetId, bool> = net.grafcets.iter().map(|grafcet| grafcet.child).collect();
    for g in &net.hierarchy {
        in_child[*g] |= net.around(*g).is_some_and(|around| in_child[around]);
    }
    let marked: IndexVec<StepId, bool> =
        net.places.iter().map(|place| place.initial && !in_child[place.grafcet]).collect();
    let mut active = marked.clone();
    let mut pulses = Pulses::new(net);
    for id in net.hierarchy.clone() {
        let grafcet = &net.grafcets[id];
        if let Some(enclosing) = grafcet.enclosing_step {
            if !active[enclosing] {
                grafcet.steps.iter().for_each(|s| active[*s] = false);
                // An inactive enclosure obeys no order, so its orders cannot conflict.
                continue;
            }
            if !net.places[enclosing].initial || in_child[net.places[enclosing].grafcet] {
                grafcet.steps.iter().filter(|s| net.places[**s].activated).for_each(|s| active[*s] = true);
            }
        }
        let conflict = pulses.act(net, id, &mut active);
        net.conflict_at_start |= conflict;
        let grafcet = &net.grafcets[id];
        let mut in_force = grafcet.orders.iter().filter(|order| active[order.step]);
        if let Some(first) = in_force.next() {
            net.conflict_at_start |= in_force.any(|other| other.forced != first.forced);
            if let Forced::Steps(steps) = &first.forced {
                grafcet.steps.iter().for_each(|s| active[*s] = false);
                steps.iter().for_each(|s| active[*s] = true);
                pulses.forget(net, id);
            }
        }
    }
    for (place, active) in net.places.iter_mut().zip(active) {
        place.initial = active;
    }
}

/// Pulse orders at the start (R15): all steps that are active have just become so, and nothing else has occurred.
struct Pulses {
    on: IndexVec<GrafcetId, CommandsOn>,
    below: IndexVec<GrafcetId, Vec<GrafcetId>>,
    /// Given by the kill, and by the freezing, of what is above.
    inherited: IndexVec<GrafcetId, (bool, bool)>,
}

impl Pulses {
    fn new(net: &Net) -> Self {
        let inherited = net.grafcets.iter().map(|_| (false, false)).collect();
        Pulses { on: net.commands_on(), below: net.commanded_below(), inherited }
    }

    /// What they make of a grafcet; says whether those that are given disagree.
    fn act(&mut self, net: &mut Net, id: GrafcetId, active: &mut IndexVec<StepId, bool>) -> bool {
        let mut given = [false; 4];
        let on = &self.on[id];
        for pulse in on.pulses.iter().map(|place| &net.pulses[*place]) {
            given[pulse.kind as usize] |= matches!(pulse.event, Event::Activation(s) if active[s]);
        }
        given[PulseKind::Start as usize] |= on.runs.iter().any(|step| active[*step]);
        let [kill, _, start, freeze] = given;
        let count = given.iter().filter(|given| **given).count();
        let (kill, freeze) = (kill || self.inherited[id].0, freeze || self.inherited[id].1);
        let steps = net.grafcets[id].steps.clone();
        if kill {
            steps.iter().for_each(|s| active[*s] = false);
            self.below[id].iter().for_each(|below| self.inherited[*below].0 = true);
        }
        if start {
            steps.iter().filter(|s| net.places[**s].started).for_each(|s| active[*s] = true);
        }
        if freeze && !kill {
            if steps.iter().any(|s| active[*s]) {
                for s in &steps {
                    net.places[*s].saved = std::mem::replace(&mut active[*s], false);
                }
                net.grafcets[id].starts_frozen = true;
            }
            self.below[id].iter().for_each(|below| self.inherited[*below].1 = true);
        }
        count > 1 && !(count == 2 && given[PulseKind::Kill as usize] && start)
    }

    /// An order that sets a situation undoes the freezing.
    fn forget(&mut self, net: &mut Net, id: GrafcetId) {
        for s in net.grafcets[id].steps.clone() {
            net.places[s].saved = false;
        }
        net.grafcets[id].starts_frozen = false;
    }
}
