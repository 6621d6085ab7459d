//! `grafc generate-tests`: tests that cover what a chart can come to, with what the rules make of them.

use super::{beyond, followed};
use crate::Exit;
use crate::arguments::{Period, ProfileArguments, QuietArgument, period};
use crate::report::{Failure, Format, Report};
use crate::stream::Stream;
use clap::{Args, ValueEnum};
use grafc::Document;
use grafc::files::{self, print};
use grafc_logic::scan::Observed;
use grafc_logic::{Options, compile_observed};
use grafc_model::reaction::Asked;
use grafc_testing::{Certified, Cover, certify};
use grafc_verify::{Times, moves};
use std::path::{Path, PathBuf};

const AFTER_HELP: &str = "\
Example:
  grafc generate-tests valve.gct
  grafc generate-tests valve.gct --cover edges -o tests/
  grafc sim valve.gct --trace valve.1.test.csv --against plc.csv

Each test NAME.N.test.csv is a round trip from an initial situation, for `grafc test` and for a controller. Exit code 4: the
tests do not cover all that may be possible.";

/// Arguments of `grafc generate-tests`.
#[derive(Args, Debug)]
#[command(after_help = AFTER_HELP)]
pub struct Arguments {
    /// The chart; `-` is standard input
    #[arg(value_name = "CHART")]
    chart: Stream,
    /// What the tests are to make happen
    #[arg(long, value_enum, default_value_t = CoverName::Transitions)]
    cover: CoverName,
    /// The folder to put them into [default: that of the chart, to which they belong]
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Put tests in the place of others of the same names
    #[arg(long)]
    force: bool,
    /// The period at which the controller calls the chart: rows are no closer
    #[arg(long, value_name = "PERIOD", value_parser = period, default_value = "10ms")]
    scan: Period,
    /// At most so many states are looked at, and ten paths of inputs for each
    #[arg(long, value_name = "N", default_value_t = 20_000)]
    max: usize,
    #[command(flatten)]
    profile: ProfileArguments,
    #[command(flatten)]
    quiet: QuietArgument,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum CoverName {
    /// Each transition is cleared
    Transitions,
    /// Each situation is come to
    Situations,
    /// Each pair of situations is taken that a reaction connects
    Edges,
}

impl CoverName {
    fn cover(self) -> Cover {
        match self {
            CoverName::Transitions => Cover::Transitions,
            CoverName::Situations => Cover::Situations,
            CoverName::Edges => Cover::Edges,
        }
    }

    fn plural(self) -> &'static str {
        match self {
            CoverName::Transitions => "transitions",
            CoverName::Situations => "situations",
            CoverName::Edges => "edges",
        }
    }
}

/// Makes the tests of one chart.
pub fn run(args: Arguments) -> Result<Exit, Failure> {
    let folder = match (&args.output, &args.chart) {
        (Some(folder), _) => folder.clone(),
        (None, Stream::File(path)) => path.parent().unwrap_or(Path::new("")).to_path_buf(),
        (None, Stream::Standard) => {
            return Err(Failure::WrongUse(
                "a chart from standard input lies in no folder".to_string(),
                "say where to put the tests: `-o DIR`".to_string(),
            ));
        }
    };
    let mut report = Report::default();
    let made = match followed(&mut report, &args.chart, &args.profile)? {
        Some((document, asked)) => tests(&document, &asked, &args)?,
        None => None,
    };
    let exit = report.tell(args.quiet.messages(Format::Human));
    let Some(made) = made else { return Ok(exit) };
    let name = args.chart.chart_name();
    let paths: Vec<PathBuf> =
        (1..=made.tests.len()).map(|number| folder.join(format!("{name}.{number}.test.csv"))).collect();
    if let Some(there) = paths.iter().find(|path| path.exists()).filter(|_| !args.force) {
        return Err(Failure::WrongUse(
            format!("`{}` is there already", there.display()),
            "choose another folder with `-o DIR`, or put the new tests in its place with `--force`".to_string(),
        ));
    }
    if !folder.as_os_str().is_empty() {
        files::make_folder(&folder)?;
    }
    let texts = paths.into_iter().map(Stream::File).zip(&made.tests).collect::<Vec<_>>();
    Stream::write_all(&texts.iter().map(|(stream, test)| (stream, &test.text)).collect::<Vec<_>>())?;
    if !args.quiet.quiet {
        let names = texts.iter().map(|(stream, _)| stream.output_name());
        print(&told(&made, args.cover, names))?;
    }
    let is_all = made.complete && made.open.is_empty();
    Ok(if is_all { exit } else { exit.max(Exit::Open) })
}

/// The tests, if the chart has no errors.
fn tests(document: &Document, asked: &Asked, args: &Arguments) -> Result<Option<Certified>, Failure> {
    let (Some(chart), Some(analysis)) = (document.chart(), document.analysis()) else { return Ok(None) };
    let mut profile = asked.profile();
    if asked.bound_as_known {
        profile = grafc::known_bound(chart, profile);
    }
    let options = Options { profile, ..Options::default() };
    let (program, _) = compile_observed(analysis.clone(), &options, Observed::Transitions);
    let Period(period) = args.scan;
    let real = moves(&program, Times::Real(period), args.max).map_err(beyond)?;
    let free = moves(&program, Times::Free, args.max).map_err(beyond)?;
    Ok(Some(certify(chart, profile, args.cover.cover(), period, (&real, &free))))
}

fn counted(count: usize, one: &str, several: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { several })
}

/// What was made, a line each, and how good it is.
fn told(made: &Certified, cover: CoverName, names: impl Iterator<Item = String>) -> String {
    let mut text = String::new();
    for (name, test) in names.zip(&made.tests) {
        let rows = counted(test.stimuli.len(), "row", "rows");
        let last = if test.comes_home { "" } else { "; no way back" };
        text.push_str(&format!("{name}: {rows}, {}{last}\n", test.covers.join(" ")));
    }
    let totals = made.totals;
    let (tests, rows) = (|n| counted(n, "test", "tests"), |n| counted(n, "row", "rows"));
    text.push_str(&format!(
        "{} in {} with {}; at least {} and {} are needed\n",
        counted(made.covered, &cover.plural()[..cover.plural().len() - 1], cover.plural()),
        tests(totals.tests),
        rows(totals.rows),
        tests(totals.fewest_tests),
        rows(totals.fewest_rows),
    ));
    if !made.dead.is_empty() && made.complete {
        text.push_str(&format!("never: {}\n", made.dead.join(" ")));
    }
    if !made.open.is_empty() {
        text.push_str(&format!(
            "open, since delays would have to end otherwise than was tried: {}\n",
            made.open.join(" ")
        ));
    }
    if !made.complete {
        text.push_str("open: there are more states, or more paths, than `--max` allows\n");
    }
    text
}
