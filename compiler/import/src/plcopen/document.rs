//! Ways through a document: children by name, the texts in them.

use crate::code::source::Source;
use crate::xml::{Document, Element, ElementId};

impl Document {
    /// The text in an element, with its places in the file.
    pub fn source(&self, text: &str, element: ElementId) -> Source {
        let found = &self.elements[element];
        let mut source = Source::empty(found.span);
        for piece in self.texts_in(element) {
            let range = piece.span.range();
            match piece.reference {
                Some(c) => source.push_reference(c, range),
                None => source.push(&text[range.clone()], range.start),
            }
        }
        source
    }
}

/// The first child of a name.
pub fn child(document: &Document, element: ElementId, name: &str) -> Option<ElementId> {
    children(document, element, name).next()
}

/// The children of a name.
pub fn children<'d>(document: &'d Document, element: ElementId, name: &'d str) -> impl Iterator<Item = ElementId> + 'd {
    document.elements[element].children.iter().copied().filter(move |&child| document.elements[child].name == name)
}

/// A whole number.
pub fn number<T: std::str::FromStr>(element: &Element, name: &str) -> Option<T> {
    element.attribute(name)?.trim().parse().ok()
}

/// The name of an element, if it has one.
pub fn name(element: &Element) -> Option<&str> {
    element.attribute("name").map(str::trim).filter(|name| !name.is_empty())
}
