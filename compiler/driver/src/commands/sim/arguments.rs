//! The arguments of `grafc sim`.

use crate::arguments::{ControlArguments, MessageArguments, Period, ProfileArguments, period};
use crate::stream::Stream;
use clap::Args;
use std::path::PathBuf;

const AFTER_HELP: &str = "\
Example:
  grafc sim valve.gct --trace valve.trace.csv -o valve.result.csv
  grafc sim valve.gct --trace valve.trace.csv --against plc.csv
  grafc sim valve.gct --trace valve.trace.csv --events --show inputs,steps
  grafc sim valve.gct --trace valve.trace.csv --scan 20ms -o valve.vcd
  grafc sim valve.gct --batch traces/ -o results/

A trace is CSV: a header `t_ms,NAME,...` of inputs, then a row a scan, the first for the initial reaction.
The result has the header `t_ms,OUTPUT,...,situation,flags`; a recording has any of these columns, and the first row
that differs is an error. With `--batch` each file NAME.csv of a folder is a trace, and its result is NAME.csv in another.";

/// Arguments of `grafc sim`.
#[derive(Args, Debug)]
#[command(after_help = AFTER_HELP)]
pub struct Arguments {
    /// The chart; `-` is standard input
    #[arg(value_name = "CHART")]
    pub(super) chart: Stream,
    /// The inputs over time; `-` is standard input
    #[arg(long, value_name = "IN.csv", required_unless_present = "batch")]
    pub(super) trace: Option<Stream>,
    /// A folder of traces, which are run 64 at once; `-o` names a folder for their results
    #[arg(long, value_name = "DIR", conflicts_with_all = ["trace", "against", "scan", "events", "show"], requires = "output")]
    pub(super) batch: Option<PathBuf>,
    /// A result recorded elsewhere, to compare with; `-` is standard input
    #[arg(long, value_name = "RECORDED.csv")]
    pub(super) against: Option<Stream>,
    /// Call the chart at this period as well, between the rows of the trace
    #[arg(long, value_name = "PERIOD", value_parser = period)]
    pub(super) scan: Option<Period>,
    /// Call the chart between the rows exactly where a delay ends
    #[arg(long, conflicts_with = "scan")]
    pub(super) events: bool,
    /// More columns, separated by commas: `inputs`, `vars`, `steps`, and names as in conditions, such as `T5`
    #[arg(long, value_name = "WHAT,...", value_delimiter = ',')]
    pub(super) show: Vec<String>,
    /// Where to put the result: a table, or with the ending `.vcd` a drawing of all values over time [default: standard output; nowhere with `--against`]
    #[arg(short, long, value_name = "OUT.csv")]
    pub(super) output: Option<Stream>,
    #[command(flatten)]
    pub(super) profile: ProfileArguments,
    #[command(flatten)]
    pub(super) controls: ControlArguments,
    #[command(flatten)]
    pub(super) messages: MessageArguments,
}
