//! As few vertices as there can be: one for each class of equivalent states.

use crate::automaton::Automaton;
use crate::machine::Machine;
use crate::mealy::mealy;
use crate::refine::{classes, quotient};

pub(crate) fn minimal(machine: &Machine) -> Automaton {
    let classes = classes(machine, &vec![0; machine.states.len()]);
    mealy(quotient(machine, &classes))
}
