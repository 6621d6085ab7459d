//! An extended automaton: each vertex bears an expression for each output, which a call computes in the vertex in which it
//! begins. So it needs no more vertices than the smallest Mealy automaton, and no output at an arc.

use crate::automaton::Automaton;
use crate::machine::Machine;
use crate::refine::{classes, quotient};
use crate::words::condition;

pub(crate) fn extended(machine: &Machine) -> Automaton {
    let machine = quotient(machine, &classes(machine, &vec![0; machine.states.len()]));
    let mut made = Automaton::plain(machine).with_arcs();
    let machine = &made.machine;
    for (vertex, state) in made.vertices.iter_mut().zip(&machine.states) {
        let outputs = machine.outputs.iter().zip(&state.outputs);
        vertex.outputs = outputs.map(|(name, when)| (name.clone(), condition(when, &machine.inputs))).collect();
    }
    made
}
