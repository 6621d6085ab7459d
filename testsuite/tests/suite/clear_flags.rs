//! `clear_flags` of generated Rust: a flag whose cause is over stays down, one whose cause lasts is raised again; and it is
//! forgotten which assertion was false.

use grafc_backends::rust::{self, Runtime};
use grafc_logic::{Encoding, Options};
use grafc_model::chart::{Chart, ControlNames};
use grafc_testsuite::charts::check;
use grafc_testsuite::executors::rust::Tools;
use grafc_testsuite::runs::compile_saved;
use std::fs;

/// Two grafcets of one level order different situations of a third while `a` and `b`.
const ORDERS: &str = "\
chart Orders
input a, b : bool
output V : bool
grafcet A { initial step 1 step 2 { force G{31} } transition 1 -> 2 : a transition 2 -> 1 : not a }
grafcet B { initial step 11 step 12 { force G{32} } transition 11 -> 12 : b transition 12 -> 11 : not b }
grafcet G { initial step 30 step 31 { V } step 32 transition 30 -> 31, 32 : a and b and not a transition 31, 32 -> 30 : 1 }
";

/// The orders disagree in each micro-step (R5) of the calls with both inputs, so that the flag is raised in each of these,
/// whether or not it was lowered before, and in no other.
const MAIN: &str = r#"
fn main() {
    use orders::{Inputs, Orders};
    let mut chart = Orders::new();
    let mut raised = |clear: bool, a: bool, b: bool, now: u32| {
        if clear {
            chart.clear_flags();
            assert!(!chart.flags().force_conflict);
        }
        chart.scan(&Inputs { a, b }, now.into());
        chart.flags().force_conflict
    };
    assert!(!raised(false, false, false, 0));
    assert!(!raised(false, true, false, 10));
    assert!(raised(false, true, true, 20));
    assert!(raised(false, true, true, 30));
    assert!(raised(true, true, true, 40), "its cause lasts");
    assert!(raised(true, true, true, 50), "its cause lasts, once more");
    assert!(raised(false, true, false, 60), "nobody lowered it");
    assert!(!raised(true, true, false, 70), "its cause is over");
    assert!(!raised(false, true, false, 80));
    assert!(raised(false, true, true, 90));
}
"#;

/// The second assertion is false while `a`, the first while `b`; the number of the first that was false stays.
const CLAIMS: &str = "\
chart Claims
input a, b : bool
initial step 1
assert not X1 or not b
assert not a
";

const CLAIMS_MAIN: &str = r#"
fn main() {
    use claims::{Claims, Inputs};
    let mut chart = Claims::new();
    let mut told = |a: bool, b: bool, now: u32| chart.scan(&Inputs { a, b }, now.into()).assertion;
    assert_eq!(told(false, false, 0), 0);
    assert_eq!(told(true, false, 10), 2);
    assert_eq!(told(false, true, 20), 2, "it stays");
    chart.clear_flags();
    assert_eq!(chart.outputs().assertion, 0);
    let mut told = |a: bool, b: bool, now: u32| chart.scan(&Inputs { a, b }, now.into()).assertion;
    assert_eq!(told(false, false, 30), 0, "none is false any more");
    assert_eq!(told(true, true, 40), 1);
}
"#;

#[test]
fn a_flag_is_raised_again_while_its_cause_lasts() {
    play("orders", &check("orders", ORDERS).expect("a chart without errors"), MAIN);
}

#[test]
fn which_assertion_was_false_is_forgotten_with_the_flags() {
    let mut chart = check("claims", CLAIMS).expect("a chart without errors");
    let names = ControlNames { check_assertions: true, ..ControlNames::default() };
    assert!(chart.control(&names).is_ok());
    play("claims", &chart, CLAIMS_MAIN);
}

/// Runs a chart as generated Rust in each encoding.
fn play(name: &str, chart: &Chart, main: &str) {
    let Some(tools) = Tools::find_or_skip() else { return };
    for encoding in Encoding::ALL {
        let Ok(program) = compile_saved(chart, &Options { encoding, ..Options::default() }) else { continue };
        let options = rust::Options { module: Some(name.into()), runtime: Runtime::Crate, ..rust::Options::default() };
        let module = rust::emit(&program, &options).expect("a module");
        let folder = tempfile::tempdir().expect("a temporary folder");
        fs::write(folder.path().join("main.rs"), module + main).expect("a file in a temporary folder");
        tools.build(folder.path()).unwrap_or_else(|said| panic!("{}: {said}", encoding.name()));
        tools.play(folder.path()).unwrap_or_else(|said| panic!("{}: {said}", encoding.name()));
    }
}
