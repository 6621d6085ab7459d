//! XML as the readers of PLC tools want it: elements on lines of their own, attributes in the order given, texts whole.
//!
//! Well-formed by construction: [`Xml::close`] closes what was opened last, texts are escaped, and what XML 1.0 has no
//! characters for becomes U+FFFD.

use quick_xml::Writer;
use quick_xml::escape::partial_escape;
use quick_xml::events::{BytesCData, BytesDecl, BytesEnd, BytesStart, BytesText, Event};

/// A growing document.
pub(crate) struct Xml {
    writer: Writer<Vec<u8>>,
    open: Vec<&'static str>,
}

/// The attributes of an element, in order.
pub(crate) type Attributes<'a> = &'a [(&'a str, &'a str)];

impl Xml {
    /// A document that has only its declaration.
    pub fn new() -> Self {
        let mut xml = Xml { writer: Writer::new_with_indent(Vec::new(), b' ', 2), open: Vec::new() };
        xml.event(Event::Decl(BytesDecl::new("1.0", Some("utf-8"), None)));
        xml
    }

    /// The text of the document, with a line break at its end.
    pub fn finish(mut self) -> String {
        while !self.open.is_empty() {
            self.close();
        }
        let mut text = String::from_utf8_lossy(&self.writer.into_inner()).into_owned();
        text.push('\n');
        text
    }

    /// The start of an element.
    pub fn open(&mut self, name: &'static str, attributes: Attributes) {
        self.event(Event::Start(element(name, attributes)));
        self.open.push(name);
    }

    /// The end of the element that was opened last.
    pub fn close(&mut self) {
        if let Some(name) = self.open.pop() {
            self.event(Event::End(BytesEnd::new(name)));
        }
    }

    /// An element with nothing in it.
    pub fn empty(&mut self, name: &'static str, attributes: Attributes) {
        self.event(Event::Empty(element(name, attributes)));
    }

    /// An element with nothing but a text, escaped.
    pub fn text(&mut self, name: &'static str, attributes: Attributes, text: &str) {
        self.open(name, attributes);
        let text = legal(text);
        self.event(Event::Text(BytesText::from_escaped(partial_escape(&text))));
        self.close();
    }

    /// An element with nothing but a text in a CDATA section. There is no escape in one: a `]]>` is drawn apart.
    pub fn cdata(&mut self, name: &'static str, attributes: Attributes, text: &str) {
        self.open(name, attributes);
        let text = legal(text).replace("]]>", "]] >");
        self.event(Event::CData(BytesCData::new(text)));
        self.close();
    }

    fn event(&mut self, event: Event) {
        // Writing to a vector cannot fail.
        self.writer.write_event(event).unwrap_or_default();
    }
}

fn element(name: &'static str, attributes: Attributes) -> BytesStart<'static> {
    let mut start = BytesStart::new(name);
    for (key, value) in attributes {
        start.push_attribute((*key, legal(value).as_str()));
    }
    start
}

/// The text with a mark in place of each character that XML 1.0 does not know.
fn legal(text: &str) -> String {
    let is_legal = |c: char| matches!(c, '\t' | '\n' | '\r' | ' '..='\u{FFFD}' | '\u{10000}'..);
    text.chars().map(|c| if is_legal(c) { c } else { '\u{FFFD}' }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_ends_a_text() {
        let mut xml = Xml::new();
        xml.open("a", &[("name", "\"<&>\""), ("other", "é")]);
        xml.cdata("b", &[], "x ]]> y ]]]]>> \u{0}\u{FFFE} & <");
        xml.text("c", &[], "1 < 2 & ]]>\nnext");
        xml.empty("d", &[]);
        assert_eq!(
            xml.finish(),
            "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<a name=\"&quot;&lt;&amp;&gt;&quot;\" other=\"é\">\n  \
             <b><![CDATA[x ]] > y ]]]] >> \u{FFFD}\u{FFFD} & <]]></b>\n  <c>1 &lt; 2 &amp; ]]&gt;\nnext</c>\n  <d/>\n</a>\n"
        );
    }
}
