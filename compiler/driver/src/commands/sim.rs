//! `grafc sim`: a chart over a trace, with the reference simulator; compared with a recording, if there is one.

use super::{refuse_output_over_input, refuse_second_standard_input};
use crate::Exit;
use crate::arguments::{MessageArguments, ProfileArguments};
use crate::report::{Failure, Report};
use crate::stream::Stream;
use clap::Args;
use grafc::files::print;

const AFTER_HELP: &str = "\
Example:
  grafc sim valve.gct --trace valve.trace.csv -o valve.result.csv
  grafc sim valve.gct --trace valve.trace.csv --against plc.csv

A trace is CSV: a header `t_ms,NAME,...` of inputs, then a row a scan, the first for the initial reaction.
The result has the header `t_ms,OUTPUT,...,situation,flags`; a recording has any of these columns, and the first row
that differs is an error.";

/// Arguments of `grafc sim`.
#[derive(Args, Debug)]
#[command(after_help = AFTER_HELP)]
pub struct Arguments {
    /// The chart; `-` is standard input
    #[arg(value_name = "CHART")]
    chart: Stream,
    /// The inputs over time; `-` is standard input
    #[arg(long, value_name = "IN.csv")]
    trace: Stream,
    /// A result recorded elsewhere, to compare with; `-` is standard input
    #[arg(long, value_name = "RECORDED.csv")]
    against: Option<Stream>,
    /// Where to put the result [default: standard output; nowhere with `--against`]
    #[arg(short, long, value_name = "OUT.csv")]
    output: Option<Stream>,
    #[command(flatten)]
    profile: ProfileArguments,
    #[command(flatten)]
    messages: MessageArguments,
}

/// Runs one chart over one trace.
pub fn run(args: Arguments) -> Result<Exit, Failure> {
    let inputs = || [&args.chart, &args.trace].into_iter().chain(&args.against);
    refuse_second_standard_input(inputs())?;
    // A comparison is asked whether it is the same, not what it is.
    let output = args.output.or(args.against.is_none().then_some(Stream::Standard));
    if let Some(output) = &output {
        refuse_output_over_input(output, inputs())?;
    }

    let mut report = Report::new(args.messages.policy()?);
    let chart = report.load(&args.chart)?;
    let trace = report.load(&args.trace)?;
    let against = args.against.as_ref().map(|stream| report.load(stream)).transpose()?;
    let mut made = None;
    if let (Some(chart), Some(trace)) = (chart, trace)
        && against != Some(None)
    {
        let text = |file| (file, report.sources.file(file).text.as_str());
        let against = against.flatten().map(text);
        let profile = args.profile.profile();
        let name = args.chart.chart_name();
        let (simulation, diagnostics) = grafc::simulate(text(chart), &name, text(trace), against, profile);
        report.diagnostics.append(diagnostics);
        made = simulation;
    }
    let messages = args.messages.messages();
    let exit = report.tell(messages);
    if let Some(made) = made.filter(|_| !report.has_errors()) {
        match &output {
            Some(output) => output.write(&made.result)?,
            None if messages.quiet => {}
            None => print(&format!("{} rows agree\n", made.compared.unwrap_or_default()))?,
        }
    }
    Ok(exit)
}
