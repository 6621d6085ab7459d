//! Generated STL, run by awlsim.

use super::run::{beyond, run};
use super::tools::Tools;
use crate::executors::jobs::{Job, run_some};
use crate::executors::task::{Executor, Outcome, Task};
use crate::runs::caught;
use crate::tools::Tool;

/// STL in awlsim: a Python that has it, `python3` or what `AWLSIM_PYTHON` names.
pub struct Awlsim {
    tools: Result<Tools, String>,
}

impl Awlsim {
    pub fn find() -> Self {
        Awlsim { tools: Tools::find() }
    }
}

impl Executor for Awlsim {
    fn name(&self) -> &str {
        "awlsim"
    }

    fn about(&self) -> &str {
        "generated STL (AWL) in awlsim, the encodings in turn"
    }

    fn limits(&self) -> &str {
        "no lreal, no times beyond 24 days, no reals that are infinite, no number or not normal"
    }

    fn missing(&self) -> Option<&str> {
        self.tools.as_ref().err().map(String::as_str)
    }

    fn tool(&self) -> Option<Tool> {
        Some(Tool::Awlsim)
    }

    fn run(&self, tasks: &[Task]) -> Vec<Outcome> {
        let jobs = tasks.iter().map(|task| {
            let job = Job::of(task).map_err(Outcome::Failed)?;
            match caught(|| Ok(beyond(&job))).map_err(Outcome::Failed)? {
                Some(why) => Err(Outcome::PassedOver(why)),
                None => Ok(job),
            }
        });
        run_some(&self.tools, jobs.collect(), run)
    }
}
