//! What is at hand of a text that is too long to be kept: the lines that messages are about.
//!
//! A trace may have any length; it is read once, row by row. A row that something is said about is put into the extract,
//! and spans are places in this. What is shown to people and tools, line, column and byte, is of the whole text again.

/// Pieces of a text, in the order in which they were put together.
#[derive(Clone, Debug, Default)]
pub struct Extract {
    text: String,
    /// In order of their places in the extract.
    pieces: Vec<Piece>,
}

/// One or more whole lines.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Piece {
    /// Where it begins in the extract.
    pub at: usize,
    /// Where it begins in the whole text.
    pub offset: u64,
    /// The number of its first line, from 1.
    pub line: usize,
}

impl Extract {
    /// Adds whole lines that begin at this byte and line of the whole text; where they begin in the extract.
    pub fn add(&mut self, lines: &str, offset: u64, line: usize) -> usize {
        if let Some(known) = self.pieces.iter().rev().find(|piece| piece.offset == offset) {
            return known.at;
        }
        let at = self.text.len();
        self.pieces.push(Piece { at, offset, line });
        self.text.push_str(lines);
        if !lines.ends_with('\n') {
            self.text.push('\n');
        }
        at
    }

    /// So many bytes it has.
    pub fn len(&self) -> usize {
        self.text.len()
    }

    /// Whether nothing is in it.
    pub fn is_empty(&self) -> bool {
        self.text.is_empty()
    }

    /// The text, and what tells where it is from.
    pub(crate) fn into_parts(mut self) -> (String, Extract) {
        (std::mem::take(&mut self.text), self)
    }

    /// The piece that a byte of the extract is in.
    pub(crate) fn around(&self, byte: usize) -> Option<Piece> {
        let behind = self.pieces.partition_point(|piece| piece.at <= byte);
        behind.checked_sub(1).map(|place| self.pieces[place])
    }

    /// The byte of the whole text that a byte of the extract is.
    pub(crate) fn offset(&self, byte: usize) -> usize {
        self.around(byte).map_or(byte, |piece| piece.offset as usize + (byte - piece.at))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Code, Diagnostic, Diagnostics, SourceMap, Span, render};
    use expect_test::expect;

    #[test]
    fn messages_give_the_places_of_the_whole_text() {
        let mut sources = SourceMap::new();
        let file = sources.add("long.csv", "");
        let mut extract = Extract::default();
        let header = extract.add("t_ms,a", 0, 1);
        let late = extract.add("90,x", 4_999_999_990, 700_000_000);
        assert_eq!(extract.add("90,x", 4_999_999_990, 700_000_000), late);
        let before = extract.add("80,1\r\n", 4_999_999_980, 699_999_999);
        let mut diagnostics = Diagnostics::new();
        diagnostics.push(
            Diagnostic::new(Code::E0603, Span::new(file, late + 3, late + 4), "`x` is no value")
                .also(Span::new(file, header + 5, header + 6), "of this")
                .also(Span::new(file, before, before + 2), "before"),
        );
        sources.show(file, extract);
        expect![[r#"
            error[E0603]: `x` is no value
                      ┌─ long.csv:700000000:4
                      │
                    1 │ t_ms,a
                      │      - of this
                      ·
            700000000 │ 90,x
                      │    ^
            699999999 │ 80,1
                      │ -- before

        "#]]
        .assert_eq(&render::human(&sources, &diagnostics, false));
        let position = sources.file(file).position(late + 3);
        assert_eq!((position.line, position.column, position.byte), (700_000_000, 4, 4_999_999_993));
    }
}
