//! AGRAFE: the XMI that its editor saves, by the meta-model of `grafcet.ecore` and `terms.ecore`.
//!
//! XMI leaves out what has its default value, so a missing `id` is 0, a missing `variableDeclarationType` is an input,
//! and an `IntegerConstant` without value is 0. Elements are found by the names of the features that hold them, their
//! classes by `xsi:type`; prefixes and name spaces differ between versions and mean nothing here.

mod attributes;
mod elements;
pub mod model;
mod references;
mod sorts;

pub use sorts::target;

use crate::lost;
use crate::xml::{Document, ElementId};
use grafc_diagnostics::Diagnostics;
use model::Model;

/// The model in a document; none, and nothing said, if it is another kind of document.
pub fn read(document: &Document, diagnostics: &mut Diagnostics) -> Option<Model> {
    let outermost = ElementId::new(0);
    // Several roots are wrapped into `xmi:XMI`; the chart is one of them.
    let mut roots = vec![outermost];
    if document.elements[outermost].name == "XMI" {
        roots.clone_from(&document.elements[outermost].children);
    }
    let &root = roots.iter().find(|&&root| document.elements[root].name == "Grafcet")?;
    for text in &document.texts {
        diagnostics.push(lost(text.span, "the text between the elements is lost").note("a model has none"));
    }
    let mut found = elements::read(document, root, diagnostics);
    references::resolve(document, &roots, &mut found, diagnostics);
    sorts::check(&found.model, diagnostics);
    Some(found.model)
}
