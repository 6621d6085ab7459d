//! What is drawn as a ladder.

use super::document::Id;
use super::graph::objects;
use super::{Lint, Rule};
use std::collections::BTreeMap;

pub(super) fn check(lint: &mut Lint) {
    let document = lint.document;
    for unit in document.all("pou") {
        let bodies: Vec<Id> = document.within(unit).filter(|id| document.name(*id) == "LD").collect();
        if bodies.is_empty() {
            continue;
        }
        let types = types(lint, unit);
        for body in bodies {
            variables(lint, body, &types);
            power(lint, body);
        }
    }
}

/// The types of the variables of a unit.
fn types<'d>(lint: &Lint<'d>, unit: Id) -> BTreeMap<String, &'d str> {
    let document = lint.document;
    let variables = document.within(unit).filter(|id| document.name(document.get(*id).parent).ends_with("Vars"));
    let with_types = variables.filter_map(|id| {
        let ty = *document.get(document.child(id, "type")?).children.first()?;
        let name = document.attribute(ty, "name").unwrap_or(document.name(ty));
        Some((lint.value(id, "name").to_ascii_uppercase(), name))
    });
    with_types.collect()
}

/// What contacts, coils and blocks name is declared.
fn variables(lint: &mut Lint, body: Id, types: &BTreeMap<String, &str>) {
    let document = lint.document;
    for &object in &document.get(body).children {
        let of = |name: &str| types.get(&name.to_ascii_uppercase()).copied();
        match document.name(object) {
            "contact" | "coil" => {
                let named = document.child(object, "variable").map(|id| document.get(id).text.as_str());
                lint.demand(named.and_then(of) == Some("BOOL"), Rule::LadderVariable, object, "of no Boolean variable");
            }
            "block" => {
                if let Some(instance) = document.attribute(object, "instanceName") {
                    let right = of(instance) == Some(lint.value(object, "typeName"));
                    lint.demand(right, Rule::LadderVariable, object, "of no instance of its type");
                }
            }
            "jump" | "label" => lint.find(Rule::NeutralJump, object, "Beremiz passes over it"),
            _ => {}
        }
    }
}

/// Power comes from a left rail and flows to the right.
fn power(lint: &mut Lint, body: Id) {
    let document = lint.document;
    let objects = objects(lint, body);
    // What was found so far of each object: whether power gets there, and whether there is a contact on every way.
    let mut reached: BTreeMap<&str, Way> = BTreeMap::new();
    for &object in &document.get(body).children {
        let local = lint.value(object, "localId");
        let pins: Vec<Id> = document.within(object).filter(|id| document.name(*id) == "connectionPointIn").collect();
        match document.name(object) {
            "leftPowerRail" => {
                reached.insert(local, Way::Rail);
                continue;
            }
            "inVariable" => {
                reached.insert(local, Way::Value);
                continue;
            }
            _ => {}
        }
        let mut way = Way::Value;
        for pin in pins {
            let wires: Vec<Id> = document.children(pin, "connection").collect();
            lint.demand(!wires.is_empty(), Rule::LadderPower, object, "an input that nothing leads to");
            let mut ways = Vec::with_capacity(wires.len());
            for wire in wires {
                let from = lint.value(wire, "refLocalId");
                let Some(before) = reached.get(from) else {
                    let known = objects.contains_key(from);
                    lint.demand(!known, Rule::LadderPower, object, "fed by what stands behind it");
                    continue;
                };
                ways.push(*before);
                let x = |id: Option<Id>| id.and_then(|id| lint.value(id, "x").parse::<f64>().ok());
                let mut points = document.children(wire, "position");
                let (last, first) = (x(points.next()), x(points.last()));
                let to_the_right = matches!((first, last), (Some(first), Some(last)) if first < last);
                lint.demand(to_the_right, Rule::LadderPower, object, "a wire that does not lead to the right");
            }
            // A bare wire or a single contact beside a series: Beremiz cannot sort them.
            let alike = ways.windows(2).all(|pair| pair[0] == pair[1]) && (ways.len() < 2 || ways[0] != Way::Rail);
            lint.demand(alike, Rule::NeutralBranches, object, "branches of one contact and of several meet");
            way = match (document.name(object), &ways[..]) {
                ("contact", [Way::Rail]) => Way::One,
                ("contact", _) => Way::Several,
                _ => Way::Value,
            };
        }
        reached.insert(local, way);
    }
}

/// What is on the way from the left.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Way {
    /// Nothing: it is the rail.
    Rail,
    /// A contact at the rail.
    One,
    /// Contacts in series.
    Several,
    /// A value: of a block, a text, a coil.
    Value,
}
