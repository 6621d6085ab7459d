//! PLCopen projects with every kind of body, through the generator of Beremiz, MATIEC and a C compiler: they do what the
//! chart means.
//!
//! Needs `BEREMIZ`, a Python with lxml (`PYTHON`), `iec2c` and `gcc`; without them each test says so and does nothing.

use crate::by_executor::{of_steps, prepared, random_charts_agree, vectors_and_charts_agree, with_delays};
use grafc_backends::plcopen::Body;
use grafc_logic::{Encoding, Options};
use grafc_testsuite::charts::{cases, charts_folder, spell, vectors_folder};
use grafc_testsuite::executors::beremiz::{Source, Tools, run};
use grafc_testsuite::executors::jobs::Job;
use grafc_testsuite::random::ChartKind;
use grafc_testsuite::runs::{self, compile};

#[test]
fn structured_text() {
    vectors_and_charts_agree("plcopen:st", 100);
}

#[test]
fn instruction_lists() {
    vectors_and_charts_agree("plcopen:il", 100);
}

#[test]
fn ladders() {
    vectors_and_charts_agree("plcopen:ld", 100);
}

#[test]
fn sequential_function_charts() {
    vectors_and_charts_agree("plcopen:sfc", 5);
}

/// The r- and s-trigger are written as they are evaluated, and do what is expected where nothing overlaps.
#[test]
fn overlapping_encodings() {
    let Some(tools) = Tools::find_or_skip() else { return };
    let all = cases(&charts_folder()).into_iter().chain(cases(&vectors_folder()).into_iter().filter(|c| c.overlapping));
    let mut jobs = Vec::new();
    let mut expected = Vec::new();
    for case in all {
        for encoding in Encoding::ALL.into_iter().filter(|encoding| encoding.overlaps()) {
            let (chart, stimuli) = prepared(&case);
            let options = Options { profile: case.profile, encoding, simplify: true };
            let program = compile(&chart, &options).unwrap_or_else(|fault| panic!("{fault}"));
            let evaluated = runs::run(&program, &stimuli);
            if case.overlapping {
                assert_eq!(spell(&chart, &stimuli, &evaluated), case.expected, "{}", case.name);
            }
            expected.push((format!("{}, {}", case.name, encoding.name()), evaluated));
            jobs.push(Job { program, stimuli });
        }
    }
    for body in [Body::St, Body::Il, Body::Ld] {
        for ((name, expected), actual) in expected.iter().zip(run(&tools, &Source::Programs(body), &jobs)) {
            assert_eq!(actual.as_ref(), Ok(expected), "{name}, {body:?}");
        }
    }
}

/// To stability and scan by scan.
#[test]
fn random_ladders() {
    random_charts_agree("plcopen:ld", 1000..1010, ChartKind::Hierarchical, |text| text, 5);
}

/// Of the whole language hardly any chart is one. Of the plain ones many are, also with
/// delays and falling edges, and with those of steps.
#[test]
fn random_sequential_function_charts() {
    random_charts_agree("plcopen:sfc", 0..200, ChartKind::Plain, |text| text, 30);
    random_charts_agree("plcopen:sfc", 200..500, ChartKind::Plain, with_delays, 30);
    random_charts_agree("plcopen:sfc", 500..900, ChartKind::Plain, of_steps, 30);
}
