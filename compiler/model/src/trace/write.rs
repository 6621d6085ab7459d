//! A result trace.

use super::columns::{FLAGS, RESTART, SITUATION, TIME, heading};
use super::situation;
use crate::chart::{Chart, Type, Value, VariableKind};
use crate::reaction::{Response, Stimulus};
use crate::simulate::Probe;

/// Columns beside the outputs.
#[derive(Clone, Copy, Default)]
pub struct Shown<'a> {
    /// Whether restarts have a column.
    pub restarts: bool,
    /// What the columns are of.
    pub probes: &'a [Probe],
    /// So many of them, inputs, stand before the outputs.
    pub before: usize,
    /// Their values after each call.
    pub values: &'a [Vec<Value>],
}

/// Writes a result trace, a row for each response.
pub fn write_trace(chart: &Chart, stimuli: &[Stimulus], responses: &[Response]) -> String {
    write_shown(chart, stimuli, responses, Shown::default())
}

/// The same with more columns.
pub fn write_shown(chart: &Chart, stimuli: &[Stimulus], responses: &[Response], shown: Shown) -> String {
    let outputs = || chart.variables.iter().filter(|variable| variable.kind == VariableKind::Output);
    let mut writer = csv::Writer::from_writer(Vec::new());
    // Writing to memory does not fail, and all rows are equally long: there is no error to hand on.
    let mut write = |row: Vec<String>| {
        let _ = writer.write_record(&row);
    };
    let (before, behind) = shown.probes.split_at(shown.before.min(shown.probes.len()));
    let name = |probe: &Probe| heading(&probe.name(chart)).into_owned();
    let mut header = vec![TIME.to_string()];
    header.extend(shown.restarts.then(|| RESTART.to_string()));
    header.extend(before.iter().map(name));
    header.extend(outputs().map(|variable| heading(&variable.name).into_owned()));
    header.extend(behind.iter().map(name));
    header.extend([SITUATION.to_string(), FLAGS.to_string()]);
    write(header);
    for (call, (stimulus, response)) in stimuli.iter().zip(responses).enumerate() {
        let looks = shown.values.get(call).map_or(&[][..], Vec::as_slice);
        let mut cells = shown.probes.iter().zip(looks).map(|(probe, value)| cell(probe.ty(chart), *value));
        let mut row = vec![stimulus.t_ms.to_string()];
        row.extend(shown.restarts.then(|| u8::from(stimulus.restart).to_string()));
        row.extend(cells.by_ref().take(before.len()));
        row.extend(outputs().zip(&response.outputs).map(|(variable, &value)| cell(variable.ty, value)));
        row.extend(cells);
        row.push(situation::cell(chart, &response.situation));
        row.push(response.flags.names().collect::<Vec<_>>().join(" "));
        write(row);
    }
    String::from_utf8_lossy(&writer.into_inner().unwrap_or_default()).into_owned()
}

/// A value as it stands in a result: reals as short as reading them back allows.
pub(super) fn cell(ty: Type, value: Value) -> String {
    match value {
        Value::Bool(b) => u8::from(b).to_string(),
        Value::Int(i) | Value::Time(i) => i.to_string(),
        Value::Real(r) if ty == Type::Real => (r as f32).to_string(),
        Value::Real(r) => r.to_string(),
    }
}
