//! A result trace.

use super::columns::{FLAGS, SITUATION, TIME, heading};
use crate::chart::{Chart, Type, Value, VariableKind};
use crate::reaction::{Response, Stimulus};

/// Writes a result trace, a row for each response.
pub fn write_trace(chart: &Chart, stimuli: &[Stimulus], responses: &[Response]) -> String {
    let outputs = || chart.variables.iter().filter(|variable| variable.kind == VariableKind::Output);
    let mut writer = csv::Writer::from_writer(Vec::new());
    // Writing to memory does not fail, and all rows are equally long: there is no error to hand on.
    let mut write = |row: Vec<String>| {
        let _ = writer.write_record(&row);
    };
    let mut header = vec![TIME.to_string()];
    header.extend(outputs().map(|variable| heading(&variable.name).into_owned()));
    header.extend([SITUATION.to_string(), FLAGS.to_string()]);
    write(header);
    for (stimulus, response) in stimuli.iter().zip(responses) {
        let mut row = vec![stimulus.t_ms.to_string()];
        row.extend(outputs().zip(&response.outputs).map(|(variable, &value)| cell(variable.ty, value)));
        let labels: Vec<&str> = response.situation.iter().map(|&step| chart.steps[step].label.as_str()).collect();
        row.push(labels.join(" "));
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
