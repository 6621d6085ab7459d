//! What a conversion comes to: vertices and arcs with the outputs where the kind of automaton has them, and the machine that
//! it is, by which it is compared with the chart's.

use crate::machine::Machine;
use crate::words::condition;

/// Kinds of automata.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Kind {
    /// Outputs at vertices.
    Moore,
    /// Outputs at arcs.
    Mealy,
    /// Expressions at vertices, of which there are as few as there can be.
    Extended,
    /// A Mealy automaton of as few vertices as there can be.
    Minimal,
}

/// An automaton.
#[derive(Clone, Debug)]
pub struct Automaton {
    /// Its kind.
    pub kind: Kind,
    /// Its vertices.
    pub vertices: Vec<Vertex>,
    /// Its arcs, by the vertices that they leave.
    pub arcs: Vec<Arc>,
    /// What it does.
    pub machine: Machine,
    /// So many states the chart has.
    pub before: usize,
    /// So many pairs chart and automaton come to: in each of them they publish the same.
    pub pairs: usize,
}

/// A vertex.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Vertex {
    /// Its name.
    pub name: String,
    /// The outputs that stand there, each with the condition under which it is published.
    pub outputs: Vec<(String, String)>,
}

/// An arc.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Arc {
    /// From this vertex.
    pub from: usize,
    /// To this one.
    pub to: usize,
    /// With these inputs.
    pub when: String,
    /// The outputs that stand there.
    pub outputs: Vec<String>,
}

impl Automaton {
    /// Of a machine, with what stands at vertices and arcs left out.
    pub(crate) fn plain(machine: Machine) -> Automaton {
        let vertices = machine.states.iter().map(|state| Vertex { name: state.name.clone(), outputs: Vec::new() });
        let vertices = vertices.collect();
        Automaton { kind: Kind::Mealy, vertices, arcs: Vec::new(), machine, before: 0, pairs: 0 }
    }

    /// With an arc for each of the machine's.
    pub(crate) fn with_arcs(mut self) -> Automaton {
        let inputs = &self.machine.inputs;
        let arcs = self.machine.states.iter().enumerate().flat_map(|(from, state)| {
            state.arcs.iter().map(move |(when, to)| Arc {
                from,
                to: *to,
                when: condition(when, inputs),
                outputs: Vec::new(),
            })
        });
        self.arcs = arcs.collect();
        self
    }
}
