//! The way from text to code, stage by stage.
//!
//! ```text
//! text ─parse─▶ syntax tree ─check─▶ chart ─build─▶ net ─passes─▶ flat net ─compile─▶ scan program ─emit─▶ code
//! ```
//!
//! Functions of their arguments alone: nothing is read, written or printed. A stage reports all it finds; after a
//! stage that found an error, no other begins, save that a text with syntax errors is checked as far as it was read.
//! What lies between two stages can be had as text.

use grafc_backends::{Output, Source, Target};
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, FileId, Span};
use grafc_logic::scan::{self, Program};
use grafc_logic::sequence::{Sequence, sequence};
use grafc_logic::{Analysis, Encoding};
use grafc_model::chart::Chart;
use grafc_model::reaction::Profile;
use grafc_model::simulate::Simulator;
use grafc_model::trace;
use grafc_net::Net;
use grafc_net::passes::Pass;
use grafc_syntax::ast::same;
use std::cell::OnceCell;

/// What is made, and what it is to mean.
#[derive(Clone, Debug)]
pub struct Options {
    /// How the chart becomes a program.
    pub lowering: grafc_logic::Options,
    /// What comes out.
    pub product: Product,
}

/// What comes out: code, or what lies between two stages.
#[derive(Clone, Debug)]
pub enum Product {
    /// Code.
    Code(Target),
    /// The syntax tree.
    Tree,
    /// The checked chart.
    Chart,
    /// The net after the pass of this name.
    NetAfter(String),
    /// The flat net.
    Net,
    /// The equations of the scan program.
    Equations,
    /// The scan program.
    Program,
}

/// As far as what is asked for. There is a text exactly if no message is an error; and none after a pass that is not run.
pub fn compile(file: FileId, text: &str, default_name: &str, options: &Options) -> (Option<Output>, Diagnostics) {
    let lowering = &options.lowering;
    let (made, said) = match &options.product {
        Product::Tree => {
            let (tree, said) = grafc_syntax::parse(file, text);
            (Some(grafc_syntax::dump(&tree)), said)
        }
        Product::Chart => {
            let (chart, said) = check(file, text, default_name);
            (chart.as_ref().map(grafc_model::dump), said)
        }
        Product::NetAfter(name) => {
            let mut found = None;
            let look =
                |pass: &Pass, net: &Net| found = found.take().or((pass.name == name).then(|| grafc_net::dump(net)));
            let (_, said) = flatten(file, text, default_name, lowering.encoding, look);
            (found, said)
        }
        Product::Net => {
            let (net, said) = flatten(file, text, default_name, lowering.encoding, |_, _| ());
            (net.as_ref().map(grafc_net::dump), said)
        }
        Product::Equations => {
            let (program, said) = lower(file, text, default_name, lowering);
            (program.as_ref().map(scan::equations), said)
        }
        Product::Program => {
            let (program, said) = lower(file, text, default_name, lowering);
            (program.as_ref().map(scan::dump), said)
        }
        Product::Code(target) => return emit(file, text, default_name, lowering, target),
    };
    (made.map(Output::from).filter(|_| !said.has_errors()), said)
}

/// As far as the checked chart. There is one exactly if no message is an error.
pub fn check(file: FileId, text: &str, default_name: &str) -> (Option<Chart>, Diagnostics) {
    let (tree, mut said) = grafc_syntax::parse(file, text);
    let (chart, mut found) = grafc_model::check(&tree, default_name);
    if said.has_errors() {
        // The author shall see all faults at once, but none that only comes from what could not be read.
        found.retain(|d| d.code.is_certain_beside_syntax_errors());
        said.append(found);
        said.sort_by_place();
        return (None, said);
    }
    said.append(found);
    let chart = chart.filter(|_| !said.has_errors());
    if let Some(chart) = &chart {
        let mut net = grafc_net::build(chart);
        grafc_net::passes::run(&mut net, false, &mut said);
        said.append(grafc_logic::warn(&Analysis::new(net)));
        said.sort_by_place();
    }
    (chart, said)
}

/// As far as the flat net; `look` sees it after each pass. There is one exactly if no message is an error.
fn flatten(
    file: FileId,
    text: &str,
    default_name: &str,
    encoding: Encoding,
    look: impl FnMut(&'static Pass, &Net),
) -> (Option<Net>, Diagnostics) {
    let (chart, mut said) = check(file, text, default_name);
    let Some(chart) = chart else { return (None, said) };
    let mut net = grafc_net::build(&chart);
    grafc_net::passes::run_and_look(&mut net, encoding.overlaps(), &mut said, look);
    (Some(net).filter(|_| !said.has_errors()), said)
}

/// As far as the scan program. There is one exactly if no message is an error.
fn lower(
    file: FileId,
    text: &str,
    default_name: &str,
    options: &grafc_logic::Options,
) -> (Option<Program>, Diagnostics) {
    let (net, mut said) = flatten(file, text, default_name, options.encoding, |_, _| ());
    let Some(net) = net else { return (None, said) };
    let (program, found) = grafc_logic::compile(Analysis::new(net), options);
    said.append(found);
    (Some(program).filter(|_| !said.has_errors()), said)
}

/// As far as code.
fn emit(
    file: FileId,
    text: &str,
    default_name: &str,
    options: &grafc_logic::Options,
    target: &Target,
) -> (Option<Output>, Diagnostics) {
    let (net, mut said) = flatten(file, text, default_name, options.encoding, |_, _| ());
    let Some(net) = net else { return (None, said) };
    let stages =
        LastStages { analysis: Analysis::new(net), options, program: OnceCell::new(), sequence: OnceCell::new() };
    let made = target.emit(&stages);
    if let Some((_, found)) = stages.program.into_inner() {
        said.append(found);
    }
    match made {
        Ok(output) => (Some(output).filter(|_| !said.has_errors()), said),
        Err(found) => {
            // What a stage said is there already.
            if !said.has_errors() {
                said.append(found);
            }
            (None, said)
        }
    }
}

/// The stages after the flat net, of which a target asks for the one that it writes.
struct LastStages<'o> {
    analysis: Analysis,
    options: &'o grafc_logic::Options,
    program: OnceCell<(Program, Diagnostics)>,
    sequence: OnceCell<Result<Sequence, Diagnostics>>,
}

impl Source for LastStages<'_> {
    fn program(&self) -> Result<&Program, Diagnostics> {
        let compile = || grafc_logic::compile(self.analysis.clone(), self.options);
        let (program, said) = self.program.get_or_init(compile);
        if said.has_errors() { Err(said.clone()) } else { Ok(program) }
    }

    fn sequence(&self) -> Result<&Sequence, Diagnostics> {
        let drawn = self.sequence.get_or_init(|| sequence(&self.analysis, self.options.profile));
        drawn.as_ref().map_err(Diagnostics::clone)
    }
}

/// What a chart does over a trace.
pub struct Simulation {
    /// The trace of its outputs.
    pub result: String,
    /// Rows of the recording that it was compared with, if there was one.
    pub compared: Option<usize>,
}

/// A chart and a trace of its inputs to a trace of its outputs, compared with one that was recorded elsewhere.
pub fn simulate(
    chart: (FileId, &str),
    default_name: &str,
    trace: (FileId, &str),
    recorded: Option<(FileId, &str)>,
    profile: Profile,
) -> (Option<Simulation>, Diagnostics) {
    let (chart, mut said) = check(chart.0, chart.1, default_name);
    let Some(chart) = chart else { return (None, said) };
    let (stimuli, found) = trace::parse_trace(trace.0, trace.1, &chart);
    said.append(found);
    if said.has_errors() {
        return (None, said);
    }
    let mut simulator = Simulator::new(&chart, profile);
    let responses: Vec<_> = stimuli.iter().map(|stimulus| simulator.react(stimulus)).collect();
    let compared = recorded.map(|(file, text)| {
        let (rows, found) = trace::compare_trace(file, text, &chart, &stimuli, &responses);
        said.append(found);
        rows
    });
    (Some(Simulation { result: trace::write_trace(&chart, &stimuli, &responses), compared }), said)
}

/// The text in canonical format, if it can be parsed.
pub fn format(file: FileId, text: &str) -> (Option<String>, Diagnostics) {
    let (tree, mut said) = grafc_syntax::parse(file, text);
    if said.has_errors() {
        return (None, said);
    }
    let formatted = grafc_syntax::format(text, &tree);
    // An author's only copy may be at stake: what comes out must be the same chart.
    let (again, found) = grafc_syntax::parse(file, &formatted);
    if found.has_errors() || !same(&tree, &again) {
        let place = Span::new(file, 0, 0);
        said.push(
            Diagnostic::new(Code::E0901, place, "this is a fault of grafc: formatting would change the chart")
                .note("the chart is left as it was")
                .help(concat!("please report it, with the chart, at ", env!("CARGO_PKG_REPOSITORY"))),
        );
        return (None, said);
    }
    (Some(formatted), said)
}
