//! Programs that tools outside compile and run, many at a time.
//!
//! What such a run prints is a line a call, `job row value…`: outputs, whether each step is active, and flags, each in the
//! order of the program. Reals come with as many digits as their type needs to be read back exactly.

use super::task::{Outcome, Task};
use crate::runs::{caught, compile, compile_observed, compile_saved};
use crate::ways::exact;
use grafc_logic::Options;
use grafc_logic::scan::{Flag, Observed, Program, Role, VarId, Variable};
use grafc_model::chart::{Chart, Type, Value};
use grafc_model::reaction::{Flags, Response, Stimulus};

/// A program and what it is given.
#[derive(Clone)]
pub struct Job {
    /// The scan program; its name is replaced by one that is unique among the jobs.
    pub program: Program,
    /// The calls.
    pub stimuli: Vec<Stimulus>,
}

impl Job {
    /// A task as a job, in the encoding whose turn it is; an error is what the compiler said.
    pub(crate) fn of(task: &Task) -> Result<Job, String> {
        Self::by(task, compile)
    }

    /// The same for a target that saves the memory of its charts.
    pub(crate) fn saved(task: &Task) -> Result<Job, String> {
        Self::by(task, compile_saved)
    }

    /// The same for a target that shows micro-steps: sometimes all that can be shown.
    pub(crate) fn observed(task: &Task) -> Result<Job, String> {
        let turn = task.turn / exact(task.profile).len();
        let observed = if turn % 2 == 0 { Observed::Transitions } else { Observed::All };
        Self::by(task, |chart, options| compile_observed(chart, options, observed))
    }

    fn by(task: &Task, compile: impl FnOnce(&Chart, &Options) -> Result<Program, String>) -> Result<Job, String> {
        let ways = exact(task.profile);
        let program = caught(|| compile(task.chart, &ways[task.turn % ways.len()].1))?;
        Ok(Job { program, stimuli: task.stimuli.to_vec() })
    }
}

/// Runs all jobs, in one batch if possible: `play` is given the numbers of jobs and what has been made of each, and
/// returns what their run prints. Where a batch of several is refused, its halves are tried, so that a fault is reported
/// with its job.
pub(crate) fn run<U>(
    jobs: &[Job],
    units: Vec<Result<U, String>>,
    play: impl Fn(&[usize], &[&U]) -> Result<String, String>,
) -> Vec<Result<Vec<Response>, String>> {
    let good: Vec<usize> = (0..jobs.len()).filter(|&i| units[i].is_ok()).collect();
    let mut results: Vec<Result<Vec<Response>, String>> = units
        .iter()
        .map(|unit| match unit {
            Ok(_) => Err("was not run".to_string()),
            Err(fault) => Err(fault.clone()),
        })
        .collect();
    let mut open = vec![good];
    while let Some(batch) = open.pop() {
        let chosen: Vec<&U> = batch.iter().filter_map(|&i| units[i].as_ref().ok()).collect();
        if chosen.is_empty() {
            continue;
        }
        match play(&batch, &chosen) {
            Ok(printed) => {
                for &index in &batch {
                    results[index] = read(&jobs[index], index, &printed);
                }
            }
            Err(fault) if batch.len() == 1 => results[batch[0]] = Err(fault),
            Err(_) => {
                let (left, right) = batch.split_at(batch.len() / 2);
                open.push(left.to_vec());
                open.push(right.to_vec());
            }
        }
    }
    results
}

/// Runs those that are jobs with tools, or says of each what is missing; the others have their outcome already.
pub(crate) fn run_some<T>(
    tools: &Result<T, String>,
    jobs: Vec<Result<Job, Outcome>>,
    run: impl FnOnce(&T, &[Job]) -> Vec<Result<Vec<Response>, String>>,
) -> Vec<Outcome> {
    let mut ready = Vec::new();
    let places: Vec<Option<Outcome>> = jobs.into_iter().map(|job| job.map(|job| ready.push(job)).err()).collect();
    // A panic of a backend is a finding of all jobs of the run: which it was, a run of each alone shows.
    let results = caught(|| Ok(run(tools.as_ref().map_err(String::clone)?, &ready)));
    let results = results.unwrap_or_else(|fault| ready.iter().map(|_| Err(fault.clone())).collect());
    let mut results = results.into_iter();
    let mut next = || results.next().unwrap_or_else(|| Err("was not run".to_string())).into();
    places.into_iter().map(|outcome| outcome.unwrap_or_else(&mut next)).collect()
}

/// The outputs of a program.
pub(crate) fn outputs(program: &Program) -> impl Iterator<Item = (VarId, &Variable)> {
    program.variables.iter_enumerated().filter(|(_, variable)| variable.role == Role::Output)
}

/// The flags of a program.
pub(crate) fn flags(program: &Program) -> impl Iterator<Item = (VarId, Flag)> {
    program.variables.iter_enumerated().filter_map(|(id, variable)| match variable.role {
        Role::Flag(flag) => Some((id, flag)),
        Role::Input
        | Role::Output
        | Role::Internal
        | Role::Constant
        | Role::Step
        | Role::State
        | Role::Memory
        | Role::Temporary
        | Role::Observed => None,
    })
}

/// What fields and properties of generated code call a flag.
pub(crate) fn flag_name(flag: Flag) -> &'static str {
    match flag {
        Flag::Livelock => "livelock",
        Flag::AllocConflict => "alloc_conflict",
        Flag::ForceConflict => "force_conflict",
        Flag::Div0 => "div0",
    }
}

/// The responses of one job, from all that was printed.
pub(crate) fn read(job: &Job, index: usize, printed: &str) -> Result<Vec<Response>, String> {
    let head = format!("{index} ");
    let mut responses = Vec::new();
    for line in printed.lines().filter(|line| line.starts_with(&head)) {
        let mut words = line.split(' ').skip(2);
        let mut response = Response { outputs: Vec::new(), situation: Vec::new(), flags: Flags::default() };
        let mut next = |ty: Type| {
            let word = words.next().ok_or_else(|| format!("`{line}` is too short"))?;
            value(ty, word).ok_or_else(|| format!("`{word}` is no {ty:?}"))
        };
        for (_, variable) in outputs(&job.program) {
            response.outputs.push(next(variable.ty)?);
        }
        for step in job.program.steps.indices() {
            if next(Type::Bool)? == Value::Bool(true) {
                response.situation.push(step);
            }
        }
        for (_, flag) in flags(&job.program) {
            let raised = next(Type::Bool)? == Value::Bool(true);
            match flag {
                Flag::Livelock => response.flags.livelock = raised,
                Flag::AllocConflict => response.flags.alloc_conflict = raised,
                Flag::ForceConflict => response.flags.force_conflict = raised,
                Flag::Div0 => response.flags.div0 = raised,
            }
        }
        responses.push(response);
    }
    Ok(responses)
}

fn value(ty: Type, word: &str) -> Option<Value> {
    Some(match ty {
        Type::Bool => Value::Bool(word == "1"),
        Type::Int | Type::Dint | Type::Uint | Type::Udint => Value::Int(word.parse().ok()?),
        // Nine digits give a single back exactly when they are read as one.
        Type::Real => Value::Real(f64::from(word.parse::<f32>().ok()?)),
        Type::Lreal => Value::Real(word.parse().ok()?),
        Type::Time => Value::Time(word.parse().ok()?),
    })
}
