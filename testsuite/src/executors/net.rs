//! The net, as built and after every pass that keeps each micro-step.
//!
//! The pass for overlapping steps adds steps, so that there are other situations on the way; what it does is seen in
//! the scan programs of those encodings.

use super::task::{Executor, Outcome, Task};
use crate::compare::first_difference;
use crate::net_steps::NetSteps;
use crate::runs::caught;
use grafc_diagnostics::Diagnostics;
use grafc_model::reaction::{Flags, Response};
use grafc_net::passes::ORDER;

struct Net {
    name: String,
    about: String,
    /// So many passes have been run.
    passes: usize,
}

/// One executor a stage of the net.
pub(super) fn executors() -> Vec<Box<dyn Executor>> {
    let built = Net { name: "net:built".into(), about: "the net as built".into(), passes: 0 };
    let passes = ORDER.iter().filter(|pass| !pass.for_overlap).enumerate().map(|(index, pass)| Net {
        name: format!("net:{}", pass.name),
        about: format!("the net after the pass {}", pass.name),
        passes: index + 1,
    });
    std::iter::once(built).chain(passes).map(|net| Box::new(net) as Box<dyn Executor>).collect()
}

impl Executor for Net {
    fn name(&self) -> &str {
        &self.name
    }

    fn about(&self) -> &str {
        &self.about
    }

    fn limits(&self) -> &str {
        "the flag DIV0 is not compared"
    }

    fn run(&self, tasks: &[Task]) -> Vec<Outcome> {
        tasks.iter().map(|task| caught(|| self.run_one(task)).into()).collect()
    }

    fn difference(&self, expected: &[Response], actual: &[Response]) -> Option<usize> {
        let without_div0 = |response: &Response| {
            let flags = Flags { div0: false, ..response.flags };
            Response { flags, ..response.clone() }
        };
        let expected: Vec<Response> = expected.iter().map(without_div0).collect();
        first_difference(&expected, actual)
    }
}

impl Net {
    fn run_one(&self, task: &Task) -> Result<Vec<Response>, String> {
        let mut net = grafc_net::build(task.chart);
        let mut diagnostics = Diagnostics::new();
        for pass in ORDER.iter().filter(|pass| !pass.for_overlap).take(self.passes) {
            (pass.run)(&mut net, &mut diagnostics);
            net.facts.extend_from_slice(pass.ensures);
        }
        if !diagnostics.is_empty() {
            return Err(format!("the passes said {diagnostics:?}"));
        }
        let mut steps = NetSteps::new(&net, task.profile);
        Ok(task.stimuli.iter().map(|stimulus| steps.react(stimulus, &mut |_| ())).collect())
    }
}
