//! Vertices and arcs for Graphviz.

use super::diagram::Diagram;
use crate::commands::graphviz::quoted;
use std::fmt::Write as _;

/// Initial vertices are doubled.
pub(super) fn dot(diagram: &Diagram) -> String {
    let mut out = format!("digraph {} {{\n  node [shape=box, fontname=\"sans-serif\"];\n", quoted(&diagram.title));
    for (id, vertex) in diagram.vertices.iter().enumerate() {
        let doubled = if vertex.initial { ", peripheries=2" } else { "" };
        // Writing to memory does not fail.
        let _ = writeln!(out, "  {id} [label={}{doubled}];", quoted(&vertex.lines.join("\n")));
    }
    for arc in &diagram.arcs {
        let _ = writeln!(out, "  {} -> {} [label={}];", arc.from, arc.to, quoted(&arc.label));
    }
    out.push_str("}\n");
    out
}
