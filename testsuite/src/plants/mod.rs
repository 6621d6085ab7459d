//! Real charts: those of AGRAFE's collection, imported, among them the plant of Schumacher and Fay.
//!
//! Each is written for every target in every encoding (`targets`), and is run, with a random trace, by everything that
//! can run charts: all must do what the simulator does.

pub mod command;
mod targets;

use crate::charts;
use crate::compare::report;
use crate::executors::{Executor, Outcome, Task};
use crate::random::trace;
use crate::runs::simulate;
use grafc_diagnostics::FileId;
use grafc_import::Options;
use grafc_model::chart::Chart;
use grafc_model::reaction::{Profile, Response, Stimulus};
pub use targets::{Compilers, PRODUCTS, Written, targets};

/// Turns with which an executor takes each of the exact encodings once, with shortened formulas.
pub const TURNS: [usize; 3] = [0, 2, 4];

/// A chart that was imported.
pub struct Plant {
    /// The name of its file; of the other reading, where names of variables say delays, with a remark.
    pub name: String,
    /// Its text.
    pub text: String,
    /// The checked chart.
    pub chart: Chart,
}

/// The charts of the collection, imported; an error is what an import or a check said.
pub fn plants(collection: Vec<(String, String)>) -> Result<Vec<Plant>, String> {
    let mut plants: Vec<Plant> = Vec::new();
    for (name, xml) in collection {
        for (end, delays) in [("", false), (" --delays", true)] {
            let (text, diagnostics) =
                grafc_import::import(FileId::default(), &xml, &Options { delays, ..Options::default() });
            let text = text.ok_or_else(|| charts::render(&name, &xml, &diagnostics))?;
            if delays && plants.last().is_some_and(|last| last.text == text) {
                continue;
            }
            let name = format!("{name}{end}");
            let chart = charts::check(&name, &text)?;
            plants.push(Plant { name, text, chart });
        }
    }
    Ok(plants)
}

/// A trace for a chart, and what it must do.
pub struct Trial<'p> {
    plant: &'p Plant,
    stimuli: Vec<Stimulus>,
    expected: Vec<Response>,
}

impl<'p> Trial<'p> {
    /// A random trace of so many scans.
    pub fn new(plant: &'p Plant, scans: usize) -> Self {
        let stimuli = trace(7, &plant.chart, scans);
        let expected = simulate(&plant.chart, Profile::default(), &stimuli);
        Trial { plant, stimuli, expected }
    }

    /// How many scans change the situation.
    pub fn changes(&self) -> usize {
        self.expected.windows(2).filter(|pair| pair[0].situation != pair[1].situation).count()
    }

    /// Why an executor passes it over, if it does; an error where it does not do what the simulator does. An executor
    /// with several encodings takes those whose turns these are.
    pub fn run(&self, executor: &dyn Executor, turns: &[usize]) -> Result<Option<&'static str>, String> {
        let (chart, profile, stimuli) = (&self.plant.chart, Profile::default(), &self.stimuli[..]);
        let turns = if executor.is_external() { turns } else { &turns[..1] };
        let tasks: Vec<Task> = turns.iter().map(|&turn| Task { chart, profile, stimuli, turn }).collect();
        for (outcome, turn) in executor.run(&tasks).into_iter().zip(turns) {
            match outcome {
                Outcome::Ran(actual) => {
                    if executor.difference(&self.expected, &actual).is_some() {
                        let report = report(chart, profile, stimuli, &self.expected, &actual);
                        return Err(format!("turn {turn}: {report}"));
                    }
                }
                Outcome::PassedOver(reason) => return Ok(Some(reason)),
                Outcome::Failed(said) => return Err(format!("turn {turn}: {said}")),
            }
        }
        Ok(None)
    }
}
