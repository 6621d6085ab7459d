//! Generated Rust, compiled by rustc and run.

use super::{Executor, Outcome, Task};
use crate::differential::{caught, compile, exact};
use crate::jobs::{Job, run_some};
use crate::rust::{Tools, run};

/// Generated Rust; rustc is the one on PATH, or what `RUSTC` names.
pub(super) struct Rust {
    tools: Result<Tools, String>,
}

impl Rust {
    pub fn find() -> Self {
        Rust { tools: Tools::find() }
    }
}

impl Executor for Rust {
    fn name(&self) -> &str {
        "rust"
    }

    fn about(&self) -> &str {
        "generated Rust through rustc, the encodings in turn"
    }

    fn missing(&self) -> Option<&str> {
        self.tools.as_ref().err().map(String::as_str)
    }

    fn is_external(&self) -> bool {
        true
    }

    fn run(&self, tasks: &[Task]) -> Vec<Outcome> {
        let jobs = tasks.iter().map(|task| job(task).map_err(Outcome::Failed)).collect();
        run_some(&self.tools, jobs, run)
    }
}

/// A task as a program, in the encoding whose turn it is.
pub(super) fn job(task: &Task) -> Result<Job, String> {
    let ways = exact(task.profile);
    let program = caught(|| compile(task.chart, &ways[task.turn % ways.len()].1))?;
    Ok(Job { program, stimuli: task.stimuli.to_vec() })
}
