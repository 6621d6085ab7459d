//! Lines and columns of byte offsets.
//!
//! Both count from 1, and columns count characters (Unicode scalar values). Lines end at a line feed; a carriage
//! return before it belongs to the line end. Looking a place up costs little even in a line of many megabytes, so
//! that a text with many faults is not quadratic.

use crate::{FileId, SourceFile, SourceMap, Span};
use std::collections::BTreeMap;
use std::ops::Range;

/// A place in a text.
#[derive(Clone, Copy, PartialEq, Eq, Debug, serde::Serialize)]
pub struct Position {
    /// From 1.
    pub line: usize,
    /// In characters, from 1.
    pub column: usize,
    /// From 0.
    pub byte: usize,
}

/// Characters are counted once per so many bytes.
const STRIDE: usize = 4096;

/// The lines of one text.
pub struct LineIndex<'a> {
    pub file: &'a SourceFile,
    /// The first byte of each line; never empty.
    starts: Vec<usize>,
    /// How many characters start before byte `i * STRIDE`.
    characters: Vec<usize>,
}

impl<'a> LineIndex<'a> {
    pub fn new(file: &'a SourceFile) -> Self {
        let bytes = file.text.as_bytes();
        let mut starts = vec![0];
        starts.extend(bytes.iter().enumerate().filter(|(_, b)| **b == b'\n').map(|(i, _)| i + 1));
        let mut characters = vec![0];
        let mut sum = 0;
        for chunk in bytes.chunks(STRIDE) {
            sum += count_characters(chunk);
            characters.push(sum);
        }
        LineIndex { file, starts, characters }
    }

    /// The bytes of a span, cut to the text and widened to whole characters.
    pub fn range(&self, span: Span) -> Range<usize> {
        let text = &self.file.text;
        let mut start = (span.start as usize).min(text.len());
        while !text.is_char_boundary(start) {
            start -= 1;
        }
        let mut end = (span.end as usize).clamp(start, text.len());
        while !text.is_char_boundary(end) {
            end += 1;
        }
        start..end
    }

    /// The line of a byte, from 0.
    pub fn line_of(&self, byte: usize) -> usize {
        self.starts.partition_point(|start| *start <= byte) - 1
    }

    /// The bytes of a line without its end; lines count from 0.
    pub fn line(&self, line: usize) -> Range<usize> {
        let start = self.starts[line];
        let end = self.starts.get(line + 1).copied().unwrap_or(self.file.text.len());
        let text = &self.file.text[start..end];
        let text = text.strip_suffix('\n').map_or(text, |text| text.strip_suffix('\r').unwrap_or(text));
        start..start + text.len()
    }

    /// Line and column of a byte.
    pub fn position(&self, byte: usize) -> Position {
        let line = self.line_of(byte);
        let column = self.characters_before(byte) - self.characters_before(self.starts[line]) + 1;
        Position { line: line + 1, column, byte }
    }

    fn characters_before(&self, byte: usize) -> usize {
        let stride = byte / STRIDE;
        self.characters[stride] + count_characters(&self.file.text.as_bytes()[stride * STRIDE..byte])
    }
}

fn count_characters(bytes: &[u8]) -> usize {
    bytes.iter().filter(|b| **b & 0xC0 != 0x80).count()
}

/// The lines of the texts that messages speak of, each counted once.
#[derive(Default)]
pub struct Indexes<'a> {
    files: BTreeMap<FileId, LineIndex<'a>>,
}

impl<'a> Indexes<'a> {
    pub fn get(&mut self, sources: &'a SourceMap, file: FileId) -> &LineIndex<'a> {
        self.files.entry(file).or_insert_with(|| LineIndex::new(sources.file(file)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(text: &str) -> SourceFile {
        SourceFile { name: "t".into(), text: text.into() }
    }

    #[test]
    fn columns_count_characters_and_crlf_is_one_line_end() {
        let file = file("шаг 1\r\n\tx\n");
        let index = LineIndex::new(&file);
        assert_eq!(index.position(7), Position { line: 1, column: 5, byte: 7 });
        assert_eq!(index.position(11), Position { line: 2, column: 2, byte: 11 });
        assert_eq!(index.position(13), Position { line: 3, column: 1, byte: 13 });
        assert_eq!(index.line(0), 0..8);
        assert_eq!(index.line(2), 13..13);
    }

    #[test]
    fn columns_are_right_on_both_sides_of_a_stride() {
        let file = file(&"ä".repeat(STRIDE));
        let index = LineIndex::new(&file);
        for character in [0, STRIDE / 2 - 1, STRIDE / 2, STRIDE / 2 + 1, STRIDE - 1, STRIDE] {
            assert_eq!(index.position(2 * character).column, character + 1);
        }
    }

    #[test]
    fn spans_are_cut_to_the_text_and_to_whole_characters() {
        let file = file("aä");
        let index = LineIndex::new(&file);
        let range = |start, end| index.range(Span { file: FileId(0), start, end });
        assert_eq!(range(2, 2), 1..3);
        assert_eq!(range(1, 2), 1..3);
        assert_eq!(range(90, 91), 3..3);
        assert_eq!(range(1, 0), 1..1);
    }
}
