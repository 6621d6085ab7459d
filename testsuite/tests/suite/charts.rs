//! The example charts: each does what its expectation says, is in canonical format, and compiles.

use grafc_backends::st;
use grafc_diagnostics::FileId;
use grafc_logic::{Encoding, Options};
use grafc_testsuite::charts::{cases, charts_folder, check};
use grafc_testsuite::expected::{each, programs_agree, same, simulator_agrees};
use grafc_testsuite::runs;

const AT_LEAST: usize = 16;

#[test]
fn the_simulator_agrees() {
    each(&cases(&charts_folder()), AT_LEAST, simulator_agrees);
}

#[test]
fn the_scan_programs_agree() {
    each(&cases(&charts_folder()), AT_LEAST, programs_agree);
}

#[test]
fn every_chart_is_in_canonical_format() {
    each(&cases(&charts_folder()), AT_LEAST, |case| {
        let (tree, diagnostics) = grafc_syntax::parse(FileId::default(), &case.text);
        if diagnostics.has_errors() {
            return Err(format!("{diagnostics:?}"));
        }
        same(&case.text, &grafc_syntax::format(&case.text, &tree))
    });
}

#[test]
fn every_chart_compiles_to_structured_text_in_every_encoding() {
    each(&cases(&charts_folder()), AT_LEAST, |case| {
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
