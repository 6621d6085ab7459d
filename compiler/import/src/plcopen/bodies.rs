//! Bodies of actions and transitions, in each of the languages.

use super::document::child;
use super::graph::Graph;
use super::network::Network;
use crate::code::tree::{Code, ExprId, ExprKind, Statement};
use crate::code::{expression, il, read};
use crate::xml::{Document, ElementId};
use grafc_diagnostics::Diagnostics;
use rustc_hash::FxHashMap;

/// A document that is read, and what is made of it.
pub struct Reading<'a> {
    pub document: &'a Document,
    pub text: &'a str,
    pub code: &'a mut Code,
    pub diagnostics: &'a mut Diagnostics,
}

/// Conditions of transitions by name, in small letters.
pub type Conditions = FxHashMap<String, ExprId>;

/// The language of a body, and its element.
pub fn language(document: &Document, body: ElementId) -> Option<(&str, ElementId)> {
    let known = ["ST", "IL", "FBD", "LD", "SFC"];
    let found = document.elements[body].children.iter().find(|&&id| known.contains(&&*document.elements[id].name));
    found.map(|&id| (document.elements[id].name.as_str(), id))
}

impl Reading<'_> {
    /// The statements of a text or a network.
    pub fn statements(&mut self, language: &str, id: ElementId) -> Vec<Statement> {
        let source = self.document.source(self.text, id);
        match language {
            "ST" => read(&source, self.code),
            "IL" => il::read(&source, self.code).statements,
            _ => {
                let graph = Graph::read(self.document, self.text, id, self.code, self.diagnostics);
                Network::new(&graph, self.code).statements()
            }
        }
    }

    /// The condition that a body computes for the transition of a name.
    pub fn condition(&mut self, body: ElementId, name: &str) -> ExprId {
        let span = self.document.elements[body].span;
        let found = language(self.document, body).map(|(language, id)| {
            let source = self.document.source(self.text, id);
            match language {
                "ST" => Some(expression(&source, self.code)),
                "IL" => il::read(&source, self.code).result,
                "SFC" => None,
                _ => {
                    let graph = Graph::read(self.document, self.text, id, self.code, self.diagnostics);
                    Network::new(&graph, self.code).result(name)
                }
            }
        });
        match found.flatten() {
            Some(id) => id,
            None => self.code.add(ExprKind::Unknown("its body computes no condition".into()), span),
        }
    }

    /// Statements that stand in an element, `<inline>` with a text in it.
    pub fn inline(&mut self, element: ElementId) -> Vec<Statement> {
        match language(self.document, element) {
            Some((language, id)) => self.statements(language, id),
            None => Vec::new(),
        }
    }

    /// The text of the documentation of an element.
    pub fn documentation(&self, element: ElementId) -> Option<String> {
        let id = child(self.document, element, "documentation")?;
        let text = self.document.source(self.text, id).text;
        let line = text.split_whitespace().collect::<Vec<_>>().join(" ");
        (!line.is_empty()).then_some(line)
    }
}
