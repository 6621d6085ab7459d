//! `grafc fmt`: the canonical format.

use super::refuse_second_standard_input;
use crate::Exit;
use crate::arguments::QuietArgument;
use crate::report::{Failure, Format, Report, to_stderr};
use crate::stream::Stream;
use clap::Args;
use grafc::files::print;

const AFTER_HELP: &str = "\
Example:
  grafc fmt --check charts/*.gct

Charts are changed in place; `-` is formatted from standard input to standard output.
A chart with errors is left alone. With --check, exit code 1 says that a chart would change.";

/// Arguments of `grafc fmt`.
#[derive(Args, Debug)]
#[command(after_help = AFTER_HELP)]
pub struct Arguments {
    /// The charts; `-` is standard input
    #[arg(required = true, value_name = "CHART")]
    charts: Vec<Stream>,
    /// Write nothing, but print the names of charts that would change
    #[arg(long)]
    check: bool,
    #[command(flatten)]
    quiet: QuietArgument,
}

/// Formats every chart, also after one that cannot be.
pub fn run(args: Arguments) -> Result<Exit, Failure> {
    refuse_second_standard_input(&args.charts)?;
    let mut report = Report::default();
    let mut exit = Exit::Done;
    for stream in &args.charts {
        match format(stream, args.check, &mut report) {
            Ok(one) => exit = exit.max(one),
            Err(failure) => {
                to_stderr(&failure.to_string());
                exit = exit.max(failure.exit());
            }
        }
    }
    Ok(exit.max(report.tell(args.quiet.messages(Format::Human))))
}

fn format(stream: &Stream, check: bool, report: &mut Report) -> Result<Exit, Failure> {
    let Some(file) = report.load(stream)? else { return Ok(Exit::ChartErrors) };
    let (formatted, diagnostics) = grafc::format(file, &report.sources.file(file).text);
    report.diagnostics.append(diagnostics);
    let Some(formatted) = formatted else { return Ok(Exit::ChartErrors) };
    let changed = formatted != report.sources.file(file).text;
    match (check, stream) {
        (true, _) if changed => {
            print(&format!("{}\n", stream.input_name()))?;
            Ok(Exit::ChartErrors)
        }
        (true, _) => Ok(Exit::Done),
        (false, Stream::Standard) => stream.write(&formatted).map(|()| Exit::Done).map_err(Failure::from),
        // A file that is right already keeps its time stamp.
        (false, Stream::File(_)) if !changed => Ok(Exit::Done),
        (false, Stream::File(_)) => stream.write(&formatted).map(|()| Exit::Done).map_err(Failure::from),
    }
}
