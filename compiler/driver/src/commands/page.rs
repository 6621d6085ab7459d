//! `grafc page`: a chart as one HTML file on which it runs.

use super::{against, refuse_output_over_input};
use crate::Exit;
use crate::arguments::{MessageArguments, ProfileArguments};
use crate::report::{Failure, Report};
use crate::stream::Stream;
use clap::{Args, ValueEnum};
use grafc::{Document, Lowering, Target};
use grafc_backends::js;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, SourceFile, Span};
use grafc_page::{Language, Live, Options, page};

const AFTER_HELP: &str = "\
Example:
  grafc page valve.gct -o valve.html
  grafc page valve.gct -o ventil.html --language de

The file needs nothing beside it: open it in a browser, or mail it. It asks no server for anything.";

/// Arguments of `grafc page`.
#[derive(Args, Debug)]
#[command(after_help = AFTER_HELP)]
pub struct Arguments {
    /// The chart; `-` is standard input
    #[arg(value_name = "CHART")]
    chart: Stream,
    /// Where to put the page [default: standard output]
    #[arg(short, long, value_name = "FILE.html")]
    output: Option<Stream>,
    #[command(flatten)]
    page: PageArguments,
    #[command(flatten)]
    messages: MessageArguments,
}

/// What a page is made with, in a file or served.
#[derive(Args, Debug)]
pub struct PageArguments {
    /// The language that the page begins with; there is a switch on it
    #[arg(long, value_enum, default_value_t = LanguageName::En, value_name = "LANGUAGE")]
    language: LanguageName,
    #[command(flatten)]
    profile: ProfileArguments,
}

/// A language of the page.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum LanguageName {
    /// English
    En,
    /// German
    De,
}

impl LanguageName {
    /// As the page has it.
    fn language(self) -> Language {
        match self {
            LanguageName::En => Language::English,
            LanguageName::De => Language::German,
        }
    }
}

/// Makes one page.
pub fn run(args: Arguments) -> Result<Exit, Failure> {
    let output = args.output.clone().unwrap_or(Stream::Standard);
    refuse_output_over_input(&output, [&args.chart])?;
    let mut report = Report::new(args.messages.policy()?);
    let mut made = None;
    if let Some(file) = report.load(&args.chart)? {
        let (page, said) = make(report.sources.file(file), &args.chart.chart_name(), &args.page, None)?;
        report.diagnostics.append(said);
        made = page;
    }
    let exit = report.tell(args.messages.messages());
    if let Some(page) = made.filter(|_| !report.has_errors()) {
        output.write(&page)?;
    }
    Ok(exit)
}

/// A text to the page of its chart; none if there is an error. It is the only text of a report, so that places in it are the
/// same there.
///
/// # Errors
/// Choices that do not go together.
pub fn make(
    source: &SourceFile,
    default_name: &str,
    args: &PageArguments,
    live: Option<Live<'_>>,
) -> Result<(Option<String>, Diagnostics), Failure> {
    let mut document = Document::new(&source.name, &source.text).named(default_name);
    let asked = args.profile.asked()?;
    document.set_options(Lowering { profile: asked.profile(), ..Lowering::default() });
    document.bound_as_known(asked.bound_as_known);
    let mut said = document.diagnostics().clone();
    let against = against(&document, &asked);
    if against.has_errors() {
        said.append(against);
        return Ok((None, said));
    }
    said.append(document.warnings().clone());
    let Some(chart) = document.chart() else { return Ok((None, said)) };
    let target = Target::Js(js::Options { observed: true, ..js::Options::default() });
    let options = Options { language: args.language.language(), live };
    match document.emit(&target).map(|module| page(chart, &module.text, &options)) {
        Ok(Ok(page)) => return Ok((Some(page), said)),
        Ok(Err(error)) => {
            let fault = format!("internal error: the page cannot be put together: {error}");
            said.push(Diagnostic::new(Code::E0901, Span::default(), fault));
        }
        Err(found) => said.append(found),
    }
    Ok((None, said))
}
