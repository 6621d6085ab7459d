//! The elements as the tools export them: numbers in document order, a condition wired from an expression right before
//! its transition, the actions of a step right behind it, and the data that the tools keep at each element.

use super::Does;
use super::tree::Element;
use crate::plcopen::dialect::Dialect;
use crate::sequence::texts::{Qualifier, Texts};
use crate::xml::Xml;

const NAME: &str = "38391c6d-6d4a-42f8-8ee7-9f45e5adafa8";
const INITIAL: &str = "6844a48e-46c2-4cc8-a185-a478f3b99cc0";
const PARALLEL: &str = "23bdaa98-72ec-41f7-817b-9dede5697086";
const QUALIFIER: &str = "e174fc0d-80b0-4a9e-a530-ca239c249a50";
const EXCLUDED: &str = "01580b27-6378-448b-8ecb-0e4b795b58d6";
const SYMBOL: &str = "bc882c11-1e91-4dd8-a6b8-2075724ed18b";
const EACH_SCAN: &str = "700a583f-b4d4-43e4-8c14-629c7cd3bec8";
const ENTRY: &str = "a6b08bd8-b696-47e3-9cbf-7408b61c9ff8";
const EXIT: &str = "a2621e18-7de3-4ea6-ae6d-89e9e0b7befd";

/// Writes all elements.
pub(super) fn write(xml: &mut Xml, elements: &[Element], texts: &Texts, does: &[Does]) {
    xml.open("SFC", &[]);
    let mut ids: Vec<String> = Vec::new();
    let mut next = 0;
    let mut fresh = || {
        next += 1;
        (next - 1).to_string()
    };
    for element in elements {
        match element {
            Element::Step { step, from } => {
                let id = fresh();
                let actions: Vec<(String, &(String, Qualifier))> =
                    does[*step].associated.iter().map(|action| (fresh(), action)).collect();
                let (name, comment) = (&texts.steps[*step], &texts.comments[*step]);
                self::step(xml, &id, name, comment, from.map(|from| ids[from].as_str()), &does[*step]);
                if !actions.is_empty() {
                    action_block(xml, &fresh(), &id, &actions);
                }
                ids.push(id);
            }
            Element::Transition { transition, from } => {
                let (condition, id) = (fresh(), fresh());
                self::transition(xml, &id, &condition, &ids[*from], &texts.conditions[*transition]);
                ids.push(id);
            }
            Element::Jump { step, from } => {
                let id = fresh();
                xml.open("jumpStep", &[("localId", &id), ("targetName", &texts.steps[*step])]);
                place(xml);
                input(xml, &ids[*from], false);
                data(xml, &[(NAME, &texts.steps[*step]), (EXCLUDED, "FALSE"), (SYMBOL, "0")]);
                xml.close();
                ids.push(id);
            }
            Element::Divergence { simultaneous, from } => {
                let id = fresh();
                let name = if *simultaneous { "simultaneousDivergence" } else { "selectionDivergence" };
                xml.open(name, &[("localId", &id)]);
                place(xml);
                input(xml, &ids[*from], false);
                xml.empty("connectionPointOut", &[("formalParameter", "sfc")]);
                data(xml, &[(PARALLEL, if *simultaneous { "TRUE" } else { "FALSE" })]);
                xml.close();
                ids.push(id);
            }
            Element::Convergence { simultaneous, from } => {
                let id = fresh();
                let name = if *simultaneous { "simultaneousConvergence" } else { "selectionConvergence" };
                xml.open(name, &[("localId", &id)]);
                place(xml);
                from.iter().for_each(|from| input(xml, &ids[*from], true));
                xml.empty("connectionPointOut", &[]);
                xml.close();
                ids.push(id);
            }
        }
    }
    xml.close();
}

fn step(xml: &mut Xml, id: &str, name: &str, comment: &str, from: Option<&str>, does: &Does) {
    match from {
        Some(_) => xml.open("step", &[("localId", id), ("name", name)]),
        None => xml.open("step", &[("localId", id), ("name", name), ("initialStep", "true")]),
    }
    place(xml);
    match from {
        Some(from) => input(xml, from, false),
        None => xml.empty("connectionPointIn", &[]),
    }
    xml.empty("connectionPointOut", &[("formalParameter", "sfc")]);
    if !does.associated.is_empty() {
        xml.empty("connectionPointOutAction", &[("formalParameter", "x")]);
    }
    let mut attributes = vec![(NAME, name), (EXCLUDED, "FALSE"), (SYMBOL, "0")];
    attributes.push((INITIAL, if from.is_none() { "TRUE" } else { "FALSE" }));
    attributes.extend(does.each_scan.as_deref().map(|action| (EACH_SCAN, action)));
    attributes.extend(does.entry.as_deref().map(|action| (ENTRY, action)));
    attributes.extend(does.exit.as_deref().map(|action| (EXIT, action)));
    data(xml, &attributes);
    if !comment.is_empty() {
        Dialect::Codesys.documentation(xml, comment);
    }
    xml.close();
}

fn transition(xml: &mut Xml, id: &str, condition: &str, from: &str, text: &str) {
    xml.open("inVariable", &[("localId", condition)]);
    place(xml);
    xml.empty("connectionPointOut", &[]);
    xml.text("expression", &[], text);
    xml.close();
    xml.open("transition", &[("localId", id)]);
    place(xml);
    input(xml, from, true);
    xml.open("condition", &[]);
    input(xml, condition, false);
    xml.close();
    data(xml, &[(NAME, text), (EXCLUDED, "FALSE"), (SYMBOL, "0")]);
    xml.close();
}

fn action_block(xml: &mut Xml, id: &str, step: &str, actions: &[(String, &(String, Qualifier))]) {
    xml.open("actionBlock", &[("localId", id)]);
    place(xml);
    xml.open("connectionPointIn", &[]);
    xml.empty("connection", &[("refLocalId", step), ("formalParameter", "x")]);
    xml.close();
    for (id, (name, qualifier)) in actions {
        let time = qualifier.time().unwrap_or_default();
        let attributes = [("qualifier", qualifier.name()), ("duration", time), ("indicator", "")];
        xml.open("action", &[&[("localId", id.as_str())], &attributes[..]].concat());
        xml.empty("relPosition", &[("x", "0"), ("y", "0")]);
        xml.empty("reference", &[("name", name)]);
        xml.empty("connectionPointOut", &[]);
        let timed = [qualifier.name(), time].join(" ");
        data(xml, &[(NAME, name), (QUALIFIER, timed.trim_end())]);
        xml.close();
    }
    xml.close();
}

fn place(xml: &mut Xml) {
    xml.empty("position", &[("x", "0"), ("y", "0")]);
}

fn input(xml: &mut Xml, from: &str, named: bool) {
    xml.open("connectionPointIn", &[]);
    match named {
        true => xml.empty("connection", &[("refLocalId", from), ("formalParameter", "sfc")]),
        false => xml.empty("connection", &[("refLocalId", from)]),
    }
    xml.close();
}

/// What the tools keep at an element.
fn data(xml: &mut Xml, attributes: &[(&str, &str)]) {
    let name = "http://www.3s-software.com/plcopenxml/sfc/element";
    xml.open("addData", &[]);
    xml.open("data", &[("name", name), ("handleUnknown", "implementation")]);
    xml.open("attributes", &[("xmlns", "")]);
    for (guid, value) in attributes {
        xml.text("attribute", &[("guid", guid)], value);
    }
    for _ in ["attributes", "data", "addData"] {
        xml.close();
    }
}
