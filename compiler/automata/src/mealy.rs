//! A Mealy automaton: outputs stand at arcs, so an arc of the machine is taken apart by what is published on it.

use crate::automaton::{Arc, Automaton};
use crate::machine::{Machine, Set, State, apart};
use crate::words::condition;

/// A row of the table of a machine: from a state with some inputs to another, and what is published.
pub(crate) struct Row {
    pub(crate) when: Set,
    pub(crate) to: usize,
    pub(crate) outputs: Vec<bool>,
}

/// The rows of a state.
pub(crate) fn rows(state: &State) -> impl Iterator<Item = Row> + '_ {
    state.arcs.iter().flat_map(|(when, to)| {
        apart(when, &state.outputs).into_iter().map(|(when, outputs)| Row { when, to: *to, outputs })
    })
}

/// The names of those outputs that are true.
pub(crate) fn named(machine: &Machine, outputs: &[bool]) -> Vec<String> {
    machine.outputs.iter().zip(outputs).filter(|(_, value)| **value).map(|(name, _)| name.clone()).collect()
}

pub(crate) fn mealy(machine: Machine) -> Automaton {
    let mut arcs = Vec::new();
    for (from, state) in machine.states.iter().enumerate() {
        for Row { when, to, outputs } in rows(state) {
            let outputs = named(&machine, &outputs);
            arcs.push(Arc { from, to, when: condition(&when, &machine.inputs), outputs });
        }
    }
    Automaton { arcs, ..Automaton::plain(machine) }
}
