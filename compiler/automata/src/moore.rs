//! A Moore automaton: outputs stand at vertices, and a call publishes those of the vertex that it leads to. A state that is
//! come to with different outputs is a vertex for each.

use crate::automaton::Automaton;
use crate::machine::{Alphabet, Machine, Set, State};
use crate::mealy::{named, rows};
use indexmap::IndexSet;
use rustc_hash::FxBuildHasher;
use std::collections::BTreeMap;

pub(crate) fn moore(machine: &Machine) -> Automaton {
    let none = Alphabet::new(machine.inputs.len()).none;
    // A state, and what stands there. What stands where the first call begins is published only if a call leads there.
    let mut found: IndexSet<(usize, Option<Vec<bool>>), FxBuildHasher> = IndexSet::default();
    found.insert((machine.initial, None));
    let (mut states, mut at): (Vec<State>, usize) = (Vec::new(), 0);
    while let Some((state, _)) = found.get_index(at) {
        let state = &machine.states[*state];
        let mut arcs: BTreeMap<usize, Set> = BTreeMap::new();
        for row in rows(state) {
            let to = found.insert_full((row.to, Some(row.outputs))).0;
            let so_far = arcs.entry(to).or_insert_with(|| none.clone());
            *so_far = so_far.or(&row.when);
        }
        let arcs = arcs.into_iter().map(|(to, when)| (when, to)).collect();
        states.push(State { arcs, ..state.clone() });
        at += 1;
    }
    // The first call may as well begin in a vertex of the same state; then nothing leads to the one that it began in.
    let twin = (1..found.len()).find(|vertex| found[*vertex].0 == machine.initial);
    let first = usize::from(twin.is_some());
    let kept = first..found.len();
    let states: Vec<State> = states.drain(kept.clone()).collect();
    let place = |vertex: usize| vertex - first;
    let moved =
        |state: State| State { arcs: state.arcs.into_iter().map(|(when, to)| (when, place(to))).collect(), ..state };
    let mut states: Vec<State> = states.into_iter().map(moved).collect();
    number(&mut states, &kept.clone().map(|vertex| found[vertex].0).collect::<Vec<_>>());
    let machine = Machine { initial: place(twin.unwrap_or(0)), states, ..machine.clone() };
    let mut made = Automaton::plain(machine).with_arcs();
    for (vertex, found) in made.vertices.iter_mut().zip(kept.map(|vertex| &found[vertex].1)) {
        let outputs = found.iter().flat_map(|outputs| named(&made.machine, outputs));
        vertex.outputs = outputs.map(|name| (name, "1".to_owned())).collect();
    }
    made
}

/// Gives the vertices of a state that is several of them letters.
fn number(vertices: &mut [State], of: &[usize]) {
    let mut count: BTreeMap<usize, usize> = BTreeMap::new();
    of.iter().for_each(|state| *count.entry(*state).or_default() += 1);
    let mut seen: BTreeMap<usize, usize> = BTreeMap::new();
    for (vertex, state) in vertices.iter_mut().zip(of) {
        let number = seen.entry(*state).or_default();
        *number += 1;
        if count[state] > 1 {
            vertex.name = format!("{}/{number}", vertex.name);
        }
    }
}
