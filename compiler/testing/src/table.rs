//! A test as a table: the chart is called at its rows, and each cell behind the column `|` is compared.

use crate::coverage::Coverage;
use grafc_diagnostics::{Diagnostics, FileId};
use grafc_model::chart::{Chart, Value};
use grafc_model::reaction::{Profile, Response};
use grafc_model::simulate::{Call, Calls, Observer, Onlooker, Run};
use grafc_model::trace::{Between, BrokenClaims, Expectations};

/// Runs a test, and says what is wrong with it, or with what the chart does in it. What it makes happen is added to the
/// coverage, if somebody measures that.
pub fn table(
    chart: &Chart,
    profile: Profile,
    (file, text): (FileId, &str),
    coverage: Option<&mut Coverage>,
) -> Diagnostics {
    // Memory can be read.
    let Ok(mut expectations) = Expectations::new(file, text.as_bytes(), chart) else { return Diagnostics::new() };
    let probes = expectations.probes().to_vec();
    let mut run = Run::new(chart, profile, Calls::Rows, &probes).watching_claims();
    let mut watch = Watch { latest: None, found: Vec::new(), broken: BrokenClaims::default(), coverage };
    watch.begin();
    // A faulty table is read to its end, but the chart is not run on guesses.
    let mut is_running = !expectations.has_errors();
    loop {
        let faults = expectations.faults();
        let Ok(Some(stimulus)) = expectations.next_row() else { break };
        watch.latest = None;
        is_running &= expectations.faults() == faults;
        if is_running {
            is_running = run.row(stimulus, &mut watch).is_ok();
        }
        for found in watch.found.drain(..) {
            let (here, before) = expectations.places();
            let said = found.told(here, before);
            expectations.say(if found == Between::TooMany { said } else { said.help("add a row at this time") });
        }
        let (here, _) = expectations.places();
        watch.broken.told(chart, here).into_iter().for_each(|told| expectations.say(told));
        let latest = watch.latest.as_ref().map(|(response, looks)| (response, looks.as_slice()));
        expectations.compare(latest);
    }
    expectations.finish()
}

/// What looks on: it keeps what the latest call came to.
struct Watch<'a, 'c> {
    latest: Option<(Response, Vec<Value>)>,
    found: Vec<Between>,
    broken: BrokenClaims,
    coverage: Option<&'a mut Coverage<'c>>,
}

impl Watch<'_, '_> {
    fn begin(&mut self) {
        if let Some(coverage) = &mut self.coverage {
            coverage.begin();
        }
    }
}

/// The run cannot go on.
struct Stop;

impl Onlooker for Watch<'_, '_> {
    type End = Stop;

    fn called(&mut self, call: Call) -> Result<(), Stop> {
        self.broken.called(call.stimulus.t_ms, call.broken);
        self.latest = Some((call.response.clone(), call.looks.to_vec()));
        Ok(())
    }

    fn unseen(&mut self, t_ms: i64) -> Result<(), Stop> {
        self.found.push(Between::Unseen(t_ms));
        Ok(())
    }

    fn too_many(&mut self) -> Stop {
        self.found.push(Between::TooMany);
        Stop
    }

    fn observer(&mut self) -> Option<&mut dyn Observer> {
        self.coverage.as_deref_mut().map(|coverage| coverage as &mut dyn Observer)
    }
}
