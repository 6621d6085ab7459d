//! `grafc sim --batch`. Expectations are written by hand from the rules of evolution.

mod common;

use common::{FAULTY, Folder, VALVE};

/// The files of a folder below.
fn folder(files: &[(&str, &str)]) -> Folder {
    let folder = Folder::new(&[("valve.gct", VALVE), ("faulty.gct", FAULTY)]);
    std::fs::create_dir(folder.path("in")).unwrap();
    for (name, text) in files {
        std::fs::write(folder.path("in").join(name), text).unwrap();
    }
    folder
}

const OPEN: &str = "t_ms,a,b\n0,0,0\n10,1,0\n";
const CLOSE: &str = "t_ms,b,a\n0,0,1\n5,1,0\n9,0,0\n";

#[test]
fn each_trace_has_a_result_of_its_name() {
    let folder = folder(&[("open.csv", OPEN), ("close.csv", CLOSE), ("notes.txt", "no trace")]);
    let run = folder.run(&["sim", "valve.gct", "--batch", "in", "-o", "out/deep"]);
    assert_eq!(run.is_done().out, "2 traces were run: out/deep\n");
    assert_eq!(folder.read("out/deep/open.csv"), "t_ms,V,situation,flags\n0,0,1,\n10,1,2,\n");
    assert_eq!(folder.read("out/deep/close.csv"), "t_ms,V,situation,flags\n0,1,2,\n5,0,1,\n9,0,1,\n");
    assert_eq!(Folder::names_in(&folder.path("out/deep")), ["close.csv", "open.csv"]);
}

/// All errors of all traces come in one run; the others have their results.
#[test]
fn a_faulty_trace_has_no_result() {
    let folder = folder(&[("a.csv", "t_ms,a\n0,0\n5,x\n6,y\n"), ("b.csv", OPEN), ("c.csv", "t_ms,nobody\n0,1\n")]);
    let run = folder.run(&["sim", "valve.gct", "--batch", "in", "-o", "out"]);
    run.ends(1, "a.csv:3:3").ends(1, "a.csv:4:3").ends(1, "c.csv:1:6").ends(1, "3 errors");
    assert_eq!(run.out, "");
    assert_eq!(Folder::names_in(&folder.path("out")), ["b.csv"]);
    folder.run(&["sim", "faulty.gct", "--batch", "in", "-o", "none"]).ends(1, "faulty.gct:6:25");
    assert!(!folder.path("none").exists());
}

/// What a trace breaks is said of that trace, and its result is there.
#[test]
fn claims_are_watched() {
    let folder = folder(&[("open.csv", OPEN), ("rest.csv", "t_ms,a\n0,0\n")]);
    std::fs::write(folder.path("claim.gct"), format!("{VALVE}assert \"closed\" : not V\n")).unwrap();
    let run = folder.run(&["sim", "claim.gct", "--batch", "in", "-o", "out"]);
    run.ends(1, "error[E0609]").ends(1, "open.csv:3:1").ends(1, "1 error");
    assert_eq!(Folder::names_in(&folder.path("out")), ["open.csv", "rest.csv"]);
}

#[test]
fn wrong_use_is_refused() {
    let folder = folder(&[("open.csv", OPEN)]);
    folder.run(&["sim", "valve.gct", "--batch", "in", "-o", "in"]).ends(2, "would overwrite the traces");
    folder.run(&["sim", "valve.gct", "--batch", "in", "-o", "-"]).ends(2, "name a folder");
    folder.run(&["sim", "valve.gct", "--batch", "in", "-o", "valve.gct"]).ends(2, "`valve.gct` is no folder");
    folder.run(&["sim", "valve.gct", "--batch", "in"]).ends(2, "--output");
    folder.run(&["sim", "valve.gct"]).ends(2, "--trace");
    folder.run(&["sim", "valve.gct", "--batch", "in", "-o", "out", "--events"]).ends(2, "--events");
    folder.run(&["sim", "valve.gct", "--batch", "nowhere", "-o", "out"]).ends(3, "nowhere");
    std::fs::create_dir(folder.path("empty")).unwrap();
    folder.run(&["sim", "valve.gct", "--batch", "empty", "-o", "out"]).ends(2, "has no traces");
    assert!(!folder.path("out").exists());
}
