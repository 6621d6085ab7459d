//! Vertices and arcs for Graphviz.

use super::diagram::Diagram;
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

/// A string of Graphviz, in which a line break is `\n`.
fn quoted(text: &str) -> String {
    let mut out = String::from("\"");
    for c in text.chars() {
        match c {
            '"' => out.push_str("\\\""),
            '\\' => out.push_str("\\\\"),
            '\n' => out.push_str("\\n"),
            c => out.push(c),
        }
    }
    out.push('"');
    out
}
