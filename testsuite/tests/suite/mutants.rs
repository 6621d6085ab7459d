//! The deliberate faults that `cargo run --release -p grafc-testsuite --bin mutants` tries still apply to the compiler.

use grafc_testsuite::binary::root;
use grafc_testsuite::mutants::run::suites;
use grafc_testsuite::mutants::{Fault, Part, Places, all, faulty_files, places};
use grafc_testsuite::tools::{Tool, or_skip};
use std::collections::BTreeSet;
use std::io::Write;
use std::process::{Command, Stdio};

#[test]
fn each_fault_has_its_place() {
    let Places { found, complaints } = places(&root()).expect("the compiler's files");
    assert!(complaints.is_empty(), "{}", complaints.join("\n"));
    assert_eq!(found.len(), all().count());
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
    for part in Part::ALL.into_iter().filter(|part| !matches!(part, Part::Restoring | Part::Shared | Part::Braces)) {
        let faults: Vec<&Fault> = all().filter(|fault| fault.at.part == part).collect();
        assert!(faults.len() >= 4, "{part:?}: {}", faults.len());
        assert!(faults.iter().all(|fault| suites(fault).len() > 1), "{part:?}");
    }
}

/// Each file has its faults beside its right texts, and nothing else has changed.
#[test]
fn faults_stand_beside_what_is_right() {
    let files = faulty_files(&root()).expect("faults that have their places");
    let found = places(&root()).expect("the compiler's files").found;
    for (file, faulty) in &files {
        let right = std::fs::read_to_string(root().join(file)).expect("the file");
        let own: Vec<_> = found.iter().filter(|(_, place)| place.file == *file).collect();
        let chosen = faulty.matches("static CHOSEN: std::sync::LazyLock<bool>").count();
        assert_eq!(chosen, own.len(), "{file}");
        let mut done = 0;
        for (fault, place) in own {
            assert!(faulty.contains(&format!("name == {:?}", fault.name)), "{}", fault.name);
            assert!(faulty.contains(&right[done..place.range.start]), "{}", fault.name);
            assert!(faulty.contains(&right[place.range.clone()]), "{}", fault.name);
            done = place.range.end;
        }
        assert!(faulty.ends_with(&right[done..]), "{file}");
    }
}

/// The text of a fault is an expression, or statements: with the choice in its place the file is still Rust.
/// Right and wrong stand beside each other in blocks of their own, from which no name comes out.
#[test]
fn no_fault_declares_a_name() {
    for fault in all() {
        assert!(!fault.text.starts_with("let "), "{}: `{}`", fault.name, fault.text);
    }
}

#[test]
fn what_has_faults_is_rust_all_the_same() {
    let here = Command::new("rustfmt").arg("--version").output().is_ok_and(|output| output.status.success());
    let Some(()) = or_skip(Tool::Rustfmt, here.then_some(()).ok_or_else(|| "rustfmt cannot be called".to_owned()))
    else {
        return;
    };
    let mut refused = Vec::new();
    for (file, faulty) in faulty_files(&root()).expect("faults that have their places") {
        let mut rustfmt = Command::new("rustfmt");
        rustfmt.args(["--edition", "2024"]).stdin(Stdio::piped()).stdout(Stdio::null()).stderr(Stdio::piped());
        let mut child = rustfmt.spawn().expect("a tool that was there before");
        let mut input = child.stdin.take().expect("it is piped");
        input.write_all(faulty.as_bytes()).expect("it reads");
        drop(input);
        let output = child.wait_with_output().expect("it ends");
        if !output.status.success() {
            refused.push(format!("{file}: {}", String::from_utf8_lossy(&output.stderr)));
        }
    }
    assert!(refused.is_empty(), "{}", refused.join("\n"));
}
