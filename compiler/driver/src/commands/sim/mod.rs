//! `grafc sim`: a chart over a trace, with the reference simulator; compared with a recording, if there is one. Or over a
//! folder of traces, 64 at once.

mod arguments;
mod batch;

use super::{refuse_output_over_input, refuse_second_standard_input};
use crate::Exit;
use crate::arguments::Period;
use crate::report::{Failure, Report};
use crate::results::{Form, Written};
use crate::stream::Stream;
use crate::traces::Watched;
use grafc::files::{Refusal, print};
use grafc::{Ended, Simulation, Text};
use grafc_model::simulate::Calls;
use grafc_model::trace::Kept;
use std::io::{self, ErrorKind};

pub use arguments::Arguments;

/// Runs one chart over one trace, or over many.
pub fn run(mut args: Arguments) -> Result<Exit, Failure> {
    match (args.batch.take(), args.trace.take()) {
        (Some(folder), _) => batch::run(args, &folder),
        (None, Some(trace)) => over(args, trace),
        (None, None) => Ok(Exit::WrongUse),
    }
}

/// Runs one chart over one trace.
fn over(args: Arguments, traced: Stream) -> Result<Exit, Failure> {
    let inputs = || [&args.chart, &traced].into_iter().chain(&args.against);
    refuse_second_standard_input(inputs())?;
    // A comparison is asked whether it is the same, not what it is.
    let output = args.output.or(args.against.is_none().then_some(Stream::Standard));
    if let Some(output) = &output {
        refuse_output_over_input(output, inputs())?;
    }

    let form = match &output {
        Some(Stream::File(path)) if path.extension().is_some_and(|e| e.eq_ignore_ascii_case("vcd")) => Form::Waveform,
        Some(Stream::File(_) | Stream::Standard) | None => Form::Table,
    };
    let mut report = Report::new(args.messages.policy()?);
    let messages = args.messages.messages();
    let chart = report.load(&args.chart)?;
    let (trace, length) = traced.open()?;
    let recorded = args.against.as_ref().map(|stream| stream.open()).transpose()?;
    let Some(chart) = chart else { return Ok(report.tell(messages)) };
    let calls = match args.scan {
        Some(Period(period)) => Calls::Every(period),
        None if args.events => Calls::Events,
        None => Calls::Rows,
    };
    // A drawing is of everything.
    let show = match form {
        Form::Waveform => [ALL.map(String::from).to_vec(), args.show].concat(),
        Form::Table => args.show,
    };
    let controls = args.controls.names();
    let (asked, bound_as_known) = (args.profile.asked()?, args.profile.bound_as_known());
    let how =
        grafc::Run { profile: asked.profile(), asked, bound_as_known, controls: Some(&controls), calls, show: &show };
    let text = (chart, report.sources.file(chart).text.as_str());
    let (simulation, diagnostics) = Simulation::new(text, &args.chart.chart_name(), how);
    report.diagnostics.append(diagnostics);
    let simulation = simulation.map_err(|grafc::NotShown { word, near }| {
        let all = "there are `inputs`, `vars`, `steps`, and names as in conditions: of variables, `X5`, `T5`";
        let help = near.map_or(all.to_owned(), |near| format!("did you mean `{near}`?"));
        Failure::WrongUse(format!("`--show {word}`: the chart has nothing of this name"), help)
    })?;
    let Some(simulation) = simulation.filter(|_| !report.is_refused()) else { return Ok(report.tell(messages)) };

    let is_seen = output != Some(Stream::Standard) || !io::IsTerminal::is_terminal(&io::stdout());
    let is_wanted = is_seen && messages.is_for_people();
    let mut trace_bytes = Watched::new(trace, is_wanted.then_some(length));
    let mut results = Written::new(&simulation, form, output.as_ref(), trace_bytes.is_live())?;
    let trace = Text { file: report.name(&traced), bytes: &mut trace_bytes, kept: Kept::Rows };
    let mut recorded = recorded.map(|(bytes, _)| bytes);
    let recorded_file = args.against.as_ref().map(|stream| report.name(stream));
    let recorded = recorded_file.zip(recorded.as_mut());
    let recorded = recorded.map(|(file, bytes)| Text { file, bytes, kept: Kept::Rows });
    let outcome = simulation.run(trace, recorded, &report.policy, &mut results);
    drop(trace_bytes);
    let outcome = match outcome {
        Ok(outcome) => outcome,
        // If it was closed early, the reader has seen enough.
        Err(Ended::Results(error)) if error.kind() == ErrorKind::BrokenPipe => return Ok(report.tell(messages)),
        Err(ended) => return Err(refusal(ended, &traced, args.against.as_ref(), output.as_ref()).into()),
    };
    report.diagnostics.append(outcome.diagnostics);
    for (file, extract) in outcome.extracts {
        report.sources.show(file, extract);
    }
    // A result that breaks an assertion is one to look at.
    let is_refused = report.is_faulty();
    // What was written before the first error stands before what is said of that.
    results.end(!is_refused)?;
    let exit = report.tell(messages);
    if output.is_none() && !is_refused && !messages.quiet {
        let rows = outcome.compared.unwrap_or_default();
        print(&if rows == 1 { "1 row agrees\n".to_owned() } else { format!("{rows} rows agree\n") })?;
    }
    Ok(exit)
}

/// What could not be read or written.
fn refusal(ended: Ended, trace: &Stream, against: Option<&Stream>, output: Option<&Stream>) -> Refusal {
    let name = |stream: Option<&Stream>, of: fn(&Stream) -> String| stream.map(of).unwrap_or_default();
    match ended {
        Ended::Trace(error) => Refusal::to_read(trace.input_name(), error),
        Ended::Recording(error) => Refusal::to_read(name(against, Stream::input_name), error),
        Ended::Results(error) => Refusal::to_write(name(output, Stream::output_name), error),
    }
}

/// What a drawing shows in any case.
const ALL: [&str; 3] = ["inputs", "vars", "steps"];
