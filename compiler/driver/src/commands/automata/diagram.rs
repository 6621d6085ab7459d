//! Vertices and arcs as they are drawn, whatever they are of.

use grafc_automata::{Automaton, System};

/// What is drawn.
pub(super) struct Diagram {
    pub(super) title: String,
    pub(super) vertices: Vec<Vertex>,
    pub(super) arcs: Vec<Arc>,
}

/// A vertex: lines of text.
pub(super) struct Vertex {
    pub(super) lines: Vec<String>,
    pub(super) initial: bool,
}

/// An arc, with what stands at it.
pub(super) struct Arc {
    pub(super) from: usize,
    pub(super) to: usize,
    pub(super) label: String,
}

/// All graphs of a chart beside each other.
pub(super) fn of_system(system: &System) -> Diagram {
    let (mut vertices, mut arcs) = (Vec::new(), Vec::new());
    for graph in &system.graphs {
        let first = vertices.len();
        for vertex in &graph.vertices {
            let mut lines = vec![format!("{} = {}", graph.name, vertex.label)];
            lines.extend(vertex.actions.iter().cloned());
            if first == vertices.len() {
                lines.extend(graph.notes.iter().cloned());
            }
            vertices.push(Vertex { lines, initial: vertex.initial });
        }
        for arc in &graph.arcs {
            let label = with_outputs(system.label(arc), &arc.actions);
            arcs.push(Arc { from: first + arc.from, to: first + arc.to, label });
        }
    }
    Diagram { title: system.name.clone(), vertices, arcs }
}

/// An automaton.
pub(super) fn of_automaton(automaton: &Automaton) -> Diagram {
    let vertices = automaton.vertices.iter().enumerate().map(|(place, vertex)| {
        let outputs = vertex.outputs.iter().map(stands);
        let lines = std::iter::once(vertex.name.clone()).chain(outputs).collect();
        Vertex { lines, initial: place == automaton.machine.initial }
    });
    let arcs = automaton.arcs.iter().map(|arc| Arc {
        from: arc.from,
        to: arc.to,
        label: with_outputs(arc.when.clone(), &arc.outputs),
    });
    Diagram { title: automaton.machine.name.clone(), vertices: vertices.collect(), arcs: arcs.collect() }
}

/// An output at a vertex.
pub(super) fn stands((name, when): &(String, String)) -> String {
    if when == "1" { name.clone() } else { format!("{name} = {when}") }
}

/// A condition, and what stands behind it.
pub(super) fn with_outputs(when: String, outputs: &[String]) -> String {
    if outputs.is_empty() { when } else { format!("{when} / {}", outputs.join(", ")) }
}
