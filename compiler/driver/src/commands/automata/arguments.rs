//! The arguments of `grafc automata`.

use crate::arguments::{ProfileArguments, QuietArgument};
use crate::stream::Stream;
use clap::{Args, ValueEnum};

const AFTER_HELP: &str = "\
Example:
  grafc automata mixer.gct
  grafc automata lock.gct --as minimal
  grafc automata lock.gct --as mealy --format kiss2 -o lock.kiss2

Without `--as`: a transition graph for each set of steps of which at most one is ever active, whose arcs bear the states of
other graphs that they wait for. With it, one automaton for the whole chart, which may neither count nor measure time; that it
does what the chart does is proved by the product of both. Exit code 4: the chart is no automaton, or has more states than
`--max`.";

/// Arguments of `grafc automata`.
#[derive(Args, Debug)]
#[command(after_help = AFTER_HELP)]
pub struct Arguments {
    /// The chart; `-` is standard input
    #[arg(value_name = "CHART")]
    pub(super) chart: Stream,
    /// Where to put what is shown; standard output without it
    #[arg(short, long, value_name = "FILE")]
    pub(super) output: Option<Stream>,
    /// The form of what is shown
    #[arg(long, value_enum, default_value_t = Form::Text)]
    pub(super) format: Form,
    /// One automaton of this kind in place of the graphs
    #[arg(long = "as", value_enum, value_name = "KIND")]
    pub(super) kind: Option<As>,
    /// At most so many states are looked at
    #[arg(long, value_name = "N", default_value_t = 20_000)]
    pub(super) max: usize,
    #[command(flatten)]
    pub(super) profile: ProfileArguments,
    #[command(flatten)]
    pub(super) quiet: QuietArgument,
}

/// Forms of what is shown.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub(super) enum Form {
    /// For people
    Text,
    /// For Graphviz
    Dot,
    /// A drawing
    Svg,
    /// A table of KISS2, which has one automaton: a Mealy automaton without `--as`
    Kiss2,
    /// One JSON object
    Json,
}

/// Kinds of automata.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub(super) enum As {
    /// Outputs at vertices: those of the vertex that a call leads to
    Moore,
    /// Outputs at arcs
    Mealy,
    /// An expression for each output at vertices, of which there are as few as there can be
    Extended,
    /// A Mealy automaton of as few vertices as there can be
    Minimal,
}
