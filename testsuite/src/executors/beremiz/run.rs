//! Programs and charts as projects, which Beremiz turns into function blocks for MATIEC.

use super::tools::Tools;
use crate::executors::function_block::{FunctionBlock, named};
use crate::executors::jobs::{self, Job};
use crate::executors::matiec::{RUNTIME, Unit, build_and_play};
use crate::executors::sequences;
use ecow::{EcoString, eco_format};
use grafc_backends::{il, plcopen, st};
use grafc_logic::scan::{Program, VarId};
use grafc_logic::sequence::Sequence;
use grafc_model::reaction::Response;
use index_vec::IndexVec;

/// What a function block holds, and from what it is made.
pub enum Source<'s> {
    /// The programs of the jobs, as Structured Text, instruction lists or ladders.
    Programs(plcopen::Body),
    /// Charts, whose programs the jobs have from `sequences::variables_of`.
    Sequences(&'s [Sequence]),
}

/// Runs all jobs. A job's fault is what a tool said.
pub fn run(tools: &Tools, source: &Source, jobs: &[Job]) -> Vec<Result<Vec<Response>, String>> {
    let written: Vec<Result<String, String>> =
        jobs.iter().enumerate().map(|(index, job)| write(source, index, job)).collect();
    let projects: Vec<String> = written.iter().filter_map(|project| project.clone().ok()).collect();
    let mut texts = match tools.generate(&projects) {
        Ok(texts) => texts.into_iter(),
        Err(said) => return jobs.iter().map(|_| Err(said.clone())).collect(),
    };
    let units = written.into_iter().enumerate().map(|(index, project)| {
        project?;
        let text = texts.next().unwrap_or_else(|| Err("nothing generated".to_string()))?;
        unit(source, index, &jobs[index], &text)
    });
    jobs::run(jobs, units.collect(), |batch, units: &[&Unit]| build_and_play(&tools.matiec, batch, units))
}

/// A job as a project.
fn write(source: &Source, index: usize, job: &Job) -> Result<String, String> {
    let program = named(index, &job.program);
    let options = plcopen::Options::default();
    let project = match source {
        Source::Programs(plcopen::Body::St) => plcopen::emit(&program, &options),
        Source::Programs(plcopen::Body::Il) => plcopen::emit_il(&program, &options),
        Source::Programs(plcopen::Body::Ld) => plcopen::ld::emit(&program, &options),
        Source::Programs(plcopen::Body::Sfc) => return Err("a program is no chart".to_string()),
        Source::Sequences(sequences) => {
            let sequence = Sequence { program: named(index, &sequences[index].program), ..sequences[index].clone() };
            plcopen::sfc::emit(&sequence, &options)
        }
    };
    project.map_err(|diagnostics| format!("{diagnostics:#?}"))
}

/// What is compiled of a project: its function blocks.
fn unit(source: &Source, index: usize, job: &Job, text: &str) -> Result<Unit, String> {
    let blocks = text.find("\nPROGRAM ").map_or(text, |at| &text[..=at]).to_string();
    let last = blocks.lines().filter_map(|line| line.trim().strip_prefix("FUNCTION_BLOCK ")).next_back();
    let block = last.ok_or_else(|| format!("no function block in\n{text}"))?;
    let program = named(index, &job.program);
    let names = match source {
        Source::Programs(plcopen::Body::Il) => il::names(&program),
        Source::Programs(plcopen::Body::Ld) => ladder_names(&program),
        Source::Programs(plcopen::Body::St | plcopen::Body::Sfc) => st::names(&program),
        Source::Sequences(sequences) => sequences::names(&sequences[index], &program, &blocks)?,
    };
    let holder = match source {
        Source::Programs(plcopen::Body::Ld) => plcopen::ld::instance(&program),
        Source::Programs(plcopen::Body::St | plcopen::Body::Il | plcopen::Body::Sfc) => None,
        Source::Sequences(sequences) => {
            plcopen::sfc::instance(&Sequence { program: program.clone(), ..sequences[index].clone() })
        }
    };
    let block = FunctionBlock {
        program,
        names,
        name: block.to_string(),
        text: blocks.clone(),
        holder: holder.map(String::from),
    };
    let driver = RUNTIME.driver(index, &block, &job.stimuli)?;
    Ok(Unit { text: blocks, driver })
}

/// Where the rungs are a block of their own, it holds the situation.
fn ladder_names(program: &Program) -> IndexVec<VarId, EcoString> {
    let mut names = st::names(program);
    if let Some(instance) = plcopen::ld::instance(program) {
        for (id, variable) in program.variables.iter_enumerated() {
            use grafc_logic::scan::Role;
            match variable.role {
                Role::Step | Role::State => names[id] = eco_format!("{instance}.{}", names[id]),
                Role::Input
                | Role::Output
                | Role::Internal
                | Role::Constant
                | Role::Flag(_)
                | Role::Memory
                | Role::Temporary
                | Role::Observed => {}
            }
        }
    }
    names
}
