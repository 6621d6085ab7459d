//! `grafc check`: all errors and warnings of charts.

use super::refuse_second_standard_input;
use crate::Exit;
use crate::arguments::MessageArguments;
use crate::report::{Failure, Report, to_stderr};
use crate::stream::Stream;
use crate::watch;
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
    #[command(flatten)]
    messages: MessageArguments,
    /// Check again whenever a chart changes, until Ctrl-C
    #[arg(long)]
    watch: bool,
}

/// Checks the charts, once or whenever one changes.
pub fn run(args: Arguments) -> Result<Exit, Failure> {
    refuse_second_standard_input(&args.charts)?;
    if args.watch { watch::run(&args.charts, args.messages.messages(), || check(&args)) } else { check(&args) }
}

/// Checks every chart, also after one that cannot be read.
fn check(args: &Arguments) -> Result<Exit, Failure> {
    let mut report = Report::new(args.messages.policy()?);
    let mut exit = Exit::Done;
    for stream in &args.charts {
        match report.load(stream) {
            Ok(Some(file)) => {
                let (_, diagnostics) = grafc::check(file, &report.sources.file(file).text, &stream.chart_name());
                report.diagnostics.append(diagnostics);
            }
            Ok(None) => {}
            Err(refusal) => {
                to_stderr(&refusal.to_string());
                exit = Exit::FilesRefused;
            }
        }
    }
    Ok(exit.max(report.publish(args.messages.messages())?))
}
