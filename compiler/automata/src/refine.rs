//! Classes of equivalent states, after Hopcroft: a class is taken apart by how its states lead into another class, and of what
//! it comes to, all but the largest part may take others apart.
//!
//! Letters are not looked at one by one: of each state it is the set of inputs that counts with which it leads into the
//! class. Arcs are deterministic and take all inputs, so what leads into a class leads into one of its parts, and the sets
//! of all parts but one say that of the last.

use crate::machine::{Machine, Set, State};
use indexmap::IndexMap;
use rustc_hash::FxBuildHasher;
use std::collections::BTreeMap;

/// The class of each state: states of one class are of one class in `at_first`, publish the same with each input, and lead to
/// the same classes. Classes are numbered by their first states.
pub(crate) fn classes(machine: &Machine, at_first: &[usize]) -> Vec<usize> {
    let mut blocks = Blocks::new(machine, at_first);
    let mut leading: Vec<Vec<(usize, &Set)>> = vec![Vec::new(); machine.states.len()];
    for (from, state) in machine.states.iter().enumerate() {
        state.arcs.iter().for_each(|(when, to)| leading[*to].push((from, when)));
    }
    while let Some(splitter) = blocks.waiting.pop() {
        blocks.waits[splitter] = false;
        let mut into: BTreeMap<usize, Set> = BTreeMap::new();
        for state in &blocks.states[splitter] {
            for (from, when) in &leading[*state] {
                into.entry(*from).and_modify(|set| *set = set.or(when)).or_insert_with(|| (*when).clone());
            }
        }
        let mut touched: BTreeMap<usize, IndexMap<Set, Vec<usize>, FxBuildHasher>> = BTreeMap::new();
        for (from, set) in into {
            touched.entry(blocks.of[from]).or_default().entry(set).or_default().push(from);
        }
        for (block, parts) in touched {
            blocks.split(block, parts.into_values().collect());
        }
    }
    let mut numbers: IndexMap<usize, (), FxBuildHasher> = IndexMap::default();
    blocks.of.iter().map(|block| numbers.insert_full(*block, ()).0).collect()
}

/// A partition, and which of its blocks may still take others apart.
struct Blocks {
    of: Vec<usize>,
    states: Vec<Vec<usize>>,
    waiting: Vec<usize>,
    waits: Vec<bool>,
}

impl Blocks {
    fn new(machine: &Machine, at_first: &[usize]) -> Blocks {
        let mut found: IndexMap<(usize, &[Set]), Vec<usize>, FxBuildHasher> = IndexMap::default();
        for (state, class) in at_first.iter().enumerate() {
            found.entry((*class, &machine.states[state].outputs)).or_default().push(state);
        }
        let states: Vec<Vec<usize>> = found.into_values().collect();
        let mut of = vec![0; machine.states.len()];
        states.iter().enumerate().for_each(|(block, states)| states.iter().for_each(|state| of[*state] = block));
        let count = states.len();
        Blocks { of, states, waiting: (0..count).collect(), waits: vec![true; count] }
    }

    /// Takes a block apart: these parts, and the rest.
    fn split(&mut self, block: usize, mut parts: Vec<Vec<usize>>) {
        let touched: usize = parts.iter().map(Vec::len).sum();
        if touched < self.states[block].len() {
            let mut is_touched = parts.iter().flatten().copied().collect::<Vec<_>>();
            is_touched.sort_unstable();
            let rest = self.states[block].iter().filter(|state| is_touched.binary_search(state).is_err());
            parts.push(rest.copied().collect());
        }
        if parts.len() == 1 {
            return;
        }
        // The largest keeps the place.
        let largest = (0..parts.len()).max_by_key(|part| parts[*part].len()).unwrap_or_default();
        self.states[block] = parts.swap_remove(largest);
        for part in parts {
            let new = self.states.len();
            part.iter().for_each(|state| self.of[*state] = new);
            self.states.push(part);
            self.waiting.push(new);
            self.waits.push(true);
        }
    }
}

/// A machine with a state for each class, named after its first one.
pub(crate) fn quotient(machine: &Machine, classes: &[usize]) -> Machine {
    let count = classes.iter().max().map_or(0, |most| most + 1);
    let mut states: Vec<Option<State>> = vec![None; count];
    for (state, class) in machine.states.iter().zip(classes) {
        if states[*class].is_some() {
            continue;
        }
        let mut arcs: BTreeMap<usize, Set> = BTreeMap::new();
        for (when, to) in &state.arcs {
            arcs.entry(classes[*to]).and_modify(|set| *set = set.or(when)).or_insert_with(|| when.clone());
        }
        let arcs = arcs.into_iter().map(|(to, when)| (when, to)).collect();
        states[*class] = Some(State { arcs, ..state.clone() });
    }
    let states = states.into_iter().flatten().collect();
    Machine { initial: classes[machine.initial], states, ..machine.clone() }
}
