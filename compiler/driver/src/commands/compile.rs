//! `grafc CHART --target T`: a chart to code.

use super::refuse_output_over_input;
use crate::Exit;
use crate::command_line::{ProfileArguments, option};
use crate::files::Place;
use crate::pipeline::{self, Options, Target};
use crate::report::{Failure, Format, Report};
use clap::{Args, ValueEnum};
use grafc_backends::st;
use grafc_logic::Encoding;
use std::str::FromStr;

/// Arguments of the compiler itself.
///
/// The two that must be given are options here, because they need not be when another command is given.
#[derive(Args, Debug)]
pub struct Arguments {
    /// The chart; `-` is standard input
    #[arg(required = true, value_name = "CHART")]
    chart: Option<Place>,
    /// What to make of it
    #[arg(long, value_enum, required = true, value_name = "TARGET")]
    target: Option<TargetName>,
    /// Where to put it [default: standard output]
    #[arg(short, long, value_name = "FILE")]
    output: Option<Place>,
    /// How the situation is held and the next one found
    #[arg(long, value_enum, default_value_t = EncodingName::SinglePhase, value_name = "ENCODING")]
    encoding: EncodingName,
    #[command(flatten)]
    profile: ProfileArguments,
    /// The kind of program organisation unit to make
    #[arg(long, value_enum, default_value_t = Pou::FunctionBlock, value_name = "KIND")]
    pou: Pou,
    /// How often the task of a configuration runs, such as 20ms or 1s [default: 20ms]
    #[arg(long, value_name = "DURATION")]
    interval: Option<Interval>,
    /// The form of messages, which go to standard error
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum TargetName {
    /// IEC 61131-3 Structured Text
    St,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum EncodingName {
    /// One bit a step, set dominant
    SinglePhase,
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
    let (Some(chart), Some(target)) = (args.chart, args.target) else {
        return Err(Failure::WrongUse("nothing to compile".to_string(), "see `grafc --help`".to_string()));
    };
    if args.interval.is_some() && args.pou != Pou::Configuration {
        return Err(Failure::WrongUse(
            "`--interval` is the interval of a configuration's task".to_string(),
            "add `--pou configuration`, or leave it out".to_string(),
        ));
    }
    let output = args.output.unwrap_or(Place::Standard);
    refuse_output_over_input(&output, [&chart])?;

    let interval = args.interval.unwrap_or(DEFAULT_INTERVAL);
    let options = Options {
        profile: args.profile.profile(),
        encoding: match args.encoding {
            EncodingName::SinglePhase => Encoding::SinglePhase,
        },
        target: match target {
            TargetName::St => Target::St(st::Options {
                pou: match args.pou {
                    Pou::FunctionBlock => st::Pou::FunctionBlock,
                    Pou::Program => st::Pou::Program,
                    Pou::Configuration => st::Pou::Configuration,
                },
                header: header(&chart, target, args.encoding, &args.profile, args.pou, interval),
                interval_ms: interval.0,
            }),
        },
    };
    let mut report = Report::default();
    let mut text = None;
    if let Some(file) = report.load(&chart)? {
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

/// Which chart, which version and which options made the code. No directories and no dates: equal charts give equal
/// code wherever and whenever they are compiled.
fn header(
    chart: &Place,
    target: TargetName,
    encoding: EncodingName,
    profile: &ProfileArguments,
    pou: Pou,
    interval: Interval,
) -> Vec<String> {
    let mut options = vec![option("target", target), option("encoding", encoding)];
    options.extend(profile.options());
    options.push(option("pou", pou));
    match pou {
        Pou::FunctionBlock | Pou::Program => {}
        Pou::Configuration => options.push(format!("--interval {}ms", interval.0)),
    }
    let source = match chart {
        Place::Standard => "standard input".to_string(),
        Place::File(path) => path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned(),
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
