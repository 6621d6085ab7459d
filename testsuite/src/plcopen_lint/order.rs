//! The order of children and the attributes that must be there, of all elements that grafc writes.

use super::{Lint, Rule};

const VARIABLES: &str = "localVars tempVars inputVars outputVars inOutVars externalVars globalVars accessVars";

/// Elements, and what may stand in them, in order.
const CHILDREN: &[(&str, &str)] = &[
    ("project", "fileHeader contentHeader types instances addData documentation"),
    ("fileHeader", ""),
    ("contentHeader", "Comment coordinateInfo addDataInfo addData"),
    ("coordinateInfo", "pageSize fbd ld sfc"),
    ("types", "dataTypes pous addData"),
    ("pou", "interface actions transitions body addData documentation"),
    ("variable", "type initialValue addData documentation"),
    ("body", "IL ST FBD LD SFC addData documentation"),
    ("instances", "configurations addData"),
    ("configuration", "resource globalVars addData documentation"),
    ("resource", "task globalVars pouInstance addData documentation"),
    ("task", "pouInstance addData documentation"),
    ("pouInstance", "addData documentation"),
    ("step", "position connectionPointIn connectionPointOut connectionPointOutAction addData documentation"),
    ("transition", "position connectionPointIn connectionPointOut condition addData documentation"),
    ("selectionDivergence", "position connectionPointIn connectionPointOut addData documentation"),
    ("selectionConvergence", "position connectionPointIn connectionPointOut addData documentation"),
    ("simultaneousDivergence", "position connectionPointIn connectionPointOut addData documentation"),
    ("simultaneousConvergence", "position connectionPointIn connectionPointOut addData documentation"),
    ("jumpStep", "position connectionPointIn addData documentation"),
    ("actionBlock", "position connectionPointIn action addData documentation"),
    ("inVariable", "position connectionPointOut expression addData documentation"),
    ("outVariable", "position connectionPointIn expression addData documentation"),
    ("leftPowerRail", "position connectionPointOut addData documentation"),
    ("rightPowerRail", "position connectionPointIn addData documentation"),
    ("contact", "position connectionPointIn connectionPointOut variable addData documentation"),
    ("coil", "position connectionPointIn connectionPointOut variable addData documentation"),
    ("block", "position inputVariables inOutVariables outputVariables addData documentation"),
    ("inputVariables", "variable"),
    ("inOutVariables", "variable"),
    ("outputVariables", "variable"),
    ("jump", "position connectionPointIn addData documentation"),
    ("label", "position addData documentation"),
    ("comment", "position content addData documentation"),
];

/// Elements, and the attributes that they must have.
const ATTRIBUTES: &[(&str, &str)] = &[
    ("fileHeader", "companyName productName productVersion creationDateTime"),
    ("contentHeader", "name"),
    ("pou", "name pouType"),
    ("configuration", "name"),
    ("resource", "name"),
    ("task", "name priority"),
    ("pouInstance", "name typeName"),
    ("step", "localId name"),
    ("transition", "localId"),
    ("selectionDivergence", "localId"),
    ("selectionConvergence", "localId"),
    ("simultaneousDivergence", "localId"),
    ("simultaneousConvergence", "localId"),
    ("jumpStep", "localId targetName"),
    ("actionBlock", "localId"),
    ("inVariable", "localId"),
    ("outVariable", "localId"),
    ("leftPowerRail", "localId"),
    ("rightPowerRail", "localId"),
    ("contact", "localId"),
    ("coil", "localId"),
    ("block", "localId typeName"),
    ("comment", "localId height width"),
    ("connection", "refLocalId"),
    ("position", "x y"),
    ("relPosition", "x y"),
];

pub(super) fn check(lint: &mut Lint) {
    let document = lint.document;
    for id in document.within(0) {
        let element = document.get(id);
        // A contact or coil names its variable in an element of the same name.
        let in_ladder = element.name == "variable" && matches!(document.name(element.parent), "contact" | "coil");
        let in_block = element.name == "variable" && document.name(element.parent).ends_with("Variables");
        let known = CHILDREN.iter().find(|(name, _)| *name == element.name && !in_ladder && !in_block);
        if let Some((_, children)) = known {
            let places: Vec<Option<usize>> = element
                .children
                .iter()
                .map(|child| children.split(' ').position(|name| name == document.name(*child)))
                .collect();
            lint.demand(places.iter().all(Option::is_some), Rule::Order, id, "something unknown stands in it");
            lint.demand(places.is_sorted(), Rule::Order, id, "the order of what stands in it");
        }
        if element.name == "interface" {
            let lists =
                element.children.iter().all(|child| VARIABLES.split(' ').any(|name| name == document.name(*child)));
            lint.demand(lists, Rule::Order, id, "something that is no list of variables stands in it");
        }
        for key in ATTRIBUTES.iter().filter(|(name, _)| *name == element.name).flat_map(|(_, keys)| keys.split(' ')) {
            lint.demand(document.attribute(id, key).is_some(), Rule::Attributes, id, key);
        }
        if in_block {
            lint.demand(document.attribute(id, "formalParameter").is_some(), Rule::Attributes, id, "formalParameter");
        }
        if element.name == "connectionPointOut" && document.name(element.parent) == "leftPowerRail" {
            lint.demand(document.attribute(id, "formalParameter").is_some(), Rule::Attributes, id, "formalParameter");
        }
        if element.name == "inline" {
            let in_condition = document.name(element.parent) == "condition";
            let named = document.attribute(id, "name").is_some();
            lint.demand(named == in_condition, Rule::Attributes, id, "named in a condition, and only there");
        }
    }
    lint.demand(document.name(0) == "project", Rule::Order, 0, "the root is no project");
    for name in ["fileHeader", "contentHeader", "types", "instances"] {
        lint.demand(document.child(0, name).is_some(), Rule::Order, 0, "a part is missing");
    }
}
