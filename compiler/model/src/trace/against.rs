//! A result recorded elsewhere beside what the chart does: the first row that differs, in the words of the chart.
//!
//! A recording has the form of a result. It may lack columns, and have those of inputs, which are not looked at. Its rows
//! belong to calls by their times: the n-th row of a time to the n-th call at that time, and a row at a time without a
//! call to what the latest call before it showed.

use super::columns::{FLAGS, RESTART, SITUATION, unknown};
use super::situation;
use super::table::{Reader, Record};
use super::values::parse_value;
use super::write::cell;
use crate::chart::{Chart, StepId, Type, Value, Variable, VariableKind};
use crate::reaction::{Response, Stimulus};
use crate::resolve::suggest::Suggestions;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, FileId, Span};
use std::collections::{BTreeMap, BTreeSet};

/// Compares a recording with the responses to stimuli: how many rows it has, and what is wrong with it. Only the first
/// row that differs is reported.
pub fn compare_trace(
    file: FileId,
    text: &str,
    chart: &Chart,
    stimuli: &[Stimulus],
    responses: &[Response],
) -> (usize, Diagnostics) {
    let mut reader = Reader { file, diagnostics: Diagnostics::new() };
    let Some((header, records)) = reader.table(text) else { return (0, reader.diagnostics) };
    let mut comparison = Comparison { chart, columns: Vec::new(), recorded: BTreeMap::new(), reader };
    comparison.columns = comparison.header(&header);
    let rows = comparison.rows(&header, &records);
    if !comparison.reader.diagnostics.has_errors() {
        comparison.first_difference(&records, &rows, stimuli, responses);
    }
    (rows.len(), comparison.reader.diagnostics)
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
#[derive(Clone, Default)]
struct RecordedRow {
    t_ms: i64,
    /// By output, the latest value that was recorded.
    outputs: BTreeMap<usize, Value>,
    situation: Option<BTreeSet<StepId>>,
    flags: Option<BTreeSet<&'static str>>,
}

struct Comparison<'a> {
    chart: &'a Chart,
    columns: Vec<Column>,
    /// By output, the latest value that was recorded: an empty cell keeps it.
    recorded: BTreeMap<usize, Value>,
    reader: Reader,
}

const FLAG_NAMES: [&str; 4] = ["LIVELOCK", "ALLOC_CONFLICT", "FORCE_CONFLICT", "DIV0"];

impl<'a> Comparison<'a> {
    fn outputs(&self) -> impl Iterator<Item = &'a Variable> + use<'a> {
        self.chart.variables.iter().filter(|variable| variable.kind == VariableKind::Output)
    }

    fn say(&mut self, code: Code, span: Span, message: String) {
        self.reader.diagnostics.push(Diagnostic::new(code, span, message));
    }

    fn header(&mut self, header: &Record) -> Vec<Column> {
        let known = |kind| self.chart.variables.iter().filter(move |variable| variable.kind == kind);
        let inputs: Vec<&Variable> = known(VariableKind::Input).collect();
        let outputs: Vec<&Variable> = self.outputs().collect();
        let mut roles: BTreeMap<&str, Column> = BTreeMap::new();
        roles.extend(inputs.iter().map(|variable| (variable.name.as_str(), Column::Skipped)));
        roles.extend(outputs.iter().enumerate().map(|(place, v)| (v.name.as_str(), Column::Output(place))));
        let own = [(SITUATION, Column::Situation), (FLAGS, Column::Flags), (RESTART, Column::Skipped)];
        let (all, looks) = ([inputs, outputs].concat(), Suggestions::new());
        let fault =
            |name: &str, span| unknown(format!("the chart has no input or output `{name}`"), name, span, &all, &looks);
        self.reader.columns(header, (Column::Time, Column::Skipped), &own, &roles, fault)
    }

    fn rows(&mut self, header: &Record, records: &[Record]) -> Vec<RecordedRow> {
        let mut latest = None;
        let mut rows = Vec::new();
        for record in records {
            let mut row = RecordedRow::default();
            if self.reader.fits(record, header) {
                for column in 0..self.columns.len() {
                    let (text, span) = record.cell(column);
                    match self.columns[column] {
                        Column::Time => latest = self.reader.time(text, span, latest),
                        Column::Output(_) if text.is_empty() => {}
                        Column::Output(place) => self.output(place, text, span),
                        Column::Situation => row.situation = Some(self.situation(text, span)),
                        Column::Flags => row.flags = Some(self.flags(text, span)),
                        Column::Skipped => {}
                    }
                }
            }
            row.t_ms = latest.map_or(0, |(t, _)| t);
            row.outputs = self.recorded.clone();
            rows.push(row);
        }
        rows
    }

    fn output(&mut self, place: usize, text: &str, span: Span) {
        let Some(variable) = self.outputs().nth(place) else { return };
        match parse_value(text, variable.ty) {
            Ok(value) => {
                self.recorded.insert(place, value);
            }
            Err(expected) => {
                let message = format!("`{text}` is not a value of `{}`", variable.name);
                let diagnostic = Diagnostic::new(Code::E0603, span, message).here(format!("expected {expected}"));
                self.reader.diagnostics.push(diagnostic);
            }
        }
    }

    fn situation(&mut self, text: &str, span: Span) -> BTreeSet<StepId> {
        let steps = &self.chart.steps;
        let mut found = BTreeSet::new();
        for label in situation::labels(text) {
            match steps.iter_enumerated().find(|(_, step)| step.label == label) {
                Some((id, _)) => {
                    found.insert(id);
                }
                None => self.say(Code::E0603, span, format!("`{label}` is not a step of the chart")),
            }
        }
        found
    }

    fn flags(&mut self, text: &str, span: Span) -> BTreeSet<&'static str> {
        let mut found = BTreeSet::new();
        for name in text.split_whitespace() {
            match FLAG_NAMES.iter().find(|flag| **flag == name) {
                Some(flag) => {
                    found.insert(*flag);
                }
                None => {
                    self.say(Code::E0603, span, format!("`{name}` is not a flag; there are {}", FLAG_NAMES.join(", ")))
                }
            }
        }
        found
    }

    fn first_difference(
        &mut self,
        records: &[Record],
        rows: &[RecordedRow],
        stimuli: &[Stimulus],
        responses: &[Response],
    ) {
        let mut call = 0;
        let mut before: Option<i64> = None;
        for (record, row) in records.iter().zip(rows) {
            // The next call of the same time, if there is one; else the latest at or before this time.
            let again = before == Some(row.t_ms) && stimuli.get(call + 1).is_some_and(|next| next.t_ms == row.t_ms);
            if again {
                call += 1;
            } else if before != Some(row.t_ms) {
                let first = stimuli.partition_point(|stimulus| stimulus.t_ms < row.t_ms);
                let exact = stimuli.get(first).is_some_and(|stimulus| stimulus.t_ms == row.t_ms);
                call = if exact { first } else { first.saturating_sub(1) };
                if !exact && first == 0 {
                    let message = format!("at {} ms the chart has not been called yet", row.t_ms);
                    self.say(Code::E0605, record.cell(0).1, message);
                    return;
                }
            }
            before = Some(row.t_ms);
            let Some(response) = responses.get(call) else { return };
            let found = self.differences(record, row, response);
            let mut found = found.into_iter();
            if let Some((message, span)) = found.next() {
                let mut diagnostic = Diagnostic::new(Code::E0605, span, format!("at {} ms {message}", row.t_ms));
                for (message, span) in found {
                    diagnostic = if span == diagnostic.primary.span {
                        diagnostic.note(message)
                    } else {
                        diagnostic.also(span, message)
                    };
                }
                self.reader.diagnostics.push(diagnostic);
                return;
            }
        }
    }

    /// How a row differs from what the chart does, with the places: situation first, because outputs follow from it.
    fn differences(&self, record: &Record, row: &RecordedRow, response: &Response) -> Vec<(String, Span)> {
        let mut found = Vec::new();
        let place = |wanted: fn(Column) -> bool| self.columns.iter().position(|column| wanted(*column));
        let step = |id: StepId| &self.chart.steps[id].label;
        if let (Some(situation), Some(column)) = (&row.situation, place(|c| matches!(c, Column::Situation))) {
            let span = record.cell(column).1;
            let expected: BTreeSet<StepId> = response.situation.iter().copied().collect();
            let surplus = situation.difference(&expected);
            found.extend(surplus.map(|id| (format!("step `{}` is active and should not be", step(*id)), span)));
            let lacking = expected.difference(situation);
            found.extend(lacking.map(|id| (format!("step `{}` should be active and is not", step(*id)), span)));
        }
        for (column, role) in self.columns.iter().enumerate() {
            let Column::Output(place) = *role else { continue };
            let (Some(variable), Some(expected)) = (self.outputs().nth(place), response.outputs.get(place)) else {
                continue;
            };
            if let Some(value) = row.outputs.get(&place)
                && !agree(variable.ty, *value, *expected)
            {
                let (name, ty) = (&variable.name, variable.ty);
                let message = format!("output `{name}` is {} and should be {}", cell(ty, *value), cell(ty, *expected));
                found.push((message, record.cell(column).1));
            }
        }
        if let (Some(flags), Some(column)) = (&row.flags, place(|c| matches!(c, Column::Flags))) {
            let span = record.cell(column).1;
            let expected: BTreeSet<&str> = response.flags.names().collect();
            found.extend(flags.difference(&expected).map(|f| (format!("flag {f} is raised and should not be"), span)));
            found.extend(expected.difference(flags).map(|f| (format!("flag {f} should be raised and is not"), span)));
        }
        found
    }
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
