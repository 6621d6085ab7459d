//! A result trace, row by row.

use super::columns::{FLAGS, RESTART, SITUATION, TIME, heading};
use super::situation;
use crate::chart::{Chart, Type, Value, Variable, VariableKind};
use crate::reaction::{Response, Stimulus};
use crate::simulate::Probe;
use std::fmt::Write as _;
use std::io::{self, Write};

/// Columns beside the outputs.
#[derive(Clone, Copy, Default, Debug)]
pub struct Shown<'a> {
    /// Whether restarts have a column.
    pub restarts: bool,
    /// What the columns are of.
    pub probes: &'a [Probe],
    /// So many of them, inputs, stand before the outputs.
    pub before: usize,
}

/// Writes a result trace, a row for each response.
pub fn write_trace(chart: &Chart, stimuli: &[Stimulus], responses: &[Response]) -> String {
    let mut table = Table::new(Vec::new(), chart, Shown::default());
    // Writing to memory does not fail.
    let _ = table.header();
    for (stimulus, response) in stimuli.iter().zip(responses) {
        let _ = table.row(stimulus, response, &[]);
    }
    String::from_utf8_lossy(&table.into_inner().unwrap_or_default()).into_owned()
}

/// A result trace that is written as it is made.
pub struct Table<'a, W: Write> {
    chart: &'a Chart,
    outputs: Vec<&'a Variable>,
    shown: Shown<'a>,
    writer: csv::Writer<W>,
    /// The cell that is written.
    text: String,
}

impl<'a, W: Write> Table<'a, W> {
    /// Nothing is written yet.
    pub fn new(out: W, chart: &'a Chart, shown: Shown<'a>) -> Self {
        let outputs = chart.variables.iter().filter(|variable| variable.kind == VariableKind::Output).collect();
        Table { chart, outputs, shown, writer: csv::Writer::from_writer(out), text: String::new() }
    }

    /// Writes the header.
    ///
    /// # Errors
    /// It cannot be written.
    pub fn header(&mut self) -> io::Result<()> {
        let (before, behind) = self.shown.probes.split_at(self.shown.before.min(self.shown.probes.len()));
        let name = |probe: &Probe| heading(&probe.name(self.chart)).into_owned();
        let mut header = vec![TIME.to_string()];
        header.extend(self.shown.restarts.then(|| RESTART.to_string()));
        header.extend(before.iter().map(name));
        header.extend(self.outputs.iter().map(|variable| heading(&variable.name).into_owned()));
        header.extend(behind.iter().map(name));
        header.extend([SITUATION.to_string(), FLAGS.to_string()]);
        self.writer.write_record(header).map_err(refused)
    }

    /// Writes the row of a call, with the values of what is shown beside the outputs.
    ///
    /// # Errors
    /// It cannot be written.
    pub fn row(&mut self, stimulus: &Stimulus, response: &Response, values: &[Value]) -> io::Result<()> {
        self.cell(|text| _ = write!(text, "{}", stimulus.t_ms))?;
        if self.shown.restarts {
            self.cell(|text| text.push(if stimulus.restart { '1' } else { '0' }))?;
        }
        let types = self.shown.probes.iter().map(|probe| probe.ty(self.chart));
        let (before, behind) = (self.shown.before.min(values.len()), values.len());
        for (ty, value) in types.clone().zip(values).take(before) {
            self.cell(|text| write_value(text, ty, *value))?;
        }
        for place in 0..self.outputs.len().min(response.outputs.len()) {
            let (ty, value) = (self.outputs[place].ty, response.outputs[place]);
            self.cell(|text| write_value(text, ty, value))?;
        }
        for (ty, value) in types.zip(values).take(behind).skip(before) {
            self.cell(|text| write_value(text, ty, *value))?;
        }
        let chart = self.chart;
        self.cell(|text| situation::write(text, chart, &response.situation))?;
        self.cell(|text| {
            for name in response.flags.names() {
                if !text.is_empty() {
                    text.push(' ');
                }
                text.push_str(name);
            }
        })?;
        self.writer.write_record(None::<&[u8]>).map_err(refused)
    }

    /// Hands on what is not yet.
    ///
    /// # Errors
    /// It cannot be written.
    pub fn flush(&mut self) -> io::Result<()> {
        self.writer.flush()
    }

    /// Where it was written to.
    ///
    /// # Errors
    /// The end of it cannot be written.
    pub fn into_inner(self) -> io::Result<W> {
        self.writer.into_inner().map_err(csv::IntoInnerError::into_error)
    }

    fn cell(&mut self, write: impl FnOnce(&mut String)) -> io::Result<()> {
        self.text.clear();
        write(&mut self.text);
        self.writer.write_field(&self.text).map_err(refused)
    }
}

/// What the writer of CSV could not write, of the kind that it was.
fn refused(error: csv::Error) -> io::Error {
    match error.into_kind() {
        csv::ErrorKind::Io(error) => error,
        // Rows are equally long, which leaves nothing that we know of.
        kind => io::Error::other(format!("{kind:?}")),
    }
}

/// A value as it stands in a result: reals as short as reading them back allows.
pub fn cell(ty: Type, value: Value) -> String {
    let mut text = String::new();
    write_value(&mut text, ty, value);
    text
}

fn write_value(text: &mut String, ty: Type, value: Value) {
    // Writing to memory does not fail.
    let _ = match value {
        Value::Bool(b) => write!(text, "{}", u8::from(b)),
        Value::Int(i) | Value::Time(i) => write!(text, "{i}"),
        Value::Real(r) if ty == Type::Real => write!(text, "{}", r as f32),
        Value::Real(r) => write!(text, "{r}"),
    };
}
