//! The way from text to code, stage by stage.
//!
//! ```text
//! text ─parse─▶ syntax tree ─check─▶ chart ─build─▶ net ─passes─▶ flat net ─compile─▶ scan program ─emit─▶ code
//! ```
//!
//! Functions of their arguments alone: nothing is read, written or printed. A stage reports all it finds; after a
//! stage that found an error, no other begins, save that a text with syntax errors is checked as far as it was read.

use grafc_backends::st;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, FileId, Span};
use grafc_logic::Encoding;
use grafc_model::chart::Chart;
use grafc_model::reaction::Profile;
use grafc_model::simulate::Simulator;
use grafc_model::trace;
use grafc_syntax::ast::same;

/// What code is made, and what it is to mean.
#[derive(Clone, Debug)]
pub struct Options {
    /// Choices that change what the chart means.
    pub profile: Profile,
    /// How the situation is held.
    pub encoding: Encoding,
    /// The language of the code.
    pub target: Target,
}

/// A language, with the choices that it alone knows.
#[derive(Clone, Debug)]
pub enum Target {
    /// IEC 61131-3 Structured Text.
    St(st::Options),
}

/// The whole way. There is code exactly if no message is an error.
pub fn compile(file: FileId, text: &str, default_name: &str, options: &Options) -> (Option<String>, Diagnostics) {
    let (chart, mut said) = check(file, text, default_name);
    let Some(chart) = chart else { return (None, said) };

    let mut net = grafc_net::build(&chart);
    grafc_net::passes::run(&mut net, &mut said);
    if said.has_errors() {
        return (None, said);
    }

    let (program, found) = grafc_logic::compile(&net, options.profile, options.encoding);
    said.append(found);
    let Some(program) = program.filter(|_| !said.has_errors()) else { return (None, said) };

    let code = match &options.target {
        Target::St(options) => st::emit(&program, options),
    };
    match code {
        Ok(code) => (Some(code), said),
        Err(found) => {
            said.append(found);
            (None, said)
        }
    }
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
    (chart.filter(|_| !said.has_errors()), said)
}

/// A chart and a trace of its inputs to a trace of its outputs.
pub fn simulate(
    chart: (FileId, &str),
    default_name: &str,
    trace: (FileId, &str),
    profile: Profile,
) -> (Option<String>, Diagnostics) {
    let (chart, mut said) = check(chart.0, chart.1, default_name);
    let Some(chart) = chart else { return (None, said) };
    let (stimuli, found) = trace::parse_trace(trace.0, trace.1, &chart);
    said.append(found);
    if said.has_errors() {
        return (None, said);
    }
    let mut simulator = Simulator::new(&chart, profile);
    let responses: Vec<_> = stimuli.iter().map(|stimulus| simulator.react(stimulus)).collect();
    (Some(trace::write_trace(&chart, &stimuli, &responses)), said)
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
