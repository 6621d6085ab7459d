//! A folder of traces: 64 of them at once in the scan program, and the results in another folder.
//!
//! What comes out is what the simulator gives for each trace alone, row by row. Where a claim is broken, the simulator is
//! asked to say it of that trace.

use super::arguments::Arguments;
use crate::Exit;
use crate::report::{Failure, Report};
use crate::stream::Stream;
use grafc::files::{self, Refusal, Writing};
use grafc::{Ended, Results, Run, Simulation, Text};
use grafc_diagnostics::{Code, FileId, Severity};
use grafc_lanes::{LANES, Lanes};
use grafc_logic::scan::{Program, VarId};
use grafc_model::reaction::Stimulus;
use grafc_model::simulate::{Call, Calls};
use grafc_model::trace::{Kept, Shown, Stimuli, Table};
use std::io::{self, Read};
use std::path::{Path, PathBuf};

/// Runs one chart over the traces of a folder.
pub fn run(args: Arguments, folder: &Path) -> Result<Exit, Failure> {
    let into = into(&args, folder)?;
    let traces = traces_in(folder)?;
    let mut report = Report::new(args.messages.policy()?);
    let messages = args.messages.messages();
    let Some(chart) = report.load(&args.chart)? else { return Ok(report.tell(messages)) };
    let controls = args.controls.names();
    let (asked, bound_as_known) = (args.profile.asked()?, args.profile.bound_as_known());
    let calls = Calls::Rows;
    let how = Run { profile: asked.profile(), asked, bound_as_known, controls: Some(&controls), calls, show: &[] };
    let text = (chart, report.sources.file(chart).text.as_str());
    let (simulation, diagnostics) = Simulation::new(text, &args.chart.chart_name(), how);
    report.diagnostics.append(diagnostics);
    // Nothing is to be shown, so nothing can be unknown.
    let Some(simulation) = simulation.ok().flatten().filter(|_| !report.is_refused()) else {
        return Ok(report.tell(messages));
    };
    let (program, diagnostics) = simulation.program();
    report.diagnostics.append(diagnostics);
    let Some(program) = program else { return Ok(report.tell(messages)) };

    files::make_folder(&into)?;
    for group in traces.chunks(LANES) {
        let mut lanes = Lanes::new(&program);
        let mut scenarios = Vec::with_capacity(group.len());
        for path in group {
            scenarios.push(Scenario::new(path, &into, &simulation, &mut report)?);
        }
        together(&mut lanes, &program, &mut scenarios)?;
        for scenario in scenarios {
            scenario.end(&simulation, &mut report)?;
        }
    }
    let exit = report.tell(messages);
    if !report.has_errors() && messages.is_for_people() {
        let count = traces.len();
        let said = if count == 1 { "1 trace was run".to_owned() } else { format!("{count} traces were run") };
        files::print(&format!("{said}: {}\n", into.display()))?;
    }
    Ok(exit)
}

/// The folder for the results.
fn into(args: &Arguments, folder: &Path) -> Result<PathBuf, Failure> {
    let wrong = |what: String, help: &str| Err(Failure::WrongUse(what, help.to_owned()));
    let Some(Stream::File(into)) = &args.output else {
        return wrong(
            "the results of several traces do not go to standard output".to_owned(),
            "name a folder: `-o results/`",
        );
    };
    if into.exists() && !into.is_dir() {
        return wrong(format!("`{}` is no folder", into.display()), "name a folder for the results");
    }
    let same = std::fs::canonicalize(folder).ok().zip(std::fs::canonicalize(into).ok());
    if same.is_some_and(|(one, other)| one == other) {
        return wrong("the results would overwrite the traces".to_owned(), "name another folder after `-o`");
    }
    Ok(into.clone())
}

/// The traces of a folder, by their names.
fn traces_in(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let refused = |error| Refusal::to_read(folder.display().to_string(), error);
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(refused)? {
        let path = entry.map_err(refused)?.path();
        if path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("csv")) && path.is_file() {
            found.push(path);
        }
    }
    if found.is_empty() {
        let what = format!("`{}` has no traces", folder.display());
        return Err(Failure::WrongUse(what, "a trace is a file NAME.csv in the folder itself".to_owned()));
    }
    found.sort();
    Ok(found)
}

/// A trace, and where its result goes.
struct Scenario<'s> {
    trace: Stream,
    result: PathBuf,
    file: FileId,
    rows: Stimuli<'s, Box<dyn Read>>,
    table: Table<'s, Writing>,
    /// The row that is run.
    row: Option<Stimulus>,
    /// Whether the trace is over, as far as it is right.
    is_over: bool,
    /// Whether an assumption or an assertion came out false.
    is_broken: bool,
}

impl<'s> Scenario<'s> {
    fn new(path: &Path, into: &Path, simulation: &'s Simulation, report: &mut Report) -> Result<Self, Refusal> {
        let trace = Stream::File(path.to_path_buf());
        let result = into.join(trace.file_name());
        let file = report.name(&trace);
        let (bytes, _) = trace.open()?;
        let rows = Stimuli::new(file, bytes, &simulation.chart, Kept::Rows);
        let rows = rows.map_err(|error| Refusal::to_read(trace.input_name(), error))?;
        let mut table = Table::new(files::begin(&result)?, &simulation.chart, Shown::default());
        table.header().map_err(|error| Refusal::to_write(result.display().to_string(), error))?;
        let is_over = rows.has_errors();
        Ok(Scenario { trace, result, file, rows, table, row: None, is_over, is_broken: false })
    }

    /// Takes the next row, up to the first error.
    fn next(&mut self) -> Result<(), Refusal> {
        let next = if self.is_over { Ok(None) } else { self.rows.next_row() };
        let next = next.map_err(|error| Refusal::to_read(self.trace.input_name(), error))?;
        self.row = next.filter(|_| !self.rows.has_errors());
        self.is_over = self.row.is_none();
        Ok(())
    }

    /// Says what is wrong with the trace, or puts the result into its place.
    fn end(mut self, simulation: &Simulation, report: &mut Report) -> Result<(), Refusal> {
        let unread = |error| Refusal::to_read(self.trace.input_name(), error);
        if self.rows.has_errors() {
            // There may be more errors.
            while self.rows.next_row().map_err(unread)?.is_some() {}
        }
        let mut is_faulty = self.rows.has_errors();
        let (diagnostics, extract) = self.rows.finish();
        if self.is_broken && !is_faulty {
            let mut bytes = self.trace.open()?.0;
            let text = Text { file: self.file, bytes: &mut bytes, kept: Kept::Rows };
            let outcome = simulation.run(text, None, &report.policy, &mut Nowhere).map_err(|ended| match ended {
                Ended::Trace(error) | Ended::Recording(error) | Ended::Results(error) => unread(error),
            })?;
            let mut said = outcome.diagnostics;
            report.policy.apply(&mut said);
            // A result that breaks an assertion is one to look at.
            is_faulty = said.iter().any(|one| one.severity() == Severity::Error && one.code != Code::E0609);
            report.diagnostics.append(said);
            outcome.extracts.into_iter().for_each(|(file, extract)| report.sources.show(file, extract));
        } else {
            report.diagnostics.append(diagnostics);
            report.sources.show(self.file, extract);
        }
        if is_faulty {
            return Ok(());
        }
        let written = self.table.into_inner();
        written.map_err(|error| Refusal::to_write(self.result.display().to_string(), error))?.put()
    }
}

/// Runs up to 64 traces to their ends.
fn together(lanes: &mut Lanes, program: &Program, scenarios: &mut [Scenario]) -> Result<(), Refusal> {
    let kept = |claim: &&grafc_logic::scan::SeenClaim| claim.must_always_hold();
    let claims: Vec<VarId> = program.claims.iter().filter(kept).filter_map(|claim| claim.condition()).collect();
    loop {
        for scenario in &mut *scenarios {
            scenario.next()?;
        }
        if scenarios.iter().all(|scenario| scenario.is_over) {
            return Ok(());
        }
        let running = scenarios.iter().enumerate();
        lanes.react_in(running.filter_map(|(lane, scenario)| Some((lane, scenario.row.as_ref()?))));
        let kept = claims.iter().fold(!0, |word, claim| word & lanes.bools_of(*claim));
        for (lane, (scenario, response)) in scenarios.iter_mut().zip(lanes.responses(LANES)).enumerate() {
            let Some(row) = &scenario.row else { continue };
            scenario.is_broken |= kept >> lane & 1 == 0;
            let written = scenario.table.row(row, &response, &[]);
            written.map_err(|error| Refusal::to_write(scenario.result.display().to_string(), error))?;
        }
    }
}

/// The results are there already.
struct Nowhere;

impl Results for Nowhere {
    fn begin(&mut self, _: bool) -> io::Result<()> {
        Ok(())
    }

    fn called(&mut self, _: Call) -> io::Result<()> {
        Ok(())
    }
}
