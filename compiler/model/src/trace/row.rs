//! One row of the table that a trace is.

use std::io;
use std::ops::Range;

/// One row of the text. It can be read anew without memory of its own.
#[derive(Clone, Debug, Default)]
pub(super) struct Row {
    /// What the parser of CSV makes of it.
    pub cells: csv::StringRecord,
    /// As it stands in the text, without blank lines before it and its line end.
    pub text: String,
    /// Where that begins in the whole text.
    pub offset: u64,
    /// The number of its line, from 1.
    pub line: usize,
    /// What parts its cells.
    pub separator: u8,
}

impl Row {
    /// How many cells it has.
    pub fn len(&self) -> usize {
        self.cells.len()
    }

    /// A cell without the blanks around it.
    pub fn cell(&self, column: usize) -> &str {
        self.cells.get(column).unwrap_or_default().trim()
    }

    /// Whether one of its cells has this text.
    pub fn has(&self, text: &str) -> bool {
        self.cells.iter().any(|cell| cell.trim() == text)
    }

    /// Where its cells lie in its text, quotes included.
    pub fn ranges(&self) -> Vec<Range<usize>> {
        let bytes = self.text.as_bytes();
        let mut ranges = Vec::new();
        let (mut start, mut quoted) = (0, false);
        for (at, byte) in bytes.iter().enumerate() {
            // Only a cell that begins with a quote is quoted; within, two quotes close and open it again.
            if *byte == b'"' && bytes[start] == b'"' {
                quoted = !quoted;
            } else if *byte == self.separator && !quoted {
                ranges.push(start..at);
                start = at + 1;
            }
        }
        ranges.push(start..bytes.len());
        ranges
    }

    /// What is wrong with quotes, and where: one that is not closed, or something between a closing quote and the end of
    /// its cell, of which nobody knows whether it belongs to the value.
    pub fn misquoted(&self) -> Option<(Range<usize>, Misquoted)> {
        if !self.text.contains('"') {
            return None;
        }
        self.ranges().into_iter().find_map(|range| {
            let mut inner = self.text[range.clone()].strip_prefix('"')?;
            while let Some((_, behind)) = inner.split_once('"') {
                match behind.strip_prefix('"') {
                    // Two quotes are one of the value.
                    Some(rest) => inner = rest,
                    None if behind.trim().is_empty() => return None,
                    None => return Some((range.end - behind.len()..range.end, Misquoted::Behind)),
                }
            }
            Some((range, Misquoted::Open))
        })
    }

    /// Where a cell lies in its text; all of it, if there is no such cell.
    pub fn range(&self, column: usize) -> Range<usize> {
        self.ranges().get(column).cloned().unwrap_or(0..self.text.len())
    }
}

/// What is wrong with quotes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Misquoted {
    /// One is not closed.
    Open,
    /// Something is behind the closing one.
    Behind,
}

/// Why there is no further row.
#[derive(Debug)]
pub(super) enum Fault {
    /// The text cannot be read.
    Input(io::Error),
    /// A byte that is not of a text, behind what the row has before it.
    NotText(u8),
    /// A row is longer than rows are.
    TooLong,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_ends_with_its_quote() {
        let found = |text: &str| {
            let row = Row { text: text.to_owned(), separator: b',', ..Row::default() };
            row.misquoted().map(|(range, kind)| (text[range].to_owned(), kind))
        };
        for good in ["0,1", "0,\"1\"", "\"1\" ,2", "\"a\"\"b\",\"\"", "\"\"\"\"", "5\",6", "\"a,\nb\",1"] {
            assert_eq!(found(good), None, "{good}");
        }
        assert_eq!(found("0,\"1\"2,3"), Some(("2".to_owned(), Misquoted::Behind)));
        assert_eq!(found("\"a\"\"b\" c,3"), Some((" c".to_owned(), Misquoted::Behind)));
        assert_eq!(found("0,\"1"), Some(("\"1".to_owned(), Misquoted::Open)));
        assert_eq!(found("0,\"1\"\"\n7"), Some(("\"1\"\"\n7".to_owned(), Misquoted::Open)));
    }
}
