//! A whole run over the rows of a trace, one after the other, with calls between them.

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

/// So many calls between the rows there are in one run. It is far more than anybody reads, and not without end: of two
/// rows, one may have a time of many years by mistake.
pub const MOST_CALLS: u64 = 100_000_000;

/// So many delays may end unseen and change nothing; what comes behind is not looked at.
const PATIENCE: u32 = 1_000_000;

/// One call, and what came of it.
#[derive(Clone, Copy, Debug)]
pub struct Call<'a> {
    /// What it was given.
    pub stimulus: &'a Stimulus,
    /// What it gave back.
    pub response: &'a Response,
    /// What was looked at after it.
    pub looks: &'a [Value],
    /// The claims that it broke, by their places; none if nobody looks at claims.
    pub broken: &'a [usize],
}

/// What looks on while a chart is run, and may end that.
pub trait Onlooker {
    /// Why a run is ended.
    type End;

    /// The chart was called.
    ///
    /// # Errors
    /// Ends the run.
    fn called(&mut self, call: Call) -> Result<(), Self::End>;

    /// Before the row at hand, a delay ended at this time that no call saw, and changed something. That is told once.
    ///
    /// # Errors
    /// Ends the run.
    fn unseen(&mut self, t_ms: i64) -> Result<(), Self::End>;

    /// Before the row at hand there are more calls than there can be, and the run ends.
    fn too_many(&mut self) -> Self::End;

    /// Who sees each micro-step, and the simulator at rest after each call at its time; nobody, if nothing is said.
    fn observer(&mut self) -> Option<&mut dyn Observer> {
        None
    }
}

/// What sees a chart from within while it is run.
pub trait Observer {
    /// A micro-step was done, or the chart has just started.
    fn micro_step(&mut self, simulator: &Simulator);

    /// A call is over, which was at this time.
    fn rested(&mut self, simulator: &mut Simulator, t_ms: i64);
}

/// A chart that is called at the rows of a trace, and between them.
pub struct Run<'a> {
    simulator: Simulator<'a>,
    calls: Calls,
    probes: &'a [Probe],
    /// The row before.
    before: Option<Stimulus>,
    /// The time of the first row.
    start: i64,
    /// What the latest call came to.
    shown: Option<Response>,
    /// The chart called where delays end as well, from the first such instant on; before that it is the same.
    exact: Option<Simulator<'a>>,
    /// Whether it was told that a delay ended unseen: from there on the run is another one.
    is_told: bool,
    /// So many calls there may still be between rows.
    left: u64,
    /// So many ends of delays are still looked at that no call sees.
    patience: u32,
}

impl<'a> Run<'a> {
    /// A run that is to begin.
    pub fn new(chart: &'a Chart, profile: Profile, calls: Calls, probes: &'a [Probe]) -> Self {
        Run {
            simulator: Simulator::new(chart, profile),
            calls,
            probes,
            before: None,
            start: 0,
            shown: None,
            exact: None,
            is_told: false,
            left: MOST_CALLS,
            patience: PATIENCE,
        }
    }

    /// The same, and looks at what is claimed of the chart.
    pub fn watching_claims(mut self) -> Self {
        self.simulator.watch_claims();
        self
    }

    /// Calls the chart up to the next row, and at it.
    ///
    /// # Errors
    /// The onlooker ended the run.
    pub fn row<O: Onlooker>(&mut self, row: Stimulus, onlooker: &mut O) -> Result<(), O::End> {
        match self.before.take() {
            Some(before) => self.between(&before, row.t_ms, onlooker)?,
            None => self.start = row.t_ms,
        }
        let response = self.react(&row, onlooker);
        if let Some(other) = &mut self.exact
            && other.react(&row) != response
        {
            self.tell(row.t_ms, onlooker)?;
        }
        self.show(&row, response, onlooker)?;
        self.before = Some(row);
        Ok(())
    }

    fn between<O: Onlooker>(&mut self, before: &Stimulus, next: i64, onlooker: &mut O) -> Result<(), O::End> {
        let at = |t_ms| Stimulus { t_ms, restart: false, inputs: before.inputs.clone() };
        match self.calls {
            Calls::Rows => {
                if let Some(at) = (!self.is_told).then(|| self.unseen(before, next)).flatten() {
                    self.tell(at, onlooker)?;
                }
            }
            Calls::Every(period) => {
                let from = before.t_ms.saturating_add(period - (before.t_ms - self.start) % period);
                // What is too much is refused before it is begun.
                let count = u64::try_from((next - 1).saturating_sub(from)).map_or(0, |span| span / period as u64 + 1);
                self.left = self.left.checked_sub(count).ok_or_else(|| onlooker.too_many())?;
                let mut now = from;
                while now < next {
                    let stimulus = at(now);
                    let response = self.react(&stimulus, onlooker);
                    self.show(&stimulus, response, onlooker)?;
                    now = now.saturating_add(period);
                }
            }
            Calls::Events => {
                let mut now = before.t_ms;
                while let Some(event) = self.simulator.next_event(now, next) {
                    self.left = self.left.checked_sub(1).ok_or_else(|| onlooker.too_many())?;
                    let stimulus = at(event);
                    let response = self.react(&stimulus, onlooker);
                    self.show(&stimulus, response, onlooker)?;
                    now = event;
                }
            }
        }
        Ok(())
    }

    fn react<O: Onlooker>(&mut self, stimulus: &Stimulus, onlooker: &mut O) -> Response {
        let Some(observer) = onlooker.observer() else { return self.simulator.react(stimulus) };
        if self.simulator.seen().is_none() {
            self.simulator.look_on();
        }
        let response = self.simulator.react_observed(stimulus, &mut |simulator| observer.micro_step(simulator));
        observer.rested(&mut self.simulator, stimulus.t_ms);
        response
    }

    fn show<O: Onlooker>(&mut self, stimulus: &Stimulus, response: Response, onlooker: &mut O) -> Result<(), O::End> {
        let looks = match self.probes {
            [] => Vec::new(),
            probes => self.simulator.look(probes, stimulus.t_ms),
        };
        let broken = self.simulator.broken();
        onlooker.called(Call { stimulus, response: &response, looks: &looks, broken })?;
        self.shown = Some(response);
        Ok(())
    }

    fn tell<O: Onlooker>(&mut self, at: i64, onlooker: &mut O) -> Result<(), O::End> {
        self.exact = None;
        self.is_told = true;
        onlooker.unseen(at)
    }

    /// Where a delay ends between a row and the next one and changes something at once.
    fn unseen(&mut self, row: &Stimulus, next: i64) -> Option<i64> {
        let mut now = row.t_ms;
        let shown = self.shown.as_ref()?;
        while let Some(at) = self.exact.as_ref().unwrap_or(&self.simulator).next_event(now, next) {
            let other = self.exact.get_or_insert_with(|| self.simulator.clone());
            let stimulus = Stimulus { t_ms: at, restart: false, inputs: row.inputs.clone() };
            if other.react(&stimulus) != *shown {
                return Some(at);
            }
            now = at;
            self.patience -= 1;
            if self.patience == 0 {
                self.exact = None;
                self.is_told = true;
                break;
            }
        }
        None
    }
}
