//! `grafc fmt`.

mod common;

use common::{FAULTY, Folder, VALVE};

/// The valve, as nobody should write it.
fn untidy() -> String {
    VALVE.replace("  step 2 { V }", "      step    2{V}").replace("input  a, b : bool", "input a,b:bool")
}

#[test]
fn charts_are_changed_in_place_and_then_stay() {
    let folder = Folder::new(&[("a.gct", &untidy())]);
    assert_eq!(folder.run(&["fmt", "a.gct"]).is_done().out, "");
    let once = folder.read("a.gct");
    assert_ne!(once, untidy());
    assert!(once.contains("step 2"), "{once}");
    folder.run(&["fmt", "a.gct"]).is_done();
    assert_eq!(folder.read("a.gct"), once);
    assert_eq!(folder.names(), ["a.gct"]);
}

#[test]
fn standard_input_goes_to_standard_output() {
    let folder = Folder::new(&[("a.gct", &untidy())]);
    let run = folder.run_with(&["fmt", "-"], untidy());
    folder.run(&["fmt", "a.gct"]);
    assert_eq!(run.is_done().out, folder.read("a.gct"));
}

#[test]
fn check_names_what_would_change_and_changes_nothing() {
    let folder = Folder::new(&[("a.gct", &untidy()), ("b.gct", VALVE)]);
    folder.run(&["fmt", "b.gct"]).is_done();
    let run = folder.run(&["fmt", "--check", "a.gct", "b.gct"]);
    assert_eq!((run.code, run.out.as_str(), run.err.as_str()), (1, "a.gct\n", ""));
    assert_eq!(folder.read("a.gct"), untidy());
    folder.run(&["fmt", "--check", "b.gct"]).is_done();
    assert_eq!(folder.run_with(&["fmt", "--check", "-"], untidy()).ends(1, "").out, "<stdin>\n");
    assert_eq!(folder.run_with(&["fmt", "--check", "-"], folder.read("b.gct")).is_done().out, "");
}

#[test]
fn a_file_that_is_right_is_not_touched() {
    let folder = Folder::new(&[("a.gct", VALVE)]);
    folder.run(&["fmt", "a.gct"]).is_done();
    let before = std::fs::metadata(folder.path("a.gct")).unwrap().modified().unwrap();
    std::thread::sleep(std::time::Duration::from_millis(20));
    folder.run(&["fmt", "a.gct"]).is_done();
    assert_eq!(std::fs::metadata(folder.path("a.gct")).unwrap().modified().unwrap(), before);
}

#[test]
fn a_chart_that_cannot_be_parsed_is_left_alone_and_others_are_not() {
    let broken = "step { \n";
    let folder = Folder::new(&[("broken.gct", broken), ("a.gct", &untidy())]);
    folder.run(&["fmt", "broken.gct", "missing.gct", "a.gct"]).ends(3, "broken.gct:1").ends(3, "missing.gct");
    assert_eq!(folder.read("broken.gct"), broken);
    assert_ne!(folder.read("a.gct"), untidy());
    let run = folder.run(&["fmt", "--check", "broken.gct"]);
    assert_eq!(run.ends(1, "error[E01").out, "");
    assert_eq!(folder.run_with(&["fmt", "-"], broken).ends(1, "<stdin>:1").out, "");
}

#[test]
fn what_is_wrong_with_its_meaning_does_not_matter() {
    let folder = Folder::new(&[("faulty.gct", FAULTY)]);
    folder.run(&["fmt", "faulty.gct"]).is_done();
}
