//! Machines: what a chart is from outside, call by call.
//!
//! Invariants: the arcs of a state are disjoint and together take all inputs, none is empty and no target comes twice; a
//! state has a set for each output.

use biodivine_lib_bdd::{Bdd, BddVariable, BddVariableSet};

/// A set of inputs: those with which something happens.
pub type Set = Bdd;

/// A deterministic machine with Boolean inputs and outputs, which does something with every input.
#[derive(Clone, Debug)]
pub struct Machine {
    /// The name of its chart.
    pub name: String,
    /// Names of the inputs.
    pub inputs: Vec<String>,
    /// Names of the outputs.
    pub outputs: Vec<String>,
    /// Where the first call begins.
    pub initial: usize,
    /// The states.
    pub states: Vec<State>,
}

/// What a call does that begins in a state.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct State {
    /// The active steps, and a number where several states have the same.
    pub name: String,
    /// With which inputs it leads to which state.
    pub arcs: Vec<(Set, usize)>,
    /// With which inputs each output is published.
    pub outputs: Vec<Set>,
}

impl Machine {
    /// Where a call leads, and what it publishes.
    pub fn call(&self, state: usize, inputs: &[bool]) -> (usize, Vec<bool>) {
        let valuation = biodivine_lib_bdd::BddValuation::new(inputs.to_vec());
        let state = &self.states[state];
        // Some arc takes the inputs.
        let to = state.arcs.iter().find(|(when, _)| when.eval_in(&valuation)).map_or(0, |(_, to)| *to);
        (to, state.outputs.iter().map(|when| when.eval_in(&valuation)).collect())
    }

    /// So many arcs lead from a state to itself, and so many to another one.
    pub fn count(&self) -> (usize, usize) {
        let ends =
            self.states.iter().enumerate().flat_map(|(from, state)| state.arcs.iter().map(move |arc| (from, arc.1)));
        let (loops, others): (Vec<_>, Vec<_>) = ends.partition(|(from, to)| from == to);
        (loops.len(), others.len())
    }
}

/// The inputs as variables of diagrams.
pub(crate) struct Alphabet {
    pub(crate) none: Set,
    pub(crate) all: Set,
    pub(crate) variables: Vec<Set>,
}

impl Alphabet {
    /// So many of them, at most 65,535.
    pub(crate) fn new(inputs: usize) -> Alphabet {
        let names = BddVariableSet::new_anonymous(u16::try_from(inputs).unwrap_or(u16::MAX));
        let variable = |input: usize| names.mk_var(BddVariable::from_index(input));
        let variables = (0..inputs.min(usize::from(u16::MAX))).map(variable).collect();
        Alphabet { none: names.mk_false(), all: names.mk_true(), variables }
    }
}

/// Takes parts of an input space apart by further sets: which of these each part lies in. Empty parts are left out.
pub(crate) fn apart<'s>(all: &Set, sets: impl IntoIterator<Item = &'s Set>) -> Vec<(Set, Vec<bool>)> {
    let mut parts = vec![(all.clone(), Vec::new())];
    for set in sets {
        let mut next = Vec::with_capacity(parts.len());
        for (part, holds) in parts {
            let (within, without) = (part.and(set), part.and_not(set));
            for (part, is_within) in [(within, true), (without, false)] {
                if !part.is_false() {
                    let mut holds = holds.clone();
                    holds.push(is_within);
                    next.push((part, holds));
                }
            }
        }
        parts = next;
    }
    parts
}
