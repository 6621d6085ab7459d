//! A chart over a trace, with the reference simulator.

use crate::compile::check;
use grafc_diagnostics::{Diagnostics, FileId};
use grafc_model::reaction::Profile;
use grafc_model::simulate::Simulator;
use grafc_model::trace;

/// What a chart does over a trace.
pub struct Simulation {
    /// The trace of its outputs.
    pub result: String,
    /// Rows of the recording that it was compared with, if there was one.
    pub compared: Option<usize>,
}

/// A chart and a trace of its inputs to a trace of its outputs, compared with one that was recorded elsewhere.
pub fn simulate(
    chart: (FileId, &str),
    default_name: &str,
    trace: (FileId, &str),
    recorded: Option<(FileId, &str)>,
    profile: Profile,
) -> (Option<Simulation>, Diagnostics) {
    let (chart, mut diagnostics) = check(chart.0, chart.1, default_name);
    let Some(chart) = chart else { return (None, diagnostics) };
    let (stimuli, found) = trace::parse_trace(trace.0, trace.1, &chart);
    diagnostics.append(found);
    if diagnostics.has_errors() {
        return (None, diagnostics);
    }
    let mut simulator = Simulator::new(&chart, profile);
    let responses: Vec<_> = stimuli.iter().map(|stimulus| simulator.react(stimulus)).collect();
    let compared = recorded.map(|(file, text)| {
        let (rows, found) = trace::compare_trace(file, text, &chart, &stimuli, &responses);
        diagnostics.append(found);
        rows
    });
    (Some(Simulation { result: trace::write_trace(&chart, &stimuli, &responses), compared }), diagnostics)
}
