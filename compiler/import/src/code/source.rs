//! A text in a language of IEC 61131-3, and where in the file each part of it stands.
//!
//! In a file of text it is a range of the file. In XML it is put together from pieces: what stands between tags, in
//! CDATA sections, and references such as `&gt;`, which take more room in the file than in the text.

use grafc_diagnostics::{FileId, Span};
use std::ops::Range;

/// A part of a [`Source`] that lies in the file in one piece.
struct Piece {
    /// Where it begins in the text.
    at: usize,
    /// Where it lies in the file.
    start: usize,
    end: usize,
    /// Whether it is in the file letter by letter.
    verbatim: bool,
}

/// A text and its places.
pub struct Source {
    pub text: String,
    pieces: Vec<Piece>,
    /// The whole of it; where it has no letters, the element that it would be in.
    pub whole: Span,
}

impl Source {
    /// No text yet, of something in the file.
    pub fn empty(whole: Span) -> Self {
        Source { text: String::new(), pieces: Vec::new(), whole }
    }

    /// A range of the file.
    pub fn of_range(file: FileId, text: &str, range: Range<usize>) -> Self {
        let mut source = Source::empty(Span::new(file, range.start, range.end));
        source.push(&text[range.clone()], range.start);
        source
    }

    /// Adds what stands in the file letter by letter.
    pub fn push(&mut self, text: &str, start: usize) {
        let at = self.text.len();
        self.text.push_str(text);
        self.pieces.push(Piece { at, start, end: start + text.len(), verbatim: true });
    }

    /// Adds what a range of the file stands for.
    pub fn push_reference(&mut self, c: char, range: Range<usize>) {
        let at = self.text.len();
        self.text.push(c);
        self.pieces.push(Piece { at, start: range.start, end: range.end, verbatim: false });
    }

    /// Where a part of the text stands in the file.
    pub fn span(&self, range: Range<usize>) -> Span {
        let (Some(first), Some(last)) =
            (self.piece(range.start), self.piece(range.end.saturating_sub(1).max(range.start)))
        else {
            return self.whole;
        };
        let start = if first.verbatim { (first.start + (range.start - first.at)).min(first.end) } else { first.start };
        let end =
            if last.verbatim { (last.start + (range.end.saturating_sub(last.at))).min(last.end) } else { last.end };
        Span::new(self.whole.file, start, end.max(start))
    }

    fn piece(&self, at: usize) -> Option<&Piece> {
        let behind = self.pieces.partition_point(|piece| piece.at <= at);
        self.pieces.get(behind.checked_sub(1)?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_are_found_in_the_file() {
        // The file: `<p>a &gt; b</p>`.
        let mut source = Source::empty(Span::new(FileId::default(), 0, 15));
        source.push("a ", 3);
        source.push_reference('>', 5..9);
        source.push(" b", 9);
        assert_eq!(source.text, "a > b");
        let place = |range| source.span(range).range();
        assert_eq!([place(0..1), place(2..3), place(4..5), place(0..5)], [3..4, 5..9, 10..11, 3..11]);
        assert_eq!(Source::empty(Span::new(FileId::default(), 2, 4)).span(0..0).range(), 2..4);
    }
}
