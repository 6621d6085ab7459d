//! A run over a trace at hand, of which everything is kept.

use super::{NotShown, Results, Run, Simulation, Text};
use grafc_diagnostics::{Diagnostics, FileId, Policy};
use grafc_model::chart::Value;
use grafc_model::reaction::{Response, Stimulus};
use grafc_model::simulate::Call;
use grafc_model::trace::{Kept, Table};
use std::io;

/// What a chart did over a trace.
pub struct Record {
    /// The chart, and what was looked at.
    pub simulation: Simulation,
    /// Its calls, and what came of each.
    pub calls: Vec<KeptCall>,
    /// Rows of the recording that it was compared with, if there was one.
    pub compared: Option<u64>,
    restarts: bool,
}

/// A call, and what came of it.
pub struct KeptCall {
    /// What it was given.
    pub stimulus: Stimulus,
    /// What it gave back.
    pub response: Response,
    /// What was looked at after it.
    pub looks: Vec<Value>,
}

impl Record {
    /// The trace of its outputs, and of what else is shown.
    pub fn csv(&self) -> String {
        let shown = self.simulation.shown(self.restarts);
        let mut table = Table::new(Vec::new(), &self.simulation.chart, shown);
        // Writing to memory does not fail.
        let _ = table.header();
        for call in &self.calls {
            let _ = table.row(&call.stimulus, &call.response, &call.looks);
        }
        String::from_utf8_lossy(&table.into_inner().unwrap_or_default()).into_owned()
    }
}

/// A chart and a trace of its inputs to what it does, compared with a trace that was recorded elsewhere. There is a record
/// if chart and trace have no errors.
///
/// All of it is in memory; [`Simulation::run`] is for traces of any length.
///
/// # Errors
/// The first word of [`Run::show`] that the chart has nothing for, and the nearest that it has.
pub fn simulate(
    chart: (FileId, &str),
    default_name: &str,
    trace: (FileId, &str),
    recorded: Option<(FileId, &str)>,
    how: Run,
) -> (Result<Option<Record>, NotShown>, Diagnostics) {
    let (simulation, mut diagnostics) = Simulation::new(chart, default_name, how);
    let simulation = match simulation {
        Ok(Some(simulation)) => simulation,
        Ok(None) => return (Ok(None), diagnostics),
        Err(word) => return (Err(word), diagnostics),
    };
    let mut calls = Calls::default();
    let mut bytes = trace.1.as_bytes();
    let mut recorded = recorded.map(|(file, text)| (file, text.as_bytes()));
    let trace = Text { file: trace.0, bytes: &mut bytes, kept: Kept::Whole };
    let recorded = recorded.as_mut().map(|(file, bytes)| Text { file: *file, bytes, kept: Kept::Whole });
    let outcome = simulation.run(trace, recorded, &Policy::default(), &mut calls);
    // Memory can be read and written.
    let outcome = outcome.unwrap_or_default();
    diagnostics.append(outcome.diagnostics);
    let Calls { calls, restarts, is_begun } = calls;
    let record = is_begun.then_some(Record { simulation, calls, compared: outcome.compared, restarts });
    (Ok(record.filter(|_| !diagnostics.has_errors())), diagnostics)
}

#[derive(Default)]
struct Calls {
    calls: Vec<KeptCall>,
    restarts: bool,
    is_begun: bool,
}

impl Results for Calls {
    fn begin(&mut self, restarts: bool) -> io::Result<()> {
        (self.restarts, self.is_begun) = (restarts, true);
        Ok(())
    }

    fn called(&mut self, call: Call) -> io::Result<()> {
        let Call { stimulus, response, looks, broken: _ } = call;
        self.calls.push(KeptCall { stimulus: stimulus.clone(), response: response.clone(), looks: looks.to_vec() });
        Ok(())
    }
}
