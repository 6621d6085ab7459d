//! `grafc sim`. Expectations are written by hand from the rules of evolution.

mod common;

use common::{FAULTY, Place, VALVE};

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
    let place = Place::new(&[("valve.gct", VALVE), ("in.csv", TRACE)]);
    assert_eq!(place.run(&["sim", "valve.gct", "--trace", "in.csv"]).is_done().out, RESULT);
    assert_eq!(place.run(&["sim", "valve.gct", "--trace", "in.csv", "-o", "out.csv"]).is_done().out, "");
    assert_eq!(place.read("out.csv"), RESULT);
    assert_eq!(place.run_with(&["sim", "-", "--trace", "in.csv"], VALVE).is_done().out, RESULT);
    assert_eq!(place.run_with(&["sim", "valve.gct", "--trace", "-"], TRACE).is_done().out, RESULT);
}

#[test]
fn a_stable_evolution_passes_through_what_a_scan_shows() {
    let place = Place::new(&[("t.gct", TRANSIENT), ("in.csv", "t_ms,a\n0,0\n10,1\n20,1\n30,0\n")]);
    let stable = "t_ms,V,W,situation,flags\n0,0,0,1,\n10,0,1,3,\n20,0,1,3,\n30,0,0,1,\n";
    let scan = "t_ms,V,W,situation,flags\n0,0,0,1,\n10,1,0,2,\n20,0,1,3,\n30,0,0,1,\n";
    assert_eq!(place.run(&["sim", "t.gct", "--trace", "in.csv"]).out, stable);
    assert_eq!(place.run(&["sim", "t.gct", "--trace", "in.csv", "--evolution", "scan"]).out, scan);
}

#[test]
fn a_bound_on_evolutions_raises_livelock() {
    let place = Place::new(&[("t.gct", TRANSIENT), ("in.csv", "t_ms,a\n0,0\n10,1\n")]);
    let expected = "t_ms,V,W,situation,flags\n0,0,0,1,\n10,1,0,2,LIVELOCK\n";
    assert_eq!(place.run(&["sim", "t.gct", "--trace", "in.csv", "--bound", "1"]).out, expected);
}

#[test]
fn faults_of_chart_or_trace_stop_without_output() {
    let place = Place::new(&[("valve.gct", VALVE), ("faulty.gct", FAULTY), ("in.csv", TRACE)]);
    std::fs::write(place.path("bad.csv"), "t_ms,nobody\n0,1\n").unwrap();
    let run = place.run(&["sim", "faulty.gct", "--trace", "in.csv", "-o", "out.csv"]);
    run.ends(1, "faulty.gct:6:25");
    let run = place.run(&["sim", "valve.gct", "--trace", "bad.csv", "-o", "out.csv"]);
    run.ends(1, "error[E0602]").ends(1, "bad.csv:1:6");
    let run = place.run(&["sim", "valve.gct", "--trace", "bad.csv", "--format", "json"]);
    assert_eq!(serde_json::from_str::<serde_json::Value>(run.err.trim_end()).unwrap()["file"], "bad.csv");
    assert_eq!(run.out, "");
    assert!(!place.path("out.csv").exists());
}

#[test]
fn wrong_use_and_refusals() {
    let place = Place::new(&[("valve.gct", VALVE), ("in.csv", TRACE)]);
    place.run(&["sim", "valve.gct"]).ends(2, "--trace");
    place.run(&["sim", "-", "--trace", "-"]).ends(2, "standard input is named twice");
    place.run(&["sim", "valve.gct", "--trace", "in.csv", "-o", "in.csv"]).ends(2, "overwrite `in.csv`");
    place.run(&["sim", "valve.gct", "--trace", "in.csv", "-o", "valve.gct"]).ends(2, "overwrite `valve.gct`");
    place.run(&["sim", "valve.gct", "--trace", "none.csv"]).ends(3, "cannot read `none.csv`");
    assert_eq!(place.read("in.csv"), TRACE);
}
