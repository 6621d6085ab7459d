//! `grafc-testsuite plants`.

use super::{Compilers, TURNS, Trial, plants, targets};
use crate::executors::{self, Executor};
use crate::xmi;
use clap::Args;
use std::io::Write as _;
use std::process::ExitCode;
use std::time::Instant;

/// AGRAFE's charts through every target and through many executors
#[derive(Args, Debug)]
pub struct Arguments {
    /// Calls of each chart
    #[arg(long, default_value_t = 10_000, value_name = "N")]
    scans: usize,
    /// Executors, by name or group; see `grafc-testsuite executors`
    #[arg(long, default_value = "all", value_name = "A,B,…")]
    executors: String,
    /// Charts whose names have this part
    #[arg(long, default_value = "", value_name = "PART")]
    only: String,
}

/// Says of each chart what came of it. The exit code is 1 if there was a fault.
pub fn run(arguments: &Arguments) -> Result<ExitCode, String> {
    let executors = executors::select(&arguments.executors)?;
    // Who asks for one by its name knows of it already.
    for executor in executors::all() {
        let broad = arguments.executors.split(',').any(|name| name.trim() == "all");
        if let Some(missing) = executor.missing().filter(|_| broad) {
            say(&format!("left out: {}: {missing}", executor.name()))?;
        }
    }
    let (compilers, missing) = Compilers::find();
    for what in missing {
        say(&format!("not asked whether it takes a text: {what}"))?;
    }
    let mut faults = 0;
    for plant in plants(xmi::collection()?)?.iter().filter(|plant| plant.name.contains(&arguments.only)) {
        let (steps, transitions) = (plant.chart.steps.len(), plant.chart.transitions.len());
        say(&format!("{}: {steps} steps, {transitions} transitions", plant.name))?;
        match targets(plant, |_| &compilers) {
            Ok(written) => say(&format!(
                "  {} texts, taken by compilers {} times, {} drawings refused (E0503)",
                written.texts, written.taken, written.undrawn
            ))?,
            Err(said) => {
                faults += 1;
                say(&format!("  targets: {said}"))?;
            }
        }
        let trial = Trial::new(plant, arguments.scans);
        say(&format!("  {} scans, {} of them change the situation", arguments.scans, trial.changes()))?;
        for executor in &executors {
            faults += usize::from(!try_one(&trial, executor.as_ref())?);
        }
    }
    say(&format!("{faults} faults"))?;
    Ok(if faults == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Whether an executor does what it should.
fn try_one(trial: &Trial, executor: &dyn Executor) -> Result<bool, String> {
    let began = Instant::now();
    let result = trial.run(executor, &TURNS);
    let came = match &result {
        Ok(None) => "agrees".to_string(),
        Ok(Some(reason)) => format!("passed over: {reason}"),
        Err(said) => format!("DISAGREES: {said}"),
    };
    say(&format!("  {:24} {:7.1} s  {came}", executor.name(), began.elapsed().as_secs_f64()))?;
    Ok(result.is_ok())
}

fn say(line: &str) -> Result<(), String> {
    let mut out = std::io::stdout().lock();
    writeln!(out, "{line}").and_then(|()| out.flush()).map_err(|error| error.to_string())
}
