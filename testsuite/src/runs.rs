//! One chart as it runs: simulated by the rules, or lowered and evaluated.

use crate::charts;
use grafc_diagnostics::{Code, Diagnostics};
use grafc_logic::scan::evaluate::Evaluator;
use grafc_logic::scan::{Observed, Program};
use grafc_logic::{Analysis, Extras, Options};
use grafc_model::chart::Chart;
use grafc_model::reaction::{Profile, Response, Stimulus};
use grafc_model::simulate::Simulator;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// What the reference simulator does.
pub fn simulate(chart: &Chart, profile: Profile, stimuli: &[Stimulus]) -> Vec<Response> {
    let mut simulator = Simulator::new(chart, profile);
    stimuli.iter().map(|stimulus| simulator.react(stimulus)).collect()
}

/// The scan program of a chart, or the messages of the stages.
pub fn compile(chart: &Chart, options: &Options) -> Result<Program, String> {
    made(chart, lowered(chart, options))
}

/// The same with what gives saved memory back, as a target needs it that saves it.
pub fn compile_saved(chart: &Chart, options: &Options) -> Result<Program, String> {
    made(chart, lowered_by(chart, options, grafc_logic::compile_saved))
}

/// The same, and what is shown of micro-steps.
pub fn compile_observed(chart: &Chart, options: &Options, observed: Observed) -> Result<Program, String> {
    made(
        chart,
        lowered_by(chart, options, |analysis, options| grafc_logic::compile_observed(analysis, options, observed)),
    )
}

/// The same with all that is asked for.
pub fn compile_with(chart: &Chart, options: &Options, extras: Extras) -> Result<Program, String> {
    let compile = |analysis, options: &Options| grafc_logic::compile_with(analysis, options, extras);
    made(chart, lowered_by(chart, options, compile))
}

fn made(chart: &Chart, (program, diagnostics): (Program, Diagnostics)) -> Result<Program, String> {
    if diagnostics.has_errors() { Err(charts::render(&chart.name, "", &diagnostics)) } else { Ok(program) }
}

/// The scan program of a chart, and what the stages say.
pub fn lowered(chart: &Chart, options: &Options) -> (Program, Diagnostics) {
    lowered_by(chart, options, grafc_logic::compile)
}

fn lowered_by(
    chart: &Chart,
    options: &Options,
    compile: impl FnOnce(Analysis, &Options) -> (Program, Diagnostics),
) -> (Program, Diagnostics) {
    let mut diagnostics = Diagnostics::new();
    let mut net = grafc_net::build(chart);
    grafc_net::passes::run(&mut net, options.encoding.overlaps(), &mut diagnostics);
    let (program, more) = compile(Analysis::new(net), options);
    diagnostics.append(more);
    (program, diagnostics)
}

/// What the scan program of a chart does.
pub fn evaluate(chart: &Chart, options: &Options, stimuli: &[Stimulus]) -> Result<Vec<Response>, String> {
    Ok(run(&compile(chart, options)?, stimuli))
}

/// What a scan program does.
pub fn run(program: &Program, stimuli: &[Stimulus]) -> Vec<Response> {
    let mut evaluator = Evaluator::new(program);
    stimuli.iter().map(|stimulus| evaluator.react(stimulus)).collect()
}

/// The program in an encoding whose steps overlap, and whether the compiler warns that the overlap can be seen.
pub fn overlapping(chart: &Chart, options: &Options) -> Result<(Program, bool), String> {
    let (program, diagnostics) = lowered(chart, options);
    if diagnostics.has_errors() {
        return Err(charts::render(&chart.name, "", &diagnostics));
    }
    Ok((program, diagnostics.iter().any(|message| message.code == Code::W0413)))
}

/// The situations after each call in an encoding whose steps overlap, if the compiler has no warning that the overlap
/// can be seen.
pub fn stable_situations(
    chart: &Chart,
    options: &Options,
    stimuli: &[Stimulus],
) -> Result<Option<Vec<Response>>, String> {
    let (program, warned) = overlapping(chart, options)?;
    Ok((!warned).then(|| run(&program, stimuli)))
}

/// A fault as a value: a panic of the compiler is a finding like any other.
pub fn caught<T>(run: impl FnOnce() -> Result<T, String>) -> Result<T, String> {
    catch_unwind(AssertUnwindSafe(run)).unwrap_or_else(|payload| {
        let text = payload.downcast_ref::<String>().cloned();
        let text = text.or_else(|| payload.downcast_ref::<&str>().map(|s| (*s).to_string()));
        Err(format!("panicked: {}", text.unwrap_or_default()))
    })
}
