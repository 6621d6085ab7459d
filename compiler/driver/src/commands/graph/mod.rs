//! `grafc graph`: what a chart can come to, as the graph of reachable markings of the textbook.

mod dot;
mod json;
mod picture;
mod text;

use super::{beyond, followed, refuse_output_over_input, with_claims};
use crate::Exit;
use crate::arguments::{ProfileArguments, QuietArgument};
use crate::report::{Failure, Format, Report};
use crate::stream::Stream;
use clap::{Args, ValueEnum};
use grafc_logic::scan::{ClaimKind, Program};
use grafc_verify::{Beyond, Graph, Of, graph};

const AFTER_HELP: &str = "\
Example:
  grafc graph valve.gct
  grafc graph valve.gct --format svg -o valve_graph.svg
  grafc graph valve.gct --of states --format json

Inputs that the assumptions of the chart exclude are left out. An edge bears the inputs with which some reaction leads from one situation to the other. Delays may end at any later
reaction. A reaction that does not end leads nowhere: what comes after LIVELOCK is not in the graph. Exit code 4: there is
more than `--max` allows, or something that cannot be followed.";

/// Arguments of `grafc graph`.
#[derive(Args, Debug)]
#[command(after_help = AFTER_HELP)]
pub struct Arguments {
    /// The chart; `-` is standard input
    #[arg(value_name = "CHART")]
    chart: Stream,
    /// Where to put the graph; standard output without it
    #[arg(short, long, value_name = "FILE")]
    output: Option<Stream>,
    /// The form of the graph
    #[arg(long, value_enum, default_value_t = Form::Text)]
    format: Form,
    /// What the nodes are
    #[arg(long, value_enum, default_value_t = OfName::Situations)]
    of: OfName,
    /// At most so many states are looked at, and ten paths of inputs for each
    #[arg(long, value_name = "N", default_value_t = 20_000)]
    max: usize,
    #[command(flatten)]
    profile: ProfileArguments,
    #[command(flatten)]
    quiet: QuietArgument,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum Form {
    /// For people
    Text,
    /// One JSON object
    Json,
    /// For Graphviz
    Dot,
    /// A drawing
    Svg,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum OfName {
    /// Situations
    Situations,
    /// States: with variables, operands of edges and delays
    States,
}

impl OfName {
    fn of(self) -> Of {
        match self {
            OfName::Situations => Of::Situations,
            OfName::States => Of::States,
        }
    }
}

/// Explores one chart.
pub fn run(args: Arguments) -> Result<Exit, Failure> {
    let output = args.output.clone().unwrap_or(Stream::Standard);
    refuse_output_over_input(&output, [&args.chart])?;
    let mut report = Report::default();
    let followed = followed(&mut report, &args.chart, &args.profile)?;
    let program = followed.and_then(|(document, asked)| with_claims(&document, asked.profile()));
    let found = program.map(|program| explored(program, args.of.of(), args.max));
    let exit = report.tell(args.quiet.messages(Format::Human));
    match found {
        None => Ok(exit),
        Some(Err(found)) => Err(beyond(found)),
        Some(Ok(graph)) if graph.barred.is_some() => Err(super::barred(graph.barred.as_deref().unwrap_or_default())),
        Some(Ok(graph)) => {
            let text = match args.format {
                Form::Text => text::text(&graph),
                Form::Json => json::json(&graph),
                Form::Dot => dot::dot(&graph),
                Form::Svg => picture::svg(&graph),
            };
            output.write(&text)?;
            Ok(if graph.complete { exit } else { exit.max(Exit::Open) })
        }
    }
}

/// The graph.
fn explored(mut program: Program, of: Of, most: usize) -> Result<Graph, Beyond> {
    // What is claimed of states changes nothing of what leads to what.
    program.claims.retain(|claim| claim.kind == ClaimKind::Assume);
    graph(&program, of, most)
}

/// The label of a node: its steps, and what else it is made of, a line each.
fn lines(node: &grafc_verify::Node) -> Vec<String> {
    let steps = format!("{{{}}}", node.steps.join(", "));
    std::iter::once(steps).chain(node.values.iter().map(|(name, value)| format!("{name} = {value}"))).collect()
}
