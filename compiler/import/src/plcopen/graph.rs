//! The drawn elements of a body, and the wires between them.
//!
//! Each element has an identity that is unique within its body, and names at its inputs the elements whose outputs are
//! wired to them. Places and sizes mean nothing here.

use super::document::{child, children, number};
use crate::code::expression;
use crate::code::tree::{Code, Direction, ExprId};
use crate::xml::{Document, Element, ElementId};
use grafc_diagnostics::{Code as ErrorCode, Diagnostic, Diagnostics, Span};
use rustc_hash::FxHashMap;

/// A body.
pub struct Graph {
    pub nodes: Vec<Node>,
    /// The place of each identity.
    by_id: FxHashMap<u64, usize>,
}

/// An element.
pub struct Node {
    pub kind: NodeKind,
    pub element: ElementId,
    pub span: Span,
    pub inputs: Vec<Pin>,
}

/// What an element is.
pub enum NodeKind {
    Rail,
    /// A value, or what a value is given to.
    Value(ExprId),
    Contact {
        variable: ExprId,
        negated: bool,
        edge: Option<Direction>,
    },
    Coil {
        variable: ExprId,
        negated: bool,
        edge: Option<Direction>,
        storage: Storage,
    },
    Block {
        ty: String,
        instance: Option<String>,
        outputs: Vec<(String, bool)>,
    },
    Connector(String),
    Continuation(String),
    Step,
    Transition,
    /// One of several ways.
    Selection,
    Fork,
    Join,
    Jump(String),
    Actions,
    /// What is drawn and does nothing, or what charts do not have.
    Other,
}

/// What a coil does with its variable.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Storage {
    None,
    Set,
    Reset,
}

/// An input.
pub struct Pin {
    /// Its name, of blocks.
    pub name: String,
    pub negated: bool,
    pub edge: Option<Direction>,
    pub wires: Vec<Wire>,
    pub span: Span,
}

/// The output that is wired to an input.
#[derive(Clone)]
pub struct Wire {
    /// The place of the element.
    pub from: usize,
    /// The name of the output, of blocks.
    pub pin: Option<String>,
}

impl Graph {
    /// The elements of a body, in the order of the file.
    pub fn read(
        document: &Document,
        text: &str,
        body: ElementId,
        code: &mut Code,
        diagnostics: &mut Diagnostics,
    ) -> Graph {
        let mut graph = Graph { nodes: Vec::new(), by_id: FxHashMap::default() };
        let drawn = &document.elements[body].children;
        for &id in drawn {
            let element = &document.elements[id];
            let Some(kind) = kind(document, text, id, code) else { continue };
            let place = graph.nodes.len();
            match number(element, "localId") {
                Some(local) if graph.by_id.contains_key(&local) => {
                    let message = format!("two elements have the `localId` {local}");
                    diagnostics.push(
                        Diagnostic::new(ErrorCode::E0704, element.span, message)
                            .help("give each element of a body an identity of its own"),
                    );
                }
                Some(local) => {
                    graph.by_id.insert(local, place);
                }
                None => {
                    let message = format!("`{}` has no `localId`", element.name);
                    diagnostics.push(
                        Diagnostic::new(ErrorCode::E0705, element.span, message).help("give it one, a whole number"),
                    );
                }
            }
            graph.nodes.push(Node { kind, element: id, span: element.span, inputs: Vec::new() });
        }
        for place in 0..graph.nodes.len() {
            let inputs = graph.pins(document, graph.nodes[place].element, diagnostics);
            graph.nodes[place].inputs = inputs;
        }
        graph
    }

    fn pins(&self, document: &Document, id: ElementId, diagnostics: &mut Diagnostics) -> Vec<Pin> {
        let mut pins = Vec::new();
        for &point in &document.elements[id].children {
            let element = &document.elements[point];
            match element.name.as_str() {
                "connectionPointIn" => {
                    let wires = self.wires(document, point, diagnostics);
                    pins.push(Pin { name: String::new(), negated: false, edge: None, wires, span: element.span });
                }
                "inputVariables" | "inOutVariables" => {
                    for variable in children(document, point, "variable") {
                        let element = &document.elements[variable];
                        let name = element.attribute("formalParameter").unwrap_or_default().to_string();
                        let wires = child(document, variable, "connectionPointIn")
                            .map(|point| self.wires(document, point, diagnostics))
                            .unwrap_or_default();
                        let (negated, edge) = (is_true(element, "negated"), edge(element));
                        pins.push(Pin { name, negated, edge, wires, span: element.span });
                    }
                }
                _ => {}
            }
        }
        pins
    }

    /// What is wired to an input.
    pub fn wires(&self, document: &Document, point: ElementId, diagnostics: &mut Diagnostics) -> Vec<Wire> {
        let mut wires = Vec::new();
        for connection in children(document, point, "connection") {
            let element = &document.elements[connection];
            let reference = element.attribute("refLocalId").unwrap_or_default();
            let found = reference.trim().parse().ok().and_then(|local: u64| self.by_id.get(&local));
            match found {
                Some(&from) => {
                    let pin = element.attribute("formalParameter").filter(|name| !name.is_empty()).map(str::to_string);
                    wires.push(Wire { from, pin });
                }
                None => diagnostics.push(
                    Diagnostic::new(
                        ErrorCode::E0704,
                        element.span,
                        format!("a connection refers to the element `{reference}`, which is not there"),
                    )
                    .help("draw the connection again in the tool that made the file, or delete it"),
                ),
            }
        }
        wires
    }
}

fn kind(document: &Document, text: &str, id: ElementId, code: &mut Code) -> Option<NodeKind> {
    let element = &document.elements[id];
    let attribute = |name: &str| element.attribute(name).unwrap_or_default().trim().to_string();
    let mut of_child = |name: &str| {
        let source = match child(document, id, name) {
            Some(child) => document.source(text, child),
            None => crate::code::source::Source::empty(element.span),
        };
        expression(&source, code)
    };
    Some(match element.name.as_str() {
        "leftPowerRail" => NodeKind::Rail,
        "inVariable" | "outVariable" | "inOutVariable" => {
            let mut value = of_child("expression");
            if is_true(element, "negated") && element.name == "inVariable" {
                value = code.not(value);
            }
            NodeKind::Value(value)
        }
        "contact" => NodeKind::Contact {
            variable: of_child("variable"),
            negated: is_true(element, "negated"),
            edge: edge(element),
        },
        "coil" => NodeKind::Coil {
            variable: of_child("variable"),
            negated: is_true(element, "negated"),
            edge: edge(element),
            storage: match element.attribute("storage") {
                Some("set") => Storage::Set,
                Some("reset") => Storage::Reset,
                _ => Storage::None,
            },
        },
        "block" => {
            let outputs = child(document, id, "outputVariables").map(|list| {
                let named = |variable: ElementId| {
                    let element = &document.elements[variable];
                    let name = element.attribute("formalParameter").unwrap_or_default();
                    (name.to_string(), is_true(element, "negated"))
                };
                children(document, list, "variable").map(named).collect()
            });
            NodeKind::Block {
                ty: attribute("typeName"),
                instance: element.attribute("instanceName").filter(|name| !name.is_empty()).map(str::to_string),
                outputs: outputs.unwrap_or_default(),
            }
        }
        "connector" => NodeKind::Connector(attribute("name")),
        "continuation" => NodeKind::Continuation(attribute("name")),
        "step" | "macroStep" => NodeKind::Step,
        "transition" => NodeKind::Transition,
        "selectionDivergence" | "selectionConvergence" => NodeKind::Selection,
        "simultaneousDivergence" => NodeKind::Fork,
        "simultaneousConvergence" => NodeKind::Join,
        "jumpStep" => NodeKind::Jump(attribute("targetName")),
        "actionBlock" => NodeKind::Actions,
        "comment" | "rightPowerRail" | "vendorElement" | "jump" | "label" | "return" | "error" => NodeKind::Other,
        _ => return None,
    })
}

/// Whether an attribute says so.
pub fn is_true(element: &Element, name: &str) -> bool {
    matches!(element.attribute(name).map(str::trim), Some("true" | "1" | "TRUE"))
}

fn edge(element: &Element) -> Option<Direction> {
    match element.attribute("edge") {
        Some("rising") => Some(Direction::Rise),
        Some("falling") => Some(Direction::Fall),
        _ => None,
    }
}
