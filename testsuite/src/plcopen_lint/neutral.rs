//! What the generator and the editor of Beremiz need.

use super::document::Id;
use super::graph::objects;
use super::{Lint, Rule};

pub(super) fn check(lint: &mut Lint) {
    let document = lint.document;
    for unit in document.all("pou") {
        let interface = document.child(unit, "interface");
        let has = interface.is_some_and(|interface| !document.get(interface).children.is_empty());
        lint.demand(has, Rule::NeutralVariables, unit, "no variables");
    }
    let runs = document.all("pouInstance").any(|instance| document.name(document.get(instance).parent) == "task");
    lint.demand(runs, Rule::NeutralConfiguration, 0, "no task runs a program");
    for body in lint.graphs() {
        for object in document.get(body).children.clone() {
            geometry(lint, object);
            if document.name(body) == "SFC" {
                feeding(lint, body, object);
            }
        }
    }
}

fn geometry(lint: &mut Lint, object: Id) {
    let document = lint.document;
    let number = |key| lint.value(object, key).parse::<f64>().is_ok();
    let sized = number("width") && number("height");
    lint.demand(sized, Rule::NeutralGeometry, object, "no size");
    for id in document.within(object) {
        match document.name(id) {
            "connectionPointIn" if document.name(document.get(id).parent) == "condition" => {}
            "connectionPointIn" | "connectionPointOut" | "connectionPointOutAction" => {
                let placed = document.child(id, "relPosition").is_some();
                lint.demand(placed, Rule::NeutralGeometry, id, "a pin without a place");
            }
            "action" => {
                let empty = ["duration", "indicator"].iter().any(|key| document.attribute(id, key) == Some(""));
                lint.demand(!empty, Rule::NeutralGeometry, id, "an empty attribute");
            }
            _ => {}
        }
    }
}

fn feeding(lint: &mut Lint, body: Id, object: Id) {
    let document = lint.document;
    let objects = objects(lint, body);
    let mut feeders: Vec<&Id> = Vec::new();
    for pin in document.children(object, "connectionPointIn") {
        let connections: Vec<Id> = document.children(pin, "connection").collect();
        // A step that nothing leads to has a pin without a connection.
        let one = connections.len() == 1 || (connections.is_empty() && document.name(object) == "step");
        lint.demand(one, Rule::NeutralConnection, object, "not one connection at a pin");
        feeders.extend(connections.iter().filter_map(|id| objects.get(lint.value(*id, "refLocalId"))));
    }
    let allowed: &[&str] = match document.name(object) {
        "step" => &["transition", "selectionConvergence", "simultaneousDivergence"],
        "transition" => &["step", "selectionDivergence", "simultaneousConvergence"],
        "selectionDivergence" => &["step", "simultaneousConvergence"],
        "simultaneousDivergence" => &["transition", "selectionConvergence"],
        "selectionConvergence" => &["transition"],
        "simultaneousConvergence" => &["step"],
        "jumpStep" => &["transition", "selectionConvergence", "simultaneousDivergence"],
        "actionBlock" => &["step"],
        _ => return,
    };
    let right = feeders.iter().all(|id| allowed.contains(&document.name(**id)));
    lint.demand(right, Rule::NeutralFeeding, object, "fed by what it must not follow");
}
