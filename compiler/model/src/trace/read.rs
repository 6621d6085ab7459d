//! A stimulus trace, row by row and cell by cell.

use super::columns::{RESTART, columns, kind_of, unknown};
use super::row::Row;
use super::rows::Rows;
use super::said::{Kept, Said};
use super::times::Times;
use super::values::parse_value;
use crate::chart::{Chart, Type, Value, Variable, VariableKind};
use crate::reaction::Stimulus;
use crate::resolve::suggest::Suggestions;
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

/// A stimulus trace that is read as it comes: what is kept of it is a row, and what is said.
pub struct Stimuli<'a, R> {
    rows: Rows<R>,
    said: Said,
    inputs: Vec<&'a Variable>,
    columns: Vec<Column>,
    /// The values of the latest row: an empty cell keeps them.
    values: Vec<Value>,
    times: Times,
    row: Row,
    is_over: bool,
}

/// What a column of the trace is.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Column {
    Time,
    /// The mark of a restart.
    Restart,
    /// The input of this place among the inputs.
    Input(usize),
    Unknown,
}

impl<'a, R: Read> Stimuli<'a, R> {
    /// A trace of the inputs of a chart, whose header is read.
    ///
    /// # Errors
    /// The text cannot be read.
    pub fn new(file: FileId, text: R, chart: &'a Chart, kept: Kept) -> io::Result<Self> {
        let inputs: Vec<&Variable> = chart.variables.iter().filter(|v| v.kind == VariableKind::Input).collect();
        let (mut rows, mut said, mut header) = (Rows::new(text)?, Said::new(file, kept), Row::default());
        let found = rows.header(&mut header, &mut said)?;
        let columns = if found { roles(&mut said, &header, chart, &inputs) } else { Vec::new() };
        let values = inputs.iter().map(|input| input.initial).collect();
        let (times, row) = (Times::default(), Row::default());
        Ok(Stimuli { rows, said, inputs, columns, values, times, row, is_over: !found })
    }

    /// Whether something was wrong so far.
    pub fn has_errors(&self) -> bool {
        self.said.has_errors()
    }

    /// Whether rows can say that the controller has restarted.
    pub fn has_restarts(&self) -> bool {
        self.columns.contains(&Column::Restart)
    }

    /// The stimulus of the next row, if there is one.
    ///
    /// # Errors
    /// The text cannot be read.
    pub fn next_row(&mut self) -> io::Result<Option<Stimulus>> {
        if self.is_over {
            return Ok(None);
        }
        self.times.pass(&mut self.row);
        match self.rows.read(&mut self.row) {
            Ok(true) => {}
            Ok(false) => {
                self.is_over = true;
                return Ok(None);
            }
            Err(fault) => {
                // What comes behind is hardly a trace.
                self.is_over = true;
                self.said.fault(&mut self.row, fault)?;
                return Ok(None);
            }
        }
        let mut restart = false;
        if self.said.fits(&self.row, self.columns.len()) {
            for (column, role) in self.columns.iter().enumerate() {
                match *role {
                    Column::Time => self.times.take(&self.row, column, &mut self.said),
                    Column::Input(place) => {
                        let text = self.row.cell(column);
                        if !text.is_empty() {
                            match parse_value(text, self.inputs[place].ty) {
                                Ok(value) => self.values[place] = value,
                                Err(expected) => {
                                    let message = format!("`{text}` is not a value of `{}`", self.inputs[place].name);
                                    self.said.bad_value(&self.row, column, message, &expected);
                                }
                            }
                        }
                    }
                    Column::Restart => {
                        let text = self.row.cell(column);
                        if !text.is_empty() {
                            match parse_value(text, Type::Bool) {
                                Ok(value) => restart = value == Value::Bool(true),
                                Err(expected) => {
                                    let message = format!("`{text}` does not say whether the controller restarts");
                                    self.said.bad_value(&self.row, column, message, &expected);
                                }
                            }
                        }
                    }
                    Column::Unknown => {}
                }
            }
        }
        Ok(Some(Stimulus { t_ms: self.times.latest(), restart, inputs: self.values.clone() }))
    }

    /// The places of the times of the latest row, and of the row before it.
    pub fn places(&mut self) -> (Span, Span) {
        let before = self.said.cell(&self.times.before, 0);
        (self.said.cell(&self.row, 0), before)
    }

    /// Says something else about the trace.
    pub fn say(&mut self, diagnostic: Diagnostic) {
        self.said.say(diagnostic);
    }

    /// All that was said, and the rows that it is about, if nobody has the text.
    pub fn finish(self) -> (Diagnostics, Extract) {
        self.said.finish()
    }
}

fn roles(said: &mut Said, header: &Row, chart: &Chart, inputs: &[&Variable]) -> Vec<Column> {
    let places = inputs.iter().enumerate().map(|(i, v)| (v.name.as_str(), Column::Input(i))).collect();
    let looks = Suggestions::new();
    let fault = |name: &str, span| {
        let of_the_chart = chart.variables.iter().find(|variable| variable.name == name);
        let message = match of_the_chart {
            Some(variable) => format!("`{name}` is {} of the chart, not an input", kind_of(variable)),
            None => format!("the chart has no input `{name}`"),
        };
        unknown(message, name, span, if of_the_chart.is_some() { &[] } else { inputs }, &looks)
    };
    columns(said, header, (Column::Time, Column::Unknown), &[(RESTART, Column::Restart)], &places, fault)
}
