//! The graph as a drawing, with the layout of charts.

use super::lines;
use grafc::drawing::{Arc, Picture, State, states};
use grafc_verify::Graph;

/// A box a node, a bar an edge; a livelock is a box of its own.
pub fn svg(graph: &Graph) -> String {
    grafc::drawing::svg(&picture(graph), None)
}

fn picture(graph: &Graph) -> Picture {
    let mut boxes: Vec<State> = (0..graph.nodes.len())
        .map(|id| State {
            lines: lines(&graph.nodes[id]),
            initial: graph.is_initial(id),
            mark: graph.is_deadlock(id).then_some("deadlock"),
        })
        .collect();
    let mut arcs: Vec<Arc> =
        graph.edges.iter().map(|edge| Arc { from: edge.from, to: edge.to, when: edge.when.clone() }).collect();
    for livelock in &graph.livelocks {
        let to = boxes.len();
        let lines = vec!["LIVELOCK".to_string(), livelock.ring.join(" ")];
        boxes.push(State { lines, initial: livelock.from.is_none(), mark: None });
        if let Some(from) = livelock.from {
            arcs.push(Arc { from, to, when: livelock.when.clone() });
        }
    }
    // Drawn after what leads from the same place to another.
    arcs.sort_by_key(|arc| arc.from);
    let description = format!("{} nodes, {} edges", graph.nodes.len(), graph.edges.len());
    states(&format!("{}: what it can come to", graph.chart), &description, &boxes, &arcs)
}
