//! The graph for programs; its form is described in docs/graph.md.

use grafc_verify::Graph;
use serde_json::{Map, Value, json};

/// One object in one line.
pub fn json(graph: &Graph) -> String {
    let nodes = graph.nodes.iter().enumerate().map(|(id, node)| {
        let mut object = Map::new();
        object.insert("id".into(), id.into());
        object.insert("steps".into(), json!(node.steps));
        if !node.values.is_empty() {
            let values: Map<String, Value> =
                node.values.iter().map(|(name, value)| (name.clone(), value.as_str().into())).collect();
            object.insert("values".into(), values.into());
        }
        Value::Object(object)
    });
    let edges = graph.edges.iter().map(|edge| json!({ "from": edge.from, "to": edge.to, "when": edge.when }));
    let livelocks = graph
        .livelocks
        .iter()
        .map(|livelock| json!({ "from": livelock.from, "when": livelock.when, "ring": livelock.ring }));
    let object = json!({
        "version": 1,
        "chart": graph.chart,
        "initial": graph.initial,
        "situations": nodes.collect::<Vec<_>>(),
        "edges": edges.collect::<Vec<_>>(),
        "deadlocks": graph.deadlocks,
        "livelock": livelocks.collect::<Vec<_>>(),
        "complete": graph.complete,
    });
    format!("{object}\n")
}
