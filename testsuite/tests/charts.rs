//! The example charts: each does what its expectation says, is in canonical format, and compiles.

use grafc_backends::st;
use grafc_diagnostics::FileId;
use grafc_logic::{Encoding, Options};
use grafc_testsuite::charts::{Case, cases, charts_folder, check, spell, stimuli};
use grafc_testsuite::runs;

/// Runs a check over all charts and reports every fault at once.
fn each(test: impl Fn(&Case) -> Result<(), String>) {
    let cases = cases(&charts_folder());
    assert!(cases.len() >= 16, "charts are missing: only {} were found", cases.len());
    let faults: Vec<String> =
        cases.iter().filter_map(|case| test(case).err().map(|fault| format!("{}:\n{fault}", case.name))).collect();
    assert!(faults.is_empty(), "{} of {} charts fail\n\n{}", faults.len(), cases.len(), faults.join("\n"));
}

fn compare(expected: &str, actual: &str) -> Result<(), String> {
    if expected == actual {
        return Ok(());
    }
    let (mut left, mut right) = (expected.lines(), actual.lines());
    let mut fault = String::new();
    loop {
        match (left.next(), right.next()) {
            (None, None) => return Err(fault),
            (l, r) if l == r => {}
            (l, r) => fault += &format!("  expected {}\n  actual   {}\n", l.unwrap_or("-"), r.unwrap_or("-")),
        }
    }
}

#[test]
fn the_simulator_agrees() {
    each(|case| {
        let chart = check(&case.name, &case.text)?;
        let stimuli = stimuli(&case.name, &case.trace, &chart)?;
        let run = runs::simulate(&chart, case.profile, &stimuli);
        compare(&case.expected, &spell(&chart, &stimuli, &run))
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

#[test]
fn every_chart_is_in_canonical_format() {
    each(|case| {
        let (tree, diagnostics) = grafc_syntax::parse(FileId::default(), &case.text);
        if diagnostics.has_errors() {
            return Err(format!("{diagnostics:?}"));
        }
        compare(&case.text, &grafc_syntax::format(&case.text, &tree))
    });
}

#[test]
fn every_chart_compiles_to_structured_text_in_every_encoding() {
    each(|case| {
        let chart = check(&case.name, &case.text)?;
        for encoding in Encoding::ALL {
            let options = Options { profile: case.profile, encoding, simplify: true };
            let program = runs::compile(&chart, &options)?;
            let text = st::emit(&program, &st::Options::default()).map_err(|diagnostics| format!("{diagnostics:?}"))?;
            if !text.contains("FUNCTION_BLOCK") {
                return Err(text);
            }
        }
        Ok(())
    });
}
