//! A result recorded elsewhere beside what the chart does: the first row that differs, in the words of the chart.
//!
//! A recording has the form of a result. It may lack columns, and have those of inputs, which are not looked at. Its rows
//! belong to calls by their times: the n-th row of a time to the n-th call at that time, and a row at a time without a
//! call to what the latest call before it showed.
//!
//! It is read beside the run, row by row.

use super::columns::{FLAGS, RESTART, SITUATION, TIME, columns, unknown};
use super::results::{About, Results, Saying, own_columns};
use super::row::Row;
use super::rows::Rows;
use super::said::{Kept, Said};
use super::times::Times;
use crate::chart::{Chart, StepId, Variable, VariableKind};
use crate::reaction::{Response, Stimulus};
use crate::resolve::suggest::Suggestions;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, Extract, FileId, Span};
use std::collections::BTreeMap;
use std::io::{self, Read};

/// Compares a recording with the responses to stimuli: how many rows it has, and what is wrong with it. Only the first
/// row that differs is reported.
pub fn compare_trace(
    file: FileId,
    text: &str,
    chart: &Chart,
    stimuli: &[Stimulus],
    responses: &[Response],
) -> (u64, Diagnostics) {
    // Memory can be read.
    let compared = || -> io::Result<(u64, Diagnostics, Extract)> {
        let mut recording = Recording::new(file, text.as_bytes(), chart, Kept::Whole)?;
        for (stimulus, response) in stimuli.iter().zip(responses) {
            recording.called(stimulus.t_ms, response)?;
        }
        recording.finish()
    };
    compared().map_or((0, Diagnostics::new()), |(rows, diagnostics, _)| (rows, diagnostics))
}

#[derive(Clone, Copy)]
enum Column {
    Time,
    /// Something that is compared.
    Compared(About),
    /// An input, or what has been reported.
    Skipped,
}

/// What a row says.
#[derive(Default)]
struct RecordedRow {
    t_ms: i64,
    /// For each column that is compared, what was recorded: of an output the latest value, since an empty cell keeps it.
    cells: Vec<Option<Saying>>,
}

/// A recording that is read as far as the run has come.
pub struct Recording<'a, R> {
    rows: Rows<R>,
    said: Said,
    results: Results<'a>,
    columns: Vec<Column>,
    times: Times,
    row: Row,
    recorded: RecordedRow,
    /// Whether `recorded` has still to be compared.
    is_waiting: bool,
    is_over: bool,
    /// What the latest call came to.
    shown: Option<Response>,
    /// What the header says; where there is nothing to compare, it is shown.
    header: Row,
    /// Whether a value was compared.
    has_compared: bool,
    /// The first row that differs; it is told if nothing is wrong with the recording.
    difference: Option<Diagnostic>,
    count: u64,
}

impl<'a, R: Read> Recording<'a, R> {
    /// A recording of a chart, whose header is read.
    ///
    /// # Errors
    /// The text cannot be read.
    pub fn new(file: FileId, text: R, chart: &'a Chart, kept: Kept) -> io::Result<Self> {
        let results = Results::new(chart);
        let (mut rows, mut said, mut header) = (Rows::new(text)?, Said::new(file, kept), Row::default());
        let found = rows.header(&mut header, &mut said)?;
        let columns = if found { roles(&mut said, &header, &results) } else { Vec::new() };
        let recorded = RecordedRow { t_ms: 0, cells: vec![None; columns.len()] };
        Ok(Recording {
            rows,
            said,
            results,
            columns,
            times: Times::default(),
            row: Row::default(),
            header,
            has_compared: false,
            recorded,
            is_waiting: false,
            is_over: !found,
            shown: None,
            difference: None,
            count: 0,
        })
    }

    /// Whether a row was not what the chart does, or could not be read.
    pub fn differs(&self) -> bool {
        self.difference.is_some() || self.said.has_errors()
    }

    /// Compares the rows up to a call with what came of it. Calls come in order of their times.
    ///
    /// # Errors
    /// The text cannot be read.
    pub fn called(&mut self, t_ms: i64, response: &Response) -> io::Result<()> {
        while self.difference.is_none() && self.wait()? {
            if self.recorded.t_ms > t_ms {
                break;
            }
            self.is_waiting = false;
            if self.recorded.t_ms == t_ms {
                // The next row of this time is of the next call at this time, if there is one.
                self.difference = self.differences(response);
                break;
            }
            self.compare_with_shown();
        }
        self.shown = Some(response.clone());
        Ok(())
    }

    /// Compares what is left; how many rows there were, what is to be said, and the rows that it is about, if nobody has
    /// the text.
    ///
    /// # Errors
    /// The text cannot be read.
    pub fn finish(mut self) -> io::Result<(u64, Diagnostics, Extract)> {
        while self.wait()? {
            self.is_waiting = false;
            if self.difference.is_none() {
                self.compare_with_shown();
            }
        }
        let difference = self.difference.take().or_else(|| self.nothing_compared());
        if let Some(difference) = difference.filter(|_| !self.said.has_errors()) {
            self.said.say(difference);
        }
        let (diagnostics, extract) = self.said.finish();
        Ok((self.count, diagnostics, extract))
    }

    /// The error that no value was compared, if none was: a recording that says nothing agrees with everything.
    fn nothing_compared(&mut self) -> Option<Diagnostic> {
        if self.has_compared || self.said.has_errors() {
            return None;
        }
        let is_compared = |column: &Column| matches!(column, Column::Compared(_));
        let message = if !self.columns.iter().any(is_compared) {
            "the recording has no column that is compared"
        } else if self.count == 0 {
            "the recording has no row"
        } else {
            "the recording has no value that is compared"
        };
        let place = self.said.place(&self.header, 0..self.header.text.len());
        let help = format!("record `{TIME}` with outputs, `{SITUATION}` or `{FLAGS}`, and a row a scan");
        Some(Diagnostic::new(Code::E0601, place, message).note("inputs are not compared").help(help))
    }

    /// Compares a row between calls, or behind those of its time, with the latest.
    fn compare_with_shown(&mut self) {
        self.difference = match self.shown.take() {
            Some(shown) => {
                let difference = self.differences(&shown);
                self.shown = Some(shown);
                difference
            }
            None => {
                let message = format!("at {} ms the chart has not been called yet", self.recorded.t_ms);
                Some(Diagnostic::new(Code::E0605, self.said.cell(&self.row, 0), message))
            }
        };
    }

    /// Whether there is a row that has to be compared.
    fn wait(&mut self) -> io::Result<bool> {
        if self.is_waiting || self.is_over {
            return Ok(self.is_waiting);
        }
        self.times.pass(&mut self.row);
        if self.rows.next(&mut self.row, &mut self.said)? {
            self.count += 1;
            self.read_row();
            self.is_waiting = true;
        } else {
            self.is_over = true;
        }
        Ok(self.is_waiting)
    }

    fn read_row(&mut self) {
        let fits = self.said.fits(&self.row, self.columns.len());
        for (column, role) in self.columns.iter().enumerate() {
            match *role {
                Column::Time if fits => self.times.take(&self.row, column, &mut self.said),
                Column::Compared(about) => {
                    let is_kept = matches!(about, About::Output(_));
                    let text = self.row.cell(column);
                    if fits && !(is_kept && text.is_empty()) {
                        let read = self.results.read(about, text, (&self.row, column), &mut self.said);
                        self.recorded.cells[column] = read.or(self.recorded.cells[column].take().filter(|_| is_kept));
                    } else if !is_kept {
                        self.recorded.cells[column] = None;
                    }
                }
                Column::Time | Column::Skipped => {}
            }
        }
        self.recorded.t_ms = self.times.latest();
    }

    /// How a row differs from what the chart does, if it does.
    fn differences(&mut self, response: &Response) -> Option<Diagnostic> {
        self.has_compared |= self.recorded.cells.iter().any(Option::is_some);
        let mut found = self.places_that_differ(response).into_iter();
        let (message, column) = found.next()?;
        let place = |said: &mut Said, column: usize| said.cell(&self.row, column);
        let message = format!("at {} ms {message}", self.recorded.t_ms);
        let mut diagnostic = Diagnostic::new(Code::E0605, place(&mut self.said, column), message);
        for (message, column) in found {
            let span: Span = place(&mut self.said, column);
            diagnostic =
                if span == diagnostic.primary.span { diagnostic.note(message) } else { diagnostic.also(span, message) };
        }
        Some(diagnostic)
    }

    /// What differs, with the columns: situation first, because outputs follow from it, and flags last.
    fn places_that_differ(&self, response: &Response) -> Vec<(String, usize)> {
        let (mut of_situation, mut of_outputs, mut of_flags) = (Vec::new(), Vec::new(), Vec::new());
        for (column, role) in self.columns.iter().enumerate() {
            let (Column::Compared(about), Some(recorded)) = (*role, &self.recorded.cells[column]) else { continue };
            let Some(done) = self.results.done(about, response, &[]) else { continue };
            if self.results.agree(about, recorded, &done) {
                continue;
            }
            match (recorded, &done) {
                (Saying::Situation(recorded), Saying::Situation(done)) => {
                    let step = |id: StepId| &self.results.chart.steps[id].label;
                    let surplus = recorded.difference(done);
                    of_situation.extend(
                        surplus.map(|id| (format!("step `{}` is active and should not be", step(*id)), column)),
                    );
                    let lacking = done.difference(recorded);
                    of_situation.extend(
                        lacking.map(|id| (format!("step `{}` should be active and is not", step(*id)), column)),
                    );
                }
                (Saying::Flags(recorded), Saying::Flags(done)) => {
                    let surplus = recorded.difference(done);
                    of_flags.extend(surplus.map(|flag| (format!("flag {flag} is raised and should not be"), column)));
                    let lacking = done.difference(recorded);
                    of_flags.extend(lacking.map(|flag| (format!("flag {flag} should be raised and is not"), column)));
                }
                (Saying::Value(_) | Saying::Situation(_) | Saying::Flags(_), _) => {
                    let [is, should] = [recorded, &done].map(|saying| self.results.spelled(about, saying));
                    let name = self.results.name(about);
                    of_outputs.push((format!("output `{name}` is {is} and should be {should}"), column));
                }
            }
        }
        of_situation.append(&mut of_outputs);
        of_situation.append(&mut of_flags);
        of_situation
    }
}

fn roles(said: &mut Said, header: &Row, results: &Results) -> Vec<Column> {
    let inputs: Vec<&Variable> = results.chart.variables.iter().filter(|v| v.kind == VariableKind::Input).collect();
    let mut roles: BTreeMap<&str, Column> = BTreeMap::new();
    roles.extend(inputs.iter().map(|variable| (variable.name.as_str(), Column::Skipped)));
    let outputs = results.outputs.iter().enumerate();
    roles.extend(outputs.map(|(place, v)| (v.name.as_str(), Column::Compared(About::Output(place)))));
    let [situation, flags] = own_columns(Column::Compared);
    let own = [situation, flags, (RESTART, Column::Skipped)];
    let (all, looks) = ([inputs.as_slice(), &results.outputs].concat(), Suggestions::new());
    let fault =
        |name: &str, span| unknown(format!("the chart has no input or output `{name}`"), name, span, &all, &looks);
    columns(said, header, 0..header.len(), (Column::Time, Column::Skipped), &own, &roles, fault)
}
