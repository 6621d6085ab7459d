//! The table that a trace is: records, cells and their places.
//!
//! The cells are parted by commas, or as spreadsheets part them where the comma is the decimal sign: by semicolons or
//! tabs. The header says which: the first of the three signs in it. A line `sep=;` before it, as such programs have it,
//! says nothing more.

use grafc_diagnostics::{Code, Diagnostic, Diagnostics, FileId, Span};
use std::ops::Range;

/// One record of the text.
pub(super) struct Record {
    cells: csv::StringRecord,
    spans: Vec<Span>,
}

impl Record {
    /// How many cells it has.
    pub fn len(&self) -> usize {
        self.cells.len()
    }

    /// A cell without the blanks around it, and its place.
    pub fn cell(&self, column: usize) -> (&str, Span) {
        (self.cells.get(column).unwrap_or_default().trim(), self.spans.get(column).copied().unwrap_or(self.span()))
    }

    /// Whether one of its cells has this text.
    pub fn has(&self, text: &str) -> bool {
        self.cells.iter().any(|cell| cell.trim() == text)
    }

    fn span(&self) -> Span {
        match self.spans[..] {
            [] => Span::default(),
            [only] => only,
            [first, .., last] => first.to(last),
        }
    }
}

pub(super) struct Reader {
    pub file: FileId,
    pub diagnostics: Diagnostics,
}

impl Reader {
    /// The header and the other records; an empty text is reported.
    pub fn table(&mut self, text: &str) -> Option<(Record, Vec<Record>)> {
        let mut records = self.records(text).into_iter();
        let Some(header) = records.next() else {
            let place = Span::new(self.file, 0, 0);
            let diagnostic = Diagnostic::new(Code::E0601, place, "the trace is empty");
            self.diagnostics.push(diagnostic.note("a trace begins with a header `t_ms,NAME,…`"));
            return None;
        };
        Some((header, records.collect()))
    }

    /// Whether a record has as many cells as the header; if not, it is reported.
    pub fn fits(&mut self, record: &Record, header: &Record) -> bool {
        let (cells, columns) = (record.len(), header.len());
        if cells != columns {
            let message = format!("the row has {}, the header has {columns}", count(cells));
            self.diagnostics.push(Diagnostic::new(Code::E0601, record.span(), message));
        }
        cells == columns
    }

    /// The records of the text with the places of their cells.
    fn records(&mut self, text: &str) -> Vec<Record> {
        let mark = if text.starts_with('\u{feff}') { '\u{feff}'.len_utf8() } else { 0 };
        let skipped = mark + hint(&text[mark..]);
        let text = &text[skipped..];
        let separator = separator(text);
        let mut builder = csv::ReaderBuilder::new();
        builder.has_headers(false).flexible(true).delimiter(separator);
        let mut reader = builder.from_reader(text.as_bytes());
        let mut records = Vec::new();
        loop {
            let mut cells = csv::StringRecord::new();
            let start = reader.position().byte() as usize;
            match reader.read_record(&mut cells) {
                Ok(true) => {
                    let end = reader.position().byte() as usize;
                    let spans = cell_ranges(text, start..end, separator)
                        .into_iter()
                        .map(|range| Span::new(self.file, range.start + skipped, range.end + skipped))
                        .collect();
                    records.push(Record { cells, spans });
                }
                Ok(false) => return records,
                // A text is UTF-8 and rows may differ in length, which leaves nothing that we know of.
                Err(error) => {
                    let place = Span::new(self.file, start + skipped, start + skipped);
                    self.diagnostics.push(Diagnostic::new(
                        Code::E0601,
                        place,
                        format!("the row is not valid CSV: {error}"),
                    ));
                    return records;
                }
            }
        }
    }
}

fn count(cells: usize) -> String {
    if cells == 1 { "1 cell".to_string() } else { format!("{cells} cells") }
}

/// What parts the cells of a text, by its header.
fn separator(text: &str) -> u8 {
    let mut quoted = false;
    for byte in text.trim_start_matches(['\r', '\n']).bytes() {
        match byte {
            b'"' => quoted = !quoted,
            b',' | b';' | b'\t' if !quoted => return byte,
            b'\n' | b'\r' if !quoted => break,
            _ => {}
        }
    }
    b','
}

/// How long the line is that tells a spreadsheet the separator, if the text begins with one.
fn hint(text: &str) -> usize {
    let line = text.split_inclusive('\n').next().unwrap_or_default();
    let is_hint = line.trim_end().strip_prefix("sep=").is_some_and(|sign| matches!(sign, "," | ";" | "\t" | ""));
    if is_hint { line.len() } else { 0 }
}

/// Where the cells of one record lie, quotes included. The record may be preceded by blank lines.
fn cell_ranges(text: &str, record: Range<usize>, separator: u8) -> Vec<Range<usize>> {
    let bytes = text.as_bytes();
    let is_end = |byte: u8| byte == b'\n' || byte == b'\r';
    let first = record.clone().find(|&at| !is_end(bytes[at])).unwrap_or(record.end);
    let mut ranges = Vec::new();
    let mut start = first;
    let mut quoted = false;
    let mut at = first;
    while at < record.end {
        match bytes[at] {
            // Only a cell that begins with a quote is quoted; within, two quotes close and open it again.
            b'"' if bytes[start] == b'"' => quoted = !quoted,
            byte if byte == separator && !quoted => {
                ranges.push(start..at);
                start = at + 1;
            }
            byte if is_end(byte) && !quoted => break,
            _ => {}
        }
        at += 1;
    }
    ranges.push(start..at);
    ranges
}
