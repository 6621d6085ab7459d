//! What the next situation must be known of before it is written, since pulse orders (R15) ask for it.

use grafc_model::chart::{Event, StepId};
use grafc_net::Net;
use index_vec::IndexVec;

/// Steps on which pulse orders act, or whose activation or deactivation gives one.
pub(crate) fn acted_on(net: &Net, found: &mut IndexVec<StepId, bool>) {
    for pulse in &net.pulses {
        match pulse.event {
            Event::Activation(s) | Event::Deactivation(s) => found[s] = true,
            Event::Event(..) | Event::Clearing(_) | Event::EachScan(..) => {}
        }
    }
    net.runs.iter().for_each(|run| found[run.step] = true);
    for (_, commanded) in net.commands() {
        net.grafcets[commanded].steps.iter().for_each(|s| found[*s] = true);
    }
}
