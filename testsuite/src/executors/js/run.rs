//! Modules of many charts in one process of node.

use super::tools::Tools;
use crate::executors::jobs::{self, Job, flag_name, flags, outputs};
use grafc_backends::js;
use grafc_logic::scan::{Program, Role};
use grafc_model::chart::{Type, Value};
use grafc_model::reaction::{Response, Stimulus};
use serde::Deserialize;
use std::fmt::Write as _;
use std::fs;

/// Plays the traces.
const DRIVER: &str = include_str!("driver.mjs");

/// What a module tells of a micro-step.
#[derive(Deserialize, Debug)]
pub struct MicroStep {
    /// The call that it belongs to.
    pub row: usize,
    /// Transitions that were enabled.
    pub enabled: Vec<String>,
    /// Transitions that cleared.
    pub cleared: Vec<String>,
    /// The steps that are active after it.
    pub situation: Vec<String>,
    /// Whether the scan is over.
    pub stable: bool,
}

/// A job as node takes it.
struct Unit {
    module: String,
    /// What the driver has to know.
    played: String,
}

/// Runs all jobs, in one process if possible. A job's fault is what node said.
pub fn run(tools: &Tools, jobs: &[Job]) -> Vec<Result<Vec<Response>, String>> {
    let units = jobs.iter().enumerate().map(|(index, job)| unit(index, job, false)).collect();
    jobs::run(jobs, units, |batch, units: &[&Unit]| play(tools, batch, units))
}

/// What the modules tell of each micro-step. Their programs show what they do.
pub fn watch(tools: &Tools, jobs: &[Job]) -> Result<Vec<Vec<MicroStep>>, String> {
    let units: Result<Vec<Unit>, String> = jobs.iter().enumerate().map(|(index, job)| unit(index, job, true)).collect();
    let units = units?;
    let batch: Vec<usize> = (0..units.len()).collect();
    let printed = play(tools, &batch, &units.iter().collect::<Vec<_>>())?;
    let mut seen: Vec<Vec<MicroStep>> = jobs.iter().map(|_| Vec::new()).collect();
    for line in printed.lines() {
        let (index, told) = line.split_once(' ').ok_or("a line without its job")?;
        let index: usize = index.parse().map_err(|_| format!("`{line}`"))?;
        seen[index].push(serde_json::from_str(told).map_err(|fault| format!("`{line}`: {fault}"))?);
    }
    Ok(seen)
}

fn unit(index: usize, job: &Job, watched: bool) -> Result<Unit, String> {
    let (module, _) = js::emit(&job.program, &js::Options::default()).map_err(|found| format!("{found:#?}"))?;
    Ok(Unit { module, played: played(index, &job.program, &job.stimuli, watched) })
}

fn play(tools: &Tools, batch: &[usize], units: &[&Unit]) -> Result<String, String> {
    let folder = tempfile::tempdir().map_err(|e| e.to_string())?;
    let write = |name: String, text: &str| fs::write(folder.path().join(name), text).map_err(|e| e.to_string());
    let mut list = String::from("export default [\n");
    for (index, unit) in batch.iter().zip(units) {
        write(format!("job_{index}.mjs"), &unit.module)?;
        list.push_str(&unit.played);
    }
    list.push_str("];\n");
    write("jobs.mjs".into(), &list)?;
    write("driver.mjs".into(), DRIVER)?;
    let said = |fault: String| match units {
        [unit] => format!("{fault}\n{}{}", unit.module, unit.played),
        _ => fault,
    };
    tools.play(folder.path(), "driver.mjs").map_err(said)
}

/// A job as the driver takes it.
fn played(index: usize, program: &Program, stimuli: &[Stimulus], watched: bool) -> String {
    let quoted = |name: &str| serde_json::Value::from(name).to_string();
    let inputs: Vec<String> = program.of_role(Role::Input).map(|(_, v)| quoted(&v.name)).collect();
    let types: Vec<Type> = program.of_role(Role::Input).map(|(_, v)| v.ty).collect();
    let shown: Vec<String> = outputs(program).map(|(_, v)| quoted(&v.name)).collect();
    let raised: Vec<String> = flags(program).map(|(_, flag)| quoted(flag_name(flag))).collect();
    let mut out = String::new();
    let _ = writeln!(
        out,
        "{{ index: {index}, inputs: [{}], outputs: [{}], flags: [{}], watched: {watched}, rows: [",
        inputs.join(", "),
        shown.join(", "),
        raised.join(", "),
    );
    for stimulus in stimuli {
        let values: Vec<String> = stimulus.inputs.iter().zip(&types).map(|(value, ty)| literal(*value, *ty)).collect();
        let _ = writeln!(out, "[{}, {}, [{}]],", stimulus.t_ms, stimulus.restart, values.join(", "));
    }
    out.push_str("] },\n");
    out
}

fn literal(value: Value, ty: Type) -> String {
    match (value, ty) {
        (Value::Bool(b), _) => b.to_string(),
        (Value::Int(n) | Value::Time(n), _) => n.to_string(),
        (Value::Real(x), _) if x.is_nan() => "NaN".into(),
        (Value::Real(x), _) if x.is_infinite() => (if x < 0.0 { "-Infinity" } else { "Infinity" }).into(),
        (Value::Real(x), _) => format!("{x:?}"),
    }
}
