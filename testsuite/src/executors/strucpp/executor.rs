//! Generated Structured Text, compiled by STruC++ and a C++ compiler and run.

use super::run::{limit, run};
use super::tools::Tools;
use crate::executors::jobs::{Job, run_some};
use crate::executors::task::{Executor, Outcome, Task};
use crate::tools::Tool;

/// STruC++: `strucpp` and `g++` on PATH.
pub struct Strucpp {
    tools: Result<Tools, String>,
}

impl Strucpp {
    pub fn find() -> Self {
        Strucpp { tools: Tools::find() }
    }
}

impl Executor for Strucpp {
    fn name(&self) -> &str {
        "strucpp:st"
    }

    fn about(&self) -> &str {
        "generated Structured Text through STruC++, the encodings in turn"
    }

    fn limits(&self) -> &str {
        "no negative times, which STruC++ does not know"
    }

    fn missing(&self) -> Option<&str> {
        self.tools.as_ref().err().map(String::as_str)
    }

    fn tool(&self) -> Option<Tool> {
        Some(Tool::Strucpp)
    }

    fn run(&self, tasks: &[Task]) -> Vec<Outcome> {
        let jobs = tasks.iter().map(|task| {
            let job = Job::of(task).map_err(Outcome::Failed)?;
            limit(&job).map_or(Ok(job), |reason| Err(Outcome::PassedOver(reason)))
        });
        run_some(&self.tools, jobs.collect(), run)
    }
}
