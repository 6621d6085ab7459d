//! Charts that restate what people of the trade asked, reported or were taught: each does what its expectation says, in
//! the simulator and as a program, and gets the warnings that it deserves.

use grafc_testsuite::charts::{Case, check, field_cases, spell, stimuli};
use grafc_testsuite::runs;

/// Runs a check over all cases and reports every fault at once.
fn each(test: impl Fn(&Case) -> Result<(), String>) {
    let cases = field_cases();
    assert!(cases.len() >= 32, "cases are missing: only {} were found", cases.len());
    let faults: Vec<String> =
        cases.iter().filter_map(|case| test(case).err().map(|fault| format!("{}:\n{fault}", case.name))).collect();
    assert!(faults.is_empty(), "{} of {} cases fail\n\n{}", faults.len(), cases.len(), faults.join("\n"));
}

fn compare(expected: &str, actual: &str) -> Result<(), String> {
    let differs = |(expected, actual): &(&str, &str)| expected != actual;
    let pairs = expected.lines().zip(actual.lines());
    let wrong: Vec<String> =
        pairs.filter(differs).map(|(expected, actual)| format!("  expected {expected}\n  actual   {actual}")).collect();
    if wrong.is_empty() && expected.lines().count() == actual.lines().count() { Ok(()) } else { Err(wrong.join("\n")) }
}

#[test]
fn the_simulator_agrees() {
    each(|case| {
        let chart = check(&case.name, &case.text)?;
        let stimuli = stimuli(&case.name, &case.trace, &chart)?;
        compare(&case.expected, &spell(&chart, &stimuli, &runs::simulate(&chart, case.profile, &stimuli)))
    });
}

#[test]
fn the_scan_programs_agree() {
    each(|case| {
        let chart = check(&case.name, &case.text)?;
        let stimuli = stimuli(&case.name, &case.trace, &chart)?;
        for (way, options) in case.ways() {
            let run = runs::evaluate(&chart, &options, &stimuli)?;
            compare(&case.expected, &spell(&chart, &stimuli, &run)).map_err(|fault| format!("{way}\n{fault}"))?;
        }
        Ok(())
    });
}
