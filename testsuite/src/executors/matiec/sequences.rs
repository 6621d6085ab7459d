//! Sequential function charts in text, as MATIEC compiles and a C compiler runs them.

use super::run::{RUNTIME, Unit, build_and_play};
use super::tools::Tools;
use crate::executors::function_block::{FunctionBlock, named};
use crate::executors::jobs::{self, Job, run_some};
use crate::executors::sequences;
use crate::executors::task::{Executor, Outcome, Task};
use crate::tools::Tool;
use grafc_backends::sfc;
use grafc_logic::sequence::Sequence;

/// Charts that can be sequential function charts, as text under MATIEC.
struct Sequences {
    tools: Result<Tools, String>,
}

/// The executor.
pub fn executor() -> Box<dyn Executor> {
    Box::new(Sequences { tools: Tools::find() })
}

impl Executor for Sequences {
    fn name(&self) -> &str {
        "matiec:sfc"
    }

    fn about(&self) -> &str {
        "sequential function charts in text, through MATIEC"
    }

    fn limits(&self) -> &str {
        "charts that can be sequential function charts without meaning something else"
    }

    fn missing(&self) -> Option<&str> {
        self.tools.as_ref().err().map(String::as_str)
    }

    fn tool(&self) -> Option<Tool> {
        Some(Tool::Matiec)
    }

    fn run(&self, tasks: &[Task]) -> Vec<Outcome> {
        let mut charts: Vec<Sequence> = Vec::new();
        let jobs = tasks.iter().map(|task| {
            let (job, chart) = sequences::job(task)?;
            charts.push(chart);
            Ok(job)
        });
        let jobs: Vec<_> = jobs.collect();
        run_some(&self.tools, jobs, |tools, jobs| {
            let units = jobs.iter().zip(&charts).enumerate().map(|(index, (job, chart))| unit(index, job, chart));
            jobs::run(jobs, units.collect(), |batch, units: &[&Unit]| build_and_play(tools, batch, units))
        })
    }
}

fn unit(index: usize, job: &Job, chart: &Sequence) -> Result<Unit, String> {
    let chart = Sequence { program: named(index, &chart.program), ..chart.clone() };
    let program = named(index, &job.program);
    let text = sfc::emit(&chart, &sfc::Options::default()).map_err(|diagnostics| format!("{diagnostics:#?}"))?;
    let mut blocks = text.lines().filter_map(|line| line.trim().strip_prefix("FUNCTION_BLOCK "));
    let name = blocks.next_back().ok_or("the text has no function block")?.to_string();
    let block = FunctionBlock {
        names: sequences::names(&chart, &program, &text)?,
        program,
        name,
        text,
        holder: sfc::instance(&chart).map(String::from),
    };
    let driver = RUNTIME.driver(index, &block, &job.stimuli)?;
    Ok(Unit { text: block.text, driver })
}
