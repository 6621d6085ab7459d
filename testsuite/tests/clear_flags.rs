//! `clear_flags` of generated Rust: a flag whose cause is over stays down, one whose cause lasts is raised again.

use grafc_backends::rust::{self, Runtime};
use grafc_logic::{Encoding, Options};
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

#[test]
fn a_flag_is_raised_again_while_its_cause_lasts() {
    let Some(tools) = Tools::find_or_skip() else { return };
    let chart = check("orders", ORDERS).expect("a chart without errors");
    for encoding in Encoding::ALL {
        let Ok(program) = compile_saved(&chart, &Options { encoding, ..Options::default() }) else { continue };
        let options =
            rust::Options { module: Some("orders".into()), runtime: Runtime::Crate, ..rust::Options::default() };
        let module = rust::emit(&program, &options).expect("a module");
        let folder = tempfile::tempdir().expect("a temporary folder");
        fs::write(folder.path().join("main.rs"), module + MAIN).expect("a file in a temporary folder");
        tools.build(folder.path()).unwrap_or_else(|said| panic!("{}: {said}", encoding.name()));
        tools.play(folder.path()).unwrap_or_else(|said| panic!("{}: {said}", encoding.name()));
    }
}
