//! A test as a table: what is given, a column `|`, and what is expected.

use super::columns::{BAR, SITUATION, TIME, heading};
use super::results::{About, Results};
use super::write::cell;
use crate::chart::{Chart, Value, VariableKind};
use crate::reaction::{Response, Stimulus};
use crate::simulate::Probe;

/// Writes a test: a row for each call, with the outputs, what the probes show and the situation as what is expected. An
/// input has its value where that changes.
pub fn write_test(
    chart: &Chart,
    stimuli: &[Stimulus],
    responses: &[Response],
    probes: &[Probe],
    looks: &[Vec<Value>],
) -> String {
    let results = Results::new(chart);
    let inputs = || chart.variables.iter().filter(|variable| variable.kind == VariableKind::Input);
    let outputs = (0..results.outputs.len()).map(About::Output);
    let probes = probes.iter().enumerate().map(|(place, probe)| About::Probe(*probe, place));
    let expected: Vec<About> = outputs.chain(probes).collect();
    let mut writer = csv::Writer::from_writer(Vec::new());
    let mut header = vec![TIME.to_string()];
    header.extend(inputs().map(|input| heading(&input.name).into_owned()));
    header.push(BAR.to_string());
    header.extend(expected.iter().map(|about| heading(&results.name(*about)).into_owned()));
    header.push(SITUATION.to_string());
    // Writing to memory does not fail.
    let _ = writer.write_record(&header);
    let mut before: Option<&Stimulus> = None;
    for ((stimulus, response), looks) in stimuli.iter().zip(responses).zip(looks) {
        let mut row = vec![stimulus.t_ms.to_string()];
        for (place, (input, value)) in inputs().zip(&stimulus.inputs).enumerate() {
            let is_same = before.is_some_and(|before| before.inputs.get(place) == Some(value));
            row.push(if is_same { String::new() } else { cell(input.ty, *value) });
        }
        row.push(String::new());
        for about in expected.iter().chain([&About::Situation]) {
            let done = results.done(*about, response, looks);
            row.push(done.map(|done| results.spelled(*about, &done)).unwrap_or_default());
        }
        let _ = writer.write_record(&row);
        before = Some(stimulus);
    }
    String::from_utf8_lossy(&writer.into_inner().unwrap_or_default()).into_owned()
}
