//! Generated Structured Text, compiled by IronPLC and run by its virtual machine.

use super::run::run;
use super::tools::Tools;
use crate::executors::jobs::{Job, run_some};
use crate::executors::task::{Executor, Outcome, Task};
use crate::tools::Tool;

/// IronPLC: `ironplcc` and `ironplcvm` on PATH.
pub struct Ironplc {
    tools: Result<Tools, String>,
}

impl Ironplc {
    pub fn find() -> Self {
        Ironplc { tools: Tools::find() }
    }
}

impl Executor for Ironplc {
    fn name(&self) -> &str {
        "ironplc:st"
    }

    fn about(&self) -> &str {
        "generated Structured Text through IronPLC, the encodings in turn"
    }

    fn limits(&self) -> &str {
        "as a program, with timers that have the test's clock"
    }

    fn missing(&self) -> Option<&str> {
        self.tools.as_ref().err().map(String::as_str)
    }

    fn tool(&self) -> Option<Tool> {
        Some(Tool::Ironplc)
    }

    fn run(&self, tasks: &[Task]) -> Vec<Outcome> {
        let jobs = tasks.iter().map(|task| Job::of(task).map_err(Outcome::Failed));
        run_some(&self.tools, jobs.collect(), run)
    }
}
