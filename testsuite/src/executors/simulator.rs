//! The reference simulator.

use super::task::{Executor, Outcome, Task};
use crate::runs::{caught, simulate};

/// The reference: what it does is what a chart means.
pub struct Simulator;

impl Executor for Simulator {
    fn name(&self) -> &str {
        "simulator"
    }

    fn about(&self) -> &str {
        "the rules, literally: the reference"
    }

    fn run(&self, tasks: &[Task]) -> Vec<Outcome> {
        let run = |task: &Task| caught(|| Ok(simulate(task.chart, task.profile, task.stimuli)));
        tasks.iter().map(|task| run(task).into()).collect()
    }
}
