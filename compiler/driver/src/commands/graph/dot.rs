//! The graph for Graphviz.

use super::lines;
use crate::commands::graphviz::quoted;
use grafc_verify::Graph;
use std::fmt::Write as _;

/// Initial ones are doubled, deadlocks are filled; rings without end lead to a point of their own.
pub fn dot(graph: &Graph) -> String {
    let mut out = format!("digraph {} {{\n  node [shape=box, fontname=\"sans-serif\"];\n", quoted(&graph.chart));
    for (id, node) in graph.nodes.iter().enumerate() {
        let doubled = if graph.is_initial(id) { ", peripheries=2" } else { "" };
        let dead = if graph.is_deadlock(id) { ", style=filled, fillcolor=\"#f4c7c3\"" } else { "" };
        let _ = writeln!(out, "  {id} [label={}{doubled}{dead}];", quoted(&lines(node).join("\n")));
    }
    for edge in &graph.edges {
        let _ = writeln!(out, "  {} -> {} [label={}];", edge.from, edge.to, quoted(&edge.when));
    }
    for (number, livelock) in graph.livelocks.iter().enumerate() {
        let ring = format!("LIVELOCK by {}", livelock.ring.join(" "));
        let _ = writeln!(out, "  l{number} [shape=octagon, label={}];", quoted(&ring));
        if let Some(from) = livelock.from {
            let _ = writeln!(out, "  {from} -> l{number} [label={}];", quoted(&livelock.when));
        }
    }
    out.push_str("}\n");
    out
}
