//! The graph for people.

use super::lines;
use grafc_verify::{Graph, Node};
use std::fmt::Write as _;

/// Node by node, each with what leads on.
pub fn text(graph: &Graph) -> String {
    let mut out = String::new();
    let situations = graph.nodes.iter().all(|node| node.values.is_empty());
    let _ = write!(out, "{}: ", graph.chart);
    if situations {
        let _ = write!(out, "{}, ", counted(graph.nodes.len(), "situation"));
    }
    let _ = write!(out, "{}, {}", counted(graph.states, "state"), counted(graph.edges.len(), "edge"));
    let _ = writeln!(out, "{}", if graph.complete { "" } else { "; there are more: raise `--max`" });
    if graph.free_delays {
        out.push_str("Delays may end at any later reaction; real times may allow less.\n");
    }
    if !graph.livelocks.is_empty() {
        out.push_str("What comes after a LIVELOCK is left out.\n");
    }
    for livelock in graph.livelocks_from(None) {
        let _ = writeln!(out, "At the start, LIVELOCK {}by {}", when(&livelock.when), livelock.ring.join(" "));
    }
    for (id, node) in graph.nodes.iter().enumerate() {
        let initial = if graph.is_initial(id) { "  initial" } else { "" };
        let dead = if graph.is_deadlock(id) { "  deadlock" } else { "" };
        let _ = writeln!(out, "\n{id}  {}{initial}{dead}", told(node));
        for edge in graph.edges_from(id) {
            let _ = writeln!(out, "   {}-> {}  {}", when(&edge.when), edge.to, told(&graph.nodes[edge.to]));
        }
        for livelock in graph.livelocks_from(Some(id)) {
            let _ = writeln!(out, "   {}LIVELOCK by {}", when(&livelock.when), livelock.ring.join(" "));
        }
    }
    out
}

fn told(node: &Node) -> String {
    lines(node).join("  ")
}

fn when(condition: &str) -> String {
    if condition == "true" { String::new() } else { format!("{condition} ") }
}

fn counted(count: usize, what: &str) -> String {
    if count == 1 { format!("1 {what}") } else { format!("{count} {what}s") }
}
