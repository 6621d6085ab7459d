//! Vertices and arcs as a drawing, with the layout of charts.

use super::diagram::Diagram;
use grafc::drawing::{Arc, State, states};

/// A box a vertex, a bar an arc.
pub(super) fn svg(diagram: &Diagram) -> String {
    let vertices = diagram.vertices.iter();
    let boxes: Vec<State> =
        vertices.map(|vertex| State { lines: vertex.lines.clone(), initial: vertex.initial, mark: None }).collect();
    let mut arcs: Vec<Arc> =
        diagram.arcs.iter().map(|arc| Arc { from: arc.from, to: arc.to, when: arc.label.clone() }).collect();
    arcs.sort_by_key(|arc| arc.from);
    let description = format!("{} vertices, {} arcs", boxes.len(), arcs.len());
    grafc::drawing::svg(&states(&format!("{}: automata", diagram.title), &description, &boxes, &arcs), None)
}
