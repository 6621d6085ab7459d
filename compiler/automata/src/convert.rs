//! The classical conversions: from the machine of a chart to an automaton of some kind, proved to do the same.

use crate::automaton::{Automaton, Kind};
use crate::machine::Machine;
use crate::product::product;
use crate::{extended, mealy, minimal, moore};

/// Converts the machine of a chart.
///
/// # Panics
/// The conversion is wrong: what it came to is not what the chart does.
pub fn convert(machine: &Machine, kind: Kind) -> Automaton {
    let mut made = match kind {
        Kind::Moore => moore::moore(machine),
        Kind::Mealy => mealy::mealy(machine.clone()),
        Kind::Extended => extended::extended(machine),
        Kind::Minimal => minimal::minimal(machine),
    };
    (made.kind, made.before) = (kind, machine.states.len());
    made.pairs = product(machine, &made.machine).unwrap_or_else(|difference| {
        unreachable!("the automaton does something else than the chart: {difference:?}");
    });
    made
}
