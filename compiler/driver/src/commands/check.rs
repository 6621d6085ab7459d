//! `grafc check`: all errors and warnings of charts.

use super::refuse_second_standard_input;
use crate::Exit;
use crate::report::{Failure, Format, Report, to_stderr};
use crate::stream::Stream;
use clap::Args;

const AFTER_HELP: &str = "\
Example:
  grafc check valve.gct pump.gct --format sarif > findings.sarif

Messages for people go to standard error, json and sarif to standard output.";

/// Arguments of `grafc check`.
#[derive(Args, Debug)]
#[command(after_help = AFTER_HELP)]
pub struct Arguments {
    /// The charts; `-` is standard input
    #[arg(required = true, value_name = "CHART")]
    charts: Vec<Stream>,
    /// The form of messages
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
}

/// Checks every chart, also after one that cannot be read.
pub fn run(args: Arguments) -> Result<Exit, Failure> {
    refuse_second_standard_input(&args.charts)?;
    let mut report = Report::default();
    let mut exit = Exit::Done;
    for stream in &args.charts {
        match report.load(stream) {
            Ok(Some(file)) => {
                let (_, said) = grafc::check(file, &report.sources.file(file).text, &stream.chart_name());
                report.diagnostics.append(said);
            }
            Ok(None) => {}
            Err(refusal) => {
                to_stderr(&refusal.to_string());
                exit = Exit::FilesRefused;
            }
        }
    }
    Ok(exit.max(report.publish(args.format)?))
}
