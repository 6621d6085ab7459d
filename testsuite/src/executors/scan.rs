//! The scan program, evaluated: in every encoding, with and without shorter formulas.
//!
//! Encodings whose steps overlap promise only the stable situations, and those only where the compiler does not warn
//! that the overlap can be seen.

use super::task::{Executor, Outcome, Task};
use crate::compare::first_other_situation;
use crate::runs::{caught, evaluate, stable_situations};
use crate::ways::exact;
use grafc_logic::{Encoding, Options};
use grafc_model::reaction::{Profile, Response};

/// One executor a way to lower a chart.
pub(super) fn executors() -> Vec<Box<dyn Executor>> {
    let mut all: Vec<Box<dyn Executor>> = Vec::new();
    for (_, options) in exact(Profile::default()) {
        let end = if options.simplify { "" } else { "-O0" };
        let name = format!("scan:{}{end}", options.encoding.name());
        let formulas = if options.simplify { "shortened formulas" } else { "formulas as they stand" };
        let about = format!("the scan program, {}, {formulas}", options.encoding.name());
        all.push(Box::new(Exact { name, about, options }));
    }
    for encoding in Encoding::ALL.into_iter().filter(|encoding| encoding.overlaps()) {
        let name = format!("scan:{}", encoding.name());
        all.push(Box::new(Overlapping { name, about: format!("the scan program, {}", encoding.name()), encoding }));
    }
    all
}

struct Exact {
    name: String,
    about: String,
    options: Options,
}

impl Executor for Exact {
    fn name(&self) -> &str {
        &self.name
    }

    fn about(&self) -> &str {
        &self.about
    }

    fn run(&self, tasks: &[Task]) -> Vec<Outcome> {
        let run = |task: &Task| {
            let options = Options { profile: task.profile, ..self.options };
            caught(|| evaluate(task.chart, &options, task.stimuli))
        };
        tasks.iter().map(|task| run(task).into()).collect()
    }
}

struct Overlapping {
    name: String,
    about: String,
    encoding: Encoding,
}

impl Executor for Overlapping {
    fn name(&self) -> &str {
        &self.name
    }

    fn about(&self) -> &str {
        &self.about
    }

    fn limits(&self) -> &str {
        "only stable situations are compared, and not of charts with W0413"
    }

    fn run(&self, tasks: &[Task]) -> Vec<Outcome> {
        let run = |task: &Task| {
            let options = Options { profile: task.profile, encoding: self.encoding, simplify: true };
            match caught(|| stable_situations(task.chart, &options, task.stimuli)) {
                Ok(Some(responses)) => Outcome::Ran(responses),
                Ok(None) => Outcome::PassedOver("the overlap can be seen (W0413)"),
                Err(fault) => Outcome::Failed(fault),
            }
        };
        tasks.iter().map(run).collect()
    }

    fn difference(&self, expected: &[Response], actual: &[Response]) -> Option<usize> {
        first_other_situation(expected, actual)
    }
}
