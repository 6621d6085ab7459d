//! An XML document as a table of elements in document order, which makes walking it plain.

use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};

/// The number of an element.
pub type Id = usize;

/// An element.
#[derive(Debug, Default)]
pub struct Element {
    /// The name as written, with its prefix.
    pub name: String,
    /// Attributes, in order.
    pub attributes: Vec<(String, String)>,
    /// The elements directly in it.
    pub children: Vec<Id>,
    /// The element that it is directly in; of the root, the root.
    pub parent: Id,
    /// The number behind the last element in it.
    pub end: Id,
    /// The texts directly in it.
    pub text: String,
    /// Whether the first thing in it is a CDATA section.
    pub starts_with_cdata: bool,
}

/// A document; element 0 is the root.
#[derive(Debug)]
pub struct Document {
    elements: Vec<Element>,
}

impl Document {
    /// Reads a document; the error says why it is not well-formed.
    pub fn read(text: &str) -> Result<Document, String> {
        let mut reader = Reader::from_str(text);
        reader.config_mut().expand_empty_elements = true;
        let mut elements: Vec<Element> = Vec::new();
        let mut open: Vec<Id> = Vec::new();
        loop {
            match reader.read_event().map_err(|error| error.to_string())? {
                Event::Start(start) => {
                    let id = elements.len();
                    match open.last() {
                        Some(parent) => elements[*parent].children.push(id),
                        None if id > 0 => return Err("there are two roots".to_string()),
                        None => {}
                    }
                    elements.push(element(&start, open.last().copied().unwrap_or(id))?);
                    open.push(id);
                }
                Event::End(_) => {
                    if let Some(id) = open.pop() {
                        elements[id].end = elements.len();
                    }
                }
                Event::Text(text) => {
                    let text = text.decode().map_err(|error| error.to_string())?;
                    append(&mut elements, &open, &text)?;
                }
                Event::CData(data) => {
                    if let Some(id) = open.last() {
                        elements[*id].starts_with_cdata |= elements[*id].text.is_empty();
                    }
                    let text = data.decode().map_err(|error| error.to_string())?;
                    append(&mut elements, &open, &text)?;
                }
                Event::GeneralRef(name) => {
                    let name = name.decode().map_err(|error| error.to_string())?;
                    let text = quick_xml::escape::unescape(&format!("&{name};"))
                        .map_err(|error| error.to_string())?
                        .into_owned();
                    append(&mut elements, &open, &text)?;
                }
                Event::Eof => break,
                Event::Decl(_) | Event::Comment(_) | Event::PI(_) | Event::DocType(_) | Event::Empty(_) => {}
            }
        }
        match (elements.is_empty(), open.last()) {
            (true, _) => Err("there is no element".to_string()),
            (false, Some(id)) => Err(format!("`{}` is not closed", elements[*id].name)),
            (false, None) => Ok(Document { elements }),
        }
    }

    /// An element.
    pub fn get(&self, id: Id) -> &Element {
        &self.elements[id]
    }

    /// The name of an element.
    pub fn name(&self, id: Id) -> &str {
        &self.elements[id].name
    }

    /// The value of an attribute.
    pub fn attribute(&self, id: Id, key: &str) -> Option<&str> {
        self.elements[id].attributes.iter().find(|(name, _)| name == key).map(|(_, value)| value.as_str())
    }

    /// The elements of a name directly in another.
    pub fn children<'d>(&'d self, id: Id, name: &'d str) -> impl Iterator<Item = Id> + 'd {
        self.elements[id].children.iter().copied().filter(move |child| self.name(*child) == name)
    }

    /// The first element of a name directly in another.
    pub fn child(&self, id: Id, name: &str) -> Option<Id> {
        self.children(id, name).next()
    }

    /// All elements within another and itself, in document order.
    pub fn within(&self, id: Id) -> std::ops::Range<Id> {
        id..self.elements[id].end
    }

    /// All elements of a name, in document order.
    pub fn all<'d>(&'d self, name: &'d str) -> impl Iterator<Item = Id> + 'd {
        (0..self.elements.len()).filter(move |id| self.name(*id) == name)
    }
}

fn element(start: &BytesStart, parent: Id) -> Result<Element, String> {
    let mut attributes = Vec::new();
    for attribute in start.attributes() {
        let attribute = attribute.map_err(|error| error.to_string())?;
        let value = String::from_utf8_lossy(&attribute.value);
        let value = quick_xml::escape::unescape(&value).map_err(|error| error.to_string())?.into_owned();
        attributes.push((String::from_utf8_lossy(attribute.key.as_ref()).into_owned(), value));
    }
    let name = String::from_utf8_lossy(start.name().as_ref()).into_owned();
    Ok(Element { name, attributes, parent, ..Element::default() })
}

fn append(elements: &mut [Element], open: &[Id], text: &str) -> Result<(), String> {
    match open.last() {
        Some(id) => elements[*id].text.push_str(text),
        None if text.trim().is_empty() => {}
        None => return Err("there is text outside the root".to_string()),
    }
    Ok(())
}
