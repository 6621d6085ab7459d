//! `grafc import`: the chart of another tool as a `.gct` text, and a report.

use super::refuse_output_over_input;
use crate::Exit;
use crate::arguments::MessageArguments;
use crate::report::{Failure, Report};
use crate::stream::Stream;
use clap::Args;

const AFTER_HELP: &str = "\
Example:
  grafc import plant.grafcet -o plant.gct

Reads charts of AGRAFE (*.grafcet, XMI). The report goes to standard error: W0701 changed, W0702 doubtful,
W0703 lost. The result is in the format of `grafc fmt`; `grafc check` says whether it keeps the rules.";

/// Arguments of `grafc import`.
#[derive(Args, Debug)]
#[command(after_help = AFTER_HELP)]
pub struct Arguments {
    /// The file of the other tool; `-` is standard input
    #[arg(value_name = "FILE")]
    file: Stream,
    /// Where to put the chart [default: standard output]
    #[arg(short, long, value_name = "CHART")]
    output: Option<Stream>,
    /// Take variables that are named like delays, such as `2s/X202`, for these delays
    #[arg(long)]
    delays: bool,
    #[command(flatten)]
    messages: MessageArguments,
}

/// Imports one chart.
pub fn run(args: Arguments) -> Result<Exit, Failure> {
    let output = args.output.unwrap_or(Stream::Standard);
    refuse_output_over_input(&output, [&args.file])?;

    let mut report = Report::new(args.messages.policy()?);
    let mut result = None;
    if let Some(file) = report.load(&args.file)? {
        let options = grafc_import::Options { delays: args.delays };
        let (made, diagnostics) = grafc_import::import(file, &report.sources.file(file).text, options);
        report.diagnostics.append(diagnostics);
        result = made;
    }
    let exit = report.tell(args.messages.messages());
    if let Some(result) = result.filter(|_| !report.has_errors()) {
        output.write(&result)?;
    }
    Ok(exit)
}
