//! `grafc draw`: a chart by the symbols of the standard.

mod pdf;
mod png;
mod scene;

use super::refuse_output_over_input;
use crate::Exit;
use crate::arguments::MessageArguments;
use crate::report::{Failure, Report};
use crate::stream::Stream;
use clap::{Args, ValueEnum};
use grafc::drawing::{Options, Page, Picture, Refusal, svg};
use std::path::Path;

const AFTER_HELP: &str = "\
Example:
  grafc draw valve.gct -o valve.svg
  grafc draw valve.gct -o valve.pdf --page a4 --revision B
  grafc draw valve.gct -o valve.png --situation 1,5

The ending of FILE says what is made: .svg, .pdf or .png. Several pages of SVG or PNG are FILE with -1, -2, ... before the
ending. A step is active for the drawing only if `--situation` names it.";

/// Arguments of `grafc draw`.
#[derive(Args, Debug)]
#[command(after_help = AFTER_HELP)]
pub struct Arguments {
    /// The chart; `-` is standard input
    #[arg(value_name = "CHART")]
    chart: Stream,
    /// Where to put the drawing; SVG on standard output without it
    #[arg(short, long, value_name = "FILE")]
    output: Option<Stream>,
    /// Only this grafcet or expansion, with what it encloses
    #[arg(long, value_name = "NAME")]
    grafcet: Option<String>,
    /// The size of pages, or a single sheet as large as the drawing
    #[arg(long, value_enum, default_value_t = PageName::None, value_name = "SIZE")]
    page: PageName,
    /// The labels of active steps, which bear a dot
    #[arg(long, value_name = "STEP,...", value_delimiter = ',')]
    situation: Vec<String>,
    /// What the title block calls the revision
    #[arg(long, value_name = "TEXT")]
    revision: Option<String>,
    #[command(flatten)]
    messages: MessageArguments,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum PageName {
    /// 210 x 297 mm, upright
    A4,
    /// 420 x 297 mm, across
    A3,
    /// One sheet
    None,
}

impl PageName {
    fn page(self) -> Option<Page> {
        match self {
            PageName::A4 => Some(Page::A4),
            PageName::A3 => Some(Page::A3),
            PageName::None => None,
        }
    }
}

#[derive(Clone, Copy)]
enum Form {
    Svg,
    Pdf,
    Png,
}

/// Draws one chart.
pub fn run(args: Arguments) -> Result<Exit, Failure> {
    let output = args.output.clone().unwrap_or(Stream::Standard);
    let form = form(&output)?;
    refuse_output_over_input(&output, [&args.chart])?;
    let page = args.page.page();
    let situation = args.situation.iter().map(|label| label.trim().to_string()).filter(|label| !label.is_empty());
    let options = Options {
        grafcet: args.grafcet.clone(),
        situation: situation.collect(),
        page,
        revision: args.revision.clone(),
    };
    let mut report = Report::default();
    let mut made = None;
    if let Some(file) = report.load(&args.chart)? {
        let text = &report.sources.file(file).text;
        let (pictures, said) = grafc::draw(file, text, &args.chart.chart_name(), &options);
        report.diagnostics.append(said);
        made = pictures;
    }
    let exit = report.tell(args.messages.messages());
    if let Some(pictures) = made {
        write(&pictures.map_err(refused)?, page, form, &output)?;
    }
    Ok(exit)
}

/// What is made, by the ending of the file.
fn form(output: &Stream) -> Result<Form, Failure> {
    let Stream::File(path) = output else { return Ok(Form::Svg) };
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase());
    match ending.as_deref() {
        Some("svg") => Ok(Form::Svg),
        Some("pdf") => Ok(Form::Pdf),
        Some("png") => Ok(Form::Png),
        Some(_) | None => Err(Failure::WrongUse(
            format!("`{}` does not say what to make", path.display()),
            "choose a name that ends in `.svg`, `.pdf` or `.png`".to_string(),
        )),
    }
}

fn refused(refusal: Refusal) -> Failure {
    match refusal {
        Refusal::NoGrafcet(name) => Failure::WrongUse(
            format!("the chart has no grafcet or expansion `{name}`"),
            "`--grafcet` takes the name of a grafcet or of a macro-step".to_string(),
        ),
        Refusal::NoStep(label) => Failure::WrongUse(
            format!("the chart has no step `{label}`"),
            "`--situation` takes labels of steps, separated by commas".to_string(),
        ),
    }
}

/// Writes all sheets, or none.
fn write(pictures: &[Picture], page: Option<Page>, form: Form, output: &Stream) -> Result<(), Failure> {
    let texts = || pictures.iter().map(|picture| svg(picture, page));
    let too_large = |what: String| {
        let others = if matches!(form, Form::Pdf) { "`.svg`" } else { "`.svg` or `.pdf`" };
        Failure::WrongUse(what, format!("write {others}, or break it into pages with `--page a4`"))
    };
    let files: Vec<Vec<u8>> = match form {
        Form::Svg => texts().map(String::into_bytes).collect(),
        Form::Png => texts().map(|text| png::png(&text).map_err(too_large)).collect::<Result<_, _>>()?,
        Form::Pdf => vec![pdf::pdf(texts(), pictures).map_err(too_large)?],
    };
    let names: Vec<Stream> = match (files.len(), output) {
        (0 | 1, _) => vec![output.clone()],
        (_, Stream::Standard) => {
            let help = "give `-o FILE`, or `--page none`";
            return Err(Failure::WrongUse("several pages cannot be printed".to_string(), help.to_string()));
        }
        (count, Stream::File(path)) => (1..=count).map(|number| Stream::File(numbered(path, number))).collect(),
    };
    let pairs: Vec<(&Stream, &Vec<u8>)> = names.iter().zip(&files).collect();
    Ok(Stream::write_all(&pairs)?)
}

/// `valve.svg` to `valve-1.svg`.
fn numbered(path: &Path, number: usize) -> std::path::PathBuf {
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let ending = path.extension().unwrap_or_default().to_string_lossy();
    path.with_file_name(format!("{stem}-{number}.{ending}"))
}
