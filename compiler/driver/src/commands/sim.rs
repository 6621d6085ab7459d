//! `grafc sim`: a chart over a trace, with the reference simulator; compared with a recording, if there is one.

use super::{refuse_output_over_input, refuse_second_standard_input};
use crate::Exit;
use crate::arguments::{ControlArguments, MessageArguments, ProfileArguments};
use crate::report::{Failure, Report};
use crate::stream::Stream;
use crate::waveform;
use clap::Args;
use grafc::files::print;
use grafc_model::simulate::Calls;

const AFTER_HELP: &str = "\
Example:
  grafc sim valve.gct --trace valve.trace.csv -o valve.result.csv
  grafc sim valve.gct --trace valve.trace.csv --against plc.csv
  grafc sim valve.gct --trace valve.trace.csv --events --show inputs,steps
  grafc sim valve.gct --trace valve.trace.csv --scan 20ms -o valve.vcd

A trace is CSV: a header `t_ms,NAME,...` of inputs, then a row a scan, the first for the initial reaction.
The result has the header `t_ms,OUTPUT,...,situation,flags`; a recording has any of these columns, and the first row
that differs is an error.";

/// Arguments of `grafc sim`.
#[derive(Args, Debug)]
#[command(after_help = AFTER_HELP)]
pub struct Arguments {
    /// The chart; `-` is standard input
    #[arg(value_name = "CHART")]
    chart: Stream,
    /// The inputs over time; `-` is standard input
    #[arg(long, value_name = "IN.csv")]
    trace: Stream,
    /// A result recorded elsewhere, to compare with; `-` is standard input
    #[arg(long, value_name = "RECORDED.csv")]
    against: Option<Stream>,
    /// Call the chart at this period as well, between the rows of the trace
    #[arg(long, value_name = "PERIOD", value_parser = period)]
    scan: Option<Period>,
    /// Call the chart between the rows exactly where a delay ends
    #[arg(long, conflicts_with = "scan")]
    events: bool,
    /// More columns, separated by commas: `inputs`, `vars`, `steps`, and names as in conditions, such as `T5`
    #[arg(long, value_name = "WHAT,...", value_delimiter = ',')]
    show: Vec<String>,
    /// Where to put the result: a table, or with the ending `.vcd` a drawing of all values over time [default: standard output; nowhere with `--against`]
    #[arg(short, long, value_name = "OUT.csv")]
    output: Option<Stream>,
    #[command(flatten)]
    profile: ProfileArguments,
    #[command(flatten)]
    controls: ControlArguments,
    #[command(flatten)]
    messages: MessageArguments,
}

/// Runs one chart over one trace.
pub fn run(args: Arguments) -> Result<Exit, Failure> {
    let inputs = || [&args.chart, &args.trace].into_iter().chain(&args.against);
    refuse_second_standard_input(inputs())?;
    // A comparison is asked whether it is the same, not what it is.
    let output = args.output.or(args.against.is_none().then_some(Stream::Standard));
    if let Some(output) = &output {
        refuse_output_over_input(output, inputs())?;
    }

    let drawn =
        matches!(&output, Some(Stream::File(path)) if path.extension().is_some_and(|e| e.eq_ignore_ascii_case("vcd")));
    let mut report = Report::new(args.messages.policy()?);
    let chart = report.load(&args.chart)?;
    let trace = report.load(&args.trace)?;
    let against = args.against.as_ref().map(|stream| report.load(stream)).transpose()?;
    let mut made = None;
    if let (Some(chart), Some(trace)) = (chart, trace)
        && against != Some(None)
    {
        let text = |file| (file, report.sources.file(file).text.as_str());
        let against = against.flatten().map(text);
        let calls = match args.scan {
            Some(Period(period)) => Calls::Every(period),
            None if args.events => Calls::Events,
            None => Calls::Rows,
        };
        // A drawing is of everything.
        let show = if drawn { [ALL.map(String::from).to_vec(), args.show].concat() } else { args.show };
        let controls = args.controls.names();
        let (profile, bound_as_known) = (args.profile.profile(), args.profile.bound_as_known());
        let how = grafc::Run { profile, bound_as_known, controls: Some(&controls), calls, show: &show };
        let name = args.chart.chart_name();
        let (simulation, diagnostics) = grafc::simulate(text(chart), &name, text(trace), against, how);
        report.diagnostics.append(diagnostics);
        made = simulation.map_err(|grafc::NotShown { word, near }| {
            let all = "there are `inputs`, `vars`, `steps`, and names as in conditions: of variables, `X5`, `T5`";
            let help = near.map_or(all.to_owned(), |near| format!("did you mean `{near}`?"));
            Failure::WrongUse(format!("`--show {word}`: the chart has nothing of this name"), help)
        })?;
    }
    let messages = args.messages.messages();
    let exit = report.tell(messages);
    if let Some(made) = made.filter(|_| !report.has_errors()) {
        match &output {
            Some(output) if drawn => output.write(&waveform::draw(&made))?,
            Some(output) => output.write(&made.csv())?,
            None if messages.quiet => {}
            None => print(&format!("{} rows agree\n", made.compared.unwrap_or_default()))?,
        }
    }
    Ok(exit)
}

/// What a drawing shows in any case.
const ALL: [&str; 3] = ["inputs", "vars", "steps"];

/// Milliseconds between two calls.
#[derive(Clone, Copy, Debug)]
struct Period(i64);

/// `20ms`, `0.5s`, `1min`.
fn period(text: &str) -> Result<Period, String> {
    let digits = text.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(text.len());
    let (number, unit) = text.split_at(digits);
    let factor = match unit {
        "ms" => 1.0,
        "s" => 1_000.0,
        "min" | "m" => 60_000.0,
        "h" => 3_600_000.0,
        _ => return Err("a period has a unit: `20ms`, `1s`".into()),
    };
    let ms = number.parse::<f64>().map_err(|_| "a period begins with a number: `20ms`")? * factor;
    if ms >= 1.0 && ms.fract() == 0.0 && ms <= f64::from(i32::MAX) {
        Ok(Period(ms as i64))
    } else {
        Err("a period is whole milliseconds, at least 1ms".into())
    }
}
