//! `grafc CHART --target T`: a chart to code, or to what lies on the way (`--emit`, `--dump-after`).

use super::refuse_output_over_input;
use crate::Exit;
use crate::arguments::{ProfileArguments, option};
use crate::files::Place;
use crate::header;
use crate::pipeline::{self, Options, Product};
use crate::report::{Failure, Format, Report};
use clap::builder::PossibleValuesParser;
use clap::{ArgGroup, Args, ValueEnum, value_parser};
use grafc_backends::{awl, iec61131_10, il, plcopen, rust, scl, st, tcpou};
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
    /// For `st`, `il` and `awl`: the kind of program organisation unit to make [default: function-block]
    #[arg(long, value_enum, value_name = "KIND", conflicts_with_all = NO_CODE)]
    pou: Option<Pou>,
    /// For `st`, `il` and `plcopen`: how often the task of the configuration runs, such as 20ms or 1s [default: 20ms]
    #[arg(long, value_name = "DURATION", alias = "interval", conflicts_with_all = NO_CODE)]
    task_interval: Option<Interval>,
    /// For `awl`: the number of the function block and of its data block [default: 1]
    #[arg(long, value_name = "NUMBER", value_parser = value_parser!(u16).range(1..), conflicts_with_all = NO_CODE)]
    block_number: Option<u16>,
    /// For `awl`: the language of the instructions [default: english]
    #[arg(long, value_enum, value_name = "LANGUAGE", conflicts_with_all = NO_CODE)]
    mnemonics: Option<MnemonicsName>,
    /// For `plcopen`: who shall read it [default: neutral]
    #[arg(long, value_enum, value_name = "DIALECT", conflicts_with_all = NO_CODE)]
    dialect: Option<Dialect>,
    /// For `plcopen`: what the function block holds [default: st]
    #[arg(long, value_enum, value_name = "LANGUAGE", conflicts_with_all = NO_CODE)]
    body: Option<Body>,
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
    /// Siemens STL (AWL), a source file for STEP 7: S7-300, S7-400
    Awl,
    /// A PLCopen XML project: function block, program, configuration
    Plcopen,
    /// Siemens SCL, a source file for TIA Portal
    Scl,
    /// A TwinCAT 3 program organisation unit
    Tcpou,
    /// The function block in the XML of IEC 61131-10
    #[value(name = "iec61131-10")]
    Iec61131_10,
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
enum MnemonicsName {
    /// `A I 0.0`
    English,
    /// `U E 0.0`
    German,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum Dialect {
    /// Beremiz and what comes from it
    Neutral,
    /// CODESYS, TwinCAT and what is built on CODESYS
    Codesys,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum Body {
    /// Structured Text
    St,
    /// Instruction list
    Il,
    /// A ladder diagram, of the neutral dialect
    Ld,
    /// A sequential function chart, if the chart can be one
    Sfc,
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
    let simplify = match args.optimize {
        Level::Plain => false,
        Level::Short => true,
    };
    let encoding = args.encoding.encoding();
    let lowering = grafc_logic::Options { profile: args.profile.profile(), encoding, simplify };
    let (Some(chart), Some(product)) = (&args.chart, product(&args, &lowering)) else {
        return Err(Failure::WrongUse("nothing to compile".to_string(), "see `grafc --help`".to_string()));
    };
    refuse_options_of_other_targets(&args)?;
    let alone = matches!(args.target, Some(TargetName::St | TargetName::Il)) && args.pou != Some(Pou::Configuration);
    if args.task_interval.is_some() && alone {
        return Err(Failure::WrongUse(
            "`--task-interval` is the interval of a configuration's task".to_string(),
            "add `--pou configuration`, or leave it out".to_string(),
        ));
    }
    if args.target == Some(TargetName::Awl) && args.pou == Some(Pou::Configuration) {
        return Err(Failure::WrongUse(
            "STEP 7 has no configurations".to_string(),
            "`--pou program` writes an OB 1, which the CPU runs in each cycle".to_string(),
        ));
    }
    if args.body == Some(Body::Ld) && args.dialect == Some(Dialect::Codesys) {
        return Err(Failure::WrongUse(
            "`--body ld` draws for the readers of `--dialect neutral` alone".to_string(),
            "take `--body st`, which every dialect has, or leave out `--dialect codesys`".to_string(),
        ));
    }
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

/// An option that only other targets know would be without effect.
fn refuse_options_of_other_targets(args: &Arguments) -> Result<(), Failure> {
    let Some(target) = args.target else { return Ok(()) };
    let options: [(&str, bool, &[TargetName]); 7] = [
        ("pou", args.pou.is_some(), &[TargetName::St, TargetName::Il, TargetName::Awl]),
        ("block-number", args.block_number.is_some(), &[TargetName::Awl]),
        ("mnemonics", args.mnemonics.is_some(), &[TargetName::Awl]),
        ("task-interval", args.task_interval.is_some(), &[TargetName::St, TargetName::Il, TargetName::Plcopen]),
        ("dialect", args.dialect.is_some(), &[TargetName::Plcopen]),
        ("body", args.body.is_some(), &[TargetName::Plcopen]),
        ("runtime", args.runtime.is_some(), &[TargetName::Rust]),
    ];
    match options.iter().find(|(_, given, known_to)| *given && !known_to.contains(&target)) {
        Some((name, _, known_to)) => {
            let targets = targets(known_to);
            Err(Failure::WrongUse(format!("`--{name}` is an option of {targets}"), "leave it out".to_string()))
        }
        None => Ok(()),
    }
}

/// Targets in a sentence: `a`, `b` and `c`.
fn targets(names: &[TargetName]) -> String {
    let names: Vec<String> = names.iter().map(|name| format!("`{}`", option("target", *name))).collect();
    match names.split_last() {
        Some((last, [])) => last.clone(),
        Some((last, others)) => format!("{} and {last}", others.join(", ")),
        None => String::new(),
    }
}

/// What is asked for.
fn product(args: &Arguments, lowering: &grafc_logic::Options) -> Option<Product> {
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
    let (chart, target) = (args.chart.as_ref()?, args.target?);
    Some(match target {
        TargetName::St => {
            let (pou, interval_ms) = around(args);
            Product::St(st::Options { pou, header: header::of_st(chart, lowering, pou, interval_ms), interval_ms })
        }
        TargetName::Il => {
            let (pou, interval_ms) = around(args);
            Product::Il(il::Options { pou, header: header::of_il(chart, lowering, pou, interval_ms), interval_ms })
        }
        TargetName::Awl => {
            let mut options = awl::Options {
                organization_block: args.pou == Some(Pou::Program),
                mnemonics: match args.mnemonics {
                    Some(MnemonicsName::English) | None => awl::Mnemonics::English,
                    Some(MnemonicsName::German) => awl::Mnemonics::German,
                },
                number: args.block_number.unwrap_or(awl::Options::default().number),
                header: Vec::new(),
            };
            options.header = header::of_awl(chart, lowering, &options);
            Product::Awl(options)
        }
        TargetName::Plcopen => {
            let mut options = plcopen::Options {
                dialect: match args.dialect {
                    Some(Dialect::Neutral) | None => plcopen::Dialect::Neutral,
                    Some(Dialect::Codesys) => plcopen::Dialect::Codesys,
                },
                body: match args.body {
                    Some(Body::St) | None => plcopen::Body::St,
                    Some(Body::Il) => plcopen::Body::Il,
                    Some(Body::Ld) => plcopen::Body::Ld,
                    Some(Body::Sfc) => plcopen::Body::Sfc,
                },
                header: Vec::new(),
                interval_ms: args.task_interval.map(|interval| interval.0),
            };
            options.header = header::of_plcopen(chart, lowering, &options);
            Product::Plcopen(options)
        }
        TargetName::Scl => Product::Scl(scl::Options { header: header::of_vendor(chart, "scl", lowering) }),
        TargetName::Tcpou => Product::Tcpou(tcpou::Options { header: header::of_vendor(chart, "tcpou", lowering) }),
        TargetName::Iec61131_10 => {
            Product::Iec61131_10(iec61131_10::Options { header: header::of_vendor(chart, "iec61131-10", lowering) })
        }
        TargetName::Rust => {
            let runtime = match args.runtime {
                Some(RuntimeName::Inline) | None => rust::Runtime::Inline,
                Some(RuntimeName::Crate) => rust::Runtime::Crate,
            };
            let header = header::of_rust(chart, lowering, runtime);
            Product::Rust(rust::Options { runtime, header, ..rust::Options::default() })
        }
    })
}

/// What stands around a function block of IEC 61131-3, and how often a task runs it.
fn around(args: &Arguments) -> (st::Pou, u32) {
    let pou = match args.pou {
        Some(Pou::FunctionBlock) | None => st::Pou::FunctionBlock,
        Some(Pou::Program) => st::Pou::Program,
        Some(Pou::Configuration) => st::Pou::Configuration,
    };
    (pou, args.task_interval.unwrap_or(DEFAULT_INTERVAL).0)
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
