//! Generated Rust, compiled by rustc and run.

use super::run::run;
use super::tools::Tools;
use crate::executors::jobs::{Job, run_some};
use crate::executors::task::{Executor, Outcome, Task};
use crate::tools::Tool;

/// Generated Rust; rustc is the one on PATH, or what `RUSTC` names.
pub struct Rust {
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

    fn tool(&self) -> Option<Tool> {
        Some(Tool::Rustc)
    }

    fn run(&self, tasks: &[Task]) -> Vec<Outcome> {
        let jobs = tasks.iter().map(|task| Job::saved(task).map_err(Outcome::Failed)).collect();
        run_some(&self.tools, jobs, run)
    }
}
