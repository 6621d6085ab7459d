//! Everything that can run a chart, behind one trait.
//!
//! The reference simulator says what a chart does; each other executor takes the chart through some of the compiler's
//! stages, the last ones through tools from outside, and must do the same. Tools are looked for on PATH or where an
//! environment variable says; an executor without its tool says so and is not run.

mod awlsim;
mod ironplc;
mod matiec;
mod net;
mod plcopen;
mod rust;
mod scan;
mod simulator;
mod strucpp;

use crate::differential::first_difference;
use grafc_model::chart::Chart;
use grafc_model::reaction::{Profile, Response, Stimulus};
pub use simulator::Simulator;

/// A chart and what is done to it.
#[derive(Clone, Copy)]
pub struct Task<'a> {
    /// The chart.
    pub chart: &'a Chart,
    /// How it evolves.
    pub profile: Profile,
    /// The calls.
    pub stimuli: &'a [Stimulus],
    /// An executor that knows several ways, and takes one a chart, takes this one, counted around.
    pub turn: usize,
}

/// What came of a task.
#[derive(Clone, PartialEq, Debug)]
pub enum Outcome {
    /// A response to each call.
    Ran(Vec<Response>),
    /// It is not for this executor, for this reason.
    PassedOver(&'static str),
    /// What a stage or a tool said: always a fault.
    Failed(String),
}

impl From<Result<Vec<Response>, String>> for Outcome {
    fn from(result: Result<Vec<Response>, String>) -> Self {
        match result {
            Ok(responses) => Outcome::Ran(responses),
            Err(fault) => Outcome::Failed(fault),
        }
    }
}

/// Something that can run charts.
pub trait Executor: Sync {
    /// Its name; what stands before a `:` names a group.
    fn name(&self) -> &str;

    /// What it runs, in a few words.
    fn about(&self) -> &str;

    /// What it cannot run, in a few words.
    fn limits(&self) -> &str {
        "none"
    }

    /// What it lacks to be used here.
    fn missing(&self) -> Option<&str> {
        None
    }

    /// Whether a task costs seconds, because tools outside are called.
    fn is_external(&self) -> bool {
        false
    }

    /// Runs all tasks, in one go where that is cheaper.
    fn run(&self, tasks: &[Task]) -> Vec<Outcome>;

    /// The first call in which a run is not what it should be, as far as this executor can show it.
    fn difference(&self, expected: &[Response], actual: &[Response]) -> Option<usize> {
        first_difference(expected, actual)
    }
}

/// All executors, the reference first.
pub fn all() -> Vec<Box<dyn Executor>> {
    let mut all: Vec<Box<dyn Executor>> = vec![Box::new(Simulator)];
    all.extend(net::executors());
    all.extend(scan::executors());
    all.push(Box::new(rust::Rust::find()));
    all.extend(matiec::executors());
    all.push(Box::new(ironplc::Ironplc::find()));
    all.push(Box::new(strucpp::Strucpp::find()));
    all.push(Box::new(awlsim::Awlsim::find()));
    all.extend(plcopen::executors());
    all
}

/// The executors of a list of names separated by commas: whole names, names of groups, `built-in` and `all`. An error
/// names what is unknown, or asked for by its own name and missing.
pub fn select(names: &str) -> Result<Vec<Box<dyn Executor>>, String> {
    let all = all();
    let mut chosen = vec![false; all.len()];
    for name in names.split(',').map(str::trim) {
        let mut known = false;
        for (executor, chosen) in all.iter().zip(&mut chosen) {
            let group = executor.name().split(':').next();
            let broad = name == "all" || name == "built-in" && !executor.is_external();
            if !broad && executor.name() != name && group != Some(name) {
                continue;
            }
            known = true;
            match executor.missing() {
                None => *chosen = true,
                Some(missing) if !broad => return Err(format!("`{name}` cannot be used: {missing}")),
                Some(_) => {}
            }
        }
        if !known {
            let names: Vec<&str> = all.iter().map(|executor| executor.name()).collect();
            return Err(format!("there is no executor `{name}`; there are {}, built-in, all", names.join(", ")));
        }
    }
    Ok(all.into_iter().zip(chosen).filter_map(|(executor, chosen)| chosen.then_some(executor)).collect())
}
