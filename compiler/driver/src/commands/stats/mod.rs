//! `grafc stats`: what a chart takes in each encoding, as a program or compiled, or what its outputs do.

mod compiled;
mod figures;
mod outputs;
mod table;

use crate::Exit;
use crate::arguments::{ProfileArguments, QuietArgument};
use crate::report::{Failure, Format, Report};
use crate::stream::Stream;
use clap::{Args, ValueEnum};
use compiled::Compiled;
use figures::Figures;
use grafc::Document;
use grafc::files::print;
use grafc_diagnostics::Diagnostics;
use outputs::Outputs;

const AFTER_HELP: &str = "\
Example:
  grafc stats valve.gct --evolution scan
  grafc stats valve.gct --outputs
  grafc stats valve.gct --compiled

What is counted, and how, is in docs/statistics.md.";

/// Arguments of `grafc stats`.
#[derive(Args, Debug)]
#[command(after_help = AFTER_HELP)]
pub struct Arguments {
    /// The chart; `-` is standard input
    #[arg(value_name = "CHART")]
    chart: Stream,
    /// Which outputs are on in which situation, in place of the figures
    #[arg(long)]
    outputs: bool,
    /// The bytes that generated C takes on microcontrollers, by the compilers that are on PATH, in place of the figures
    #[arg(long, conflicts_with = "outputs")]
    compiled: bool,
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

impl Form {
    fn choose<T>(self, of: &T, human: impl Fn(&T) -> String, json: impl Fn(&T) -> String) -> String {
        match self {
            Form::Human => human(of),
            Form::Json => json(of),
        }
    }
}

/// Measures one chart.
pub fn run(args: Arguments) -> Result<Exit, Failure> {
    let mut report = Report::default();
    let mut found = None;
    if let Some(mut document) = report.document(&args.chart)? {
        let diagnostics;
        (found, diagnostics) = if args.outputs {
            outputs(&document, args.format)
        } else if args.compiled {
            let (compiled, diagnostics) = Compiled::new(&mut document, &args.profile.asked()?)?;
            (compiled.map(|compiled| args.format.choose(&compiled, Compiled::table, Compiled::json)), diagnostics)
        } else {
            let asked = args.profile.asked()?;
            let (figures, diagnostics) = figures::figures(&mut document, &asked);
            (figures.map(|figures| args.format.choose(&figures, Figures::table, Figures::json)), diagnostics)
        };
        report.diagnostics.append(diagnostics);
    }
    let messages = match args.format {
        Form::Human => Format::Human,
        Form::Json => Format::Json,
    };
    let exit = report.tell(args.quiet.messages(messages));
    if let Some(text) = found {
        print(&text)?;
    }
    Ok(exit)
}

/// There is a text exactly if no message is an error.
fn outputs(document: &Document, form: Form) -> (Option<String>, Diagnostics) {
    let mut diagnostics = document.diagnostics().clone();
    diagnostics.append(document.warnings().clone());
    let outputs = Outputs::new(document).filter(|_| !diagnostics.has_errors());
    (outputs.map(|outputs| form.choose(&outputs, Outputs::table, Outputs::json)), diagnostics)
}
