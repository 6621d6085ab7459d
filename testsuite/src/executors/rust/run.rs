//! Modules of many charts in one program of rustc.

use super::driver;
use super::tools::Tools;
use crate::executors::jobs::{self, Job};
use grafc_backends::rust::{self, Runtime};
use grafc_model::reaction::Response;
use std::fs;

/// Of so many charts one brings along what it needs at run time. An odd number, since every other chart is parted.
const INLINE: usize = 5;

/// A job as rustc takes it.
struct Unit {
    /// The module of its chart.
    module: String,
    /// The function that runs it.
    driver: String,
}

/// Runs all jobs, in one batch if possible. A job's fault is what rustc or the program said.
pub fn run(tools: &Tools, jobs: &[Job]) -> Vec<Result<Vec<Response>, String>> {
    let units = jobs.iter().enumerate().map(|(index, job)| unit(index, job)).collect();
    jobs::run(jobs, units, |batch, units: &[&Unit]| build_and_play(tools, batch, units))
}

fn unit(index: usize, job: &Job) -> Result<Unit, String> {
    // Most have what they need at run time from the crate, and some from a module of their own, as a chart by itself has.
    let runtime = if index % INLINE == 0 { Runtime::Inline } else { Runtime::Crate };
    let mut options = rust::Options { runtime, module: Some(driver::module(index)), ..rust::Options::default() };
    // Every other chart is parted as large ones are.
    if index % 2 == 1 {
        options.longest_function = 1 + index % 7;
    }
    let module = rust::emit(&job.program, &options).map_err(|diagnostics| format!("{diagnostics:#?}"))?;
    let names = rust::names(&job.program);
    Ok(Unit { module, driver: driver::write(index, &job.program, &names, &job.stimuli) })
}

fn build_and_play(tools: &Tools, batch: &[usize], units: &[&Unit]) -> Result<String, String> {
    let folder = tempfile::tempdir().map_err(|e| e.to_string())?;
    let mut source = String::from(driver::HEAD);
    for unit in units {
        source.push_str(&unit.module);
        source.push_str(&unit.driver);
    }
    source.push_str(&driver::main(batch));
    fs::write(folder.path().join("main.rs"), &source).map_err(|e| e.to_string())?;
    let said = |fault: String| if units.len() == 1 { format!("{fault}\n{source}") } else { fault };
    tools.runtime(folder.path())?;
    tools.rustc(folder.path()).map_err(said)?;
    tools.play(folder.path()).map_err(said)
}
