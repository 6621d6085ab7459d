//! A chart over a trace, with the reference simulator.
//!
//! [`Simulation::new`] reads the chart and what is wanted of it; [`Simulation::run`] takes it over a trace that is read
//! as it comes, and hands on each call as it is made: neither is kept, so that a run of any length takes the memory of one
//! call. [`simulate`] does both for a trace at hand, and keeps what comes of it.

mod kept;
mod run;
mod shown;

use crate::compile::{bounded, check};
use crate::stages::flatten;
use grafc_diagnostics::{Diagnostics, FileId};
use grafc_logic::scan::{Claimed, Program};
use grafc_logic::{Analysis, Extras};
use grafc_model::chart::{Chart, ControlNames};
use grafc_model::reaction::{Asked, Profile};
use grafc_model::simulate::{Calls, Probe};
use grafc_model::trace::Shown;

pub use kept::{KeptCall, Record, simulate};
pub use run::{Ended, Outcome, Results, Text};
pub use shown::NotShown;

/// How a chart is run over a trace.
#[derive(Clone, Copy, Default)]
pub struct Run<'a> {
    /// How it evolves, where its heading does not choose.
    pub profile: Profile,
    /// What was asked for of that; what the heading chooses otherwise is refused (E0217).
    pub asked: Asked,
    /// Whether the bound on micro-steps is the one that is known to be enough, where one is.
    pub bound_as_known: bool,
    /// Inputs that act on it as a whole, if there are any.
    pub controls: Option<&'a ControlNames>,
    /// When it is called.
    pub calls: Calls,
    /// What is shown beside the outputs: `inputs`, `vars`, `steps`, and names as in conditions; a name that is one of
    /// these words stands in backquotes.
    pub show: &'a [String],
}

/// A profile with the bound on micro-steps that is known to be enough, if one is that is no larger than usual.
pub fn known_bound(chart: &Chart, profile: Profile) -> Profile {
    let Some(net) = flatten(chart.clone(), false, &mut Diagnostics::new()) else { return profile };
    let lowering = grafc_logic::Options { profile, ..grafc_logic::Options::default() };
    bounded(&lowering, true, &Analysis::new(net)).profile
}

/// A chart that can be run over traces.
pub struct Simulation {
    /// The chart.
    pub chart: Chart,
    /// What is looked at beside the outputs.
    pub probes: Vec<Probe>,
    /// So many of them, inputs, are shown before the outputs.
    before: usize,
    profile: Profile,
    calls: Calls,
}

impl Simulation {
    /// A chart, if it has no errors.
    ///
    /// # Errors
    /// The first word of [`Run::show`] that the chart has nothing for, and the nearest that it has.
    pub fn new(
        chart: (FileId, &str),
        default_name: &str,
        how: Run,
    ) -> (Result<Option<Simulation>, NotShown>, Diagnostics) {
        let (chart, mut diagnostics) = check(chart.0, chart.1, default_name);
        let Some(mut chart) = chart else { return (Ok(None), diagnostics) };
        if let Some(Err(found)) = how.controls.map(|names| chart.control(names)) {
            diagnostics.append(found);
            return (Ok(None), diagnostics);
        }
        let against = chart.options.against(&how.asked);
        if against.has_errors() {
            diagnostics.append(against);
            return (Ok(None), diagnostics);
        }
        let (probes, before) = match shown::probes(&chart, how.show) {
            Ok(found) => found,
            Err(word) => return (Err(NotShown { near: shown::near(&chart, &word), word }), diagnostics),
        };
        let profile = if how.bound_as_known { known_bound(&chart, how.profile) } else { how.profile };
        let simulation = Simulation { chart, probes, before, profile, calls: how.calls };
        (Ok(Some(simulation)), diagnostics)
    }

    /// The scan program that does in each call what the simulation does, with what is claimed of the chart: for who runs many
    /// scenarios of it. None if the chart cannot be lowered, which is said.
    pub fn program(&self) -> (Option<Program>, Diagnostics) {
        let mut diagnostics = Diagnostics::new();
        let Some(net) = flatten(self.chart.clone(), false, &mut diagnostics) else { return (None, diagnostics) };
        let options = grafc_logic::Options { profile: self.profile, ..grafc_logic::Options::default() };
        let extras = Extras { claims: Claimed::All, ..Extras::default() };
        let (program, found) = grafc_logic::compile_with(Analysis::new(net), &options, extras);
        if found.has_errors() { (None, found) } else { (Some(program), Diagnostics::new()) }
    }

    /// The columns of a result, of a trace that may or may not say that the controller has restarted.
    pub fn shown(&self, restarts: bool) -> Shown<'_> {
        Shown { restarts: restarts && self.before > 0, probes: &self.probes, before: self.before }
    }
}
