//! `grafc sim`: a chart over a trace, with the reference simulator.

use super::{refuse_output_over_input, refuse_second_standard_input};
use crate::Exit;
use crate::command_line::ProfileArguments;
use crate::files::Place;
use crate::pipeline;
use crate::report::{Failure, Format, Report};
use clap::Args;

const AFTER_HELP: &str = "\
Example:
  grafc sim valve.gct --trace valve.trace.csv -o valve.result.csv

A trace is CSV: a header `t_ms,NAME,...` of inputs, then a row a scan, the first for the initial reaction.
The result has the header `t_ms,OUTPUT,...,situation,flags`.";

/// Arguments of `grafc sim`.
#[derive(Args, Debug)]
#[command(after_help = AFTER_HELP)]
pub struct Arguments {
    /// The chart; `-` is standard input
    #[arg(value_name = "CHART")]
    chart: Place,
    /// The inputs over time; `-` is standard input
    #[arg(long, value_name = "IN.csv")]
    trace: Place,
    /// Where to put the result [default: standard output]
    #[arg(short, long, value_name = "OUT.csv")]
    output: Option<Place>,
    #[command(flatten)]
    profile: ProfileArguments,
    /// The form of messages, which go to standard error
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
}

/// Runs one chart over one trace.
pub fn run(args: Arguments) -> Result<Exit, Failure> {
    refuse_second_standard_input([&args.chart, &args.trace])?;
    let output = args.output.unwrap_or(Place::Standard);
    refuse_output_over_input(&output, [&args.chart, &args.trace])?;

    let mut report = Report::default();
    let chart = report.load(&args.chart)?;
    let trace = report.load(&args.trace)?;
    let mut result = None;
    if let (Some(chart), Some(trace)) = (chart, trace) {
        let chart = (chart, report.sources.file(chart).text.as_str());
        let trace = (trace, report.sources.file(trace).text.as_str());
        let (made, said) = pipeline::simulate(chart, &args.chart.chart_name(), trace, args.profile.profile());
        report.diagnostics.append(said);
        result = made;
    }
    let exit = report.tell(args.format);
    if let Some(result) = result {
        output.write(&result)?;
    }
    Ok(exit)
}
