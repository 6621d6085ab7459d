//! `grafc test`: charts against their tests, told as cargo tells of tests.

mod drawn;
mod find;
mod junit;
mod run;
mod told;

use super::refuse_output_over_input;
use crate::Exit;
use crate::arguments::{ControlArguments, MessageArguments, Period, ProfileArguments, period};
use crate::report::{Failure, Report};
use crate::signals::Interrupt;
use crate::stream::Stream;
use clap::Args;
use grafc::files::print;
use grafc_diagnostics::{Code, Diagnostic, Span};
use grafc_testing::coverage::{lcov, summary};
use run::{Loaded, Test};
use std::path::PathBuf;

const AFTER_HELP: &str = "\
Example:
  grafc test
  grafc test weigh.gct --coverage
  grafc test charts --filter batch --junit tests.xml
  grafc test weigh.gct --lcov weigh.info --coverage-drawing weigh.coverage.svg

NAME.test.csv and NAME.*.test.csv beside NAME.gct are its tests: a trace of its inputs, a column `|`, and what is
expected of outputs, variables and `situation`; a blank cell expects nothing. `scenario` blocks in NAME.gct and in
NAME.scenarios are tests, too. Exit code 1: a test failed; 4: Ctrl-C left some that were not run.";

/// Arguments of `grafc test`.
#[derive(Args, Debug)]
#[command(after_help = AFTER_HELP)]
pub struct Arguments {
    /// Charts, tests, or folders with what is below them [default: the folder in which one is]
    #[arg(value_name = "PATH")]
    paths: Vec<PathBuf>,
    #[command(flatten)]
    choice: Choice,
    /// The period at which scenarios call the chart
    #[arg(long, value_name = "PERIOD", value_parser = period, default_value = "10ms")]
    scan: Period,
    /// Write what came of each test as JUnit reads it
    #[arg(long, value_name = "FILE")]
    junit: Option<Stream>,
    /// Say what of each chart the tests have made happen
    #[arg(long)]
    coverage: bool,
    /// Write that on the lines of the charts, as lcov reads it
    #[arg(long, value_name = "FILE")]
    lcov: Option<Stream>,
    /// Draw the chart with that as colours; of several charts into a folder
    #[arg(long, value_name = "FILE.svg")]
    coverage_drawing: Option<PathBuf>,
    #[command(flatten)]
    profile: ProfileArguments,
    #[command(flatten)]
    controls: ControlArguments,
    #[command(flatten)]
    messages: MessageArguments,
}

/// Which tests are run.
#[derive(Args, Debug)]
struct Choice {
    /// Only tests with this in their names; several times: with any of them
    #[arg(long, value_name = "NAME")]
    filter: Vec<String>,
    /// No tests with this in their names
    #[arg(long, value_name = "NAME")]
    skip: Vec<String>,
    /// `--filter` and `--skip` are whole names
    #[arg(long)]
    exact: bool,
    /// Print the names of the tests, and run none
    #[arg(long)]
    list: bool,
}

impl Choice {
    fn takes(&self, name: &str) -> bool {
        let is = |asked: &String| if self.exact { name == asked } else { name.contains(asked.as_str()) };
        (self.filter.is_empty() || self.filter.iter().any(is)) && !self.skip.iter().any(is)
    }
}

/// Runs the tests of all charts.
pub fn run(args: Arguments) -> Result<Exit, Failure> {
    let here = [PathBuf::from(".")];
    let found = find::find(if args.paths.is_empty() { &here } else { &args.paths })?;
    let inputs: Vec<Stream> = found.files().cloned().map(Stream::File).collect();
    let drawing = args.coverage_drawing.clone().map(Stream::File);
    for output in [&args.junit, &args.lcov, &drawing].into_iter().flatten() {
        refuse_output_over_input(output, &inputs)?;
    }
    let messages = args.messages.messages();
    let mut report = Report::new(args.messages.policy()?);
    for test in &found.alone {
        let file = report.sources.add(find::shown(test), "");
        let error = Diagnostic::new(Code::E0608, Span::new(file, 0, 0), "the test belongs to no chart");
        report.diagnostics.push(error.help("there is no chart beside it whose name its own begins with"));
    }
    let asked = args.profile.asked()?;
    let mut charts = Vec::new();
    for (path, tested) in &found.charts {
        charts.push(Loaded::new(path, tested, &args.controls.names(), &asked, &mut report)?);
    }
    let names = charts.iter().flat_map(|chart| &chart.tests).map(|test| test.name.as_str());
    let (chosen, others): (Vec<&str>, Vec<&str>) = names.partition(|name| args.choice.takes(name));
    let (count, left_out) = (chosen.len(), others.len());
    if args.choice.list {
        let list: String = chosen.iter().map(|name| format!("{name}: test\n")).collect();
        print(&list)?;
        return Ok(report.tell(messages));
    }
    let faulty = charts.iter().map(|chart| chart.faulty).sum();
    let measured = args.coverage || args.lcov.is_some() || args.coverage_drawing.is_some();
    let how = run::How { profile: asked.profile(), bound_as_known: asked.bound_as_known, scan: args.scan.0 };
    let told = told::Told::new(count, messages);
    told.begin()?;
    // What is known when somebody interrupts it is told and written all the same.
    let interrupt = Interrupt::awaited();
    let mut suites = Vec::new();
    let mut coverages = Vec::new();
    for loaded in &charts {
        let tests: Vec<&Test> = loaded.tests.iter().filter(|test| args.choice.takes(&test.name)).collect();
        let (results, coverage) =
            run::run(loaded, &tests, how, measured, &mut report, &interrupt, &mut |test| told.test(test))?;
        suites.push((loaded, results));
        coverages.extend(coverage.map(|coverage| (loaded, coverage)));
    }
    let ending = told.end(&suites, left_out, faulty, &report.sources)?;
    if args.coverage {
        for (loaded, coverage) in &coverages {
            print(&format!("\n{}", summary(coverage, report.sources.file(loaded.file))))?;
        }
    }
    if let Some(output) = &args.junit {
        output.write(&junit::junit(&suites, &report.sources))?;
    }
    if let Some(output) = &args.lcov {
        let text: String =
            coverages.iter().map(|(of, coverage)| lcov(coverage, report.sources.file(of.file))).collect();
        output.write(&text)?;
    }
    if let Some(path) = &args.coverage_drawing {
        drawn::write(path, &coverages)?;
    }
    Ok(report.tell(messages).max(ending))
}
