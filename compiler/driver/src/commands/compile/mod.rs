//! `grafc CHART... --target T`: charts to code, or to the form after a stage (`--emit`, `--dump-after`).

mod job;
mod plan;

use crate::Exit;
use crate::arguments::{ControlArguments, MessageArguments, ProfileArguments, option};
use crate::choices::{self, Choices};
use crate::report::{Failure, Messages, Report, to_stderr};
use crate::stream::Stream;
use crate::watch;
use clap::builder::PossibleValuesParser;
use clap::{ArgGroup, Args, ValueEnum};
use grafc::{Options, Product};
use grafc_logic::Encoding;
use grafc_net::passes;
use job::Job;

/// Arguments of the compiler itself.
#[derive(Args, Debug)]
#[command(group = ArgGroup::new("product"))]
pub struct Arguments {
    /// The charts; `-` is standard input
    #[arg(required = true, value_name = "CHART")]
    pub charts: Vec<Stream>,
    /// What to make of them [default: by the ending of `-o FILE`]
    #[arg(short, long, group = "product", value_name = "TARGET", value_parser = choices::targets())]
    target: Option<String>,
    /// Instead of code, what the compiler knows after a stage, as text
    #[arg(long, value_enum, group = "product", value_name = "STAGE")]
    emit: Option<Stage>,
    /// Instead of code, the net after a pass
    #[arg(long, group = "product", value_name = "PASS", value_parser = pass_names())]
    dump_after: Option<String>,
    /// Where to put it; a folder takes a file for each chart [default: standard output]
    #[arg(short, long, value_name = "FILE|DIR/")]
    output: Option<Stream>,
    /// And where to put which lines of the code come from which element of the chart, as JSON
    #[arg(long, value_name = "FILE|DIR/", conflicts_with_all = choices::NO_CODE)]
    map: Option<Stream>,
    /// Compile again whenever a chart changes, until Ctrl-C
    #[arg(long)]
    watch: bool,
    /// How the situation is held and the next one found
    #[arg(long, value_enum, default_value_t = EncodingName::SinglePhase, value_name = "ENCODING")]
    encoding: EncodingName,
    /// Whether formulas are shortened
    #[arg(short = 'O', long, value_enum, default_value_t = Optimization::Short, value_name = "LEVEL")]
    optimize: Optimization,
    #[command(flatten)]
    profile: ProfileArguments,
    #[command(flatten)]
    controls: ControlArguments,
    #[command(flatten)]
    choices: Choices,
    #[command(flatten)]
    messages: MessageArguments,
}

/// What lies between two stages of the compiler.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum Stage {
    /// The syntax tree
    Ast,
    /// The checked chart: names resolved, types known
    Model,
    /// The flat Petri net: macro-steps, enclosures and orders dissolved
    Net,
    /// The equations of one scan
    Logic,
    /// The statements of one scan, with all variables
    Scan,
}

fn pass_names() -> PossibleValuesParser {
    PossibleValuesParser::new(passes::ORDER.iter().map(|pass| pass.name))
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum EncodingName {
    /// A bit a step, reset by the clearing after it, setting wins
    SinglePhase,
    /// A bit a step, reset by an active successor, resetting wins
    RTrigger,
    /// A bit a step, reset by an active successor, setting wins
    STrigger,
    /// A bit a step, written where a transition clears
    Sequent,
    /// A number for steps that exclude each other, and CASE; a bit for each of the others
    Switch,
}

impl EncodingName {
    fn encoding(self) -> Encoding {
        match self {
            EncodingName::SinglePhase => Encoding::SinglePhase,
            EncodingName::RTrigger => Encoding::RTrigger,
            EncodingName::STrigger => Encoding::STrigger,
            EncodingName::Sequent => Encoding::Sequent,
            EncodingName::Switch => Encoding::Switch,
        }
    }
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum Optimization {
    /// Formulas as the textbook has them
    #[value(name = "0")]
    Plain,
    /// Without what is proved to make no difference
    #[value(name = "1")]
    Short,
}

impl Arguments {
    fn lowering(&self) -> Result<grafc_logic::Options, Failure> {
        let simplify = match self.optimize {
            Optimization::Plain => false,
            Optimization::Short => true,
        };
        Ok(grafc_logic::Options {
            profile: self.profile.asked()?.profile(),
            encoding: self.encoding.encoding(),
            simplify,
        })
    }
}

/// Compiles the charts, once or whenever one changes.
pub fn run(args: Arguments) -> Result<Exit, Failure> {
    let lowering = args.lowering()?;
    refuse_pass_not_run(&args)?;
    let jobs = plan::jobs(&args)?;
    let messages = args.messages.messages();
    let product = Product::Program;
    let (bound_as_known, controls) = (args.profile.bound_as_known(), args.controls.names());
    let (asked, policy) = (args.profile.asked()?, args.messages.policy()?);
    let options = Options { lowering, asked, source: None, bound_as_known, controls, product, policy };
    if args.watch {
        watch::run(&args.charts, messages, || Ok(compile(&jobs, &options, messages)))
    } else {
        Ok(compile(&jobs, &options, messages))
    }
}

/// All errors of all charts; and for each chart without one what it asks for, in its place. The options are those of all,
/// but for the product.
fn compile(jobs: &[Job], asked: &Options, messages: Messages) -> Exit {
    let mut report = Report::new(asked.policy.clone());
    let mut exit = Exit::Done;
    let mut made = Vec::new();
    for job in jobs {
        match report.load(job.chart) {
            Ok(Some(file)) => {
                let source = Some(job.chart.file_name());
                let options = Options { product: job.product.clone(), source, ..asked.clone() };
                let text = &report.sources.file(file).text;
                let (output, diagnostics) = grafc::compile(file, text, &job.chart.chart_name(), &options);
                report.diagnostics.append(diagnostics);
                made.extend(output.map(|output| (job, output)));
            }
            Ok(None) => {}
            Err(refusal) => {
                to_stderr(&refusal.to_string());
                exit = Exit::FilesRefused;
            }
        }
    }
    exit = exit.max(report.tell(messages));
    for (job, output) in made {
        if let Err(refusal) = job.write(&output, asked.lowering.encoding, &report.sources) {
            to_stderr(&refusal.to_string());
            exit = Exit::FilesRefused;
        }
    }
    exit
}

/// A pass that is there for other encodings alone.
fn refuse_pass_not_run(args: &Arguments) -> Result<(), Failure> {
    match passes::ORDER.iter().find(|pass| args.dump_after.as_deref() == Some(pass.name)) {
        Some(pass) if pass.for_overlap && !args.encoding.encoding().overlaps() => Err(Failure::WrongUse(
            format!("`{}` is not run with `{}`", pass.name, option("encoding", args.encoding)),
            "add `--encoding r-trigger` or `--encoding s-trigger`".to_string(),
        )),
        Some(_) | None => Ok(()),
    }
}
