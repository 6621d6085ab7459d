//! What CODESYS and TwinCAT say beside the standard, in `addData`.
//!
//! An element of a chart has attributes there, each called by a number: the actions of a step at its entry, while it is
//! active and at its exit, and the time of an action. The rest repeats what the element itself says, or is about its
//! look. Everything else in `addData` is skipped.

use super::document::children;
use crate::sfc::Qualifier;
use crate::xml::{Document, ElementId};

const MAIN: &str = "700a583f-b4d4-43e4-8c14-629c7cd3bec8";
const ENTRY: &str = "a6b08bd8-b696-47e3-9cbf-7408b61c9ff8";
const EXIT: &str = "a2621e18-7de3-4ea6-ae6d-89e9e0b7befd";
const QUALIFIER: &str = "e174fc0d-80b0-4a9e-a530-ca239c249a50";

/// The actions of a step, in the order in which they are done.
pub fn of_step(document: &Document, text: &str, step: ElementId) -> Vec<(Qualifier, String)> {
    let mut found = Vec::new();
    let attributes = attributes(document, text, step);
    for (wanted, qualifier) in [(ENTRY, Qualifier::Entry), (MAIN, Qualifier::Main), (EXIT, Qualifier::Exit)] {
        let named = attributes.iter().filter(|(guid, value)| guid == wanted && !value.is_empty());
        found.extend(named.map(|(_, value)| (qualifier, value.clone())));
    }
    found
}

/// The time of an action: `D T#2s`.
pub fn time(document: &Document, text: &str, action: ElementId) -> Option<String> {
    let attributes = attributes(document, text, action);
    let (_, value) = attributes.iter().find(|(guid, _)| guid == QUALIFIER)?;
    let (_, time) = value.split_once(char::is_whitespace)?;
    Some(time.trim().to_string())
}

/// The attributes of an element, by their numbers.
fn attributes(document: &Document, text: &str, element: ElementId) -> Vec<(String, String)> {
    let mut found = Vec::new();
    for add in children(document, element, "addData") {
        for data in children(document, add, "data") {
            for list in children(document, data, "attributes") {
                for attribute in children(document, list, "attribute") {
                    let guid = document.elements[attribute].attribute("guid").unwrap_or_default();
                    let value = document.source(text, attribute).text;
                    found.push((guid.to_ascii_lowercase(), value.trim().to_string()));
                }
            }
        }
    }
    found
}
