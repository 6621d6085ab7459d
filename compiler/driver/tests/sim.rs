//! `grafc sim`. Expectations are written by hand from the rules of evolution.

mod common;

use common::{FAULTY, Folder, Run, VALVE};

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

/// A recording that was cut off, or has other columns, is no proof of anything.
#[test]
fn a_recording_that_says_nothing_is_refused() {
    let folder = Folder::new(&[("valve.gct", VALVE), ("in.csv", TRACE)]);
    let run = |recorded: &str| {
        std::fs::write(folder.path("plc.csv"), recorded).unwrap();
        folder.run(&["sim", "valve.gct", "--trace", "in.csv", "--against", "plc.csv"])
    };
    for (recorded, fault) in [
        ("t_ms,V\n", "the recording has no row"),
        ("t_ms\n0\n10\n", "the recording has no column that is compared"),
        ("t_ms\n", "the recording has no column that is compared"),
        ("t_ms,a\n0,1\n", "the recording has no column that is compared"),
        ("t_ms,V\n0,\n10,\n", "the recording has no value that is compared"),
    ] {
        let refused = run(recorded);
        refused.ends(1, &format!("error[E0601]: {fault}")).ends(1, "plc.csv:1:1").ends(1, "help: record `t_ms` with");
        assert_eq!(refused.out, "", "{recorded}");
    }
    run("").ends(1, "error[E0601]");
    // What is wrong with its header is the reason then.
    let wrong = run("t_ms,W\n0,1\n");
    assert!(wrong.err.contains("E0602") && !wrong.err.contains("E0601"), "{}", wrong.err);
    assert_eq!(run("t_ms,V\n0,0\n").is_done().out, "1 row agrees\n");
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
        "the flags are LIVELOCK, ALLOC_CONFLICT, FORCE_CONFLICT, DIV0",
        "error[E0601]: the row has 2 cells, the header has 6",
    ] {
        run.ends(1, message);
    }
    assert!(!run.err.contains("E0605"), "{}", run.err);
    folder.run(&["sim", "valve.gct", "--trace", "-", "--against", "-"]).ends(2, "standard input is named twice");
    let over = ["sim", "valve.gct", "--trace", "in.csv", "--against", "plc.csv", "-o", "plc.csv"];
    folder.run(&over).ends(2, "overwrite `plc.csv`");
}

/// Rows that differ from the header as each other are told once, for it is the header that is wrong; one that fits ends that.
#[test]
fn a_wrong_header_is_told_once() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    let sim = |rows: &str| {
        std::fs::write(folder.path("in.csv"), format!("t_ms,a\n{rows}")).unwrap();
        folder.run(&["sim", "valve.gct", "--trace", "in.csv", "-q"])
    };
    let told = |run: &Run| run.err.matches("error[E0601]").count();
    let all = sim("0,0,0\n1,0,0\n2,0,0\n");
    all.ends(1, "the row has 3 cells, the header has 2").ends(1, "the 2 rows after it are like this");
    assert_eq!(told(&all), 1, "{}", all.err);
    assert_eq!(told(&sim("0,0,0\n1,0,0\n2,0\n3,0,0\n4,0\n5,0,0\n")), 3);
    assert_eq!(told(&sim("0,0,0\n1,0,0\n2\n3\n")), 3);
}

#[test]
fn quotes_end_where_their_cells_do() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    let sim = |text: &str| {
        std::fs::write(folder.path("in.csv"), text).unwrap();
        folder.run(&["sim", "valve.gct", "--trace", "in.csv", "-q"])
    };
    sim("t_ms,a\n0,\"1\"0\n5,0\n")
        .ends(1, "error[E0601]: there is something behind the closing quote")
        .ends(1, "in.csv:2:6");
    sim("t_ms,a\n0,\"1\n").ends(1, "error[E0601]: a quote is not closed").ends(1, "in.csv:2:3");
    sim("t_ms,\"a\"b\n0,1\n").ends(1, "there is something behind the closing quote");
    sim("t_ms,\"a\"\n0,\"1\"\n").is_done();
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

/// A second in step 1, half a second in step 2, while `run`.
const BLINK: &str = "input run : bool
output lamp : bool
var n : int
initial step 1
step 2 { lamp  n := n + 1 on activation }
transition 1 -> 2 : run and 1s/X1
transition 2 -> 1 : [T2 >= 500ms]
";

#[test]
fn calls_between_the_rows() {
    let folder = Folder::new(&[("b.gct", BLINK), ("in.csv", "t_ms,run\n0,1\n2600,0\n5000,\n")]);
    let sim = |options: &[&str]| folder.run(&[&["sim", "b.gct", "--trace", "in.csv"], options].concat());
    // Step 1 until 1000, step 2 until 1500, step 1 until 2500, step 2 until 3000, and then nothing any more.
    let events = "0,0,1,\n1000,1,2,\n1500,0,1,\n2500,1,2,\n2600,1,2,\n3000,0,1,\n4000,0,1,\n5000,0,1,\n";
    assert_eq!(sim(&["--events"]).is_done().out, format!("t_ms,lamp,situation,flags\n{events}"));
    // Every 700 ms: the second is over at 1400, the half second at 2100.
    let scans =
        "0,0,1,\n700,0,1,\n1400,1,2,\n2100,0,1,\n2600,0,1,\n2800,0,1,\n3500,0,1,\n4200,0,1,\n4900,0,1,\n5000,0,1,\n";
    assert_eq!(sim(&["--scan", "700ms"]).is_done().out, format!("t_ms,lamp,situation,flags\n{scans}"));
    let rows = sim(&[]);
    assert_eq!(rows.out, "t_ms,lamp,situation,flags\n0,0,1,\n2600,0,1,\n5000,0,1,\n");
    assert!(rows.err.contains("warning[W0601]: at 1000 ms") && rows.err.contains("in.csv:3:1"), "{}", rows.err);
    sim(&["--scan", "700ms", "--events"]).ends(2, "--events");
    for wrong in ["5", "0ms", "0.5ms", "ms", "2d"] {
        sim(&["--scan", wrong]).ends(2, "--scan");
    }
    sim(&["--scan", "25d"]).ends(2, "--scan");
    sim(&["--scan", "600h"]).ends(2, "a period is at most 2147483647ms");
    sim(&["--scan", "1ms", "--bound", "2"]).is_done();
}

#[test]
fn what_would_do_nothing_is_refused() {
    let folder = Folder::new(&[("valve.gct", VALVE), ("in.csv", TRACE)]);
    for option in [["--bound", "9"], ["--bound", "auto"], ["--livelock-outputs", "computed"]] {
        let with =
            |evolution| [&["sim", "valve.gct", "--trace", "in.csv", "--evolution", evolution], &option[..]].concat();
        let said = format!("so `{}` would do nothing", option[0]);
        folder.run(&with("scan")).ends(2, &said).ends(2, "leave one of the two out");
        folder.run(&with("stable")).is_done();
    }
}

#[test]
fn a_trace_that_sees_each_end_of_a_delay_gets_no_warning() {
    let trace = "t_ms,run\n0,1\n1000,\n1500,\n1600,0\n2500,\n";
    let folder = Folder::new(&[("b.gct", BLINK), ("in.csv", trace)]);
    let run = folder.run(&["sim", "b.gct", "--trace", "in.csv"]);
    assert_eq!((run.is_done().out.lines().count(), run.err.as_str()), (6, ""));
}

#[test]
fn more_columns() {
    let folder = Folder::new(&[("b.gct", BLINK), ("in.csv", "t_ms,run,restart\n0,1,\n1000,,\n1200,,1\n")]);
    let sim = |show: &str| folder.run(&["sim", "b.gct", "--trace", "in.csv", "--show", show]);
    let all = "t_ms,restart,run,lamp,n,X1,X2,T2,XG1,situation,flags
0,0,1,0,0,1,0,0,1,1,
1000,0,1,1,1,0,1,0,1,2,
1200,1,1,0,0,1,0,0,1,1,
";
    assert_eq!(sim("inputs,vars,steps,T2,XG1,X1,lamp").is_done().out, all);
    assert_eq!(sim("T2").out, "t_ms,lamp,T2,situation,flags\n0,0,0,1,\n1000,1,0,2,\n1200,0,0,1,\n");
    sim("X7").ends(2, "`--show X7`").ends(2, "there are `inputs`, `vars`, `steps`");
    for (word, meant) in [("lmap", "lamp"), ("input", "inputs"), ("x2", "X2"), ("Run", "run"), ("stpes", "steps")] {
        sim(word).ends(2, &format!("did you mean `{meant}`?"));
    }
}

/// `$end` ends a declaration; a name that begins so is escaped.
#[test]
fn names_in_a_waveform_are_no_words_of_the_format() {
    let chart = "chart `$end` input `$end`, `$a b`, `c$` : bool initial step `$end`";
    let folder = Folder::new(&[("b.gct", chart), ("in.csv", "t_ms\n0\n")]);
    folder.run(&["sim", "b.gct", "--trace", "in.csv", "-o", "b.vcd", "-q"]).is_done();
    let text = folder.read("b.vcd");
    let named = |line: &str| line.split(' ').nth_back(1).map(str::to_owned);
    let names: Vec<String> = text.lines().filter(|line| line.starts_with("$var")).filter_map(named).collect();
    assert_eq!(names[..4], ["\\$end", "\\$a_b", "c$", "X$end"]);
    assert!(text.contains("$scope module \\$end $end\n"), "{text}");
}

#[test]
fn a_waveform() {
    let folder = Folder::new(&[("b.gct", BLINK), ("in.csv", "t_ms,run\n5,1\n1005,\n")]);
    assert_eq!(folder.run(&["sim", "b.gct", "--trace", "in.csv", "-o", "b.vcd"]).is_done().out, "");
    let text = folder.read("b.vcd");
    let scopes: Vec<&str> = text.lines().filter_map(|line| line.strip_prefix("$scope module ")).collect();
    assert_eq!(scopes, ["b $end", "inputs $end", "outputs $end", "variables $end", "G1 $end", "flags $end"]);
    assert!(text.starts_with("$timescale 1 ms $end\n"), "{text}");
    let named = |name: &str| {
        let line = text.lines().find(|line| line.starts_with("$var") && line.ends_with(&format!(" {name} $end")));
        line.and_then(|line| line.split(' ').nth(3)).expect("it is declared").to_owned()
    };
    // At 5 ms all values, at 1005 ms what has changed: the lamp, the number, both steps.
    let (_, first) = text.split_once("#5\n").expect("the first call");
    let (first, second) = first.split_once("#1005\n").expect("the second call");
    assert!(
        first.contains(&format!("1{}\n", named("X1"))) && first.contains(&format!("0{}\n", named("lamp"))),
        "{text}"
    );
    let mut changes: Vec<&str> = second.lines().collect();
    changes.sort_unstable();
    let mut expected = [
        format!("0{}", named("X1")),
        format!("1{}", named("X2")),
        format!("1{}", named("lamp")),
        format!("b0000000000000001 {}", named("n")),
    ];
    expected.sort_unstable();
    assert_eq!(changes, expected);
}

#[test]
fn tables_of_spreadsheets() {
    let chart = "input a : bool input x : real output V : bool initial step 1 { V if [x > 1.4] and a }";
    for trace in [
        "t_ms;a;x\r\n0;WAHR;1,5\r\n10;;1,3\r\n",
        "sep=;\nt_ms;a;x\n0;1;1,5\n10;;1.3\n",
        "t_ms\ta\tx\n0\tVRAI\t1,5\n10\t\t1,3\n",
        "t_ms,a,x\n0,1,\"1,5\"\n10,,1.3\n",
    ] {
        let folder = Folder::new(&[("c.gct", chart), ("in.csv", trace)]);
        let run = folder.run(&["sim", "c.gct", "--trace", "in.csv"]);
        assert_eq!(run.is_done().out, "t_ms,V,situation,flags\n0,1,1,\n10,0,1,\n", "{trace}");
    }
}

#[test]
fn headers_that_could_be_either() {
    let chart = "input restart : bool output V : bool initial step 1 { V if restart }";
    let folder =
        Folder::new(&[("c.gct", chart), ("in.csv", "t_ms,restart\n0,1\n"), ("q.csv", "t_ms,`restart`\n0,1\n")]);
    folder.run(&["sim", "c.gct", "--trace", "in.csv"]).ends(1, "stands in backquotes: `restart`");
    assert_eq!(folder.run(&["sim", "c.gct", "--trace", "q.csv"]).is_done().out, "t_ms,V,situation,flags\n0,1,1,\n");
}
