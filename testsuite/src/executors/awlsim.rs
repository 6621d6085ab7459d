//! Generated STL, run by awlsim.

use super::rust::job;
use super::{Executor, Outcome, Task};
use crate::awlsim::{Tools, beyond, run};
use crate::differential::caught;
use crate::jobs::run_some;

/// STL in awlsim: a Python that has it, `python3` or what `AWLSIM_PYTHON` names.
pub(super) struct Awlsim {
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

    fn is_external(&self) -> bool {
        true
    }

    fn run(&self, tasks: &[Task]) -> Vec<Outcome> {
        let jobs = tasks.iter().map(|task| {
            let job = job(task).map_err(Outcome::Failed)?;
            match caught(|| Ok(beyond(&job))).map_err(Outcome::Failed)? {
                Some(why) => Err(Outcome::PassedOver(why)),
                None => Ok(job),
            }
        });
        run_some(&self.tools, jobs.collect(), run)
    }
}
