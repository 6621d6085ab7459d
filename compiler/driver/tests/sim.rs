//! `grafc sim`. Expectations are written by hand from the rules of evolution.

mod common;

use common::{FAULTY, Folder, VALVE};

const TRACE: &str = "t_ms,a,b\n0,0,0\n10,1,0\n20,0,0\n30,0,1\n40,0,0\n";
const RESULT: &str = "t_ms,V,situation,flags\n0,0,1,\n10,1,2,\n20,1,2,\n30,0,1,\n40,0,1,\n";

/// Step 2 is left as soon as it is entered.
const TRANSIENT: &str = "\
input  a : bool
output V, W : bool
initial step 1
step 2 { V }
step 3 { W }
transition 1 -> 2 : a
transition 2 -> 3 : 1
transition 3 -> 1 : not a
";

#[test]
fn a_trace_of_inputs_becomes_a_trace_of_outputs() {
    let folder = Folder::new(&[("valve.gct", VALVE), ("in.csv", TRACE)]);
    assert_eq!(folder.run(&["sim", "valve.gct", "--trace", "in.csv"]).is_done().out, RESULT);
    assert_eq!(folder.run(&["sim", "valve.gct", "--trace", "in.csv", "-o", "out.csv"]).is_done().out, "");
    assert_eq!(folder.read("out.csv"), RESULT);
    assert_eq!(folder.run_with(&["sim", "-", "--trace", "in.csv"], VALVE).is_done().out, RESULT);
    assert_eq!(folder.run_with(&["sim", "valve.gct", "--trace", "-"], TRACE).is_done().out, RESULT);
}

#[test]
fn a_stable_evolution_passes_through_what_a_scan_shows() {
    let folder = Folder::new(&[("t.gct", TRANSIENT), ("in.csv", "t_ms,a\n0,0\n10,1\n20,1\n30,0\n")]);
    let stable = "t_ms,V,W,situation,flags\n0,0,0,1,\n10,0,1,3,\n20,0,1,3,\n30,0,0,1,\n";
    let scan = "t_ms,V,W,situation,flags\n0,0,0,1,\n10,1,0,2,\n20,0,1,3,\n30,0,0,1,\n";
    assert_eq!(folder.run(&["sim", "t.gct", "--trace", "in.csv"]).out, stable);
    assert_eq!(folder.run(&["sim", "t.gct", "--trace", "in.csv", "--evolution", "scan"]).out, scan);
}

#[test]
fn a_bound_on_evolutions_raises_livelock() {
    let folder = Folder::new(&[("t.gct", TRANSIENT), ("in.csv", "t_ms,a\n0,0\n10,1\n")]);
    let expected = "t_ms,V,W,situation,flags\n0,0,0,1,\n10,1,0,2,LIVELOCK\n";
    assert_eq!(folder.run(&["sim", "t.gct", "--trace", "in.csv", "--bound", "1"]).out, expected);
}

#[test]
fn faults_of_chart_or_trace_stop_without_output() {
    let folder = Folder::new(&[("valve.gct", VALVE), ("faulty.gct", FAULTY), ("in.csv", TRACE)]);
    std::fs::write(folder.path("bad.csv"), "t_ms,nobody\n0,1\n").unwrap();
    let run = folder.run(&["sim", "faulty.gct", "--trace", "in.csv", "-o", "out.csv"]);
    run.ends(1, "faulty.gct:6:25");
    let run = folder.run(&["sim", "valve.gct", "--trace", "bad.csv", "-o", "out.csv"]);
    run.ends(1, "error[E0602]").ends(1, "bad.csv:1:6");
    let run = folder.run(&["sim", "valve.gct", "--trace", "bad.csv", "--format", "json"]);
    assert_eq!(serde_json::from_str::<serde_json::Value>(run.err.trim_end()).unwrap()["file"], "bad.csv");
    assert_eq!(run.out, "");
    assert!(!folder.path("out.csv").exists());
}

#[test]
fn a_recording_that_agrees_is_said_to() {
    let folder = Folder::new(&[("valve.gct", VALVE), ("in.csv", TRACE), ("whole.csv", RESULT)]);
    let run = folder.run(&["sim", "valve.gct", "--trace", "in.csv", "--against", "whole.csv"]);
    assert_eq!(run.is_done().out, "5 rows agree\n");
    // Some columns in any order, those of inputs, fewer rows, a time between two calls, empty cells.
    std::fs::write(folder.path("part.csv"), "t_ms,V,a\n0,0,0\n10,1,1\n25,,0\n40,0,0\n").unwrap();
    let run = folder.run(&["sim", "valve.gct", "--trace", "in.csv", "--against", "part.csv"]);
    assert_eq!(run.is_done().out, "4 rows agree\n");
    // The result is written where it is asked for.
    let run = folder.run(&["sim", "valve.gct", "--trace", "in.csv", "--against", "part.csv", "-o", "out.csv"]);
    assert_eq!(run.is_done().out, "");
    assert_eq!(folder.read("out.csv"), RESULT);
}

#[test]
fn the_first_difference_from_a_recording_is_told_in_the_words_of_the_chart() {
    let folder = Folder::new(&[("valve.gct", VALVE), ("in.csv", TRACE)]);
    let run = |recorded: &str| {
        std::fs::write(folder.path("plc.csv"), recorded).unwrap();
        folder.run(&["sim", "valve.gct", "--trace", "in.csv", "--against", "plc.csv", "-o", "out.csv"])
    };
    // At 30 ms `b` closes the valve; the recording has it open, at 40 ms as well.
    let late = run("t_ms,V,situation,flags\n0,0,1,\n10,1,2,\n20,1,2,\n30,1,2,\n40,1,2,\n");
    late.ends(1, "error[E0605]: at 30 ms step `2` is active and should not be").ends(1, "plc.csv:5:6");
    late.ends(1, "step `1` should be active and is not").ends(1, "output `V` is 1 and should be 0");
    assert!(!late.err.contains("at 40 ms"), "{}", late.err);
    assert!(!folder.path("out.csv").exists());
    let flag = run("t_ms,flags\n0,LIVELOCK\n");
    flag.ends(1, "at 0 ms flag LIVELOCK is raised and should not be");
    // The second of two calls in one millisecond is not the first.
    std::fs::write(folder.path("in.csv"), "t_ms,a,b\n5,0,0\n5,1,0\n").unwrap();
    run("t_ms,V\n5,0\n5,1\n").is_done();
    run("t_ms,V\n5,0\n5,0\n").ends(1, "at 5 ms output `V` is 0 and should be 1").ends(1, "plc.csv:3:3");
    run("t_ms,V\n4,0\n").ends(1, "at 4 ms the chart has not been called yet");
}

#[test]
fn faults_of_a_recording_are_reported_together() {
    let folder = Folder::new(&[("valve.gct", VALVE), ("in.csv", TRACE)]);
    std::fs::write(folder.path("plc.csv"), "t_ms,V,W,situation,flags,V\n0,x,0,9,OOPS,0\n10,1\n5,1,1,1,,1\n").unwrap();
    let run = folder.run(&["sim", "valve.gct", "--trace", "in.csv", "--against", "plc.csv"]);
    for message in [
        "error[E0602]: the chart has no input or output `W`",
        "error[E0601]: column `V` appears twice",
        "error[E0603]: `x` is not a value of `V`",
        "error[E0603]: `9` is not a step of the chart",
        "error[E0603]: `OOPS` is not a flag",
        "error[E0601]: the row has 2 cells, the header has 6",
    ] {
        run.ends(1, message);
    }
    assert!(!run.err.contains("E0605"), "{}", run.err);
    folder.run(&["sim", "valve.gct", "--trace", "-", "--against", "-"]).ends(2, "standard input is named twice");
    let over = ["sim", "valve.gct", "--trace", "in.csv", "--against", "plc.csv", "-o", "plc.csv"];
    folder.run(&over).ends(2, "overwrite `plc.csv`");
}

#[test]
fn wrong_use_and_refusals() {
    let folder = Folder::new(&[("valve.gct", VALVE), ("in.csv", TRACE)]);
    folder.run(&["sim", "valve.gct"]).ends(2, "--trace");
    folder.run(&["sim", "-", "--trace", "-"]).ends(2, "standard input is named twice");
    folder.run(&["sim", "valve.gct", "--trace", "in.csv", "-o", "in.csv"]).ends(2, "overwrite `in.csv`");
    folder.run(&["sim", "valve.gct", "--trace", "in.csv", "-o", "valve.gct"]).ends(2, "overwrite `valve.gct`");
    folder.run(&["sim", "valve.gct", "--trace", "none.csv"]).ends(3, "cannot read `none.csv`");
    assert_eq!(folder.read("in.csv"), TRACE);
}
