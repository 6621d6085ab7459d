//! The table that a trace is: rows, cells and their places, one row after the other.
//!
//! The cells are parted by commas, or as spreadsheets part them where the comma is the decimal sign: by semicolons or
//! tabs. The header says which: the first of the three signs in it. A line `sep=;` before it, as such programs have it,
//! says nothing more.
//!
//! However long the table is, what is kept of it is a row, and what has been read ahead.

use super::input::{Input, LONGEST_ROW};
use super::row::{Fault, Row};
use super::said::Said;
use grafc_diagnostics::{Code, Diagnostic, Span};
use std::io::{self, Cursor, Read};

/// The rows of a text.
pub(super) struct Rows<R> {
    csv: csv::Reader<Input<io::Chain<Cursor<Vec<u8>>, R>>>,
    /// Where the bytes that the parser is given begin in the whole text.
    skipped: u64,
    separator: u8,
    lines: LineCount,
}

impl<R: Read> Rows<R> {
    /// The rows of what comes; it is read as far as the header, to see what parts the cells.
    pub fn new(mut text: R) -> io::Result<Self> {
        let mut head = Vec::new();
        let form = loop {
            let known = head.len();
            head.resize(known.max(4096) + known, 0);
            let read = read(&mut text, &mut head[known..])?;
            head.truncate(known + read);
            if let Some(form) = Form::of(&head, read == 0) {
                break form;
            }
            if head.len() > LONGEST_ROW {
                break Form { skipped: 0, line: 1, separator: b',' };
            }
        };
        head.drain(..form.skipped);
        let (skipped, separator) = (form.skipped as u64, form.separator);
        let mut builder = csv::ReaderBuilder::new();
        builder.has_headers(false).flexible(true).delimiter(separator).buffer_capacity(1 << 16);
        let csv = builder.from_reader(Input::new(Cursor::new(head).chain(text), skipped));
        Ok(Rows { csv, skipped, separator, lines: LineCount { line: form.line, behind_return: false } })
    }

    /// Reads the next row; whether there is one. A row with a fault has what stands before that.
    pub fn read(&mut self, row: &mut Row) -> Result<bool, Fault> {
        let start = self.skipped + self.csv.position().byte();
        self.csv.get_mut().forget(start);
        let read = self.csv.read_record(&mut row.cells);
        let end = match &read {
            Err(error) if error.is_io_error() => u64::MAX,
            Ok(_) | Err(_) => self.skipped + self.csv.position().byte(),
        };
        let bytes = self.csv.get_ref().part(start, end);
        let is_end = |byte: &u8| matches!(byte, b'\r' | b'\n');
        let (blank, rest) = bytes.split_at(bytes.iter().take_while(|byte| is_end(byte)).count());
        let own = match rest.iter().rposition(|byte| !is_end(byte)) {
            Some(last) => &rest[..=last],
            None => rest,
        };
        self.lines.pass(blank);
        (row.offset, row.line, row.separator) = (start + blank.len() as u64, self.lines.line, self.separator);
        self.lines.pass(rest);
        row.text.clear();
        let fault = match std::str::from_utf8(own) {
            Ok(text) => {
                row.text.push_str(text);
                None
            }
            Err(error) => {
                let (good, bad) = own.split_at(error.valid_up_to());
                row.text.push_str(&String::from_utf8_lossy(good));
                bad.first().map(|byte| Fault::NotText(*byte))
            }
        };
        match (read, fault) {
            (Err(_), _) if self.csv.get_ref().is_too_long => {
                // Its beginning is enough to find it.
                row.text = row.text.lines().next().unwrap_or_default().chars().take(80).collect();
                Err(Fault::TooLong)
            }
            (Err(error), fault) => Err(match error.into_kind() {
                csv::ErrorKind::Io(error) => Fault::Input(error),
                // Rows may differ in length, so that this is all that is left.
                kind => fault.unwrap_or_else(|| Fault::Input(io::Error::other(format!("{kind:?}")))),
            }),
            (Ok(is_there), None) => Ok(is_there),
            (Ok(_), Some(fault)) => Err(fault),
        }
    }
}

impl<R: Read> Rows<R> {
    /// Reads the header; whether there is one. An empty text is an error.
    pub fn header(&mut self, header: &mut Row, said: &mut Said) -> io::Result<bool> {
        match self.read(header) {
            Ok(true) => {
                said.quotes(header);
                Ok(true)
            }
            Ok(false) => {
                let empty = Diagnostic::new(Code::E0601, Span::new(said.file, 0, 0), "the trace is empty");
                said.error(empty.note("a trace begins with a header `t_ms,NAME,…`"));
                Ok(false)
            }
            Err(fault) => said.fault(header, fault).map(|()| false),
        }
    }

    /// Reads the next row; whether there is one. A fault in it is said.
    pub fn next(&mut self, row: &mut Row, said: &mut Said) -> io::Result<bool> {
        match self.read(row) {
            Ok(is_there) => Ok(is_there),
            Err(fault) => said.fault(row, fault).map(|()| false),
        }
    }
}

/// The same as `Read::read`, which may be interrupted for nothing.
fn read(text: &mut impl Read, buffer: &mut [u8]) -> io::Result<usize> {
    loop {
        match text.read(buffer) {
            Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
            done => return done,
        }
    }
}

/// What line a place is in.
struct LineCount {
    /// From 1.
    line: usize,
    /// Whether a carriage return is before it.
    behind_return: bool,
}

impl LineCount {
    fn pass(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            if byte == b'\r' || byte == b'\n' && !self.behind_return {
                self.line += 1;
            }
            self.behind_return = byte == b'\r';
        }
    }
}

/// What the beginning of a text says of it.
struct Form {
    /// So many bytes are before the header: a byte order mark, a line that says what parts the cells.
    skipped: usize,
    /// The line of the header.
    line: usize,
    separator: u8,
}

impl Form {
    /// What is said, if that is known yet.
    fn of(head: &[u8], is_all: bool) -> Option<Form> {
        const MARK: &[u8] = "\u{feff}".as_bytes();
        const HINT: &[u8] = b"sep=";
        let is_begun = |whole: &[u8], text: &[u8]| text.len() < whole.len() && whole.starts_with(text) && !is_all;
        if is_begun(MARK, head) {
            return None;
        }
        let mark = if head.starts_with(MARK) { MARK.len() } else { 0 };
        let text = &head[mark..];
        if is_begun(HINT, text) {
            return None;
        }
        let mut hint = 0;
        if text.starts_with(HINT) {
            let end = text.iter().position(|byte| *byte == b'\n').map(|at| at + 1);
            let line = &text[..end.or(is_all.then_some(text.len()))?];
            if matches!(line.trim_ascii_end(), b"sep=," | b"sep=;" | b"sep=") {
                hint = line.len();
            }
        }
        let separator = separator(&text[hint..]).or(is_all.then_some(b','))?;
        Some(Form { skipped: mark + hint, line: if hint > 0 { 2 } else { 1 }, separator })
    }
}

/// What parts the cells of a text, by its header; none if that is not all there.
fn separator(text: &[u8]) -> Option<u8> {
    let mut quoted = false;
    for byte in text.iter().skip_while(|byte| matches!(byte, b'\r' | b'\n')) {
        match byte {
            b'"' => quoted = !quoted,
            b',' | b';' | b'\t' if !quoted => return Some(*byte),
            b'\n' | b'\r' if !quoted => return Some(b','),
            _ => {}
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Gives one byte at a time.
    struct Slowly<'t>(&'t [u8]);

    impl Read for Slowly<'_> {
        fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
            let Some((first, rest)) = self.0.split_first() else { return Ok(0) };
            buffer[0] = *first;
            self.0 = rest;
            Ok(1)
        }
    }

    /// Line, byte, text and cells of each row.
    fn rows(text: &[u8], slowly: bool) -> Vec<(usize, u64, String, Vec<String>)> {
        let input: Box<dyn Read + '_> = if slowly { Box::new(Slowly(text)) } else { Box::new(text) };
        let mut rows = Rows::new(input).expect("memory can be read");
        let (mut found, mut row) = (Vec::new(), Row::default());
        while rows.read(&mut row).expect("a text") {
            let cells: Vec<String> = (0..row.len()).map(|column| row.cell(column).to_owned()).collect();
            assert_eq!(row.ranges().len(), cells.len());
            found.push((row.line, row.offset, row.text.clone(), cells));
        }
        found
    }

    #[test]
    fn rows_know_where_they_are() {
        let text = "\u{feff}sep=;\r\n\r\na;\"b\n;\"\"x\"\n\n 1 ;2\r\r3;4\r\n";
        let row = |line, offset, text: &str, cells: [&str; 2]| {
            (line, offset, text.to_owned(), cells.map(str::to_owned).to_vec())
        };
        let expected = [
            row(3, 12, "a;\"b\n;\"\"x\"", ["a", "b\n;\"x"]),
            row(6, 24, " 1 ;2", ["1", "2"]),
            row(8, 31, "3;4", ["3", "4"]),
        ];
        assert_eq!(rows(text.as_bytes(), false), expected);
        assert_eq!(rows(text.as_bytes(), true), expected);
    }

    #[test]
    fn what_is_no_text_has_a_place() {
        let mut rows = Rows::new(&b"t_ms,a\n0,1\n1,\xFFx\n"[..]).expect("memory can be read");
        let mut row = Row::default();
        assert!(rows.read(&mut row).is_ok_and(|is_there| is_there) && rows.read(&mut row).is_ok());
        assert!(matches!(rows.read(&mut row), Err(Fault::NotText(0xFF))));
        assert_eq!((row.line, row.offset, row.text.as_str()), (3, 11, "1,"));
    }

    #[test]
    fn a_quote_that_is_not_closed_does_not_take_the_whole_text_into_memory() {
        let text = b"t_ms,a\n0,1\n1,\"0\n".iter().copied().chain(std::iter::repeat_n(b'x', 4 * LONGEST_ROW));
        let mut rows = Rows::new(io::Cursor::new(text.collect::<Vec<u8>>())).expect("memory can be read");
        let mut row = Row::default();
        assert!(rows.read(&mut row).is_ok() && rows.read(&mut row).is_ok());
        assert!(matches!(rows.read(&mut row), Err(Fault::TooLong)));
        assert_eq!((row.line, row.text.as_str()), (3, "1,\"0"));
    }
}
