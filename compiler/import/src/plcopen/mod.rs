//! PLCopen XML (TC6), as Beremiz and OpenPLC save it, and as CODESYS and TwinCAT export it.
//!
//! ```text
//! elements ─ declarations, bodies ─▶ units ─ graph ─▶ drawn elements ─ wires, network ─▶ charts and expressions
//! ```
//!
//! Name spaces differ between versions and mean nothing here. Units are found wherever they stand, since CODESYS keeps
//! those of an application in `addData`.

mod bodies;
mod chart;
mod declarations;
mod document;
mod graph;
mod network;
mod vendor;
mod wires;

use crate::code::tree::Code;
use crate::sfc::{Body, ByName, NamedAction, Project, Section, Unit};
use crate::xml::{Document, ElementId};
use bodies::{Conditions, Reading};
use document::{child, children, name};
use grafc_diagnostics::{Code as ErrorCode, Diagnostic, Diagnostics};

/// The project of a document.
pub fn read(document: &Document, text: &str, diagnostics: &mut Diagnostics) -> Project {
    let mut project = Project::default();
    let mut code = Code::default();
    let mut reading = Reading { document, text, code: &mut code, diagnostics };
    for (id, element) in document.elements.iter_enumerated() {
        let parent = element.parent.map(|parent| document.elements[parent].name.as_str());
        match (element.name.as_str(), parent) {
            ("fileHeader", Some("project")) => {
                project.product = element.attribute("productName").map(str::to_string);
            }
            ("pou", _) => project.units.extend(unit(&mut reading, id)),
            ("dataType", _) => reading.data_type(id, &mut project.enumerations, &mut project.structures),
            ("globalVars", Some(parent)) if parent != "interface" => {
                let list = reading.list(id, Section::Global);
                project.globals.extend(list.iter().cloned());
                // CODESYS writes the name of the list before that of the variable.
                if let Some(prefix) = name(element) {
                    project.globals.extend(list.into_iter().map(|mut variable| {
                        variable.name = format!("{prefix}.{}", variable.name);
                        variable
                    }));
                }
            }
            _ => {}
        }
    }
    project.code = code;
    project
}

fn unit(reading: &mut Reading, id: ElementId) -> Option<Unit> {
    let document = reading.document;
    let element = &document.elements[id];
    let Some(name) = name(element) else {
        let message = "a program organisation unit has no name";
        reading.diagnostics.push(
            Diagnostic::new(ErrorCode::E0705, element.span, message)
                .help("give it a name in the tool that made the file"),
        );
        return None;
    };
    let variables = child(document, id, "interface").map(|interface| reading.interface(interface));
    let conditions = transitions(reading, id);
    let mut unit = Unit {
        name: name.to_string(),
        span: element.span,
        variables: ByName::default(),
        actions: ByName::default(),
        chart: None,
    };
    unit.variables.extend(variables.into_iter().flatten());
    if let Some(list) = child(document, id, "actions") {
        let named: Vec<ElementId> = children(document, list, "action").collect();
        for action in named {
            let element = &document.elements[action];
            let body = child(document, action, "body").and_then(|body| action_body(reading, body, &conditions));
            if let (Some(name), Some(body)) = (document::name(element), body) {
                unit.actions.push(NamedAction { name: name.to_string(), span: element.span, body });
            }
        }
    }
    let bodies: Vec<ElementId> = children(document, id, "body").collect();
    for body in bodies {
        if let Some(("SFC", chart)) = bodies::language(document, body) {
            unit.chart = Some(chart::read(reading, chart, &conditions));
            break;
        }
    }
    Some(unit)
}

/// The body of an action; none if it has none, or if it is in no language that is known.
fn action_body(reading: &mut Reading, body: ElementId, conditions: &Conditions) -> Option<Body> {
    let (language, id) = bodies::language(reading.document, body)?;
    Some(match language {
        "SFC" => Body::Chart(chart::read(reading, id, conditions)),
        _ => Body::Statements(reading.statements(language, id)),
    })
}

/// The transitions that have bodies of their own.
fn transitions(reading: &mut Reading, unit: ElementId) -> Conditions {
    let document = reading.document;
    let mut conditions = Conditions::default();
    let Some(list) = child(document, unit, "transitions") else { return conditions };
    let named: Vec<ElementId> = children(document, list, "transition").collect();
    for transition in named {
        let (Some(name), Some(body)) =
            (document::name(&document.elements[transition]), child(document, transition, "body"))
        else {
            continue;
        };
        let condition = reading.condition(body, name);
        conditions.insert(name.to_lowercase(), condition);
    }
    conditions
}
