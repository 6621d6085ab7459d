//! The passes that flatten a net, in order.
//!
//! A pass is a function with a line in [`ORDER`]; it names the facts that it needs and those that it brings about. The
//! runner refuses an order whose needs are not met, and in debug builds verifies the net after each pass.

mod expand_macro_steps;

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
    /// Does it. Reports and goes on.
    pub run: fn(&mut Net, &mut Diagnostics),
}

/// All passes, in the order in which they run.
pub const ORDER: &[Pass] = &[expand_macro_steps::PASS];

/// Runs all passes.
///
/// # Panics
/// In debug builds, if a pass leaves a net that does not verify, or if [`ORDER`] is wrong: faults of grafc.
pub fn run(net: &mut Net, diagnostics: &mut Diagnostics) {
    debug_assert_eq!(crate::verify(net), Ok(()), "the net as built");
    for pass in ORDER {
        debug_assert!(pass.requires.iter().all(|fact| net.facts.contains(fact)), "`{}` runs too early", pass.name);
        (pass.run)(net, diagnostics);
        net.facts.extend_from_slice(pass.ensures);
        debug_assert_eq!(crate::verify(net), Ok(()), "after `{}`", pass.name);
    }
}
