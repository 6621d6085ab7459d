//! `grafc CHART --target T`: a chart to code, or to the form after a stage (`--emit`, `--dump-after`).

use super::refuse_output_over_input;
use crate::Exit;
use crate::arguments::{ProfileArguments, option};
use crate::choices::{self, Choices};
use crate::map::{self, Made};
use crate::report::{Failure, Format, Report};
use crate::stream::Stream;
use clap::builder::PossibleValuesParser;
use clap::{ArgGroup, Args, ValueEnum};
use grafc::header;
use grafc::{Options, Product};
use grafc_backends::Target;
use grafc_logic::Encoding;
use grafc_net::passes;

/// Arguments of the compiler itself.
///
/// What must be given is optional here, because it need not be when another command is given.
#[derive(Args, Debug)]
#[command(group = ArgGroup::new("product").required(true))]
pub struct Arguments {
    /// The chart; `-` is standard input
    #[arg(required = true, value_name = "CHART")]
    chart: Option<Stream>,
    /// What to make of it
    #[arg(long, group = "product", value_name = "TARGET", value_parser = choices::targets())]
    target: Option<String>,
    /// Instead of code, what the compiler knows after a stage, as text
    #[arg(long, value_enum, group = "product", value_name = "STAGE")]
    emit: Option<Stage>,
    /// Instead of code, the net after a pass
    #[arg(long, group = "product", value_name = "PASS", value_parser = pass_names())]
    dump_after: Option<String>,
    /// Where to put it [default: standard output]
    #[arg(short, long, value_name = "FILE")]
    output: Option<Stream>,
    /// And where to put which lines of the code come from which element of the chart, as JSON
    #[arg(long, value_name = "FILE", conflicts_with_all = choices::NO_CODE)]
    map: Option<Stream>,
    /// How the situation is held and the next one found
    #[arg(long, value_enum, default_value_t = EncodingName::SinglePhase, value_name = "ENCODING")]
    encoding: EncodingName,
    /// Whether formulas are shortened
    #[arg(short = 'O', long, value_enum, default_value_t = Optimization::Short, value_name = "LEVEL")]
    optimize: Optimization,
    #[command(flatten)]
    profile: ProfileArguments,
    #[command(flatten)]
    choices: Choices,
    /// The form of messages, which go to standard error
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
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

/// Compiles one chart.
pub fn run(args: Arguments) -> Result<Exit, Failure> {
    let simplify = match args.optimize {
        Optimization::Plain => false,
        Optimization::Short => true,
    };
    let encoding = args.encoding.encoding();
    let lowering = grafc_logic::Options { profile: args.profile.profile(), encoding, simplify };
    let nothing = || Failure::WrongUse("nothing to compile".to_string(), "see `grafc --help`".to_string());
    let chart = args.chart.as_ref().ok_or_else(nothing)?;
    let product = product(&args, chart, &lowering).ok_or_else(nothing)??;
    if let Some(pass) = passes::ORDER.iter().find(|pass| args.dump_after.as_deref() == Some(pass.name))
        && pass.for_overlap
        && !encoding.overlaps()
    {
        return Err(Failure::WrongUse(
            format!("`{}` is not run with `{}`", pass.name, option("encoding", args.encoding)),
            "add `--encoding r-trigger` or `--encoding s-trigger`".to_string(),
        ));
    }
    let output = args.output.clone().unwrap_or(Stream::Standard);
    refuse_output_over_input(&output, [chart])?;
    if let Some(map) = &args.map {
        refuse_map(map, chart, &output, args.target.as_deref())?;
    }

    let options = Options { lowering, product };
    let mut report = Report::default();
    let mut made = None;
    if let Some(file) = report.load(chart)? {
        let (output, said) = grafc::compile(file, &report.sources.file(file).text, &chart.chart_name(), &options);
        report.diagnostics.append(said);
        made = output;
    }
    let exit = report.tell(args.format);
    if let Some(made) = made {
        output.write(&made.text)?;
        if let (Some(stream), Some(map)) = (&args.map, &made.map) {
            let (chart, target) = (chart.file_name(), args.target.as_deref().unwrap_or_default());
            let output = args.output.as_ref().filter(|output| **output != Stream::Standard).map(Stream::file_name);
            let about = Made { chart: &chart, output: output.as_deref(), target, encoding: encoding.name() };
            stream.write(&map::json(map, &about, &report.sources))?;
        }
    }
    Ok(exit)
}

/// A map that nobody can write, or that would take the place of something else.
fn refuse_map(map: &Stream, chart: &Stream, output: &Stream, target: Option<&str>) -> Result<(), Failure> {
    let mapped = || Target::ALL.iter().filter(|about| about.mapped);
    if target.is_some_and(|target| mapped().all(|about| about.name != target)) {
        let what = format!("`--map` is an option of {}", choices::sentence(mapped(), "--target "));
        return Err(Failure::WrongUse(what, "leave it out".to_string()));
    }
    if map.is_same_stream(output) {
        let what = "the map and the code would be written to one place".to_string();
        return Err(Failure::WrongUse(what, "choose another file with `--map` or `-o`".to_string()));
    }
    if map.is_same_file(chart) {
        let what = format!("the map would overwrite `{}`", chart.input_name());
        return Err(Failure::WrongUse(what, "choose another file with `--map`".to_string()));
    }
    Ok(())
}

/// What is asked for, if anything is.
fn product(args: &Arguments, chart: &Stream, lowering: &grafc_logic::Options) -> Option<Result<Product, Failure>> {
    if let Some(pass) = &args.dump_after {
        return Some(Ok(Product::NetAfter(pass.clone())));
    }
    if let Some(stage) = args.emit {
        return Some(Ok(match stage {
            Stage::Ast => Product::Tree,
            Stage::Model => Product::Chart,
            Stage::Net => Product::Net,
            Stage::Logic => Product::Equations,
            Stage::Scan => Product::Program,
        }));
    }
    let target = args.choices.target(args.target.as_ref()?)?;
    Some(target.map(|mut target| {
        target.set_header(header(&chart.file_name(), lowering, &target));
        if args.map.is_some() { Product::Mapped(target) } else { Product::Code(target) }
    }))
}
