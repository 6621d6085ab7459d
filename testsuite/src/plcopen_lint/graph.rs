//! What is drawn: ids, connections, steps, transitions, actions, in any dialect.

use super::document::Id;
use super::{Lint, Rule};
use std::collections::{BTreeMap, BTreeSet};

/// Qualifiers that need to know how long.
const TIMED: &str = "L D SD DS SL";

pub(super) fn check(lint: &mut Lint) {
    for body in lint.graphs() {
        connections(lint, body);
        if lint.document.name(body) == "SFC" {
            chart(lint, body);
        }
    }
    for unit in lint.document.all("pou") {
        actions(lint, unit);
    }
}

/// The objects of a body by their local ids; connections come from them.
pub(super) fn objects<'d>(lint: &Lint<'d>, body: Id) -> BTreeMap<&'d str, Id> {
    let document = lint.document;
    document.within(body).filter_map(|id| Some((document.attribute(id, "localId")?, id))).collect()
}

fn connections(lint: &mut Lint, body: Id) {
    let document = lint.document;
    let mut given = BTreeSet::new();
    for id in document.within(body) {
        if let Some(local) = document.attribute(id, "localId") {
            let right = !local.is_empty() && local.bytes().all(|b| b.is_ascii_digit()) && given.insert(local);
            lint.demand(right, Rule::LocalId, id, "no number of its own");
        }
    }
    let objects = objects(lint, body);
    for id in document.within(body).filter(|id| document.name(*id) == "connection") {
        match objects.get(lint.value(id, "refLocalId")) {
            None => lint.find(Rule::Reference, id, "from nothing"),
            Some(from) => {
                let named = document.name(*from) != "block" || !lint.value(id, "formalParameter").is_empty();
                lint.demand(named, Rule::BlockPin, id, "from no pin of its block");
            }
        }
    }
}

fn chart(lint: &mut Lint, body: Id) {
    let document = lint.document;
    let steps: Vec<Id> = document.children(body, "step").collect();
    let initial = steps.iter().any(|step| lint.value(*step, "initialStep") == "true");
    lint.demand(initial, Rule::InitialStep, body, "no initial step");
    for jump in document.children(body, "jumpStep") {
        let target = lint.value(jump, "targetName");
        let there = steps.iter().any(|step| lint.value(*step, "name").eq_ignore_ascii_case(target));
        lint.demand(there, Rule::JumpTarget, jump, "to no step");
    }
    for transition in document.children(body, "transition") {
        let condition = document.child(transition, "condition");
        let said = condition.is_some_and(|condition| document.get(condition).children.len() == 1);
        lint.demand(said, Rule::Condition, transition, "without a condition");
    }
}

fn actions(lint: &mut Lint, unit: Id) {
    let document = lint.document;
    for action in document.within(unit).filter(|id| document.name(document.get(*id).parent) == "actionBlock") {
        if document.name(action) != "action" {
            continue;
        }
        let qualifier = document.attribute(action, "qualifier").unwrap_or("N");
        let timed = TIMED.split(' ').any(|timed| timed == qualifier);
        let lasts = !lint.value(action, "duration").is_empty();
        lint.demand(timed == lasts, Rule::Duration, action, qualifier);
        let Some(reference) = document.child(action, "reference") else { continue };
        let name = lint.value(reference, "name");
        let there = document.within(unit).any(|id| {
            let is_named = document.attribute(id, "name").is_some_and(|known| known.eq_ignore_ascii_case(name));
            let is_boolean = || {
                let ty = document.child(id, "type");
                ty.is_some_and(|ty| document.child(ty, "BOOL").is_some())
            };
            is_named
                && match document.name(id) {
                    "variable" => is_boolean(),
                    "action" => document.name(document.get(id).parent) == "actions",
                    _ => false,
                }
        });
        lint.demand(there, Rule::ActionReference, action, "names nothing of the unit");
    }
}
