//! `grafc CHART --target T`: a chart to code, or to what lies on the way (`--emit`, `--dump-after`).

use super::refuse_output_over_input;
use crate::Exit;
use crate::command_line::{ProfileArguments, option};
use crate::files::Place;
use crate::pipeline::{self, Options, Product};
use crate::report::{Failure, Format, Report};
use clap::builder::PossibleValuesParser;
use clap::{ArgGroup, Args, ValueEnum};
use grafc_backends::{rust, st};
use grafc_logic::Encoding;
use grafc_net::passes;
use std::str::FromStr;

/// Arguments of the compiler itself.
///
/// What must be given is optional here, because it need not be when another command is given.
#[derive(Args, Debug)]
#[command(group = ArgGroup::new("product").required(true))]
pub struct Arguments {
    /// The chart; `-` is standard input
    #[arg(required = true, value_name = "CHART")]
    chart: Option<Place>,
    /// What to make of it
    #[arg(long, value_enum, group = "product", value_name = "TARGET")]
    target: Option<TargetName>,
    /// Instead of code, what the compiler knows on the way, as text
    #[arg(long, value_enum, group = "product", value_name = "STAGE")]
    emit: Option<Stage>,
    /// Instead of code, the net after a pass
    #[arg(long, group = "product", value_name = "PASS", value_parser = pass_names())]
    dump_after: Option<String>,
    /// Where to put it [default: standard output]
    #[arg(short, long, value_name = "FILE")]
    output: Option<Place>,
    /// How the situation is held and the next one found
    #[arg(long, value_enum, default_value_t = EncodingName::SinglePhase, value_name = "ENCODING")]
    encoding: EncodingName,
    /// Whether formulas are shortened
    #[arg(short = 'O', long, value_enum, default_value_t = Level::Short, value_name = "LEVEL")]
    optimize: Level,
    #[command(flatten)]
    profile: ProfileArguments,
    /// For `st` and `il`: the kind of program organisation unit to make [default: function-block]
    #[arg(long, value_enum, value_name = "KIND", conflicts_with_all = NO_CODE)]
    pou: Option<Pou>,
    /// For `st` and `il`: how often the task of a configuration runs, such as 20ms or 1s [default: 20ms]
    #[arg(long, value_name = "DURATION", conflicts_with_all = NO_CODE)]
    interval: Option<Interval>,
    /// For `rust`: where the code has from what it needs at run time [default: inline]
    #[arg(long, value_enum, value_name = "RUNTIME", conflicts_with_all = NO_CODE)]
    runtime: Option<RuntimeName>,
    /// The form of messages, which go to standard error
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum TargetName {
    /// IEC 61131-3 Structured Text
    St,
    /// IEC 61131-3 instruction list
    Il,
    /// A Rust module, without std and allocation
    Rust,
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

/// What leaves no choice about code.
const NO_CODE: [&str; 2] = ["emit", "dump_after"];

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
enum Level {
    /// Formulas as the textbook has them
    #[value(name = "0")]
    Plain,
    /// Without what is proved to make no difference
    #[value(name = "1")]
    Short,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum Pou {
    /// A function block to be called from a program
    FunctionBlock,
    /// A program
    Program,
    /// A program with a configuration and a task to run it
    Configuration,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum RuntimeName {
    /// From itself: the module stands alone
    Inline,
    /// From the crate `grafc-runtime`, whose trait `Chart` it implements
    Crate,
}

/// A cycle time in milliseconds.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
struct Interval(u32);

impl FromStr for Interval {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        const FORM: &str = "expected whole milliseconds or seconds, such as 20ms or 1s";
        let (number, factor) = match (text.strip_suffix("ms"), text.strip_suffix('s')) {
            (Some(number), _) => (number, 1),
            (None, Some(number)) => (number, 1000),
            (None, None) => return Err(FORM),
        };
        if number.is_empty() || !number.bytes().all(|b| b.is_ascii_digit()) {
            return Err(FORM);
        }
        let ms = number.parse::<u32>().ok().and_then(|n| n.checked_mul(factor)).filter(|ms| *ms <= i32::MAX as u32);
        match ms {
            Some(0) => Err("a task needs a time between its runs"),
            Some(ms) => Ok(Interval(ms)),
            None => Err("too long: a time has at most 2147483647 ms"),
        }
    }
}

const DEFAULT_INTERVAL: Interval = Interval(20);

/// Compiles one chart.
pub fn run(args: Arguments) -> Result<Exit, Failure> {
    let (Some(chart), Some(product)) = (&args.chart, product(&args)) else {
        return Err(Failure::WrongUse("nothing to compile".to_string(), "see `grafc --help`".to_string()));
    };
    refuse_options_of_other_targets(&args)?;
    if args.interval.is_some() && args.pou != Some(Pou::Configuration) {
        return Err(Failure::WrongUse(
            "`--interval` is the interval of a configuration's task".to_string(),
            "add `--pou configuration`, or leave it out".to_string(),
        ));
    }
    let encoding = args.encoding.encoding();
    if let Some(pass) = passes::ORDER.iter().find(|pass| args.dump_after.as_deref() == Some(pass.name))
        && pass.for_overlap
        && !encoding.overlaps()
    {
        return Err(Failure::WrongUse(
            format!("`{}` is not run with `{}`", pass.name, option("encoding", args.encoding)),
            "add `--encoding r-trigger` or `--encoding s-trigger`".to_string(),
        ));
    }
    let output = args.output.clone().unwrap_or(Place::Standard);
    refuse_output_over_input(&output, [chart])?;

    let simplify = match args.optimize {
        Level::Plain => false,
        Level::Short => true,
    };
    let lowering = grafc_logic::Options { profile: args.profile.profile(), encoding, simplify };
    let options = Options { lowering, product };
    let mut report = Report::default();
    let mut text = None;
    if let Some(file) = report.load(chart)? {
        let (made, said) = pipeline::compile(file, &report.sources.file(file).text, &chart.chart_name(), &options);
        report.diagnostics.append(said);
        text = made;
    }
    let exit = report.tell(args.format);
    if let Some(text) = text {
        output.write(&text)?;
    }
    Ok(exit)
}

/// An option that only another target knows would be without effect.
fn refuse_options_of_other_targets(args: &Arguments) -> Result<(), Failure> {
    let iec = [("pou", args.pou.is_some()), ("interval", args.interval.is_some())];
    let rust = [("runtime", args.runtime.is_some())];
    let (foreign, own): (&[(&str, bool)], _) = match args.target {
        Some(TargetName::St | TargetName::Il) => (&rust, "`--target rust`"),
        Some(TargetName::Rust) => (&iec, "`--target st` and `--target il`"),
        None => return Ok(()),
    };
    match foreign.iter().find(|(_, given)| *given) {
        Some((name, _)) => {
            Err(Failure::WrongUse(format!("`--{name}` is an option of {own}"), "leave it out".to_string()))
        }
        None => Ok(()),
    }
}

/// What is asked for.
fn product(args: &Arguments) -> Option<Product> {
    if let Some(pass) = &args.dump_after {
        return Some(Product::NetAfter(pass.clone()));
    }
    if let Some(stage) = args.emit {
        return Some(match stage {
            Stage::Ast => Product::Tree,
            Stage::Model => Product::Chart,
            Stage::Net => Product::Net,
            Stage::Logic => Product::Equations,
            Stage::Scan => Product::Program,
        });
    }
    args.target.map(|target| match target {
        TargetName::St => Product::St(iec_options(args, target)),
        TargetName::Il => Product::Il(iec_options(args, target)),
        TargetName::Rust => Product::Rust(rust::Options {
            runtime: match args.runtime {
                Some(RuntimeName::Inline) | None => rust::Runtime::Inline,
                Some(RuntimeName::Crate) => rust::Runtime::Crate,
            },
            header: header(args, target),
            module: None,
        }),
    })
}

/// What stands around a function block of IEC 61131-3.
fn iec_options(args: &Arguments, target: TargetName) -> st::Options {
    st::Options {
        pou: match args.pou {
            Some(Pou::FunctionBlock) | None => st::Pou::FunctionBlock,
            Some(Pou::Program) => st::Pou::Program,
            Some(Pou::Configuration) => st::Pou::Configuration,
        },
        header: header(args, target),
        interval_ms: args.interval.unwrap_or(DEFAULT_INTERVAL).0,
    }
}

/// Which chart, which version and which options made the code. No directories and no dates: equal charts give equal
/// code wherever and whenever they are compiled.
fn header(args: &Arguments, target: TargetName) -> Vec<String> {
    let mut options = vec![option("target", target), option("encoding", args.encoding)];
    match args.optimize {
        Level::Plain => options.push(option("optimize", args.optimize)),
        Level::Short => {}
    }
    options.extend(args.profile.options());
    match target {
        TargetName::St | TargetName::Il => {
            let pou = args.pou.unwrap_or(Pou::FunctionBlock);
            options.push(option("pou", pou));
            match pou {
                Pou::FunctionBlock | Pou::Program => {}
                Pou::Configuration => {
                    options.push(format!("--interval {}ms", args.interval.unwrap_or(DEFAULT_INTERVAL).0));
                }
            }
        }
        TargetName::Rust => options.push(option("runtime", args.runtime.unwrap_or(RuntimeName::Inline))),
    }
    let source = match &args.chart {
        Some(Place::File(path)) => path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned(),
        Some(Place::Standard) | None => "standard input".to_string(),
    };
    vec![format!("Made by grafc {} from {source}", env!("CARGO_PKG_VERSION")), options.join(" ")]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn intervals_are_whole_milliseconds_above_zero() {
        assert_eq!("20ms".parse(), Ok(Interval(20)));
        assert_eq!("2s".parse(), Ok(Interval(2000)));
        for wrong in ["", "20", "ms", "s", "0ms", "-1ms", "+1ms", "1.5s", "1 s", "2147484s", "99999999999ms", "1m"] {
            assert!(wrong.parse::<Interval>().is_err(), "{wrong}");
        }
    }
}
