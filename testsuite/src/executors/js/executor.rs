//! Generated JavaScript, run by node.

use super::run::run;
use super::tools::Tools;
use crate::executors::jobs::{Job, run_some};
use crate::executors::task::{Executor, Outcome, Task};
use crate::tools::Tool;

/// Generated JavaScript; node is the one on PATH, or what `NODE` names.
pub struct JavaScript {
    tools: Result<Tools, String>,
}

impl JavaScript {
    pub fn find() -> Self {
        JavaScript { tools: Tools::find() }
    }
}

impl Executor for JavaScript {
    fn name(&self) -> &str {
        "js"
    }

    fn about(&self) -> &str {
        "generated JavaScript under node, the encodings in turn"
    }

    fn missing(&self) -> Option<&str> {
        self.tools.as_ref().err().map(String::as_str)
    }

    fn tool(&self) -> Option<Tool> {
        Some(Tool::Node)
    }

    fn run(&self, tasks: &[Task]) -> Vec<Outcome> {
        let jobs = tasks.iter().map(|task| Job::observed(task).map_err(Outcome::Failed)).collect();
        run_some(&self.tools, jobs, run)
    }
}
