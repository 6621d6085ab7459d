//! Lines and columns of byte offsets, and back.
//!
//! Messages count both from 1, and columns in characters (Unicode scalar values); a language server counts from 0, and
//! columns in bytes or in units of UTF-16, as its client likes. Lines end at a line feed; a carriage return before it
//! belongs to the line end, and no place lies behind it on that line.
//!
//! The table is made once a text. Looking a place up costs a search among the lines and the reading of at most a stride
//! of text, also in a line of many megabytes, so that a text with many faults is not quadratic. Whatever is asked, the
//! answer lies in the text and between two characters: places come from editors, which may be a keystroke behind.

use std::ops::Range;

/// A place in a text, as messages give it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "json", derive(serde::Serialize))]
pub struct Position {
    /// From 1.
    pub line: usize,
    /// In characters, from 1.
    pub column: usize,
    /// From 0.
    pub byte: usize,
}

/// A place in a text, as editors give it: line and column from 0.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default)]
pub struct EditorPosition {
    /// The line.
    pub line: u32,
    /// So many units of the line are before it.
    pub column: u32,
}

/// What columns are counted in.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Unit {
    /// Bytes of UTF-8.
    Utf8,
    /// Units of UTF-16: a character beyond U+FFFF is two.
    Utf16,
    /// Characters.
    Characters,
}

/// Characters are counted once per so many bytes.
const STRIDE: usize = 1024;

/// What comes before a place, in each unit but bytes.
#[derive(Clone, Copy, Default)]
struct Sums {
    characters: usize,
    utf16: usize,
}

/// The lines of a text, which is given with each question.
#[derive(Clone, Debug)]
pub(crate) struct Lines {
    /// The first byte of each line; never empty.
    starts: Vec<u32>,
    /// The characters and units of UTF-16 that start before byte `i * STRIDE`; none if there are as many as bytes.
    sums: Vec<(u32, u32)>,
}

impl Lines {
    pub(crate) fn new(text: &str) -> Self {
        let bytes = text.as_bytes();
        let mut starts = vec![0];
        starts.extend(bytes.iter().enumerate().filter(|(_, b)| **b == b'\n').map(|(i, _)| i as u32 + 1));
        let mut sums = Vec::new();
        if !text.is_ascii() {
            let mut sum = Sums::default();
            sums.push((0, 0));
            for chunk in bytes.chunks(STRIDE) {
                sum.add(chunk);
                sums.push((sum.characters as u32, sum.utf16 as u32));
            }
        }
        Lines { starts, sums }
    }

    /// How many lines there are; the last one may be empty.
    pub(crate) fn count(&self) -> usize {
        self.starts.len()
    }

    /// The line of a byte, from 0.
    pub(crate) fn line_of(&self, byte: usize) -> usize {
        self.starts.partition_point(|start| *start as usize <= byte) - 1
    }

    /// The bytes of a line without its end; lines count from 0. A line that there is not is empty, at the end.
    pub(crate) fn line(&self, text: &str, line: usize) -> Range<usize> {
        let start = self.starts.get(line).map_or(text.len(), |start| floor(text, *start as usize));
        let end = self.starts.get(line + 1).map_or(text.len(), |start| floor(text, *start as usize));
        let line = &text[start..end];
        let line = line.strip_suffix('\n').map_or(line, |line| line.strip_suffix('\r').unwrap_or(line));
        start..start + line.len()
    }

    /// Line and column of a byte.
    pub(crate) fn position(&self, text: &str, byte: usize) -> Position {
        let byte = floor(text, byte);
        let line = self.line_of(byte);
        let start = self.starts[line] as usize;
        let column = self.before(text, byte).since(self.before(text, start)).characters + 1;
        Position { line: line + 1, column, byte }
    }

    /// Line and column of a byte, in a unit; within a line end they are those of the end of the line.
    pub(crate) fn place(&self, text: &str, byte: usize, unit: Unit) -> EditorPosition {
        let byte = floor(text, byte);
        let line = self.line_of(byte);
        let range = self.line(text, line);
        let byte = byte.min(range.end);
        let column = match unit {
            Unit::Utf8 => byte - range.start,
            Unit::Utf16 => self.before(text, byte).since(self.before(text, range.start)).utf16,
            Unit::Characters => self.before(text, byte).since(self.before(text, range.start)).characters,
        };
        EditorPosition { line: line as u32, column: column as u32 }
    }

    /// The byte at a place: that of the character which the place lies in, at most the end of its line or of the text.
    pub(crate) fn byte(&self, text: &str, place: EditorPosition, unit: Unit) -> usize {
        let range = self.line(text, place.line as usize);
        let column = place.column as usize;
        let (total, of): (usize, fn(Sums) -> usize) = match unit {
            Unit::Utf8 => return floor(text, range.start.saturating_add(column).min(range.end)),
            Unit::Utf16 => (self.before(text, range.start).utf16 + column, |sums| sums.utf16),
            Unit::Characters => (self.before(text, range.start).characters + column, |sums| sums.characters),
        };
        if self.sums.is_empty() {
            return floor(text, total.min(range.end));
        }
        // The last stride that begins at or before the place; in it, the characters are counted one by one.
        let stride = self.sums.partition_point(|&sums| of(sums.into()) <= total) - 1;
        let mut at = ceiling(text, stride * STRIDE).max(range.start);
        let mut left = total.saturating_sub(of(self.before(text, at)));
        for character in text[at..range.end.max(at)].chars() {
            let units = if unit == Unit::Utf16 { character.len_utf16() } else { 1 };
            if units > left {
                break;
            }
            left -= units;
            at += character.len_utf8();
        }
        at.min(range.end)
    }

    fn before(&self, text: &str, byte: usize) -> Sums {
        let Some(&sums) = self.sums.get(byte / STRIDE) else { return Sums { characters: byte, utf16: byte } };
        let mut sums = Sums::from(sums);
        sums.add(&text.as_bytes()[byte / STRIDE * STRIDE..byte]);
        sums
    }
}

impl Sums {
    /// Counts what starts in a piece of UTF-8.
    fn add(&mut self, bytes: &[u8]) {
        let starting = bytes.iter().filter(|b| **b & 0xC0 != 0x80).count();
        self.characters += starting;
        // Four bytes of UTF-8 are two units of UTF-16.
        self.utf16 += starting + bytes.iter().filter(|b| **b >= 0xF0).count();
    }

    /// What lies between two places of a text, if the table is its own.
    fn since(self, earlier: Sums) -> Sums {
        Sums {
            characters: self.characters.saturating_sub(earlier.characters),
            utf16: self.utf16.saturating_sub(earlier.utf16),
        }
    }
}

impl From<(u32, u32)> for Sums {
    fn from((characters, utf16): (u32, u32)) -> Self {
        Sums { characters: characters as usize, utf16: utf16 as usize }
    }
}

/// The nearest place between two characters at or before a byte.
pub(crate) fn floor(text: &str, byte: usize) -> usize {
    let mut byte = byte.min(text.len());
    while !text.is_char_boundary(byte) {
        byte -= 1;
    }
    byte
}

/// The nearest place between two characters at or after a byte.
pub(crate) fn ceiling(text: &str, byte: usize) -> usize {
    let mut byte = byte.min(text.len());
    while !text.is_char_boundary(byte) {
        byte += 1;
    }
    byte
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(line: u32, column: u32) -> EditorPosition {
        EditorPosition { line, column }
    }

    #[test]
    fn columns_count_characters_and_crlf_is_one_line_end() {
        let text = "шаг 1\r\n\tx\n";
        let lines = Lines::new(text);
        assert_eq!(lines.position(text, 7), Position { line: 1, column: 5, byte: 7 });
        assert_eq!(lines.position(text, 11), Position { line: 2, column: 2, byte: 11 });
        assert_eq!(lines.position(text, 13), Position { line: 3, column: 1, byte: 13 });
        assert_eq!(lines.line(text, 0), 0..8);
        assert_eq!(lines.line(text, 2), 13..13);
        assert_eq!(lines.count(), 3);
    }

    #[test]
    fn columns_are_right_on_both_sides_of_a_stride() {
        // Two bytes, one unit; and four bytes, two units.
        for (character, units) in [("ä", 1), ("😀", 2)] {
            let (text, size) = (character.repeat(STRIDE), character.len());
            let lines = Lines::new(&text);
            let at_stride = STRIDE / size;
            for n in [0, at_stride - 1, at_stride, at_stride + 1, 2 * at_stride - 1, STRIDE - 1, STRIDE] {
                assert_eq!(lines.position(&text, size * n).column, n + 1);
                let places = [(Unit::Utf8, size * n), (Unit::Utf16, units * n), (Unit::Characters, n)];
                for (unit, column) in places {
                    assert_eq!(lines.place(&text, size * n, unit), at(0, column as u32), "{n} {unit:?}");
                    assert_eq!(lines.byte(&text, at(0, column as u32), unit), size * n, "{n} {unit:?}");
                }
            }
        }
    }

    /// `a`, an umlaut of two bytes, a face of four; a line end of two characters; a line without an end.
    const MIXED: &str = "aä😀b\r\n\n€x";

    #[test]
    fn places_in_each_unit() {
        let lines = Lines::new(MIXED);
        // Byte, line, and the column in bytes, in units of UTF-16, in characters.
        for (byte, line, columns) in [
            (0, 0, [0, 0, 0]),
            (1, 0, [1, 1, 1]),
            (3, 0, [3, 2, 2]),
            (7, 0, [7, 4, 3]),
            (8, 0, [8, 5, 4]),
            (10, 1, [0, 0, 0]),
            (11, 2, [0, 0, 0]),
            (14, 2, [3, 1, 1]),
            (15, 2, [4, 2, 2]),
        ] {
            for (unit, column) in [Unit::Utf8, Unit::Utf16, Unit::Characters].into_iter().zip(columns) {
                assert_eq!(lines.place(MIXED, byte, unit), at(line, column), "{byte} {unit:?}");
                assert_eq!(lines.byte(MIXED, at(line, column), unit), byte, "{byte} {unit:?}");
            }
        }
    }

    #[test]
    fn places_that_are_none_are_moved_to_the_nearest_before() {
        let lines = Lines::new(MIXED);
        assert_eq!(lines.place(MIXED, 2, Unit::Utf16), at(0, 1), "within a character");
        assert_eq!(lines.place(MIXED, 9, Unit::Utf16), at(0, 5), "between carriage return and line feed");
        assert_eq!(lines.place(MIXED, 99, Unit::Utf16), at(2, 2), "behind the text");
        assert_eq!(lines.byte(MIXED, at(0, 3), Unit::Utf16), 3, "within a pair of surrogates");
        assert_eq!(lines.byte(MIXED, at(0, 5), Unit::Utf8), 3, "within a character");
        assert_eq!(lines.byte(MIXED, at(0, 99), Unit::Utf16), 8, "behind the line");
        assert_eq!(lines.byte(MIXED, at(1, 7), Unit::Characters), 10, "behind an empty line");
        for unit in [Unit::Utf8, Unit::Utf16, Unit::Characters] {
            assert_eq!(lines.byte(MIXED, at(2, u32::MAX), unit), 15);
            assert_eq!(lines.byte(MIXED, at(3, 0), unit), 15, "behind the last line");
            assert_eq!(lines.byte(MIXED, at(u32::MAX, u32::MAX), unit), 15);
        }
    }

    #[test]
    fn a_text_of_one_byte_a_character() {
        let text = "ab\ncd\n";
        let lines = Lines::new(text);
        for unit in [Unit::Utf8, Unit::Utf16, Unit::Characters] {
            assert_eq!(lines.place(text, 4, unit), at(1, 1));
            assert_eq!(lines.byte(text, at(1, 1), unit), 4);
            assert_eq!(lines.byte(text, at(1, 9), unit), 5);
            assert_eq!(lines.byte(text, at(2, 0), unit), 6);
            assert_eq!(Lines::new("").byte("", at(0, 1), unit), 0);
            assert_eq!(Lines::new("").place("", 1, unit), at(0, 0));
        }
    }

    #[test]
    fn a_table_of_another_text_does_no_harm() {
        let lines = Lines::new(&MIXED.repeat(400));
        for text in ["", "ä", "a\nb", &"😀".repeat(300)] {
            for line in [0, 1, 2, 900] {
                for column in [0, 1, 5000] {
                    for unit in [Unit::Utf8, Unit::Utf16, Unit::Characters] {
                        assert!(text.is_char_boundary(lines.byte(text, at(line, column), unit)));
                    }
                }
            }
        }
    }
}
