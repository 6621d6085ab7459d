//! What every executor is given, and what comes of it.

use crate::compare::first_difference;
use crate::tools::Tool;
use grafc_model::chart::Chart;
use grafc_model::reaction::{Profile, Response, Stimulus};

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

    /// The tool from outside that it is about.
    fn tool(&self) -> Option<Tool> {
        None
    }

    /// Whether a task costs seconds, because a tool from outside is called.
    fn is_external(&self) -> bool {
        self.tool().is_some()
    }

    /// Runs all tasks, in one go where that is cheaper.
    fn run(&self, tasks: &[Task]) -> Vec<Outcome>;

    /// The first call in which a run is not what it should be, as far as this executor can show it.
    fn difference(&self, expected: &[Response], actual: &[Response]) -> Option<usize> {
        first_difference(expected, actual)
    }
}
