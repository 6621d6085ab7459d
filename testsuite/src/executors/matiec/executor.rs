//! Generated Structured Text and instruction lists, compiled by MATIEC and a C compiler and run.

use super::run::{Language, miscalculates, run};
use super::tools::Tools;
use crate::executors::jobs::{Job, run_some};
use crate::executors::task::{Executor, Outcome, Task};
use crate::tools::Tool;

/// Code in one of its languages under MATIEC: `iec2c` and `gcc` on PATH.
struct Matiec {
    language: Language,
    tools: Result<Tools, String>,
}

/// One executor a language.
pub fn executors() -> Vec<Box<dyn Executor>> {
    let of = |language| Box::new(Matiec { language, tools: Tools::find() }) as Box<dyn Executor>;
    Language::ALL.into_iter().map(of).collect()
}

impl Executor for Matiec {
    fn name(&self) -> &str {
        match self.language {
            Language::St => "matiec:st",
            Language::Il => "matiec:il",
        }
    }

    fn about(&self) -> &str {
        match self.language {
            Language::St => "generated Structured Text through MATIEC, the encodings in turn",
            Language::Il => "generated instruction lists through MATIEC, the encodings in turn",
        }
    }

    fn limits(&self) -> &str {
        "no products or quotients of times, which MATIEC computes wrongly"
    }

    fn missing(&self) -> Option<&str> {
        self.tools.as_ref().err().map(String::as_str)
    }

    fn tool(&self) -> Option<Tool> {
        Some(Tool::Matiec)
    }

    fn run(&self, tasks: &[Task]) -> Vec<Outcome> {
        let jobs = tasks.iter().map(|task| {
            if miscalculates(task.chart) {
                return Err(Outcome::PassedOver("MATIEC computes products of times wrongly"));
            }
            Job::of(task).map_err(Outcome::Failed)
        });
        run_some(&self.tools, jobs.collect(), |tools, jobs| run(tools, self.language, jobs))
    }
}
