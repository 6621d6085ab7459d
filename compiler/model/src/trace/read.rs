//! A stimulus trace, row by row and cell by cell.

use super::columns::bar;
use super::given::Given;
use super::row::Row;
use super::rows::Rows;
use super::said::{Kept, Said};
use crate::chart::Chart;
use crate::reaction::Stimulus;
use grafc_diagnostics::{Diagnostic, Diagnostics, Extract, FileId, Span};
use std::io::{self, Read};

/// Reads a stimulus trace. Every row gives a stimulus; a cell that cannot be read is reported and taken as empty.
pub fn parse_trace(file: FileId, text: &str, chart: &Chart) -> (Vec<Stimulus>, Diagnostics) {
    let mut stimuli = Vec::new();
    // Memory can be read.
    let Ok(mut rows) = Stimuli::new(file, text.as_bytes(), chart, Kept::Whole) else {
        return (stimuli, Diagnostics::new());
    };
    while let Ok(Some(stimulus)) = rows.next_row() {
        stimuli.push(stimulus);
    }
    (stimuli, rows.finish().0)
}

/// A stimulus trace that is read as it comes: what is kept of it is a row, and what is said. It ends at a column `|`,
/// behind which a test has what it expects.
pub struct Stimuli<'a, R> {
    rows: Rows<R>,
    said: Said,
    given: Given<'a>,
    /// So many cells has a row.
    width: usize,
    row: Row,
    is_over: bool,
}

impl<'a, R: Read> Stimuli<'a, R> {
    /// A trace of the inputs of a chart, whose header is read.
    ///
    /// # Errors
    /// The text cannot be read.
    pub fn new(file: FileId, text: R, chart: &'a Chart, kept: Kept) -> io::Result<Self> {
        let (mut rows, mut said, mut header) = (Rows::new(text)?, Said::new(file, kept), Row::default());
        let found = rows.header(&mut header, &mut said)?;
        let width = if found { header.len() } else { 0 };
        let given = Given::new(&mut said, &header, chart, bar(&header).unwrap_or(width).min(width));
        Ok(Stimuli { rows, said, given, width, row: Row::default(), is_over: !found })
    }

    /// Whether something was wrong so far.
    pub fn has_errors(&self) -> bool {
        self.said.has_errors()
    }

    /// Whether rows can say that the controller has restarted.
    pub fn has_restarts(&self) -> bool {
        self.given.has_restarts()
    }

    /// The stimulus of the next row, if there is one.
    ///
    /// # Errors
    /// The text cannot be read.
    pub fn next_row(&mut self) -> io::Result<Option<Stimulus>> {
        if self.is_over {
            return Ok(None);
        }
        let next = self.given.next(&mut self.rows, &mut self.row, &mut self.said, self.width)?;
        self.is_over = next.is_none();
        Ok(next.map(|(stimulus, _)| stimulus))
    }

    /// The places of the times of the latest row, and of the row before it.
    pub fn places(&mut self) -> (Span, Span) {
        let before = self.said.cell(&self.given.times.before, 0);
        (self.said.cell(&self.row, 0), before)
    }

    /// Says something else about the trace.
    pub fn say(&mut self, diagnostic: Diagnostic) {
        self.said.say(diagnostic);
    }

    /// Says what came of a run over the trace, which may be right all the same.
    pub fn came_of_it(&mut self, diagnostic: Diagnostic) {
        self.said.came_of_it(diagnostic);
    }

    /// All that was said, and the rows that it is about, if nobody has the text.
    pub fn finish(self) -> (Diagnostics, Extract) {
        self.said.finish()
    }
}
