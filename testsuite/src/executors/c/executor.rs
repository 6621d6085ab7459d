//! Generated C, compiled and run.

use super::run::run;
use super::tools::{Checks, Tools};
use crate::executors::jobs::{Job, run_some};
use crate::executors::task::{Executor, Outcome, Task};
use crate::tools::Tool;

/// Generated C; the compiler is the one that `CC` names, else `gcc` on PATH.
pub struct C {
    tools: Result<Tools, String>,
}

impl C {
    pub fn find() -> Self {
        C { tools: Tools::find() }
    }
}

impl Executor for C {
    fn name(&self) -> &str {
        "c"
    }

    fn about(&self) -> &str {
        "generated C through a C compiler, the encodings in turn, one in four with checks of memory"
    }

    fn missing(&self) -> Option<&str> {
        self.tools.as_ref().err().map(String::as_str)
    }

    fn tool(&self) -> Option<Tool> {
        Some(Tool::Cc)
    }

    /// In one of four turns what is undefined is looked for, and memory is guarded.
    fn run(&self, tasks: &[Task]) -> Vec<Outcome> {
        let checks = if tasks.first().is_none_or(|task| task.turn % 4 == 0) { Checks::Memory } else { Checks::Nothing };
        let jobs = tasks.iter().map(|task| Job::saved(task).map_err(Outcome::Failed)).collect();
        run_some(&self.tools, jobs, |tools, jobs| run(tools, jobs, checks))
    }
}
