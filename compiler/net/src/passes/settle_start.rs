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
use crate::net::{Fact, Forced, Net};
use grafc_diagnostics::Diagnostics;

pub const PASS: Pass = Pass {
    name: "settle-start",
    requires: &[Fact::NoMacroSteps, Fact::RankedOrders],
    ensures: &[Fact::SettledStart],
    for_overlap: false,
    run,
};

fn run(net: &mut Net, _diagnostics: &mut Diagnostics) {
    let mut active = net.places.iter().map(|place| place.initial).collect::<index_vec::IndexVec<_, _>>();
    for id in &net.hierarchy {
        let grafcet = &net.grafcets[*id];
        if let Some(enclosing) = grafcet.enclosing_step {
            if !active[enclosing] {
                grafcet.steps.iter().for_each(|s| active[*s] = false);
                // An inactive enclosure obeys no order, so its orders cannot conflict.
                continue;
            }
            if !net.places[enclosing].initial {
                grafcet.steps.iter().filter(|s| net.places[**s].activated).for_each(|s| active[*s] = true);
            }
        }
        let mut in_force = grafcet.orders.iter().filter(|order| active[order.step]);
        if let Some(first) = in_force.next() {
            net.conflict_at_start |= in_force.any(|other| other.forced != first.forced);
            if let Forced::Steps(steps) = &first.forced {
                grafcet.steps.iter().for_each(|s| active[*s] = false);
                steps.iter().for_each(|s| active[*s] = true);
            }
        }
    }
    for (place, active) in net.places.iter_mut().zip(active) {
        place.initial = active;
    }
}
