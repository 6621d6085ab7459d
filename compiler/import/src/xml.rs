//! XML to a flat list of elements.
//!
//! Elements lie in the order of the document, parents before children, so that nobody walks them by recursion. A
//! document type is refused, because only with one can a file declare entities and blow up; so is nesting beyond any
//! drawing. The first fault ends the reading: what comes behind it cannot be trusted.

use grafc_diagnostics::{Code, Diagnostic, Diagnostics, FileId, Span};
use index_vec::{IndexVec, define_index_type};
use quick_xml::events::attributes::AttrError;
use quick_xml::events::{BytesStart, Event};
use quick_xml::{Reader, XmlVersion};
use rustc_hash::FxHashSet;

define_index_type! {
    /// An element of a [`Document`].
    pub struct ElementId = u32;
}

/// How deep elements may be nested. Real charts reach about 20; a condition adds one a level.
const DEPTH: usize = 1000;

/// A file that is well formed.
pub struct Document {
    /// All elements, in the order of their start tags.
    pub elements: IndexVec<ElementId, Element>,
    /// All comments, in order.
    pub comments: Vec<Comment>,
    /// What stands between the tags, in order, white space alone left out.
    pub texts: Vec<Text>,
}

/// An element.
pub struct Element {
    /// Its name without the prefix.
    pub name: String,
    /// Its attributes with their prefixes, in order.
    pub attributes: Vec<(String, String)>,
    /// The element around it.
    pub parent: Option<ElementId>,
    /// The elements in it.
    pub children: Vec<ElementId>,
    /// Its start tag.
    pub span: Span,
    /// Where its end tag begins.
    pub end: u32,
}

impl Element {
    /// The value of an attribute, by its name with the prefix.
    pub fn attribute(&self, name: &str) -> Option<&str> {
        self.attributes.iter().find(|(key, _)| key == name).map(|(_, value)| value.as_str())
    }
}

/// `<!-- … -->`.
pub struct Comment {
    /// What is in it.
    pub text: String,
    /// The element around it.
    pub parent: Option<ElementId>,
    /// Its first byte.
    pub start: u32,
}

/// A piece of text.
pub struct Text {
    /// Where it stands: letter by letter, unless it is a reference.
    pub span: Span,
    /// The character that a reference such as `&gt;` stands for.
    pub reference: Option<char>,
}

impl Document {
    /// The pieces of text within an element, at any depth.
    pub fn texts_in(&self, element: ElementId) -> &[Text] {
        let element = &self.elements[element];
        let begin = self.texts.partition_point(|text| text.span.start < element.span.end);
        let end = self.texts.partition_point(|text| text.span.start < element.end);
        self.texts.get(begin..end).unwrap_or_default()
    }

    /// The start tag of the outermost element.
    pub fn root_span(&self) -> Span {
        self.elements[ElementId::new(0)].span
    }
}

/// The elements of a text; none after a fault.
pub fn read(file: FileId, text: &str, diagnostics: &mut Diagnostics) -> Option<Document> {
    if u32::try_from(text.len()).is_err() {
        let message = "the file is longer than 4 GiB";
        diagnostics.push(Diagnostic::new(Code::E0109, Span::new(file, 0, 0), message).help("split the chart"));
        return None;
    }
    if let Some(at) = text.find(is_forbidden) {
        diagnostics.push(forbidden(file, text, at));
        return None;
    }
    let mut builder =
        Builder { file, elements: IndexVec::new(), comments: Vec::new(), texts: Vec::new(), open: Vec::new() };
    match builder.run(text) {
        Ok(()) => Some(Document { elements: builder.elements, comments: builder.comments, texts: builder.texts }),
        Err(fault) => {
            diagnostics.push(fault);
            None
        }
    }
}

struct Builder {
    file: FileId,
    elements: IndexVec<ElementId, Element>,
    comments: Vec<Comment>,
    texts: Vec<Text>,
    open: Vec<ElementId>,
}

impl Builder {
    fn run(&mut self, text: &str) -> Result<(), Diagnostic> {
        // The mark of byte order is no part of the text, but offsets count it.
        let skipped = text.len() - text.trim_start_matches('\u{FEFF}').len();
        let mut reader = Reader::from_str(&text[skipped..]);
        reader.config_mut().check_end_names = true;
        loop {
            let start = skipped + position(reader.buffer_position());
            let event = reader.read_event();
            let end = skipped + position(reader.buffer_position());
            let span = Span::new(self.file, start, end.max(start));
            match event {
                Err(error) => {
                    let at = (skipped + position(reader.error_position())).min(text.len());
                    return Err(malformed(self.point(text, at), spell(&error)));
                }
                Ok(Event::Start(tag)) => {
                    self.element(&tag, span)?;
                }
                Ok(Event::Empty(tag)) => {
                    self.element(&tag, span)?;
                    self.close(end);
                }
                Ok(Event::End(_)) => self.close(start),
                Ok(Event::Comment(comment)) => self.comments.push(Comment {
                    text: String::from_utf8_lossy(&comment).into_owned(),
                    parent: self.open.last().copied(),
                    start: span.start,
                }),
                // White space between two references is part of a text; that between tags is not.
                Ok(Event::Text(found)) if found.iter().all(u8::is_ascii_whitespace) && !self.goes_on(start) => {}
                Ok(Event::Text(_)) => self.text(span, None)?,
                Ok(Event::CData(found)) => {
                    let inner = start + "<![CDATA[".len();
                    self.text(Span::new(self.file, inner, inner + found.len()), None)?;
                }
                Ok(Event::GeneralRef(name)) => {
                    let name = String::from_utf8_lossy(&name).into_owned();
                    let Some(c) = referred(&name) else {
                        return Err(malformed(span, "a reference after `&` means nothing"));
                    };
                    self.text(span, Some(c))?;
                }
                Ok(Event::DocType(_)) => {
                    return Err(Diagnostic::new(Code::E0702, span, "the file declares a document type")
                        .note("with one, a short file can stand for an endless one; no chart needs it")
                        .help("delete the `<!DOCTYPE …>` declaration, and write out what it abbreviates"));
                }
                Ok(Event::Decl(_) | Event::PI(_)) => {}
                Ok(Event::Eof) => return self.finish(text),
            }
        }
    }

    fn element(&mut self, tag: &BytesStart, span: Span) -> Result<(), Diagnostic> {
        let parent = self.open.last().copied();
        if parent.is_none() && !self.elements.is_empty() {
            return Err(malformed(span, "there is a second element after the outermost one"));
        }
        if self.open.len() == DEPTH {
            return Err(Diagnostic::new(Code::E0702, span, format!("elements are nested more than {DEPTH} deep"))
                .help("split the condition, or restore the file if no tool would write it like this"));
        }
        let name = String::from_utf8_lossy(tag.local_name().as_ref()).into_owned();
        let mut attributes = Vec::new();
        let mut names = FxHashSet::default();
        // The reader's own check for duplicates compares each with each.
        for attribute in tag.attributes().with_checks(false) {
            let attribute = attribute.map_err(|error| malformed(span, attribute_fault(&error)))?;
            let key = String::from_utf8_lossy(attribute.key.as_ref()).into_owned();
            if !names.insert(key.clone()) {
                return Err(malformed(span, format!("the attribute `{key}` is given twice")));
            }
            let value = attribute.normalized_value(XmlVersion::Implicit1_0);
            let value = value.map_err(|error| malformed(span, spell(&error)))?;
            if let Some(c) = value.chars().find(|c| is_forbidden(*c)) {
                return Err(malformed(span, format!("the attribute `{key}` holds {}", code_point(c))));
            }
            attributes.push((key, value.into_owned()));
        }
        let id = self.elements.push(Element { name, attributes, parent, children: Vec::new(), span, end: span.end });
        if let Some(parent) = parent {
            self.elements[parent].children.push(id);
        }
        self.open.push(id);
        Ok(())
    }

    /// The end of the element that is open.
    fn close(&mut self, end: usize) {
        if let Some(id) = self.open.pop() {
            self.elements[id].end = u32::try_from(end).unwrap_or(u32::MAX);
        }
    }

    /// Whether a text ends just there.
    fn goes_on(&self, start: usize) -> bool {
        self.texts.last().is_some_and(|last| last.span.range().end == start && last.reference.is_some())
    }

    fn text(&mut self, span: Span, reference: Option<char>) -> Result<(), Diagnostic> {
        if self.open.is_empty() {
            return Err(malformed(span, "there is text outside of the outermost element"));
        }
        self.texts.push(Text { span, reference });
        Ok(())
    }

    fn finish(&self, text: &str) -> Result<(), Diagnostic> {
        match self.open.last() {
            Some(&open) => {
                let element = &self.elements[open];
                let message = format!("the file ends within the element `{}`", element.name);
                Err(malformed(self.point(text, text.len()), message).also(element.span, "it begins here"))
            }
            None if self.elements.is_empty() => Err(malformed(self.point(text, 0), "the file has no element")),
            None => Ok(()),
        }
    }

    /// The character at an offset, or the place behind the last.
    fn point(&self, text: &str, at: usize) -> Span {
        let at = (0..=at).rev().find(|&at| text.is_char_boundary(at)).unwrap_or_default();
        let length = text[at..].chars().next().map_or(0, char::len_utf8);
        Span::new(self.file, at, at + length)
    }
}

/// Whether a file in XML cannot hold a character, not even by a reference (XML 1.0, 2.2).
fn is_forbidden(c: char) -> bool {
    matches!(c, '\0'..='\u{1F}' | '\u{FFFE}' | '\u{FFFF}') && !matches!(c, '\t' | '\n' | '\r')
}

/// The character that a reference stands for, by its name or number.
fn referred(name: &str) -> Option<char> {
    let c = match name.strip_prefix('#') {
        Some(number) => {
            let hexadecimal = number.strip_prefix('x').map(|digits| u32::from_str_radix(digits, 16));
            char::from_u32(hexadecimal.unwrap_or_else(|| number.parse()).ok()?)?
        }
        None => match name {
            "lt" => '<',
            "gt" => '>',
            "amp" => '&',
            "apos" => '\'',
            "quot" => '"',
            _ => return None,
        },
    };
    (!is_forbidden(c)).then_some(c)
}

fn code_point(c: char) -> String {
    format!("the character U+{:04X}, which XML does not have", u32::from(c))
}

fn forbidden(file: FileId, text: &str, at: usize) -> Diagnostic {
    let c = text[at..].chars().next().unwrap_or_default();
    malformed(Span::new(file, at, at + c.len_utf8()), format!("the file holds {}", code_point(c)))
}

fn malformed(span: Span, what: impl Into<String>) -> Diagnostic {
    Diagnostic::new(Code::E0701, span, what)
        .help("save the chart again with the tool that made it, or take the file from a copy that is whole")
}

fn position(offset: u64) -> usize {
    usize::try_from(offset).unwrap_or(usize::MAX)
}

/// What the reader says, in the words of a message.
fn spell(error: &quick_xml::Error) -> String {
    match error {
        quick_xml::Error::Syntax(error) => error.to_string(),
        quick_xml::Error::IllFormed(error) => error.to_string(),
        quick_xml::Error::InvalidAttr(error) => attribute_fault(error).to_string(),
        quick_xml::Error::Escape(_) => "a reference after `&` means nothing".to_string(),
        quick_xml::Error::Io(_) | quick_xml::Error::Encoding(_) | quick_xml::Error::Namespace(_) => error.to_string(),
    }
}

fn attribute_fault(error: &AttrError) -> &'static str {
    match error {
        AttrError::ExpectedEq(_) => "an attribute has no `=`",
        AttrError::ExpectedValue(_) => "an attribute has no value",
        AttrError::UnquotedValue(_) => "the value of an attribute is not in quotation marks",
        AttrError::ExpectedQuote(..) => "the value of an attribute does not end",
        AttrError::Duplicated(..) => "an attribute is given twice",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fault(text: &str) -> (Code, u32) {
        let mut diagnostics = Diagnostics::new();
        assert!(read(FileId::default(), text, &mut diagnostics).is_none(), "{text}");
        let last = diagnostics.iter().last().expect("a message");
        (last.code, last.primary.span.start)
    }

    #[test]
    fn elements_lie_in_order_and_know_their_places() {
        let mut diagnostics = Diagnostics::new();
        let document =
            read(FileId::default(), "\u{FEFF}<p:a x='1&lt;2'><b/><!-- c --><d>\n</d></p:a>", &mut diagnostics);
        let document = document.expect("it is well formed");
        let names: Vec<_> = document.elements.iter().map(|e| (e.name.as_str(), e.span.start)).collect();
        assert_eq!(names, [("a", 3), ("b", 19), ("d", 33)]);
        assert_eq!(document.elements[ElementId::new(0)].attribute("x"), Some("1<2"));
        assert_eq!(document.elements[ElementId::new(0)].children.len(), 2);
        assert_eq!((document.comments[0].text.as_str(), document.comments[0].start), (" c ", 23));
        assert!(diagnostics.is_empty());
    }

    #[test]
    fn what_is_malformed_has_a_place() {
        assert_eq!(fault(""), (Code::E0701, 0));
        assert_eq!(fault("<a><b></a>"), (Code::E0701, 6));
        assert_eq!(fault("<a><b/>"), (Code::E0701, 7));
        assert_eq!(fault("<a/><b/>"), (Code::E0701, 4));
        assert_eq!(fault("<a x=1/>"), (Code::E0701, 0));
        assert_eq!(fault("<a><b x='1' y='2' x='3'/></a>"), (Code::E0701, 3));
        assert_eq!(fault("<a x='&boom;'/>"), (Code::E0701, 0));
        assert_eq!(fault("words"), (Code::E0701, 0));
    }

    #[test]
    fn characters_that_xml_does_not_have_are_refused() {
        assert_eq!(fault("<a>\0</a>"), (Code::E0701, 3));
        assert_eq!(fault("<a x='1\u{1}2'/>"), (Code::E0701, 7));
        assert_eq!(fault("<!-- \u{FFFE} --><a/>"), (Code::E0701, 5));
        for reference in ["&#0;", "&#x1F;", "&#xFFFF;"] {
            assert_eq!(fault(&format!("<a x='{reference}'/>")), (Code::E0701, 0), "{reference}");
        }
        let text = "<a x='&#9;&#xA;\t\u{7F}\u{85}'/>\r\n";
        assert!(read(FileId::default(), text, &mut Diagnostics::new()).is_some());
    }

    #[test]
    fn entities_are_not_declared() {
        assert_eq!(fault("<!DOCTYPE a [<!ENTITY b 'c'>]><a x='&b;'/>"), (Code::E0702, 0));
    }

    #[test]
    fn nesting_ends_somewhere() {
        let nested = |depth: usize| format!("{}{}", "<a>".repeat(depth), "</a>".repeat(depth));
        assert!(read(FileId::default(), &nested(DEPTH), &mut Diagnostics::new()).is_some());
        assert_eq!(fault(&nested(DEPTH + 1)), (Code::E0702, 3 * DEPTH as u32));
        // Not even the end need be there.
        assert_eq!(fault(&"<a>".repeat(100_000)), (Code::E0702, 3 * DEPTH as u32));
    }
}
