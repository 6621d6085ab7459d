//! Sources of many charts in one program.

use super::driver;
use super::tools::{Checks, Tools};
use crate::executors::jobs::{self, Job};
use grafc_backends::c;
use grafc_logic::scan::Program;
use grafc_model::reaction::Response;
use std::fs;

/// A job as a compiler takes it.
struct Unit {
    source: String,
    header: String,
    /// The function that runs it.
    driver: String,
}

/// Runs all jobs, in one batch if possible. A job's fault is what the compiler or the program said.
pub fn run(tools: &Tools, jobs: &[Job], checks: Checks) -> Vec<Result<Vec<Response>, String>> {
    let units = jobs.iter().enumerate().map(|(index, job)| unit(index, job)).collect();
    jobs::run(jobs, units, |batch, units: &[&Unit]| build_and_play(tools, checks, batch, units))
}

fn unit(index: usize, job: &Job) -> Result<Unit, String> {
    let (source, header, program) = unit_of(index, job)?;
    let driver = driver::write(index, &program, &c::names(&program), &job.stimuli);
    Ok(Unit { source, header, driver })
}

/// The source of a job and its header, and the program with the name that it has there.
pub(super) fn unit_of(index: usize, job: &Job) -> Result<(String, String, Program), String> {
    let mut program = job.program.clone();
    program.name = driver::chart(index);
    let options = c::Options { include: Some(driver::header(index)), ..c::Options::default() };
    let (source, header) = c::emit(&program, &options).map_err(|diagnostics| format!("{diagnostics:#?}"))?;
    Ok((source, header.unwrap_or_default(), program))
}

fn build_and_play(tools: &Tools, checks: Checks, batch: &[usize], units: &[&Unit]) -> Result<String, String> {
    let folder = tempfile::tempdir().map_err(|e| e.to_string())?;
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).map_err(|e| e.to_string());
    let mut sources = vec!["main.c".to_owned()];
    let mut main = String::from(driver::HEAD);
    for (index, unit) in batch.iter().zip(units) {
        let name = format!("{}.c", driver::chart(*index));
        write(&name, &unit.source)?;
        write(&driver::header(*index), &unit.header)?;
        main.push_str(&unit.driver);
        sources.push(name);
    }
    main.push_str(&driver::main(batch));
    write("main.c", &main)?;
    let said = |fault: String| match units {
        [unit] => format!("{fault}\n{}\n{}\n{main}", unit.header, unit.source),
        _ => fault,
    };
    tools.build(folder.path(), &sources, checks).map_err(said)?;
    tools.play(folder.path(), "main").map_err(said)
}
