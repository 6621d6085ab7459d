//! Tells each place and transition of an enclosure what it is within (IEC 60848, symbol 41; rules R3 and R5).
//!
//! Before:  step 5 encloses G5, which holds 51, 52 and `51 -t3-> 52`
//!
//! After:   51, 52 and t3 are within 5; no grafcet has an enclosing step
//!
//! A place is active only while the one that it is within is active; if it has an activation link, it becomes active
//! together with that one. A transition clears only while the place that it is within is active, which matters for
//! source transitions: the others have a place before them to see to it.

use super::Pass;
use crate::net::{Fact, Net};
use grafc_diagnostics::Diagnostics;

pub const PASS: Pass = Pass {
    name: "flatten-enclosures",
    requires: &[Fact::SettledStart, Fact::ClosedFreezing],
    ensures: &[Fact::NoEnclosures],
    for_overlap: false,
    run,
};

fn run(net: &mut Net, _diagnostics: &mut Diagnostics) {
    for place in &mut net.places {
        place.within = net.grafcets[place.grafcet].enclosing_step.into_iter().collect();
    }
    for transition in &mut net.transitions {
        transition.within = net.grafcets[transition.grafcet].enclosing_step.into_iter().collect();
    }
    for grafcet in &mut net.grafcets {
        grafcet.enclosing_step = None;
    }
}
