//! A whole run over the rows of a trace, with calls between them.

use super::{Probe, Simulator};
use crate::chart::{Chart, Value};
use crate::reaction::{Profile, Response, Stimulus};

/// When the chart is called.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Calls {
    /// At the rows of the trace.
    #[default]
    Rows,
    /// At the rows, and between them at this period, in milliseconds, from the first row on.
    Every(i64),
    /// At the rows, and between them exactly where a delay ends.
    Events,
}

/// So many calls of one run are kept.
pub const MOST_CALLS: usize = 1_000_000;

/// What a run was.
#[derive(Debug, Default)]
pub struct Record {
    /// The calls.
    pub stimuli: Vec<Stimulus>,
    /// What came of each.
    pub responses: Vec<Response>,
    /// What was looked at after each.
    pub looks: Vec<Vec<Value>>,
    /// Where the first delay ended that no call saw, and changed something: the row behind it, and the time.
    pub unseen: Option<(usize, i64)>,
    /// The row before which there were more calls than are kept, and the run ended.
    pub cut: Option<usize>,
}

/// Runs a chart over the rows of a trace.
pub fn run(chart: &Chart, profile: Profile, rows: &[Stimulus], calls: Calls, probes: &[Probe]) -> Record {
    let mut run = Run { simulator: Simulator::new(chart, profile), probes, record: Record::default() };
    let mut exact: Option<Simulator> = None;
    for (index, row) in rows.iter().enumerate() {
        run.call(row.clone());
        let response = &run.record.responses[run.record.responses.len() - 1];
        if let Some(other) = &mut exact {
            let seen = other.react(row);
            // From here on the run is another one.
            if run.record.unseen.is_none() && seen != *response {
                run.record.unseen = Some((index, row.t_ms));
            }
        }
        let Some(next) = rows.get(index + 1).map(|next| next.t_ms) else { break };
        let between = |t_ms| Stimulus { t_ms, restart: false, inputs: row.inputs.clone() };
        match calls {
            Calls::Rows => {
                if run.record.unseen.is_none() {
                    run.record.unseen = run.unseen(&mut exact, row, next).map(|at| (index + 1, at));
                }
                if run.record.unseen.is_some() {
                    exact = None;
                }
            }
            Calls::Every(period) => {
                let start = rows[0].t_ms;
                let mut at = start + ((row.t_ms - start) / period + 1) * period;
                while at < next && run.is_short(index + 1) {
                    run.call(between(at));
                    at += period;
                }
            }
            Calls::Events => {
                let mut now = row.t_ms;
                while let Some(at) = run.simulator.next_event(now, next).filter(|_| run.is_short(index + 1)) {
                    run.call(between(at));
                    now = at;
                }
            }
        }
        if run.record.cut.is_some() {
            break;
        }
    }
    run.record
}

struct Run<'a> {
    simulator: Simulator<'a>,
    probes: &'a [Probe],
    record: Record,
}

impl<'a> Run<'a> {
    fn call(&mut self, stimulus: Stimulus) {
        self.record.responses.push(self.simulator.react(&stimulus));
        if !self.probes.is_empty() {
            self.record.looks.push(self.simulator.look(self.probes, stimulus.t_ms));
        }
        self.record.stimuli.push(stimulus);
    }

    /// Whether there may be another call before a row.
    fn is_short(&mut self, row: usize) -> bool {
        if self.record.stimuli.len() >= MOST_CALLS {
            self.record.cut = Some(row);
        }
        self.record.cut.is_none()
    }

    /// Where a delay ends between a row and the next one and changes something at once. `exact` is the chart called there,
    /// too, from the first such delay on; before that it is the same.
    fn unseen(&self, exact: &mut Option<Simulator<'a>>, row: &Stimulus, next: i64) -> Option<i64> {
        let mut now = row.t_ms;
        let shown = self.record.responses.last()?;
        while let Some(at) = exact.as_ref().unwrap_or(&self.simulator).next_event(now, next) {
            let other = exact.get_or_insert_with(|| self.simulator.clone());
            let stimulus = Stimulus { t_ms: at, restart: false, inputs: row.inputs.clone() };
            if other.react(&stimulus) != *shown {
                return Some(at);
            }
            now = at;
        }
        None
    }
}
