//! The scan program run for 64 traces at once: the one that is asked for, and 63 drawn beside it, which all ways of
//! lowering must do alike. Of those the simulator is asked only where two ways differ.

use super::task::{Executor, Outcome, Task};
use crate::compare::{first_difference, report};
use crate::random::trace;
use crate::runs::{caught, compile, simulate};
use crate::ways::exact;
use grafc_lanes::{LANES, run};
use grafc_model::reaction::{Response, Stimulus};

/// The executor.
pub(super) struct AtOnce;

impl Executor for AtOnce {
    fn name(&self) -> &str {
        "lanes"
    }

    fn about(&self) -> &str {
        "the scan program for 64 traces at once, in all exact encodings"
    }

    fn run(&self, tasks: &[Task]) -> Vec<Outcome> {
        tasks.iter().map(|task| caught(|| one(task)).into()).collect()
    }
}

fn one(task: &Task) -> Result<Vec<Response>, String> {
    let drawn: Vec<Vec<Stimulus>> =
        (1..LANES).map(|lane| trace((task.turn * LANES + lane) as u64, task.chart, task.stimuli.len())).collect();
    let traces: Vec<&[Stimulus]> = [task.stimuli].into_iter().chain(drawn.iter().map(Vec::as_slice)).collect();
    let mut first: Option<Vec<Vec<Response>>> = None;
    for (way, options) in exact(task.profile) {
        let found = run(&compile(task.chart, &options)?, &traces);
        let Some(first) = &first else {
            first = Some(found);
            continue;
        };
        for ((one, other), stimuli) in first.iter().zip(&found).zip(&traces) {
            if first_difference(one, other).is_some() {
                let expected = simulate(task.chart, task.profile, stimuli);
                let wrong = if first_difference(&expected, other).is_some() { other } else { one };
                return Err(format!("{way}\n{}", report(task.chart, task.profile, stimuli, &expected, wrong)));
            }
        }
    }
    Ok(first.into_iter().flatten().next().unwrap_or_default())
}
