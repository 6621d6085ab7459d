//! PLCopen projects through Beremiz's generator and MATIEC.

use super::run::{Source, run};
use super::tools::Tools;
use crate::executors::jobs::{Job, run_some};
use crate::executors::matiec::miscalculates;
use crate::executors::sequences;
use crate::executors::task::{Executor, Outcome, Task};
use crate::tools::Tool;
use grafc_backends::plcopen::Body;
use grafc_logic::sequence::Sequence;

/// One kind of body.
struct Plcopen {
    body: Body,
    tools: Result<Tools, String>,
}

/// One executor a kind of body.
pub fn executors() -> Vec<Box<dyn Executor>> {
    let of = |body| Box::new(Plcopen { body, tools: Tools::find() }) as Box<dyn Executor>;
    [Body::St, Body::Il, Body::Ld, Body::Sfc].into_iter().map(of).collect()
}

impl Executor for Plcopen {
    fn name(&self) -> &str {
        match self.body {
            Body::St => "plcopen:st",
            Body::Il => "plcopen:il",
            Body::Ld => "plcopen:ld",
            Body::Sfc => "plcopen:sfc",
        }
    }

    fn about(&self) -> &str {
        match self.body {
            Body::St => "Structured Text in a PLCopen project, through Beremiz and MATIEC, the encodings in turn",
            Body::Il => "instruction lists in a PLCopen project, through Beremiz and MATIEC, the encodings in turn",
            Body::Ld => "ladder diagrams in a PLCopen project, through Beremiz and MATIEC, the encodings in turn",
            Body::Sfc => "sequential function charts in a PLCopen project, through Beremiz and MATIEC",
        }
    }

    fn limits(&self) -> &str {
        match self.body {
            Body::St | Body::Il | Body::Ld => "no products or quotients of times, which MATIEC computes wrongly",
            Body::Sfc => "charts that can be drawn without meaning something else",
        }
    }

    fn missing(&self) -> Option<&str> {
        self.tools.as_ref().err().map(String::as_str)
    }

    fn tool(&self) -> Option<Tool> {
        Some(Tool::Beremiz)
    }

    fn run(&self, tasks: &[Task]) -> Vec<Outcome> {
        let mut charts: Vec<Sequence> = Vec::new();
        let jobs = tasks.iter().map(|task| match self.body {
            _ if miscalculates(task.chart) => Err(Outcome::PassedOver("MATIEC computes products of times wrongly")),
            Body::St | Body::Il | Body::Ld => Job::of(task).map_err(Outcome::Failed),
            Body::Sfc => {
                let (job, chart) = sequences::job(task)?;
                charts.push(chart);
                Ok(job)
            }
        });
        let jobs: Vec<_> = jobs.collect();
        let source = match self.body {
            Body::St | Body::Il | Body::Ld => Source::Programs(self.body),
            Body::Sfc => Source::Sequences(&charts),
        };
        run_some(&self.tools, jobs, |tools, jobs| run(tools, &source, jobs))
    }
}
