//! One chart, one trace, several executors: all must respond alike.

pub mod command;
pub mod coverage;
pub mod long_run;
pub mod mismatch;
pub mod shrink;
pub mod table;

use crate::charts;
use grafc_diagnostics::{Code, Diagnostics};
use grafc_logic::scan::Program;
use grafc_logic::scan::evaluate::Evaluator;
use grafc_logic::{Encoding, Options};
use grafc_model::chart::{Chart, Value};
use grafc_model::reaction::{Evolution, Profile, Response, Stimulus};
use grafc_model::simulate::Simulator;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// What the reference simulator does.
pub fn simulate(chart: &Chart, profile: Profile, stimuli: &[Stimulus]) -> Vec<Response> {
    let mut simulator = Simulator::new(chart, profile);
    stimuli.iter().map(|stimulus| simulator.react(stimulus)).collect()
}

/// The scan program of a chart, or the messages of the stages.
pub fn compile(chart: &Chart, options: &Options) -> Result<Program, String> {
    let (program, said) = lowered(chart, options);
    match program {
        Some(program) if !said.has_errors() => Ok(program),
        Some(_) | None => Err(charts::render(&chart.name, "", &said)),
    }
}

/// The scan program of a chart, and what the stages say.
pub fn lowered(chart: &Chart, options: &Options) -> (Option<Program>, Diagnostics) {
    let mut said = Diagnostics::new();
    let mut net = grafc_net::build(chart);
    grafc_net::passes::run(&mut net, options.encoding.overlaps(), &mut said);
    let (program, more) = grafc_logic::compile(&net, options);
    said.append(more);
    (program, said)
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

/// All ways to lower a chart that must do exactly what the simulator does, with a name each.
pub fn exact(profile: Profile) -> Vec<(String, Options)> {
    ways(profile, Encoding::ALL.into_iter().filter(|encoding| !encoding.overlaps()))
}

/// All ways to lower a chart to some encodings, with a name each.
pub fn ways(profile: Profile, encodings: impl Iterator<Item = Encoding>) -> Vec<(String, Options)> {
    let mut ways = Vec::new();
    for encoding in encodings {
        for simplify in [true, false] {
            let name = format!("{}{}", encoding.name(), if simplify { "" } else { " -O0" });
            ways.push((name, Options { profile, encoding, simplify }));
        }
    }
    ways
}

/// The program in an encoding whose steps overlap, and whether the compiler warns that the overlap can be seen.
pub fn overlapping(chart: &Chart, options: &Options) -> Result<(Program, bool), String> {
    let (program, said) = lowered(chart, options);
    let program = program.ok_or_else(|| charts::render(&chart.name, "", &said))?;
    Ok((program, said.iter().any(|message| message.code == Code::W0413)))
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

/// The first row in which the situations differ; rows after a livelock are no stable situations.
pub fn first_other_situation(left: &[Response], right: &[Response]) -> Option<usize> {
    left.iter()
        .zip(right)
        .take_while(|(l, r)| !l.flags.livelock && !r.flags.livelock)
        .position(|(l, r)| l.situation != r.situation)
}

/// A fault as a value: a panic of the compiler is a finding like any other.
pub fn caught<T>(run: impl FnOnce() -> Result<T, String>) -> Result<T, String> {
    catch_unwind(AssertUnwindSafe(run)).unwrap_or_else(|payload| {
        let text = payload.downcast_ref::<String>().cloned();
        let text = text.or_else(|| payload.downcast_ref::<&str>().map(|s| (*s).to_string()));
        Err(format!("panicked: {}", text.unwrap_or_default()))
    })
}

/// The first row in which two runs differ.
pub fn first_difference(left: &[Response], right: &[Response]) -> Option<usize> {
    let rows = left.len().max(right.len());
    (0..rows).find(|&row| match (left.get(row), right.get(row)) {
        (Some(l), Some(r)) => !same(l, r),
        (_, _) => true,
    })
}

/// Equality in which a NaN equals a NaN, whatever its payload.
fn same(left: &Response, right: &Response) -> bool {
    let equal = |(l, r): (&Value, &Value)| match (l, r) {
        (Value::Real(l), Value::Real(r)) => l == r || l.is_nan() && r.is_nan(),
        (l, r) => l == r,
    };
    left.situation == right.situation
        && left.flags == right.flags
        && left.outputs.len() == right.outputs.len()
        && left.outputs.iter().zip(&right.outputs).all(equal)
}

/// The profile of a seed: mostly the standard's, at times another.
pub fn profile(seed: u64) -> Profile {
    let mut rng = fastrand::Rng::with_seed(seed ^ 0x7072_6f66);
    Profile {
        evolution: if rng.f32() < 0.25 { Evolution::Scan } else { Evolution::Stable },
        initial_actions: rng.f32() < 0.8,
        bound: if rng.f32() < 0.1 { Some(rng.u32(1..=6)) } else { None },
    }
}

/// Two runs that should be one: everything needed to see it again.
pub fn report(chart: &Chart, profile: Profile, stimuli: &[Stimulus], left: &[Response], right: &[Response]) -> String {
    let row = first_difference(left, right).unwrap_or_default();
    let up_to = |run: &[Response]| {
        let rows = (row + 1).min(run.len()).min(stimuli.len());
        charts::spell(chart, &stimuli[..rows], &run[..rows])
    };
    let last = |text: String| text.lines().last().unwrap_or_default().to_string();
    let (left, right) = (up_to(left), up_to(right));
    format!(
        "{}\nrow {row}\n  columns   {}\n  simulator {}\n  other     {}\n{}",
        charts::profile_line(profile),
        left.lines().next().unwrap_or_default(),
        last(left.clone()),
        last(right),
        shrink::NamedTrace::of(chart, &stimuli[..(row + 1).min(stimuli.len())]).to_csv(),
    )
}
