//! A stimulus trace, cell by cell.

use super::TIME;
use crate::chart::{Chart, Type, Value, Variable, VariableKind};
use crate::reaction::Stimulus;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, FileId, Fix, Span};
use std::collections::BTreeMap;
use std::ops::Range;

/// Reads a stimulus trace. Every row gives a stimulus; a cell that cannot be read is reported and taken as empty.
pub fn parse_trace(file: FileId, text: &str, chart: &Chart) -> (Vec<Stimulus>, Diagnostics) {
    let mut reader = Reader { file, diagnostics: Diagnostics::new() };
    let stimuli = reader.read(text, chart);
    (stimuli, reader.diagnostics)
}

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
    fn read(&mut self, text: &str, chart: &Chart) -> Vec<Stimulus> {
        let Some((header, records)) = self.table(text) else { return Vec::new() };
        let inputs: Vec<&Variable> = chart.variables.iter().filter(|v| v.kind == VariableKind::Input).collect();
        let columns = self.header(&header, chart, &inputs);

        let mut stimuli = Vec::new();
        let mut values: Vec<Value> = inputs.iter().map(|input| input.initial).collect();
        let mut latest: Option<(i64, Span)> = None;
        for record in records {
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
                        Column::Input(_) | Column::Unknown => {}
                    }
                }
            }
            stimuli.push(Stimulus { t_ms: latest.map_or(0, |(t, _)| t), inputs: values.clone() });
        }
        stimuli
    }

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
        let skipped = if text.starts_with('\u{feff}') { '\u{feff}'.len_utf8() } else { 0 };
        let text = &text[skipped..];
        let mut reader = csv::ReaderBuilder::new().has_headers(false).flexible(true).from_reader(text.as_bytes());
        let mut records = Vec::new();
        loop {
            let mut cells = csv::StringRecord::new();
            let start = reader.position().byte() as usize;
            match reader.read_record(&mut cells) {
                Ok(true) => {
                    let end = reader.position().byte() as usize;
                    let spans = cell_ranges(text, start..end)
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

    fn header(&mut self, header: &Record, chart: &Chart, inputs: &[&Variable]) -> Vec<Column> {
        let places: BTreeMap<&str, usize> = inputs.iter().enumerate().map(|(i, v)| (v.name.as_str(), i)).collect();
        let mut seen: BTreeMap<&str, Span> = BTreeMap::new();
        let mut columns = Vec::new();
        for column in 0..header.cells.len() {
            let (name, span) = header.cell(column);
            let earlier = seen.insert(name, span);
            columns.push(if column == 0 {
                if name != TIME {
                    let message = format!("the first column is `{name}`, not `{TIME}`");
                    self.diagnostics.push(Diagnostic::new(Code::E0601, span, message));
                }
                Column::Time
            } else if let Some(earlier) = earlier {
                let message = format!("column `{name}` appears twice");
                self.diagnostics.push(Diagnostic::new(Code::E0601, span, message).also(earlier, "also here"));
                Column::Unknown
            } else if let Some(&place) = places.get(name) {
                Column::Input(place)
            } else {
                self.diagnostics.push(unknown_column(name, span, chart));
                Column::Unknown
            });
        }
        columns
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
enum Column {
    Time,
    /// The input of this place among the inputs.
    Input(usize),
    Unknown,
}

fn count(cells: usize) -> String {
    if cells == 1 { "1 cell".to_string() } else { format!("{cells} cells") }
}

fn unknown_column(name: &str, span: Span, chart: &Chart) -> Diagnostic {
    let Some(variable) = chart.variables.iter().find(|variable| variable.name == name) else {
        let diagnostic = Diagnostic::new(Code::E0602, span, format!("the chart has no input `{name}`"));
        let like = |v: &&Variable| v.kind == VariableKind::Input && v.name.to_lowercase() == name.to_lowercase();
        return match chart.variables.iter().find(like) {
            Some(input) => diagnostic
                .help(format!("write `{}`", input.name))
                .fix(Fix::certain(format!("write `{}`", input.name)).replace(span, input.name.as_str())),
            None => diagnostic,
        };
    };
    let kind = match variable.kind {
        VariableKind::Input => "an input",
        VariableKind::Output => "an output",
        VariableKind::Internal => "an internal variable",
        VariableKind::Constant => "a constant",
    };
    Diagnostic::new(Code::E0602, span, format!("`{name}` is {kind} of the chart, not an input"))
}

/// The value of a cell, or what was expected.
pub(super) fn parse_value(text: &str, ty: Type) -> Result<Value, String> {
    let whole = |least: i64, greatest: i64| {
        text.parse::<i64>()
            .ok()
            .filter(|number| (least..=greatest).contains(number))
            .ok_or_else(|| format!("a whole number from {least} to {greatest}"))
    };
    let real = |single: bool| {
        let number = text.parse::<f64>().ok().map(|number| if single { f64::from(number as f32) } else { number });
        number.filter(|number| number.is_finite()).map(Value::Real)
    };
    match ty {
        Type::Bool => match text.to_ascii_uppercase().as_str() {
            "0" | "FALSE" => Ok(Value::Bool(false)),
            "1" | "TRUE" => Ok(Value::Bool(true)),
            _ => Err("`0`, `1`, `FALSE` or `TRUE`".to_string()),
        },
        Type::Int => whole(i64::from(i16::MIN), i64::from(i16::MAX)).map(Value::Int),
        Type::Dint => whole(i64::from(i32::MIN), i64::from(i32::MAX)).map(Value::Int),
        Type::Uint => whole(0, i64::from(u16::MAX)).map(Value::Int),
        Type::Udint => whole(0, i64::from(u32::MAX)).map(Value::Int),
        Type::Real => real(true).ok_or_else(|| "a number that single precision can hold".to_string()),
        Type::Lreal => real(false).ok_or_else(|| "a number that double precision can hold".to_string()),
        Type::Time => text.parse().map(Value::Time).map_err(|_| "whole milliseconds".to_string()),
    }
}

/// Where the cells of one record lie, quotes included. The record may be preceded by blank lines.
fn cell_ranges(text: &str, record: Range<usize>) -> Vec<Range<usize>> {
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
            b',' if !quoted => {
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
