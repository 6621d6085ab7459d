//! What the rows of a trace give the chart: times, restarts, and values of inputs.

use super::columns::{RESTART, columns, kind_of, unknown};
use super::row::Row;
use super::rows::Rows;
use super::said::Said;
use super::times::Times;
use super::values::parse_value;
use crate::chart::{Chart, Type, Value, Variable, VariableKind};
use crate::reaction::Stimulus;
use crate::resolve::suggest::Suggestions;
use std::io;

/// The columns of what is given, and the values that the latest row came to.
pub(super) struct Given<'a> {
    inputs: Vec<&'a Variable>,
    columns: Vec<Column>,
    /// An empty cell keeps them.
    values: Vec<Value>,
    /// The times of the rows.
    pub times: Times,
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

impl<'a> Given<'a> {
    /// What the first columns give, so many as are said.
    pub fn new(said: &mut Said, header: &Row, chart: &'a Chart, width: usize) -> Self {
        let inputs: Vec<&Variable> = chart.variables.iter().filter(|v| v.kind == VariableKind::Input).collect();
        let columns = if width > 0 { roles(said, header, chart, &inputs, width) } else { Vec::new() };
        let values = inputs.iter().map(|input| input.initial()).collect();
        Given { inputs, columns, values, times: Times::default() }
    }

    /// Whether rows can say that the controller has restarted.
    pub fn has_restarts(&self) -> bool {
        self.columns.contains(&Column::Restart)
    }

    /// The stimulus of a row. A cell that cannot be read is reported and taken as empty.
    fn read(&mut self, row: &Row, said: &mut Said) -> Stimulus {
        let mut restart = false;
        for (column, role) in self.columns.iter().enumerate() {
            match *role {
                Column::Time => self.times.take(row, column, said),
                Column::Input(place) => {
                    let text = row.cell(column);
                    if !text.is_empty() {
                        match parse_value(text, self.inputs[place].ty) {
                            Ok(value) => self.values[place] = value,
                            Err(expected) => {
                                let message = format!("`{text}` is not a value of `{}`", self.inputs[place].name);
                                said.bad_value(row, column, message, &expected);
                            }
                        }
                    }
                }
                Column::Restart => {
                    let text = row.cell(column);
                    if !text.is_empty() {
                        match parse_value(text, Type::Bool) {
                            Ok(value) => restart = value == Value::Bool(true),
                            Err(expected) => {
                                let message = format!("`{text}` does not say whether the controller restarts");
                                said.bad_value(row, column, message, &expected);
                            }
                        }
                    }
                }
                Column::Unknown => {}
            }
        }
        self.kept(restart)
    }

    /// Reads the next row, if there is one: its stimulus, and whether it has as many cells as it must have. What comes behind
    /// a row that is no text is hardly a trace.
    ///
    /// # Errors
    /// The text cannot be read.
    pub fn next<R: io::Read>(
        &mut self,
        rows: &mut Rows<R>,
        row: &mut Row,
        said: &mut Said,
        width: usize,
    ) -> io::Result<Option<(Stimulus, bool)>> {
        self.times.pass(row);
        if !rows.next(row, said)? {
            return Ok(None);
        }
        let fits = said.fits(row, width);
        let stimulus = if fits { self.read(row, said) } else { self.kept(false) };
        Ok(Some((stimulus, fits)))
    }

    /// The stimulus of a row that cannot be read: that of the row before.
    fn kept(&self, restart: bool) -> Stimulus {
        Stimulus { t_ms: self.times.latest(), restart, inputs: self.values.clone() }
    }
}

fn roles(said: &mut Said, header: &Row, chart: &Chart, inputs: &[&Variable], width: usize) -> Vec<Column> {
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
    let own = [(RESTART, Column::Restart)];
    columns(said, header, 0..width, (Column::Time, Column::Unknown), &own, &places, fault)
}
