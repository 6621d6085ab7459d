//! The passes that flatten a net, in order.
//!
//! A pass is a function with a line in [`ORDER`]; it names the facts that it needs and those that it establishes. The
//! runner refuses an order whose needs are not met, and in debug builds verifies the net after each pass.

mod break_two_step_rings;
mod close_freezing;
mod expand_macro_steps;
mod flatten_enclosures;
mod nest_children;
mod rank_orders;
mod settle_start;

use crate::net::{Fact, Net};
use grafc_diagnostics::Diagnostics;

/// One pass over a net.
pub struct Pass {
    /// The name, as options and reports spell it.
    pub name: &'static str,
    /// Facts that must hold before.
    pub requires: &'static [Fact],
    /// Facts that hold after.
    pub ensures: &'static [Fact],
    /// Whether it serves only encodings in which a step and its successor overlap.
    pub for_overlap: bool,
    /// Does it. Reports and goes on.
    pub run: fn(&mut Net, &mut Diagnostics),
}

/// All passes, in the order in which they run.
pub const ORDER: &[Pass] = &[
    expand_macro_steps::PASS,
    rank_orders::PASS,
    settle_start::PASS,
    close_freezing::PASS,
    flatten_enclosures::PASS,
    nest_children::PASS,
    break_two_step_rings::PASS,
];

/// Runs all passes; those for overlapping steps only if asked. `after` sees the net after each pass.
///
/// # Panics
/// In debug builds, if a pass leaves a net that does not verify, or if [`ORDER`] is wrong: faults of grafc.
pub fn run_and_look(
    net: &mut Net,
    overlap: bool,
    diagnostics: &mut Diagnostics,
    mut after: impl FnMut(&'static Pass, &Net),
) {
    debug_assert_eq!(crate::verify(net), Ok(()), "the net as built");
    for pass in ORDER.iter().filter(|pass| overlap || !pass.for_overlap) {
        debug_assert!(pass.requires.iter().all(|fact| net.facts.contains(fact)), "`{}` runs too early", pass.name);
        (pass.run)(net, diagnostics);
        net.facts.extend_from_slice(pass.ensures);
        debug_assert_eq!(crate::verify(net), Ok(()), "after `{}`", pass.name);
        after(pass, net);
    }
}

/// Runs all passes; those for overlapping steps only if asked.
pub fn run(net: &mut Net, overlap: bool, diagnostics: &mut Diagnostics) {
    run_and_look(net, overlap, diagnostics, |_, _| ());
}
