//! A result recorded elsewhere beside what the chart does: the first row that differs, in the words of the chart.
//!
//! A recording has the form of a result. It may lack columns, and have those of inputs, which are not looked at. Its rows
//! belong to calls by their times: the n-th row of a time to the n-th call at that time, and a row at a time without a
//! call to what the latest call before it showed.
//!
//! It is read beside the run, row by row.

use super::columns::{FLAGS, RESTART, SITUATION, TIME, columns, unknown};
use super::row::Row;
use super::rows::Rows;
use super::said::{Kept, Said};
use super::situation;
use super::times::Times;
use super::values::parse_value;
use super::write::cell;
use crate::chart::{Chart, StepId, Type, Value, Variable, VariableKind};
use crate::reaction::{Response, Stimulus};
use crate::resolve::suggest::Suggestions;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, Extract, FileId, Span};
use std::collections::{BTreeMap, BTreeSet};
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
    /// The output of this place among the outputs.
    Output(usize),
    Situation,
    Flags,
    /// An input, or what has been reported.
    Skipped,
}

/// What a row says.
#[derive(Default)]
struct RecordedRow {
    t_ms: i64,
    /// The latest value of each output that was recorded: an empty cell keeps it.
    outputs: Vec<Option<Value>>,
    situation: Option<BTreeSet<StepId>>,
    flags: Option<BTreeSet<&'static str>>,
}

/// A recording that is read as far as the run has come.
pub struct Recording<'a, R> {
    rows: Rows<R>,
    said: Said,
    chart: &'a Chart,
    outputs: Vec<&'a Variable>,
    steps: BTreeMap<&'a str, StepId>,
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

const FLAG_NAMES: [&str; 4] = ["LIVELOCK", "ALLOC_CONFLICT", "FORCE_CONFLICT", "DIV0"];

impl<'a, R: Read> Recording<'a, R> {
    /// A recording of a chart, whose header is read.
    ///
    /// # Errors
    /// The text cannot be read.
    pub fn new(file: FileId, text: R, chart: &'a Chart, kept: Kept) -> io::Result<Self> {
        let outputs: Vec<&Variable> = chart.variables.iter().filter(|v| v.kind == VariableKind::Output).collect();
        let (mut rows, mut said, mut header) = (Rows::new(text)?, Said::new(file, kept), Row::default());
        let found = rows.header(&mut header, &mut said)?;
        let columns = if found { roles(&mut said, &header, chart, &outputs) } else { Vec::new() };
        let mut steps = BTreeMap::new();
        for (id, step) in chart.steps.iter_enumerated() {
            steps.entry(step.label.as_str()).or_insert(id);
        }
        let recorded = RecordedRow { outputs: vec![None; outputs.len()], ..RecordedRow::default() };
        Ok(Recording {
            rows,
            said,
            chart,
            outputs,
            steps,
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
        let is_compared = |column: &Column| matches!(column, Column::Output(_) | Column::Situation | Column::Flags);
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
        match self.rows.read(&mut self.row) {
            Ok(true) => {
                self.count += 1;
                self.read_row();
                self.is_waiting = true;
            }
            Ok(false) => self.is_over = true,
            Err(fault) => {
                self.is_over = true;
                self.said.fault(&mut self.row, fault)?;
            }
        }
        Ok(self.is_waiting)
    }

    fn read_row(&mut self) {
        (self.recorded.situation, self.recorded.flags) = (None, None);
        if self.said.fits(&self.row, self.columns.len()) {
            for (column, role) in self.columns.iter().enumerate() {
                let text = self.row.cell(column);
                match *role {
                    Column::Time => self.times.take(&self.row, column, &mut self.said),
                    Column::Output(_) if text.is_empty() => {}
                    Column::Output(place) => match parse_value(text, self.outputs[place].ty) {
                        Ok(value) => self.recorded.outputs[place] = Some(value),
                        Err(expected) => {
                            let message = format!("`{text}` is not a value of `{}`", self.outputs[place].name);
                            self.said.bad_value(&self.row, column, message, &expected);
                        }
                    },
                    Column::Situation => {
                        let mut found = BTreeSet::new();
                        for label in situation::labels(text) {
                            match self.steps.get(label) {
                                Some(id) => _ = found.insert(*id),
                                None => {
                                    let place = self.said.cell(&self.row, column);
                                    let message = format!("`{label}` is not a step of the chart");
                                    let error = Diagnostic::new(Code::E0603, place, message);
                                    let meant = Suggestions::new().nearest(label, self.steps.keys().copied());
                                    let help = meant.map_or_else(
                                        || "write the labels of the active steps, with blanks between them".to_string(),
                                        |meant| format!("write `{meant}`"),
                                    );
                                    self.said.error(error.help(help));
                                }
                            }
                        }
                        self.recorded.situation = Some(found);
                    }
                    Column::Flags => {
                        let mut found = BTreeSet::new();
                        for name in text.split_whitespace() {
                            match FLAG_NAMES.iter().find(|flag| **flag == name) {
                                Some(flag) => _ = found.insert(*flag),
                                None => {
                                    let place = self.said.cell(&self.row, column);
                                    let all = FLAG_NAMES.join(", ");
                                    let message = format!("`{name}` is not a flag");
                                    let error = Diagnostic::new(Code::E0603, place, message);
                                    self.said.error(error.help(format!("the flags are {all}")));
                                }
                            }
                        }
                        self.recorded.flags = Some(found);
                    }
                    Column::Skipped => {}
                }
            }
        }
        self.recorded.t_ms = self.times.latest();
    }

    /// How a row differs from what the chart does, if it does.
    fn differences(&mut self, response: &Response) -> Option<Diagnostic> {
        let recorded = &self.recorded;
        self.has_compared |=
            recorded.situation.is_some() || recorded.flags.is_some() || recorded.outputs.iter().any(Option::is_some);
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

    /// What differs, with the columns: situation first, because outputs follow from it.
    fn places_that_differ(&self, response: &Response) -> Vec<(String, usize)> {
        let mut found = Vec::new();
        let place = |wanted: fn(Column) -> bool| self.columns.iter().position(|column| wanted(*column));
        let step = |id: StepId| &self.chart.steps[id].label;
        let row = &self.recorded;
        if let (Some(situation), Some(column)) = (&row.situation, place(|c| matches!(c, Column::Situation))) {
            let expected: BTreeSet<StepId> = response.situation.iter().copied().collect();
            let surplus = situation.difference(&expected);
            found.extend(surplus.map(|id| (format!("step `{}` is active and should not be", step(*id)), column)));
            let lacking = expected.difference(situation);
            found.extend(lacking.map(|id| (format!("step `{}` should be active and is not", step(*id)), column)));
        }
        for (column, role) in self.columns.iter().enumerate() {
            let Column::Output(place) = *role else { continue };
            let (variable, Some(expected)) = (self.outputs[place], response.outputs.get(place)) else { continue };
            if let Some(value) = row.outputs[place]
                && !agree(variable.ty, value, *expected)
            {
                let (name, ty) = (&variable.name, variable.ty);
                let message = format!("output `{name}` is {} and should be {}", cell(ty, value), cell(ty, *expected));
                found.push((message, column));
            }
        }
        if let (Some(flags), Some(column)) = (&row.flags, place(|c| matches!(c, Column::Flags))) {
            let expected: BTreeSet<&str> = response.flags.names().collect();
            let surplus = flags.difference(&expected);
            found.extend(surplus.map(|flag| (format!("flag {flag} is raised and should not be"), column)));
            let lacking = expected.difference(flags);
            found.extend(lacking.map(|flag| (format!("flag {flag} should be raised and is not"), column)));
        }
        found
    }
}

fn roles(said: &mut Said, header: &Row, chart: &Chart, outputs: &[&Variable]) -> Vec<Column> {
    let inputs: Vec<&Variable> = chart.variables.iter().filter(|v| v.kind == VariableKind::Input).collect();
    let mut roles: BTreeMap<&str, Column> = BTreeMap::new();
    roles.extend(inputs.iter().map(|variable| (variable.name.as_str(), Column::Skipped)));
    roles.extend(outputs.iter().enumerate().map(|(place, v)| (v.name.as_str(), Column::Output(place))));
    let own = [(SITUATION, Column::Situation), (FLAGS, Column::Flags), (RESTART, Column::Skipped)];
    let (all, looks) = ([inputs.as_slice(), outputs].concat(), Suggestions::new());
    let fault =
        |name: &str, span| unknown(format!("the chart has no input or output `{name}`"), name, span, &all, &looks);
    columns(said, header, (Column::Time, Column::Skipped), &own, &roles, fault)
}

/// Reals agree to as many digits as tools print: six of a `real`, twelve of an `lreal`. What is infinite or no number
/// agrees with its like alone.
fn agree(ty: Type, a: Value, b: Value) -> bool {
    let tolerance = if ty == Type::Real { 1e-6 } else { 1e-12 };
    match (a, b) {
        (Value::Real(a), Value::Real(b)) if a.is_finite() && b.is_finite() => {
            a == b || (a - b).abs() <= tolerance * a.abs().max(b.abs())
        }
        (Value::Real(a), Value::Real(b)) => a == b || a.is_nan() && b.is_nan(),
        (a, b) => a == b,
    }
}
