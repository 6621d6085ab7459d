//! Statement lists through awlsim: what `play.py` is given of a job.

use super::tools::Tools;
use crate::executors::jobs::{self, Job, flags, outputs};
use crate::runs::caught;
use ecow::EcoString;
use grafc_backends::awl;
use grafc_diagnostics::Code;
use grafc_formula::{Comparison, Formula, FormulaId};
use grafc_logic::scan::evaluate::Evaluator;
use grafc_logic::scan::{Program, Role};
use grafc_model::chart::{Type, Value};
use grafc_model::reaction::{Response, Stimulus};
use serde_json::{Value as Json, json};

/// Runs all jobs, in one batch if possible. A job's fault is what the compiler or awlsim said.
pub fn run(tools: &Tools, jobs: &[Job]) -> Vec<Result<Vec<Response>, String>> {
    let units = jobs.iter().enumerate().map(|(index, job)| caught(|| unit(index, job))).collect();
    jobs::run(jobs, units, |_, units: &[&Json]| tools.play(units))
}

/// Runs a source that has an `OB 1`: bytes of inputs a cycle, and what so many bytes of outputs are after each.
///
/// # Errors
/// What awlsim says.
pub fn play_cycles(tools: &Tools, source: &str, inputs: &[Vec<u8>], bytes: usize) -> Result<Vec<Vec<u8>>, String> {
    let printed = tools.play(&[&json!({"index": 0, "text": source, "image": inputs, "bytes": bytes})])?;
    let row = |line: &str| line.split(' ').skip(2).map(|word| word.parse().map_err(|_| line.to_string())).collect();
    printed.lines().map(row).collect()
}

/// Whether awlsim takes each of some sources without an `OB 1`, and runs it once.
///
/// # Errors
/// What it says.
pub fn accepts(tools: &Tools, sources: &[String]) -> Result<(), String> {
    let unit = |text: &String| json!({"index": 0, "text": text, "inputs": [], "rows": [[]], "reads": []});
    let units: Vec<Json> = sources.iter().map(unit).collect();
    if tools.play(&units.iter().collect::<Vec<_>>()).is_err() {
        // Which it was.
        units.iter().try_for_each(|unit| tools.play(&[unit]).map(|_| ()))?;
    }
    Ok(())
}

/// A job as `play.py` takes it.
fn unit(index: usize, job: &Job) -> Result<Json, String> {
    let program = &job.program;
    // Now and then in German.
    let mnemonics = if index % 3 == 2 { awl::Mnemonics::German } else { awl::Mnemonics::English };
    let text = awl::emit(program, &awl::Options { mnemonics, ..awl::Options::default() })
        .map_err(|diagnostics| format!("{diagnostics:#?}"))?;
    let names = awl::names(program);
    let clock = awl::clock_input(program);
    let mut inputs: Vec<Json> = clock.iter().map(|name| json!([name, "TIME"])).collect();
    let given = program.variables.iter_enumerated().filter(|(_, v)| v.role == Role::Input);
    inputs.extend(given.map(|(id, v)| json!([names[id], type_name(v.ty)])));
    inputs.push(json!([awl::restart_input(program), "BOOL"]));
    let row = |stimulus: &Stimulus| -> Vec<Json> {
        let now = clock.iter().map(|_| json!(now(index, stimulus.t_ms)));
        let given = now.chain(stimulus.inputs.iter().map(|value| number(*value)));
        given.chain([json!(u8::from(stimulus.restart))]).collect()
    };
    let rows: Vec<Vec<Json>> = job.stimuli.iter().map(row).collect();
    let mut reads: Vec<Json> = outputs(program).map(|(id, v)| json!([names[id], type_name(v.ty), null])).collect();
    for step in &program.steps {
        reads.push(step_read(program, &names, step.active)?);
    }
    reads.extend(flags(program).map(|(id, _)| json!([names[id], "BOOL", null])));
    Ok(json!({"index": index, "text": text, "inputs": inputs, "rows": rows, "reads": reads}))
}

/// A clock that soon wraps around: after 31 bits, as that of SFC 64, or after 32.
fn now(index: usize, t_ms: i64) -> i64 {
    let range = 1i64 << (31 + index % 2);
    (t_ms + range - 5000).rem_euclid(range)
}

/// Whether a step is active: a variable of its own, or the value of the one that holds several.
fn step_read(
    program: &Program,
    names: &index_vec::IndexVec<grafc_logic::scan::VarId, EcoString>,
    id: FormulaId,
) -> Result<Json, String> {
    let pool = &program.pool;
    match pool.get(id) {
        Formula::Variable(v) => Ok(json!([names[*v], "BOOL", null])),
        Formula::Compare(Comparison::Equal, [a, b]) => match (pool.get(*a), pool.get(*b)) {
            (Formula::Variable(v), Formula::Constant(Value::Int(n))) => {
                Ok(json!([names[*v], type_name(program.variables[*v].ty), n]))
            }
            (a, b) => Err(format!("a step is active where {a:?} = {b:?}, which nothing here can read")),
        },
        other => Err(format!("a step is active where {other:?} is true, which nothing here can read")),
    }
}

fn type_name(ty: Type) -> &'static str {
    match ty {
        Type::Bool => "BOOL",
        Type::Int => "INT",
        Type::Dint => "DINT",
        Type::Uint => "WORD",
        Type::Udint => "DWORD",
        Type::Real | Type::Lreal => "REAL",
        Type::Time => "TIME",
    }
}

fn number(value: Value) -> Json {
    match value {
        Value::Bool(b) => json!(u8::from(b)),
        Value::Int(n) | Value::Time(n) => json!(n),
        Value::Real(x) => json!(x),
    }
}

/// Why a comparison with awlsim would not test grafc, if it would not.
///
/// S7-300 and S7-400 have no double precision, times of 32 bits, and no small reals that are not normal; awlsim takes
/// the difference of two infinite reals to compare them, which is no number.
pub fn beyond(job: &Job) -> Option<&'static str> {
    let program = &job.program;
    if let Err(diagnostics) = awl::instructions(program)
        && diagnostics.iter().any(|one| matches!(one.code, Code::E0504 | Code::E0505))
    {
        return Some("S7-300 and S7-400 have no `lreal` and no times beyond 24 days (E0504, E0505)");
    }
    let is_beyond = |value: Value| match value {
        Value::Time(ms) => i32::try_from(ms).is_err(),
        Value::Real(x) => !(x == 0.0 || (x as f32).is_normal()),
        Value::Bool(_) | Value::Int(_) => false,
    };
    let watched: Vec<_> = program
        .variables
        .iter_enumerated()
        .filter(|(_, v)| matches!(v.ty, Type::Time | Type::Real))
        .map(|(id, _)| id)
        .collect();
    let mut evaluator = Evaluator::new(program);
    let mut found = false;
    for stimulus in &job.stimuli {
        let mut look = |e: &mut Evaluator| found |= watched.iter().any(|id| is_beyond(e.value_of(*id)));
        evaluator.react_observed(stimulus, &mut look);
        look(&mut evaluator);
    }
    found.then_some("a time leaves 32 bits, or a real is infinite, no number or next to nothing")
}
