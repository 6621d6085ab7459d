//! Charts that say what they do, held against the simulator and against scan programs.

use crate::charts::{Case, check, spell, stimuli};
use crate::runs;
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
