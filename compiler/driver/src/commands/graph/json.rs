//! The graph for programs; its form is described in docs/graph.md.

use grafc_verify::{Graph, Node};
use serde::{Serialize, Serializer};

#[derive(Serialize)]
struct Form<'g> {
    version: u32,
    chart: &'g str,
    initial: &'g [usize],
    situations: Vec<Situation<'g>>,
    edges: Vec<Edge<'g>>,
    deadlocks: &'g [usize],
    livelock: Vec<Livelock<'g>>,
    complete: bool,
}

#[derive(Serialize)]
struct Situation<'g> {
    id: usize,
    steps: &'g [String],
    #[serde(skip_serializing_if = "Option::is_none")]
    values: Option<Values<'g>>,
}

/// An object, in the order of the chart.
struct Values<'g>(&'g [(String, String)]);

#[derive(Serialize)]
struct Edge<'g> {
    from: usize,
    to: usize,
    when: &'g str,
}

#[derive(Serialize)]
struct Livelock<'g> {
    from: Option<usize>,
    when: &'g str,
    ring: &'g [String],
}

impl Serialize for Values<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(name, value)| (name, value)))
    }
}

/// One object in one line.
pub fn json(graph: &Graph) -> String {
    let form = Form {
        version: 1,
        chart: &graph.chart,
        initial: &graph.initial,
        situations: graph.nodes.iter().enumerate().map(|(id, node)| of(id, node)).collect(),
        edges: graph.edges.iter().map(|edge| Edge { from: edge.from, to: edge.to, when: &edge.when }).collect(),
        deadlocks: &graph.deadlocks,
        livelock: graph
            .livelocks
            .iter()
            .map(|livelock| Livelock { from: livelock.from, when: &livelock.when, ring: &livelock.ring })
            .collect(),
        complete: graph.complete,
    };
    // Texts and numbers can all be written.
    serde_json::to_string(&form).map(|text| text + "\n").unwrap_or_default()
}

fn of(id: usize, node: &Node) -> Situation<'_> {
    let values = (!node.values.is_empty()).then_some(Values(&node.values));
    Situation { id, steps: &node.steps, values }
}
