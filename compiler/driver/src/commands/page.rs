//! `grafc page`: a chart as one HTML file on which it runs.

use super::refuse_output_over_input;
use crate::Exit;
use crate::arguments::{MessageArguments, ProfileArguments};
use crate::report::{Failure, Report};
use crate::stream::Stream;
use clap::{Args, ValueEnum};
use grafc::{Lowering, Options, Policy, Product, Target};
use grafc_backends::js;
use grafc_diagnostics::{Diagnostics, FileId};
use grafc_model::reaction::Profile;
use grafc_page::{Language, page};

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
    /// The language that the page begins with; there is a switch on it
    #[arg(long, value_enum, default_value_t = LanguageName::En, value_name = "LANGUAGE")]
    language: LanguageName,
    #[command(flatten)]
    profile: ProfileArguments,
    #[command(flatten)]
    messages: MessageArguments,
}

/// A language of the page.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub enum LanguageName {
    /// English
    En,
    /// German
    De,
}

impl LanguageName {
    /// As the page has it.
    pub fn language(self) -> Language {
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
        let text = &report.sources.file(file).text;
        let how = How {
            profile: args.profile.profile(),
            bound_as_known: args.profile.bound_as_known(),
            page: grafc_page::Options { language: args.language.language(), live: None },
        };
        let (page, said) = make(file, text, &args.chart.chart_name(), &how);
        report.diagnostics.append(said);
        made = page;
    }
    let exit = report.tell(args.messages.messages());
    if let Some(page) = made.filter(|_| !report.has_errors()) {
        output.write(&page)?;
    }
    Ok(exit)
}

/// What a page is made with.
pub struct How<'a> {
    /// What the chart means.
    pub profile: Profile,
    /// Whether the bound on micro-steps is the one that is known to be enough.
    pub bound_as_known: bool,
    /// What is chosen of the page itself.
    pub page: grafc_page::Options<'a>,
}

/// A text to the page of its chart; none if there is an error.
pub fn make(file: FileId, text: &str, default_name: &str, how: &How<'_>) -> (Option<String>, Diagnostics) {
    let target = Target::Js(js::Options { observed: true, ..js::Options::default() });
    let lowering = Lowering { profile: how.profile, ..Lowering::default() };
    let options = Options {
        bound_as_known: how.bound_as_known,
        policy: Policy::default(),
        ..Options::new(lowering, Product::Code(target))
    };
    let (module, said) = grafc::compile(file, text, default_name, &options);
    // What was wrong with the text has been said.
    let (tree, _) = grafc::syntax::parse(file, text);
    let chart = grafc_model::check(&tree, default_name).0;
    let page = chart.zip(module).map(|(chart, module)| page(&chart, &module.text, &how.page));
    match page.transpose() {
        Ok(page) => (page, said),
        Err(error) => {
            let mut said = said;
            let fault = format!("internal error: the page cannot be put together: {error}");
            said.push(grafc_diagnostics::Diagnostic::new(grafc_diagnostics::Code::E0901, Default::default(), fault));
            (None, said)
        }
    }
}
