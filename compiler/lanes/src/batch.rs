//! Any number of scenarios from their first call to their last, 64 of them at once.

use crate::code::LANES;
use crate::lanes::Lanes;
use grafc_logic::scan::Program;
use grafc_model::reaction::{Response, Stimulus};

/// What a program does with each of some traces, which may differ in length: a response for each stimulus.
pub fn run(program: &Program, traces: &[&[Stimulus]]) -> Vec<Vec<Response>> {
    // Traces of about one length go together: lanes whose trace is over rest.
    let mut order: Vec<usize> = (0..traces.len()).collect();
    order.sort_by_key(|trace| std::cmp::Reverse(traces[*trace].len()));
    let mut found: Vec<Vec<Response>> = traces.iter().map(|trace| Vec::with_capacity(trace.len())).collect();
    for group in order.chunks(LANES) {
        let mut lanes = Lanes::new(program);
        for row in 0..traces[group[0]].len() {
            // The longest are first.
            let running = &group[..group.partition_point(|trace| traces[*trace].len() > row)];
            let stimuli: Vec<&Stimulus> = running.iter().map(|trace| &traces[*trace][row]).collect();
            lanes.react(&stimuli);
            for (trace, response) in running.iter().zip(lanes.responses(running.len())) {
                found[*trace].push(response);
            }
        }
    }
    found
}
