//! Corrections as data: changes of the text that a program can make for the author.
//!
//! What `help` says in words, a fix does, where that is a change of the text. A message may have several; each is a
//! correction by itself.

use crate::{FileId, Span};
use std::fmt;

/// A change of one place.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Edit {
    /// What is replaced; empty to insert.
    pub span: Span,
    /// What stands there afterwards; empty to delete.
    pub text: String,
}

/// How sure it is that the author wants a fix.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Applicability {
    /// The text can have meant nothing else: another spelling of the same.
    Certain,
    /// It is a guess, or one correction of several.
    Maybe,
}

/// A correction: edits that belong together.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Fix {
    /// What it does, as a menu calls it: "replace `valev` by `valve`".
    pub title: String,
    /// The edits; no two of them overlap.
    pub edits: Vec<Edit>,
    /// How sure it is.
    pub applicability: Applicability,
}

impl Fix {
    /// A correction that is only another spelling; it has no edits yet.
    pub fn certain(title: impl Into<String>) -> Self {
        Fix { title: title.into(), edits: Vec::new(), applicability: Applicability::Certain }
    }

    /// A correction that the author has to choose; it has no edits yet.
    pub fn maybe(title: impl Into<String>) -> Self {
        Fix { title: title.into(), edits: Vec::new(), applicability: Applicability::Maybe }
    }

    /// Puts a text in place of what is there, or between, if the span is empty.
    pub fn replace(mut self, span: Span, text: impl Into<String>) -> Self {
        self.edits.push(Edit { span, text: text.into() });
        self
    }

    /// Takes out what is there.
    pub fn delete(self, span: Span) -> Self {
        self.replace(span, "")
    }
}

/// Why edits cannot be made.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Misfit {
    /// The edit is of another text.
    OtherText(Span),
    /// The edit ends behind the text or before its start, or lies within a character.
    Outside(Span),
    /// Two edits change the same place: the second of them.
    Overlap(Span),
}

impl fmt::Display for Misfit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Misfit::OtherText(span) => write!(f, "the edit at {span:?} is of another text"),
            Misfit::Outside(span) => write!(f, "there is no place {span:?} in the text"),
            Misfit::Overlap(span) => write!(f, "the place {span:?} is changed twice"),
        }
    }
}

impl std::error::Error for Misfit {}

/// The text `file` after the edits, in whatever order they are given; of several insertions at one place the first given
/// comes first.
pub fn apply<'e>(file: FileId, text: &str, edits: impl IntoIterator<Item = &'e Edit>) -> Result<String, Misfit> {
    let mut edits: Vec<&Edit> = edits.into_iter().collect();
    edits.sort_by_key(|edit| (edit.span.start, edit.span.end));
    let mut out = String::with_capacity(text.len());
    let mut done = 0;
    for Edit { span, text: new } in edits {
        if span.file != file {
            return Err(Misfit::OtherText(*span));
        }
        let range = span.range();
        if text.get(range.clone()).is_none() {
            return Err(Misfit::Outside(*span));
        }
        let Some(kept) = text.get(done..range.start) else { return Err(Misfit::Overlap(*span)) };
        out.push_str(kept);
        out.push_str(new);
        done = range.end;
    }
    out.push_str(&text[done..]);
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    const FILE: FileId = FileId::new(3);

    fn edit(start: u32, end: u32, text: &str) -> Edit {
        Edit { span: Span { file: FILE, start, end }, text: text.into() }
    }

    #[test]
    fn edits_are_made_in_the_order_of_the_text() {
        let edits = [edit(6, 7, ""), edit(0, 1, "xy"), edit(3, 3, "<"), edit(3, 3, ">"), edit(7, 7, "!")];
        assert_eq!(apply(FILE, "aäcdef", &edits[..4]).as_deref(), Ok("xyä<>cde"));
        assert_eq!(apply(FILE, "abcdefg", &edits).as_deref(), Ok("xybc<>def!"));
        assert_eq!(apply(FILE, "", []).as_deref(), Ok(""));
        assert_eq!(apply(FILE, "", &[edit(0, 0, "a")]).as_deref(), Ok("a"));
    }

    #[test]
    fn neighbours_do_not_overlap() {
        assert_eq!(apply(FILE, "abc", &[edit(1, 2, "x"), edit(2, 3, "y"), edit(1, 1, "-")]).as_deref(), Ok("a-xy"));
    }

    #[test]
    fn what_does_not_fit_is_refused() {
        let refused = |edits: &[Edit]| apply(FILE, "aäb", edits).unwrap_err();
        let span = |start, end| Span { file: FILE, start, end };
        assert_eq!(refused(&[edit(0, 3, ""), edit(1, 4, "")]), Misfit::Overlap(span(1, 4)));
        assert_eq!(refused(&[edit(0, 3, ""), edit(1, 1, "x")]), Misfit::Overlap(span(1, 1)));
        assert_eq!(refused(&[edit(1, 2, "")]), Misfit::Outside(span(1, 2)), "within a character");
        assert_eq!(refused(&[edit(4, 5, "")]), Misfit::Outside(span(4, 5)));
        assert_eq!(refused(&[edit(3, 1, "")]), Misfit::Outside(span(3, 1)));
        let elsewhere = Span { file: FileId::new(0), start: 0, end: 1 };
        assert_eq!(refused(&[Edit { span: elsewhere, text: String::new() }]), Misfit::OtherText(elsewhere));
    }
}
