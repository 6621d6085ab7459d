//! Says from where freezing reaches a grafcet (rule R2).
//!
//! Before:  an order on G2; step 5 of G2 encloses G5, step 51 of G5 encloses G6
//!
//! After:   `G5.frozen_with = G2`, `G6.frozen_with = G2`
//!
//! A frozen grafcet freezes the enclosures of its steps, theirs, and so on. Grafcets on which there are no orders are
//! passed over, so that each grafcet names the nearest one that adds something: it is frozen while an order on it is in
//! force or the one that it names is frozen.

use super::Pass;
use crate::net::{Fact, Net};
use grafc_diagnostics::Diagnostics;

pub const PASS: Pass = Pass {
    name: "close-freezing",
    requires: &[Fact::RankedOrders],
    ensures: &[Fact::ClosedFreezing],
    for_overlap: false,
    run,
};

fn run(net: &mut Net, _diagnostics: &mut Diagnostics) {
    // What encloses comes first, so its own answer is there.
    for id in &net.hierarchy {
        let Some(enclosing) = net.grafcets[*id].enclosing_step else { continue };
        let around = net.places[enclosing].grafcet;
        let outer = &net.grafcets[around];
        net.grafcets[*id].frozen_with = if outer.orders.is_empty() { outer.frozen_with } else { Some(around) };
    }
}
