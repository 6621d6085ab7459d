//! Charts that say what they do, held against the simulator, scan programs and all executors.

use crate::charts::{Case, check, spell, stimuli};
use crate::executors::{Outcome, Task, all, is_here_or_skip};
use crate::runs;
use grafc_model::chart::Chart;
use grafc_model::reaction::{Profile, Stimulus};
use std::fmt::Write;

/// Applies a check to every case.
///
/// # Panics
///
/// Where one fails: every fault is told, not only the first. And where there are fewer cases than there must be.
pub fn each(cases: &[Case], at_least: usize, test: impl Fn(&Case) -> Result<(), String>) {
    assert!(cases.len() >= at_least, "charts are missing: only {} were found", cases.len());
    let faults: Vec<String> =
        cases.iter().filter_map(|case| test(case).err().map(|fault| format!("{}:\n{fault}", case.name))).collect();
    assert!(faults.is_empty(), "{} of {} charts fail\n\n{}", faults.len(), cases.len(), faults.join("\n"));
}

/// Whether the simulator does what a chart says.
///
/// # Errors
///
/// The rows that differ.
pub fn simulator_agrees(case: &Case) -> Result<(), String> {
    let chart = check(&case.name, &case.text)?;
    let stimuli = stimuli(&case.name, &case.trace, &chart)?;
    same(&case.expected, &spell(&chart, &stimuli, &runs::simulate(&chart, case.profile, &stimuli)))
}

/// Whether its scan programs do, in each way that it can be lowered.
///
/// # Errors
///
/// The way, and the rows that differ.
pub fn programs_agree(case: &Case) -> Result<(), String> {
    let chart = check(&case.name, &case.text)?;
    let stimuli = stimuli(&case.name, &case.trace, &chart)?;
    for (way, options) in case.ways() {
        let run = runs::evaluate(&chart, &options, &stimuli)?;
        same(&case.expected, &spell(&chart, &stimuli, &run)).map_err(|fault| format!("{way}\n{fault}"))?;
    }
    Ok(())
}

/// One that knows several ways to run a chart takes all of them in so many turns.
const TURNS: usize = 8;

/// What costs seconds takes some of them.
const TURNS_OUTSIDE: usize = 3;

/// Whether the simulator does what a table says, and every executor that is here does so in its ways.
///
/// # Errors
///
/// The first that does something else, and what.
pub fn all_agree(chart: &Chart, profile: Profile, stimuli: &[Stimulus], expected: &str) -> Result<(), String> {
    let by_the_rules = runs::simulate(chart, profile, stimuli);
    same(expected, &spell(chart, stimuli, &by_the_rules)).map_err(|fault| format!("the simulator:\n{fault}"))?;
    let tasks: Vec<Task> = (0..TURNS).map(|turn| Task { chart, profile, stimuli, turn }).collect();
    for executor in all().iter().filter(|executor| is_here_or_skip(executor.as_ref())) {
        let turns = if executor.is_external() { TURNS_OUTSIDE } else { TURNS };
        for outcome in executor.run(&tasks[..turns]) {
            match outcome {
                Outcome::Ran(responses) if executor.difference(&by_the_rules, &responses).is_none() => {}
                Outcome::Ran(responses) => {
                    let actual = spell(chart, stimuli, &responses);
                    return Err(format!("{}: expected\n{expected}actual\n{actual}", executor.name()));
                }
                Outcome::PassedOver(_) => {}
                Outcome::Failed(fault) => return Err(format!("{}: {fault}", executor.name())),
            }
        }
    }
    Ok(())
}

/// Whether two texts are the same.
///
/// # Errors
///
/// The lines that differ.
pub fn same(expected: &str, actual: &str) -> Result<(), String> {
    if expected == actual {
        return Ok(());
    }
    let (mut left, mut right) = (expected.lines(), actual.lines());
    let mut fault = String::new();
    loop {
        match (left.next(), right.next()) {
            (None, None) => return Err(fault),
            (l, r) if l == r => {}
            (l, r) => {
                let _ = writeln!(fault, "  expected {}\n  actual   {}", l.unwrap_or("-"), r.unwrap_or("-"));
            }
        }
    }
}
