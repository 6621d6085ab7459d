//! What is said about the rows of a trace: so many errors, and how many more there are.
//!
//! A text that somebody else keeps has its places in that text. Of one that nobody keeps, the rows that something is said
//! about are kept here.

use super::input::LONGEST_ROW;
use super::row::{Fault, Misquoted, Row};
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, Extract, FileId, Severity, Span, render};
use std::io;
use std::ops::Range;

/// So many errors of a trace are told; others are counted.
pub const MOST_ERRORS: usize = 50;
/// Nor are more told, once the rows that they show are as long as this together.
const MOST_SHOWN: usize = 4 * LONGEST_ROW;

/// Messages about a text.
pub(super) struct Said {
    pub file: FileId,
    diagnostics: Diagnostics,
    /// The rows that messages are about, unless the whole text is kept.
    extract: Option<Extract>,
    errors: usize,
    misfits: Misfits,
}

/// Rows that do not fit the header, while none has fit: as many cells in each, so that it is the header that is wrong.
#[derive(Default)]
struct Misfits {
    /// The cells of each, if there are such rows.
    cells: Option<usize>,
    /// The place of the message about the first among the messages, if it is told.
    told: Option<usize>,
    /// So many follow it.
    more: usize,
    /// Whether that has ended: a row fits, or has another number of cells.
    is_over: bool,
}

/// Who has the text of a trace.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Kept {
    /// The caller: places are those in the text.
    Whole,
    /// Nobody: places are those in the extract that the messages come with.
    Rows,
}

impl Said {
    pub fn new(file: FileId, kept: Kept) -> Self {
        let extract = match kept {
            Kept::Whole => None,
            Kept::Rows => Some(Extract::default()),
        };
        Said { file, diagnostics: Diagnostics::new(), extract, errors: 0, misfits: Misfits::default() }
    }

    /// Whether there is an error.
    pub fn has_errors(&self) -> bool {
        self.errors > 0
    }

    /// How many errors there are, those included that are not told.
    pub fn errors(&self) -> usize {
        self.errors
    }

    /// A part of a row as a place; none that counts if nothing more is told.
    pub fn place(&mut self, row: &Row, part: Range<usize>) -> Span {
        if self.is_full() {
            return Span::new(self.file, 0, 0);
        }
        let start = match &mut self.extract {
            Some(extract) => extract.add(&row.text, row.offset, row.line),
            None => row.offset as usize,
        };
        Span::new(self.file, start + part.start, start + part.end)
    }

    /// The place of a cell.
    pub fn cell(&mut self, row: &Row, column: usize) -> Span {
        if self.is_full() { Span::new(self.file, 0, 0) } else { self.place(row, row.range(column)) }
    }

    /// Says that something is wrong.
    pub fn error(&mut self, error: Diagnostic) {
        if self.is_full() {
            self.diagnostics.leave_out(1);
        } else {
            self.diagnostics.push(error);
        }
        self.errors += 1;
    }

    /// Says what came of a run over the text, which may be right all the same.
    pub fn came_of_it(&mut self, diagnostic: Diagnostic) {
        self.diagnostics.push(diagnostic);
    }

    /// Says something: all that is no error, however much there is of it.
    pub fn say(&mut self, diagnostic: Diagnostic) {
        match diagnostic.severity() {
            Severity::Error => self.error(diagnostic),
            Severity::Warning => self.diagnostics.push(diagnostic),
        }
    }

    /// Says that a cell has no value that it can have.
    pub fn bad_value(&mut self, row: &Row, column: usize, message: String, expected: &str) {
        let place = self.cell(row, column);
        self.error(Diagnostic::new(Code::E0603, place, message).here(format!("expected {expected}")));
    }

    /// Whether a row can be read: what is quoted ends with its quote, and there are as many cells as in the header. If not,
    /// that is an error; rows that all differ from the header in the same way are told once.
    pub fn fits(&mut self, row: &Row, columns: usize) -> bool {
        if !self.quotes(row) {
            self.misfits.is_over = true;
            return false;
        }
        let cells = row.len();
        let misfits = &mut self.misfits;
        misfits.is_over |= cells == columns || misfits.cells.is_some_and(|known| known != cells);
        if cells == columns {
            return true;
        }
        if !misfits.is_over && misfits.cells.is_some() {
            misfits.more += 1;
            self.errors += 1;
            return false;
        }
        let what = if cells == 1 { "1 cell".to_string() } else { format!("{cells} cells") };
        let place = self.place(row, 0..row.text.len());
        let error = Diagnostic::new(Code::E0601, place, format!("the row has {what}, the header has {columns}"))
            .help("give each row a cell for each column of the header; an empty one keeps the value before it");
        if !self.misfits.is_over {
            self.misfits.cells = Some(cells);
            self.misfits.told = (!self.is_full()).then(|| self.diagnostics.iter().len());
        }
        self.error(error);
        false
    }

    /// Whether what is quoted in a row ends with its quote; if not, that is an error.
    pub fn quotes(&mut self, row: &Row) -> bool {
        let Some((part, wrong)) = row.misquoted() else { return true };
        let place = self.place(row, part);
        let (message, help) = match wrong {
            Misquoted::Open => ("a quote is not closed", "close it with `\"`, or leave it out"),
            Misquoted::Behind => {
                ("there is something behind the closing quote", "put all of the cell in quotes, or none of it")
            }
        };
        self.error(Diagnostic::new(Code::E0601, place, message).help(help));
        false
    }

    /// Says why a row cannot be read, unless that is not the fault of the text.
    pub fn fault(&mut self, row: &mut Row, fault: Fault) -> io::Result<()> {
        let error = match fault {
            Fault::Input(error) => return Err(error),
            Fault::NotText(byte) => {
                let at = row.text.len();
                row.text.push(char::REPLACEMENT_CHARACTER);
                let place = self.place(row, at..row.text.len());
                let message = format!("byte 0x{byte:02X} at offset {} is not UTF-8", row.offset + at as u64);
                Diagnostic::new(Code::E0110, place, message).help("save the file as UTF-8")
            }
            Fault::TooLong => {
                let message = format!("the row is longer than {} MiB", LONGEST_ROW >> 20);
                Diagnostic::new(Code::E0601, self.place(row, 0..row.text.len()), message)
                    .help("perhaps a quote is not closed")
            }
        };
        self.error(error);
        Ok(())
    }

    /// All that was said, and the rows that it is about.
    pub fn finish(mut self) -> (Diagnostics, Extract) {
        let Misfits { told, more, .. } = self.misfits;
        if let Some(first) = told.and_then(|place| self.diagnostics.iter_mut().nth(place)).filter(|_| more > 0) {
            let rows = if more == 1 {
                "the row after it is".to_string()
            } else {
                format!("the {} rows after it are", render::grouped(more))
            };
            first.notes.push(format!("{rows} like this: perhaps it is the header that is wrong"));
        }
        let more = self.diagnostics.left_out();
        if let Some(last) = self.diagnostics.iter_mut().last().filter(|_| more > 0) {
            let errors = if more == 1 { "error" } else { "errors" };
            last.notes.push(format!("and {} more {errors} in this table", render::grouped(more)));
        }
        (self.diagnostics, self.extract.unwrap_or_default())
    }

    fn is_full(&self) -> bool {
        self.errors >= MOST_ERRORS || self.extract.as_ref().is_some_and(|extract| extract.len() > MOST_SHOWN)
    }
}
