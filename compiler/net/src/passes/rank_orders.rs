//! Gives each grafcet the orders on it, the one that wins first (rule R2), with every situation as places.
//!
//! Before:  `orders = [1: G2{INIT}, 2: G2{*}, 3: G2{}]`, step 3 at a higher level of the hierarchy than 1 and 2
//!
//! After:   `G2.orders = [3: {}, 1: {10}, 2: current]`, step 10 being the initial one of G2
//!
//! The order in force on a grafcet is the first one whose step is active: of the highest level, then the first declared.
//! `{INIT}` means the steps that the chart marks as initial, which is why this comes before the start is settled.

use super::Pass;
use crate::net::{Fact, Forced, Net, RankedOrder};
use grafc_diagnostics::Diagnostics;
use grafc_model::chart::{Situation, StepId};

pub const PASS: Pass =
    Pass { name: "rank-orders", requires: &[], ensures: &[Fact::RankedOrders], for_overlap: false, run };

fn run(net: &mut Net, _diagnostics: &mut Diagnostics) {
    let mut orders = std::mem::take(&mut net.orders);
    // Stable: orders of one level stay in order of declaration.
    orders.sort_by_key(|order| net.grafcets[net.places[order.step].grafcet].level);
    for order in orders {
        let forced = match order.situation {
            Situation::Steps(steps) => Forced::Steps(in_order(steps)),
            Situation::Initial => {
                let steps = net.grafcets[order.grafcet].steps.iter().copied();
                Forced::Steps(in_order(steps.filter(|s| net.places[*s].initial).collect()))
            }
            Situation::Current => Forced::Current,
        };
        net.grafcets[order.grafcet].orders.push(RankedOrder { step: order.step, forced, span: order.span });
    }
}

fn in_order(mut steps: Vec<StepId>) -> Vec<StepId> {
    steps.sort_unstable();
    steps.dedup();
    steps
}
