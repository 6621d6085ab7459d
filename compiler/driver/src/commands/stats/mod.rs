//! `grafc stats`: what a chart takes in each encoding.

mod figures;
mod table;

use crate::Exit;
use crate::arguments::{ProfileArguments, QuietArgument};
use crate::report::{Failure, Format, Report};
use crate::stream::Stream;
use clap::{Args, ValueEnum};
use figures::Figures;
use grafc::Document;
use grafc::files::print;

const AFTER_HELP: &str = "\
Example:
  grafc stats valve.gct --evolution scan

What is counted, and how, is in docs/statistics.md.";

/// Arguments of `grafc stats`.
#[derive(Args, Debug)]
#[command(after_help = AFTER_HELP)]
pub struct Arguments {
    /// The chart; `-` is standard input
    #[arg(value_name = "CHART")]
    chart: Stream,
    #[command(flatten)]
    profile: ProfileArguments,
    /// The form of the figures, and of messages, which go to standard error
    #[arg(long, value_enum, default_value_t = Form::Human)]
    format: Form,
    #[command(flatten)]
    quiet: QuietArgument,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum Form {
    /// A table for people
    Human,
    /// One JSON object
    Json,
}

/// Measures one chart.
pub fn run(args: Arguments) -> Result<Exit, Failure> {
    let mut report = Report::default();
    let mut found = None;
    if let Some(file) = report.load(&args.chart)? {
        let source = report.sources.file(file);
        // The only text, so places in it are the same in document and report.
        let mut document = Document::new(&source.name, &source.text).named(args.chart.chart_name());
        let (figures, diagnostics) = figures::figures(&mut document, args.profile.profile());
        report.diagnostics.append(diagnostics);
        found = figures;
    }
    let (exit, text) = match args.format {
        Form::Human => (report.tell(args.quiet.messages(Format::Human)), found.as_ref().map(Figures::table)),
        Form::Json => (report.tell(args.quiet.messages(Format::Json)), found.as_ref().map(Figures::json)),
    };
    if let Some(text) = text {
        print(&text)?;
    }
    Ok(exit)
}
