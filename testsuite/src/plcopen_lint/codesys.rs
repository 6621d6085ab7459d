//! The form that all sequential function charts in exports of CODESYS and TwinCAT have.

use super::document::Id;
use super::graph::objects;
use super::{Lint, Rule};

const QUALIFIERS: &str = "N R S L D P SD DS SL";
const DATA: &str = "http://www.3s-software.com/plcopenxml/sfc/element";

pub(super) fn check(lint: &mut Lint) {
    for body in lint.document.all("SFC") {
        numbering(lint, body);
        flow(lint, body);
        nesting(lint, body);
        for object in lint.document.get(body).children.clone() {
            places(lint, object);
            pins(lint, body, object);
            condition(lint, body, object);
            actions(lint, object);
            data(lint, object);
        }
    }
}

fn numbering(lint: &mut Lint, body: Id) {
    let document = lint.document;
    let mut ids: Vec<usize> = Vec::new();
    for object in document.within(body).filter(|id| document.attribute(*id, "localId").is_some()) {
        let id = lint.value(object, "localId").parse();
        // An action counts before its block, in which it stands.
        match document.name(document.get(object).parent) {
            "actionBlock" => {
                let at = ids.len().saturating_sub(1);
                ids.insert(at, id.unwrap_or(usize::MAX));
            }
            _ => ids.push(id.unwrap_or(usize::MAX)),
        }
    }
    lint.demand(ids.iter().copied().eq(0..ids.len()), Rule::CodesysNumbering, body, "local ids do not count from 0");
    for object in &document.get(body).children {
        let own = lint.value(*object, "localId").parse::<usize>().unwrap_or_default();
        for connection in document.within(*object).filter(|id| document.name(*id) == "connection") {
            let from = lint.value(connection, "refLocalId").parse::<usize>().unwrap_or(usize::MAX);
            lint.demand(from < own, Rule::CodesysNumbering, *object, "a connection leads forward");
        }
    }
}

fn places(lint: &mut Lint, object: Id) {
    let document = lint.document;
    for id in document.within(object) {
        let right = match document.name(id) {
            "position" => lint.value(id, "x") == "0" && lint.value(id, "y") == "0",
            "relPosition" => document.name(document.get(id).parent) == "action",
            _ => document.attribute(id, "width").is_none() && document.attribute(id, "height").is_none(),
        };
        lint.demand(right, Rule::CodesysPlaces, object, "a place or a size");
    }
}

fn pins(lint: &mut Lint, body: Id, object: Id) {
    let document = lint.document;
    let name = document.name(object);
    for pin in document.children(object, "connectionPointOut") {
        let wanted = matches!(name, "step" | "selectionDivergence" | "simultaneousDivergence").then_some("sfc");
        let right = document.attribute(pin, "formalParameter") == wanted && name != "transition";
        lint.demand(right, Rule::CodesysPins, object, "the name of its output");
    }
    for connection in
        document.children(object, "connectionPointIn").flat_map(|pin| document.children(pin, "connection"))
    {
        let wanted = matches!(name, "transition" | "selectionConvergence" | "simultaneousConvergence").then_some("sfc");
        let right = document.attribute(connection, "formalParameter") == wanted || name == "actionBlock";
        lint.demand(right, Rule::CodesysPins, object, "the name at its connection");
    }
    if name == "step" {
        let local = lint.value(object, "localId");
        let acts = document.children(body, "actionBlock").any(|block| {
            document.within(block).any(|id| document.name(id) == "connection" && lint.value(id, "refLocalId") == local)
        });
        let pin = document.child(object, "connectionPointOutAction");
        let right = pin.map(|pin| lint.value(pin, "formalParameter")) == acts.then_some("x");
        lint.demand(right, Rule::CodesysPins, object, "the output for its actions");
        lint.demand(document.child(object, "connectionPointIn").is_some(), Rule::CodesysPins, object, "its input");
    }
}

fn condition(lint: &mut Lint, body: Id, object: Id) {
    let document = lint.document;
    if document.name(object) != "transition" {
        return;
    }
    let siblings = &document.get(body).children;
    let before = siblings.iter().take_while(|id| **id != object).last();
    let wired = document.within(object).filter(|id| document.name(*id) == "condition").any(|condition| {
        document.within(condition).any(|id| {
            document.name(id) == "connection"
                && before.is_some_and(|before| {
                    document.name(*before) == "inVariable"
                        && lint.value(*before, "localId") == lint.value(id, "refLocalId")
                })
        })
    });
    lint.demand(wired, Rule::CodesysCondition, object, "the condition does not come from right before it");
}

/// The objects that feed another.
fn feeders<'d>(lint: &Lint<'d>, body: Id, object: Id) -> Vec<&'d str> {
    let document = lint.document;
    let objects = objects(lint, body);
    let pins = document.children(object, "connectionPointIn");
    let connections = pins.flat_map(|pin| document.children(pin, "connection"));
    connections.filter_map(|id| objects.get(lint.value(id, "refLocalId"))).map(|id| document.name(*id)).collect()
}

fn flow(lint: &mut Lint, body: Id) {
    let document = lint.document;
    let children = document.get(body).children.clone();
    let first = children.first().is_some_and(|id| lint.value(*id, "initialStep") == "true");
    let last = children.last().is_some_and(|id| document.name(*id) == "jumpStep");
    lint.demand(first && last, Rule::CodesysFlow, body, "does not go from an initial step to a jump");
    let initial = document.children(body, "step").filter(|id| lint.value(*id, "initialStep") == "true").count();
    lint.demand(initial == 1, Rule::CodesysFlow, body, "not one initial step");
    for object in children {
        let name = document.name(object);
        let fed = feeders(lint, body, object);
        let allowed: &[&str] = match name {
            "step" => &["transition", "selectionConvergence", "simultaneousDivergence"],
            "transition" => &["step", "selectionDivergence", "simultaneousConvergence", "selectionConvergence"],
            "selectionConvergence" => &["transition", "jumpStep", "selectionConvergence", "step"],
            "simultaneousConvergence" => &["step", "jumpStep"],
            "selectionDivergence" => &["step", "selectionDivergence"],
            "simultaneousDivergence" => &["transition"],
            "jumpStep" => &["transition", "selectionConvergence"],
            _ => continue,
        };
        let right = fed.iter().all(|feeder| allowed.contains(feeder));
        lint.demand(right, Rule::CodesysFlow, object, "follows what it must not follow");
        let without_input = fed.is_empty();
        lint.demand(
            without_input == (lint.value(object, "initialStep") == "true"),
            Rule::CodesysFlow,
            object,
            "only the initial step has no input",
        );
    }
}

fn nesting(lint: &mut Lint, body: Id) {
    let document = lint.document;
    let mut open: Vec<(&str, usize)> = Vec::new();
    for object in &document.get(body).children {
        let name = document.name(*object);
        if let Some(kind) = name.strip_suffix("Divergence") {
            let local = lint.value(*object, "localId");
            let leaves = |id: &Id| document.name(*id) == "connection" && lint.value(*id, "refLocalId") == local;
            open.push((kind, document.within(body).filter(leaves).count()));
        } else if let Some(kind) = name.strip_suffix("Convergence") {
            let width = document.children(*object, "connectionPointIn").count();
            lint.demand(open.pop() == Some((kind, width)), Rule::CodesysNesting, *object, "closes nothing of its kind");
        }
    }
    lint.demand(open.is_empty(), Rule::CodesysNesting, body, "a divergence is not closed");
}

fn actions(lint: &mut Lint, object: Id) {
    let document = lint.document;
    for action in document.children(object, "action") {
        let attributes = ["duration", "indicator"].iter().all(|key| document.attribute(action, key).is_some());
        let qualifier = QUALIFIERS.split(' ').any(|known| known == lint.value(action, "qualifier"));
        let named = document.child(action, "reference").is_some();
        lint.demand(attributes && qualifier && named, Rule::CodesysAction, action, "not in the form of the tool");
    }
}

fn data(lint: &mut Lint, object: Id) {
    let document = lint.document;
    let bearers = document.within(object).filter(|id| {
        matches!(
            document.name(*id),
            "step" | "transition" | "selectionDivergence" | "simultaneousDivergence" | "jumpStep" | "action"
        )
    });
    for bearer in bearers {
        let data = document.child(bearer, "addData").and_then(|add| document.child(add, "data"));
        let right = data.is_some_and(|data| {
            lint.value(data, "name") == DATA
                && lint.value(data, "handleUnknown") == "implementation"
                && document.child(data, "attributes").is_some_and(|list| document.child(list, "attribute").is_some())
        });
        lint.demand(right, Rule::CodesysData, bearer, "without its data");
    }
}
