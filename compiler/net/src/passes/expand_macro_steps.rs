//! Replaces each macro-step by its expansion (IEC 60848, symbols 6 and 42; rule M1).
//!
//! Before:  `1 -t1-> M3 -t2-> 2`      After:  `1 -t1-> E3`, `E3 … S3`, `S3 -t2-> 2`
//!
//! The steps of the expansion are places of the net already. Leaving the macro-step deactivates its exit step only:
//! other steps of the expansion that are still active stay so. The table keeps the places of each expansion, because
//! they are what the macro-step's activity means.

use super::Pass;
use crate::net::{Fact, Net};
use grafc_diagnostics::Diagnostics;

pub const PASS: Pass =
    Pass { name: "expand-macro-steps", requires: &[], ensures: &[Fact::NoMacroSteps], for_overlap: false, run };

fn run(net: &mut Net, _diagnostics: &mut Diagnostics) {
    for m in &mut net.macro_steps {
        for t in m.entered_by.drain(..) {
            net.transitions[t].post.push(m.entry);
        }
        for t in m.left_by.drain(..) {
            net.transitions[t].pre.push(m.exit);
        }
    }
}
