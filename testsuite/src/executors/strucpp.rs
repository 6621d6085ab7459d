//! Generated Structured Text, compiled by STruC++ and a C++ compiler and run.

use super::rust::job;
use super::{Executor, Outcome, Task};
use crate::jobs::run_some;
use crate::strucpp::{Tools, limit, run};

/// STruC++: `strucpp` and `g++` on PATH.
pub(super) struct Strucpp {
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

    fn is_external(&self) -> bool {
        true
    }

    fn run(&self, tasks: &[Task]) -> Vec<Outcome> {
        let jobs = tasks.iter().map(|task| {
            let job = job(task).map_err(Outcome::Failed)?;
            limit(&job).map_or(Ok(job), |reason| Err(Outcome::PassedOver(reason)))
        });
        run_some(&self.tools, jobs.collect(), run)
    }
}
