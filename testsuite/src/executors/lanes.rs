//! The scan program run for 64 traces at once: the one that is asked for, and 63 drawn beside it, which all ways of
//! lowering must do alike. Of those the simulator is asked only where two ways differ.

use super::task::{Executor, Outcome, Task};
use crate::compare::{first_difference, report};
use crate::random::trace;
use crate::runs::{self, caught, compile, simulate};
use crate::ways::exact;
use grafc_lanes::{LANES, Lanes};
use grafc_logic::scan::Program;
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
    let ways = exact(task.profile);
    let compiled = ways.iter().map(|(_, options)| compile(task.chart, options));
    let programs = compiled.collect::<Result<Vec<Program>, String>>()?;
    let mut all: Vec<Lanes> = programs.iter().map(Lanes::new).collect();
    let mut responses = Vec::with_capacity(task.stimuli.len());
    for row in 0..task.stimuli.len() {
        let stimuli: Vec<&Stimulus> = traces.iter().map(|trace| &trace[row]).collect();
        all.iter_mut().for_each(|lanes| lanes.react(&stimuli));
        let [first, others @ ..] = &mut all[..] else { break };
        for (place, other) in others.iter_mut().enumerate() {
            let differing = first.differing(other);
            if differing != 0 {
                let pair = [0, place + 1].map(|way| (ways[way].0.as_str(), &programs[way]));
                return Err(disagreement(task, traces[differing.trailing_zeros() as usize], pair));
            }
        }
        responses.extend(first.responses(1));
    }
    Ok(responses)
}

/// Which of two ways, run alone, does what the simulator does not.
fn disagreement(task: &Task, stimuli: &[Stimulus], pair: [(&str, &Program); 2]) -> String {
    let expected = simulate(task.chart, task.profile, stimuli);
    for (way, program) in pair {
        let actual = runs::run(program, stimuli);
        if first_difference(&expected, &actual).is_some() {
            return format!("{way}\n{}", report(task.chart, task.profile, stimuli, &expected, &actual));
        }
    }
    format!("{}: alone it does what the simulator does", pair[1].0)
}
