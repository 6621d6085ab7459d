//! The deliberate faults that `cargo run --release -p grafc-testsuite --bin mutants` tries still apply to the compiler.

use grafc_testsuite::mutants::run::suites;
use grafc_testsuite::mutants::{Fault, all, faults_that_do_not_apply, with_faults};
use std::collections::BTreeSet;
use std::path::Path;

#[test]
fn each_fault_has_its_place() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let complaints = faults_that_do_not_apply(&root);
    assert!(complaints.is_empty(), "{}", complaints.join("\n"));
}

#[test]
fn each_fault_is_one_and_has_a_name() {
    let names: BTreeSet<&str> = all().map(|fault| fault.name).collect();
    assert_eq!(names.len(), all().count(), "two faults have one name");
    assert!(names.len() >= 50, "only {} faults", names.len());
    for Fault { name, text, instead, breaks, .. } in all() {
        assert!(text != instead && !breaks.is_empty(), "`{name}` is none");
        assert!(
            name.bytes().all(|byte| byte.is_ascii_lowercase() || byte == b'-' || byte.is_ascii_digit()),
            "`{name}`"
        );
    }
}

/// Each backend that has rules of its own has faults of its own, and tests that should notice them.
#[test]
fn each_backend_has_faults() {
    for folder in ["st", "il", "awl", "rust", "plcopen/ld", "plcopen/sfc"] {
        let folder = format!("backends/src/{folder}/");
        let faults: Vec<&Fault> = all().filter(|fault| fault.file.starts_with(&folder)).collect();
        assert!(faults.len() >= 4, "{folder}: {}", faults.len());
        assert!(faults.iter().all(|fault| suites(fault).len() > 1), "{folder}");
    }
}

#[test]
fn a_text_that_is_not_there_or_there_twice_is_told() {
    let fault = all().next().expect("a fault");
    assert!(fault.place("nothing of the kind").is_err());
    assert!(fault.place(&fault.text.repeat(2)).is_err());
    assert_eq!(fault.place(&format!("12{}", fault.text)), Ok(2));
    // A file with faults in which none of them has its place.
    assert!(with_faults(fault.file, "").is_err());
    assert_eq!(with_faults("README.md", "as it was").as_deref(), Ok("as it was"));
}
