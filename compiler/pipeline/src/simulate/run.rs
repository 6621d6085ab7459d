//! A run over a trace as it comes, beside a recording as it comes, that hands on what comes of it.

use super::Simulation;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, Extract, FileId, Policy, Severity};
use grafc_model::simulate::{Call, Onlooker, Run};
use grafc_model::trace::{Between, BrokenClaims, Kept, Recording, Stimuli};
use std::io::{self, Read};

/// A text that is read as it comes.
pub struct Text<'a> {
    /// What messages call it by.
    pub file: FileId,
    /// Its bytes.
    pub bytes: &'a mut dyn Read,
    /// Whether the caller has all of it; else messages come with the rows that they are about.
    pub kept: Kept,
}

/// What takes the calls of a run, one after the other.
pub trait Results {
    /// The run begins, over a trace whose header has no errors; whether its rows can say that the controller has restarted.
    ///
    /// # Errors
    /// Ends the run.
    fn begin(&mut self, restarts: bool) -> io::Result<()>;

    /// The chart was called.
    ///
    /// # Errors
    /// Ends the run.
    fn called(&mut self, call: Call) -> io::Result<()>;
}

/// What is to be said of a run.
#[derive(Default)]
pub struct Outcome {
    /// What was found in trace and recording.
    pub diagnostics: Diagnostics,
    /// Rows of the recording, if there was one.
    pub compared: Option<u64>,
    /// Of texts that nobody keeps, the rows that the messages are about ([`SourceMap::show`]).
    ///
    /// [`SourceMap::show`]: grafc_diagnostics::SourceMap::show
    pub extracts: Vec<(FileId, Extract)>,
}

/// Why a run was ended: what could not be read or written.
#[derive(Debug)]
pub enum Ended {
    /// The trace.
    Trace(io::Error),
    /// The recording.
    Recording(io::Error),
    /// The results.
    Results(io::Error),
}

impl Simulation {
    /// Runs the chart over a trace, compared with a recording if there is one. Results are handed on up to the first error
    /// of trace or recording; both are read to their ends for more.
    ///
    /// # Errors
    /// Something cannot be read or written.
    pub fn run(
        &self,
        trace: Text,
        recorded: Option<Text>,
        policy: &Policy,
        results: &mut dyn Results,
    ) -> Result<Outcome, Ended> {
        let file = trace.file;
        let mut rows = Stimuli::new(file, trace.bytes, &self.chart, trace.kept).map_err(Ended::Trace)?;
        let recorded_file = recorded.as_ref().map(|text| text.file);
        let recording = recorded.map(|text| Recording::new(text.file, text.bytes, &self.chart, text.kept));
        let recording = recording.transpose().map_err(Ended::Recording)?;
        let (has_restarts, is_denied) = (rows.has_restarts(), is_denied(policy));
        let mut watch = Watch {
            results,
            recording,
            has_restarts,
            is_begun: false,
            is_denied,
            found: Vec::new(),
            broken: BrokenClaims::default(),
        };
        let mut run = Run::new(&self.chart, self.profile, self.calls, &self.probes).watching_claims();
        let mut is_running = true;
        while let Some(stimulus) = rows.next_row().map_err(Ended::Trace)? {
            is_running &= !rows.has_errors();
            if !is_running {
                continue;
            }
            match run.row(stimulus, &mut watch) {
                Ok(()) => {}
                Err(Stop::Found) => is_running = false,
                Err(Stop::Refused(ended)) => return Err(ended),
            }
            for found in watch.found.drain(..) {
                let (here, before) = rows.places();
                rows.say(found.told(here, before));
            }
            if watch.broken.has_found() {
                let (here, _) = rows.places();
                watch.broken.told(&self.chart, here).into_iter().for_each(|told| rows.came_of_it(told));
            }
        }
        let differs = watch.recording.as_ref().is_some_and(Recording::differs);
        if is_running && !rows.has_errors() && !differs {
            watch.begin().map_err(Ended::Results)?;
        }
        let is_whole = !rows.has_errors();
        let (mut diagnostics, extract) = rows.finish();
        let mut extracts = vec![(file, extract)];
        let mut compared = None;
        // Where the trace is faulty, so is what comes of it.
        if let (Some(recording), Some(file), true) = (watch.recording, recorded_file, is_whole) {
            let (count, found, extract) = recording.finish().map_err(Ended::Recording)?;
            diagnostics.append(found);
            extracts.push((file, extract));
            compared = Some(count);
        }
        Ok(Outcome { diagnostics, compared, extracts })
    }
}

/// Whether the warning of a delay that ends unseen is taken for an error.
fn is_denied(policy: &Policy) -> bool {
    let mut one = Diagnostics::new();
    one.push(Diagnostic::new(Code::W0601, grafc_diagnostics::Span::default(), ""));
    policy.apply(&mut one);
    one.iter().any(|warning| warning.severity() == Severity::Error)
}

/// What looks on: it compares, and hands on.
struct Watch<'a, R> {
    results: &'a mut dyn Results,
    recording: Option<Recording<'a, R>>,
    has_restarts: bool,
    is_begun: bool,
    is_denied: bool,
    found: Vec<Between>,
    broken: BrokenClaims,
}

/// Why the chart is not called any more.
enum Stop {
    /// There is an error.
    Found,
    /// Something cannot be read or written.
    Refused(Ended),
}

impl<R: Read> Watch<'_, R> {
    fn begin(&mut self) -> io::Result<()> {
        if std::mem::replace(&mut self.is_begun, true) { Ok(()) } else { self.results.begin(self.has_restarts) }
    }
}

impl<R: Read> Onlooker for Watch<'_, R> {
    type End = Stop;

    fn called(&mut self, call: Call) -> Result<(), Stop> {
        self.broken.called(call.stimulus.t_ms, call.broken);
        if let Some(recording) = &mut self.recording {
            let compared = recording.called(call.stimulus.t_ms, call.response);
            compared.map_err(|error| Stop::Refused(Ended::Recording(error)))?;
            if recording.differs() {
                return Err(Stop::Found);
            }
        }
        self.begin().and_then(|()| self.results.called(call)).map_err(|error| Stop::Refused(Ended::Results(error)))
    }

    fn unseen(&mut self, t_ms: i64) -> Result<(), Stop> {
        self.found.push(Between::Unseen(t_ms));
        if self.is_denied { Err(Stop::Found) } else { Ok(()) }
    }

    fn too_many(&mut self) -> Stop {
        self.found.push(Between::TooMany);
        Stop::Found
    }
}
