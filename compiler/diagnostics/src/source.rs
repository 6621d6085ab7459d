//! Source texts and places in them.

use crate::extract::Extract;
use crate::lines::{EditorPosition, Lines, Position, Unit, ceiling, floor};
use std::fmt;
use std::num::NonZeroU32;
use std::ops::Range;
use std::sync::OnceLock;

/// A text that was handed to grafc: a chart or a trace.
///
/// Never 0 inside, so that a span that may be missing takes no more room than a span: trees and tables are full of them.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct FileId(NonZeroU32);

const _: () = assert!(size_of::<Option<Span>>() == size_of::<Span>());

impl FileId {
    /// The text of a number; they count from 0.
    pub const fn new(number: u32) -> Self {
        FileId(NonZeroU32::MIN.saturating_add(number))
    }

    fn index(self) -> usize {
        self.0.get() as usize - 1
    }
}

impl Default for FileId {
    /// The first text.
    fn default() -> Self {
        FileId::new(0)
    }
}

/// A half-open range of bytes in one source text.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct Span {
    /// The text that the range lies in.
    pub file: FileId,
    /// First byte.
    pub start: u32,
    /// One past the last byte.
    pub end: u32,
}

impl Span {
    /// The bytes `start..end` of `file`.
    pub fn new(file: FileId, start: usize, end: usize) -> Self {
        debug_assert!(start <= end, "a span starts before it ends");
        Span { file, start: start as u32, end: end as u32 }
    }

    /// The smallest span that holds both.
    pub fn to(self, other: Span) -> Span {
        debug_assert_eq!(self.file, other.file, "a span lies in one file");
        Span { file: self.file, start: self.start.min(other.start), end: self.end.max(other.end) }
    }

    /// The empty span before it.
    pub fn before(self) -> Span {
        Span { end: self.start, ..self }
    }

    /// The empty span behind it.
    pub fn behind(self) -> Span {
        Span { start: self.end, ..self }
    }

    /// Whether the other one lies in it.
    pub fn holds(self, other: Span) -> bool {
        self.file == other.file && self.start <= other.start && other.end <= self.end
    }

    /// The byte range, for slicing the text.
    pub fn range(self) -> Range<usize> {
        self.start as usize..self.end as usize
    }
}

impl fmt::Debug for Span {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}..{}", self.start, self.end)
    }
}

/// A source text and the name that messages call it by.
#[derive(Clone, Debug)]
pub struct SourceFile {
    /// What messages call the text: a path as the user gave it, or `<stdin>`.
    pub name: String,
    /// The text, or what is at hand of it.
    pub text: String,
    /// Made when a line is asked for.
    lines: OnceLock<Lines>,
    /// Where what is at hand lies in the whole, if it is not all of it.
    pieces: Extract,
}

impl SourceFile {
    /// A text and its name.
    pub fn new(name: impl Into<String>, text: impl Into<String>) -> Self {
        SourceFile { name: name.into(), text: text.into(), lines: OnceLock::new(), pieces: Extract::default() }
    }

    fn lines(&self) -> &Lines {
        self.lines.get_or_init(|| Lines::new(&self.text))
    }

    /// Line and column of a byte, as messages count them; and the byte, as the whole text has it.
    pub fn position(&self, byte: usize) -> Position {
        let position = self.lines().position(&self.text, byte);
        let line = self.line_number(position.line - 1);
        Position { line, byte: self.pieces.offset(position.byte), ..position }
    }

    /// What messages call a line of the text at hand; lines count from 0, their numbers from 1.
    pub fn line_number(&self, line: usize) -> usize {
        match self.pieces.around(self.lines().line(&self.text, line).start) {
            Some(piece) => piece.line + (line - self.line_of(piece.at)),
            None => line + 1,
        }
    }

    /// Line and column of a byte, as editors count them.
    pub fn place(&self, byte: usize, unit: Unit) -> EditorPosition {
        self.lines().place(&self.text, byte, unit)
    }

    /// The byte at a line and column, as editors count them.
    pub fn byte(&self, place: EditorPosition, unit: Unit) -> usize {
        self.lines().byte(&self.text, place, unit)
    }

    /// The line of a byte, from 0.
    pub fn line_of(&self, byte: usize) -> usize {
        self.lines().line_of(byte)
    }

    /// The bytes of a line without its end; lines count from 0.
    pub fn line(&self, line: usize) -> Range<usize> {
        self.lines().line(&self.text, line)
    }

    /// How many lines there are; behind a line feed at the end there is one more, which is empty.
    pub fn line_count(&self) -> usize {
        self.lines().count()
    }

    /// The bytes of a span, cut to the text and widened to whole characters.
    pub fn range(&self, span: Span) -> Range<usize> {
        let start = floor(&self.text, span.start as usize);
        start..ceiling(&self.text, (span.end as usize).max(start))
    }
}

/// All texts of one run of the compiler.
#[derive(Clone, Debug, Default)]
pub struct SourceMap {
    files: Vec<SourceFile>,
}

impl SourceMap {
    /// A map without texts.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a text; spans in it carry the id returned.
    pub fn add(&mut self, name: impl Into<String>, text: impl Into<String>) -> FileId {
        let id = FileId::new(self.files.len() as u32);
        self.files.push(SourceFile::new(name, text));
        id
    }

    /// Says what is at hand of a text that was added as an empty one: the spans in it are those of the extract.
    pub fn show(&mut self, id: FileId, extract: Extract) {
        let file = &mut self.files[id.index()];
        let (text, pieces) = extract.into_parts();
        *file = SourceFile { pieces, ..SourceFile::new(std::mem::take(&mut file.name), text) };
    }

    /// The text of an id that [`SourceMap::add`] returned.
    pub fn file(&self, id: FileId) -> &SourceFile {
        &self.files[id.index()]
    }

    /// The piece of text under a span.
    pub fn slice(&self, span: Span) -> &str {
        &self.file(span.file).text[span.range()]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spans_are_cut_to_the_text_and_to_whole_characters() {
        let file = SourceFile::new("t", "aä");
        let range = |start, end| file.range(Span { file: FileId::new(0), start, end });
        assert_eq!(range(2, 2), 1..3);
        assert_eq!(range(1, 2), 1..3);
        assert_eq!(range(90, 91), 3..3);
        assert_eq!(range(1, 0), 1..1);
    }
}
