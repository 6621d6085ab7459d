//! Function blocks and their traces through IronPLC, one at a time.

use super::play::Play;
use super::tools::Tools;
use crate::executors::function_block::FunctionBlock;
use crate::executors::jobs::{self, Job};
use grafc_model::reaction::Response;
use std::fs;

/// Runs all jobs. A job's fault is what a tool said.
pub fn run(tools: &Tools, jobs: &[Job]) -> Vec<Result<Vec<Response>, String>> {
    jobs.iter().enumerate().map(|(index, job)| run_one(tools, index, job)).collect()
}

fn run_one(tools: &Tools, index: usize, job: &Job) -> Result<Vec<Response>, String> {
    let block = FunctionBlock::structured_text(index, job)?;
    accepts(tools, &block.text)?;
    let play = Play::new(&block, &job.stimuli)?;
    let folder = tempfile::tempdir().map_err(|e| e.to_string())?;
    let (text, code) = (folder.path().join("play.st"), folder.path().join("play.iplc"));
    fs::write(&text, &play.text).map_err(|e| e.to_string())?;
    let said = |fault: String| format!("{fault}\n{}", play.text);
    tools.compile(&text, &code).map_err(said)?;
    let mut printed = String::new();
    for scans in play.runs() {
        let shown = tools.run(&code, scans).map_err(said)?;
        printed.push_str(&play.read(index, scans, &shown).map_err(said)?);
    }
    jobs::read(job, index, &printed)
}

/// Whether IronPLC takes a text.
pub fn accepts(tools: &Tools, text: &str) -> Result<(), String> {
    let folder = tempfile::tempdir().map_err(|e| e.to_string())?;
    let file = folder.path().join("chart.st");
    fs::write(&file, text).map_err(|e| e.to_string())?;
    tools.check(&file).map_err(|said| format!("{said}\n{text}"))
}
