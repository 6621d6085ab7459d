//! A stimulus trace, cell by cell.

use super::columns::{RESTART, kind_of, unknown};
use super::table::{Reader, Record};
use super::values::parse_value;
use crate::chart::{Chart, Type, Value, Variable, VariableKind};
use crate::reaction::Stimulus;
use crate::resolve::suggest::Suggestions;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, FileId, Span};

/// Reads a stimulus trace. Every row gives a stimulus; a cell that cannot be read is reported and taken as empty.
pub fn parse_trace(file: FileId, text: &str, chart: &Chart) -> (Vec<Stimulus>, Diagnostics) {
    let (rows, diagnostics) = parse_rows(file, text, chart);
    (rows.into_iter().map(|(stimulus, _)| stimulus).collect(), diagnostics)
}

/// The same, with the place of the time of each row.
pub fn parse_rows(file: FileId, text: &str, chart: &Chart) -> (Vec<(Stimulus, Span)>, Diagnostics) {
    let mut reader = Reader { file, diagnostics: Diagnostics::new() };
    let rows = reader.read(text, chart);
    (rows, reader.diagnostics)
}

impl Reader {
    fn read(&mut self, text: &str, chart: &Chart) -> Vec<(Stimulus, Span)> {
        let Some((header, records)) = self.table(text) else { return Vec::new() };
        let inputs: Vec<&Variable> = chart.variables.iter().filter(|v| v.kind == VariableKind::Input).collect();
        let columns = self.header(&header, chart, &inputs);

        let mut stimuli = Vec::new();
        let mut values: Vec<Value> = inputs.iter().map(|input| input.initial).collect();
        let mut latest: Option<(i64, Span)> = None;
        for record in records {
            let mut restart = false;
            if self.fits(&record, &header) {
                for (column, role) in columns.iter().enumerate() {
                    let (text, span) = record.cell(column);
                    match *role {
                        Column::Time => latest = self.time(text, span, latest),
                        Column::Input(place) if !text.is_empty() => {
                            if let Some(value) = self.value(text, span, inputs[place]) {
                                values[place] = value;
                            }
                        }
                        Column::Restart if !text.is_empty() => restart = self.restart(text, span),
                        Column::Input(_) | Column::Restart | Column::Unknown => {}
                    }
                }
            }
            let t_ms = latest.map_or(0, |(t, _)| t);
            stimuli.push((Stimulus { t_ms, restart, inputs: values.clone() }, record.cell(0).1));
        }
        stimuli
    }

    fn header(&mut self, header: &Record, chart: &Chart, inputs: &[&Variable]) -> Vec<Column> {
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
        self.columns(header, (Column::Time, Column::Unknown), &[(RESTART, Column::Restart)], &places, fault)
    }

    /// The time of a row, and its place; if it cannot be read, that of the row before.
    pub fn time(&mut self, text: &str, span: Span, latest: Option<(i64, Span)>) -> Option<(i64, Span)> {
        let Some(t) = text.parse::<i64>().ok().filter(|&t| t >= 0) else {
            let message =
                if text.is_empty() { "the row has no time".into() } else { format!("`{text}` is not a time") };
            let diagnostic = Diagnostic::new(Code::E0603, span, message).here("expected whole milliseconds");
            self.diagnostics.push(diagnostic);
            return latest;
        };
        match latest {
            Some((before, place)) if t < before => {
                let message = format!("the time goes back from {before} ms to {t} ms");
                self.diagnostics.push(Diagnostic::new(Code::E0604, span, message).also(place, "the time before"));
                latest
            }
            Some(_) | None => Some((t, span)),
        }
    }

    /// Whether the controller restarts in a row.
    fn restart(&mut self, text: &str, span: Span) -> bool {
        match parse_value(text, Type::Bool) {
            Ok(value) => value == Value::Bool(true),
            Err(expected) => {
                let message = format!("`{text}` does not say whether the controller restarts");
                self.diagnostics.push(Diagnostic::new(Code::E0603, span, message).here(format!("expected {expected}")));
                false
            }
        }
    }

    fn value(&mut self, text: &str, span: Span, input: &Variable) -> Option<Value> {
        parse_value(text, input.ty)
            .map_err(|expected| {
                let message = format!("`{text}` is not a value of `{}`", input.name);
                self.diagnostics.push(Diagnostic::new(Code::E0603, span, message).here(format!("expected {expected}")));
            })
            .ok()
    }
}

/// What a column of the trace is.
#[derive(Clone, Copy)]
enum Column {
    Time,
    /// The mark of a restart.
    Restart,
    /// The input of this place among the inputs.
    Input(usize),
    Unknown,
}
