//! Function blocks through STruC++ and a C++ compiler.

use super::tools::Tools;
use crate::executors::c_driver::Runtime;
use crate::executors::function_block::FunctionBlock;
use crate::executors::jobs::{self, Job};
use grafc_model::reaction::Response;
use std::fs;

/// How the C++ code that STruC++ writes is used.
const RUNTIME: Runtime = Runtime {
    head: "\
#include <cstdio>
#include <new>
#include \"charts.cpp\"
static long long ms(long long t) { return t * 1000000; }
static long long in_ms(long long t) { return t / 1000000; }
",
    instance: |block, _| format!("static strucpp::{block} d;"),
    restart: |block, kept| {
        let named = kept.iter().enumerate();
        let saved: String = named.clone().map(|(n, name)| format!("auto kept_{n} = d.{name}.get(); ")).collect();
        let set = |(n, name): (usize, &String)| format!(" d.{name}.set(kept_{n});");
        format!(
            "{saved}typedef strucpp::{block} block; d.~block(); new (&d) block();{}",
            named.map(set).collect::<String>()
        )
    },
    clock: "strucpp::__CURRENT_TIME_NS = ms(t);",
    call: |_| "d();".to_string(),
    get: |name| format!("d.{name}.get()"),
    set: |name, value| format!("d.{name}.set({value});"),
};

/// A job as the tools take it.
struct Unit {
    /// The text of its function block.
    text: String,
    /// The C++ code that runs it.
    driver: String,
}

/// Runs all jobs, in one batch if possible. A job's fault is what a tool said.
pub fn run(tools: &Tools, jobs: &[Job]) -> Vec<Result<Vec<Response>, String>> {
    let units = jobs.iter().enumerate().map(|(index, job)| unit(index, job)).collect();
    jobs::run(jobs, units, |batch, units: &[&Unit]| build_and_play(tools, batch, units))
}

fn unit(index: usize, job: &Job) -> Result<Unit, String> {
    let block = FunctionBlock::structured_text(index, job)?;
    let driver = RUNTIME.driver(index, &block, &job.stimuli)?;
    Ok(Unit { text: block.text, driver })
}

fn build_and_play(tools: &Tools, batch: &[usize], units: &[&Unit]) -> Result<String, String> {
    let folder = tempfile::tempdir().map_err(|e| e.to_string())?;
    let source: String = units.iter().map(|u| u.text.as_str()).collect::<Vec<_>>().join("\n");
    let said = |fault: String| format!("{fault}\n{source}");
    fs::write(folder.path().join("charts.st"), &source).map_err(|e| e.to_string())?;
    tools.strucpp(folder.path()).map_err(said)?;
    let main = RUNTIME.main(batch, units.iter().map(|unit| unit.driver.as_str()));
    fs::write(folder.path().join("main.cpp"), &main).map_err(|e| e.to_string())?;
    tools.cpp(folder.path()).map_err(said)?;
    tools.play(folder.path()).map_err(said)
}

/// Why STruC++ does not do a job as it should, if it is known not to.
pub fn limit(job: &Job) -> Option<&'static str> {
    let text = FunctionBlock::structured_text(0, job).map(|block| block.text).unwrap_or_default();
    text.contains("T#-").then_some("STruC++ knows no negative times")
}

/// Whether STruC++ takes a text.
pub fn accepts(tools: &Tools, text: &str) -> Result<(), String> {
    let folder = tempfile::tempdir().map_err(|e| e.to_string())?;
    fs::write(folder.path().join("charts.st"), text).map_err(|e| e.to_string())?;
    tools.strucpp(folder.path())
}
