//! What items have in common: the documentation above them, and functions of few lines.

use super::expressions::WIDTH;
use crate::writer::Writer;
use std::borrow::Cow;

/// A comment that documents what follows, on one line: a break might begin what Markdown takes for a list. The text is
/// clean.
pub(super) fn doc(out: &mut Writer, text: &str) {
    out.start();
    out.text("/// ");
    out.text(&escaped(text));
    out.end();
}

/// A text in which Markdown finds neither links nor tags.
pub(super) fn escaped(text: &str) -> Cow<'_, str> {
    const SPECIAL: [char; 5] = ['[', ']', '<', '>', '\\'];
    if !text.contains(SPECIAL) {
        return text.into();
    }
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        if SPECIAL.contains(&c) {
            out.push('\\');
        }
        out.push(c);
    }
    out.into()
}

/// Writes a function of few lines.
pub(super) fn function(out: &mut Writer, about: &str, head: &str, body: &[&str]) {
    out.line(&format!("/// {about}"));
    debug_assert!(out.indent() + head.len() + 2 <= WIDTH);
    out.open(&format!("{head} {{"));
    for line in body {
        out.line(line);
    }
    out.close("}");
    out.blank();
}
