//! `grafc sim` on traces that are long, faulty, or not all there yet.

mod common;

use common::{Folder, Run, VALVE};
use std::io::{BufRead, BufReader, Write};
use std::process::{Child, Command, Stdio};

/// Valve open from 10 ms to 30 ms; at 20 ms the fault that is put in.
const RESULT: &str = "t_ms,V,situation,flags\n0,0,1,\n10,1,2,\n";

fn folder(trace: &str) -> Folder {
    Folder::new(&[("valve.gct", VALVE), ("in.csv", trace)])
}

#[test]
fn standard_output_has_the_rows_before_the_first_error_and_a_file_none() {
    let folder = folder("t_ms,a,b\n0,0,0\n10,1,0\n20,2,0\n30,0,1\n25,0,1\n");
    let run = folder.run(&["sim", "valve.gct", "--trace", "in.csv"]);
    run.ends(1, "`2` is not a value of `a`").ends(1, "in.csv:4:4");
    run.ends(1, "the time goes back from 30 ms to 25 ms").ends(1, "in.csv:6:1");
    assert_eq!(run.out, RESULT);
    for output in ["out.csv", "out.vcd"] {
        folder.run(&["sim", "valve.gct", "--trace", "in.csv", "-o", output]).ends(1, "in.csv:4:4");
    }
    assert_eq!(folder.names(), ["in.csv", "valve.gct"]);
    // What is no file has the rows, too.
    if cfg!(target_os = "linux") {
        let run = folder.run(&["sim", "valve.gct", "--trace", "in.csv", "-o", "/dev/stdout"]);
        run.ends(1, "in.csv:4:4");
        assert_eq!(run.out, RESULT);
    }
}

#[test]
fn the_rows_end_before_a_difference_or_a_warning_that_is_denied() {
    let folder = folder("t_ms,a,b\n0,0,0\n10,1,0\n20,0,0\n");
    std::fs::write(folder.path("plc.csv"), "t_ms,V\n0,0\n10,1\n20,0\n").unwrap();
    let run = folder.run(&["sim", "valve.gct", "--trace", "in.csv", "--against", "plc.csv", "-o", "-"]);
    run.ends(1, "at 20 ms output `V` is 0 and should be 1");
    assert_eq!(run.out, RESULT);
    let chart = "output V : bool initial step 1 step 2 { V } transition 1 -> 2 : 5ms/X1";
    std::fs::write(folder.path("late.gct"), chart).unwrap();
    std::fs::write(folder.path("late.csv"), "t_ms\n0\n10\n").unwrap();
    let run = folder.run(&["sim", "late.gct", "--trace", "late.csv"]);
    assert_eq!((run.code, run.out.as_str()), (0, "t_ms,V,situation,flags\n0,0,1,\n10,1,2,\n"), "{}", run.err);
    let run = folder.run(&["sim", "late.gct", "--trace", "late.csv", "-D", "W0601"]);
    run.ends(1, "error[W0601]: at 5 ms");
    assert_eq!(run.out, "t_ms,V,situation,flags\n0,0,1,\n");
}

#[test]
fn errors_beyond_fifty_are_counted() {
    let mut trace = String::from("t_ms,a,b\n0,0,0\n");
    for t in 0..3264 {
        trace.push_str(&format!("{t},yes,0\n"));
    }
    let folder = folder(&trace);
    let run = folder.run(&["sim", "valve.gct", "--trace", "in.csv"]);
    run.ends(1, "= note: and 3,214 more errors in this table").ends(1, "\n3,264 errors\n");
    assert_eq!(run.err.matches("error[E0603]").count(), 50);
    assert_eq!(run.out, "t_ms,V,situation,flags\n0,0,1,\n");
    let run = folder.run(&["sim", "valve.gct", "--trace", "in.csv", "--format", "json"]);
    let lines: Vec<serde_json::Value> = run.err.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!(lines.len(), 50);
    assert_eq!(lines[49]["notes"], serde_json::json!(["and 3,214 more errors in this table"]));
}

#[test]
fn places_are_those_of_the_whole_text() {
    let mut trace = String::from("t_ms,a,b\r\n");
    for t in 0..5000 {
        trace.push_str(&format!("{t},0,0\r\n"));
    }
    let byte = trace.len() + "5000,".len();
    trace.push_str("5000,ä,0\r\n1,0,0\r\n");
    let folder = folder(&trace);
    let run = folder.run(&["sim", "valve.gct", "--trace", "in.csv"]);
    run.ends(1, "in.csv:5002:6\n     │\n5002 │ 5000,ä,0\n     │      ^ expected");
    run.ends(1, "in.csv:5003:1\n     │\n5002 │ 5000,ä,0\n     │ ---- the time before\n5003 │ 1,0,0\n     │ ^");
    assert_eq!(run.out.lines().count(), 5001);
    let run = folder.run_with(&["sim", "valve.gct", "--trace", "-", "--format", "json"], trace);
    let first: serde_json::Value = serde_json::from_str(run.err.lines().next().unwrap()).unwrap();
    assert_eq!(first["start"], serde_json::json!({ "line": 5002, "column": 6, "byte": byte }));
    assert_eq!(first["end"], serde_json::json!({ "line": 5002, "column": 7, "byte": byte + 2 }));
}

#[test]
fn what_is_no_text_or_no_row_ends_the_trace() {
    let folder = folder("");
    let run = folder.run_with(&["sim", "valve.gct", "--trace", "-"], b"t_ms,a,b\n0,0,0\n10,1,0\n20,0,\xFF\n30,x,0\n");
    run.ends(1, "error[E0110]: byte 0xFF at offset 27 is not UTF-8").ends(1, "<stdin>:4:6").ends(1, "\n1 error\n");
    assert_eq!(run.out, RESULT);
    let open = format!("t_ms,a,b\n0,0,0\n10,1,0\n20,\"0,0\n{}", "30,0,0\n".repeat(1_000_000));
    let run = folder.run_with(&["sim", "valve.gct", "--trace", "-"], open);
    run.ends(1, "error[E0601]: the row is longer than 4 MiB").ends(1, "<stdin>:4:1").ends(1, "a quote is not closed");
    assert_eq!(run.out, RESULT);
    folder.run(&["sim", "valve.gct", "--trace", "."]).ends(3, "cannot read `.`");
}

#[test]
fn calls_without_end_are_refused_at_once() {
    let chart = "output V : bool initial step 1 step 2 { V } transition 1 -> 2 : 5ms/X1 transition 2 -> 1 : 5ms/X2";
    let folder = Folder::new(&[("b.gct", chart), ("in.csv", "t_ms\n0\n10\n9223372036854775807\n")]);
    let run = folder.run(&["sim", "b.gct", "--trace", "in.csv", "--scan", "5ms"]);
    run.ends(1, "error[E0606]: before this row there are more than 100,000,000 calls between rows")
        .ends(1, "in.csv:4:1");
    assert_eq!(run.out, "t_ms,V,situation,flags\n0,0,1,\n5,1,2,\n10,0,1,\n");
    // A period that does not fit into the range of times calls nothing behind it.
    std::fs::write(folder.path("late.csv"), "t_ms\n9223372036854775806\n9223372036854775807\n").unwrap();
    assert_eq!(folder.run(&["sim", "b.gct", "--trace", "late.csv", "--scan", "5ms"]).is_done().out.lines().count(), 3);
}

/// grafc with pipes, for who writes while it runs.
fn spawn(folder: &Folder, arguments: &[&str]) -> Child {
    let mut command = Command::new(assert_cmd::cargo::cargo_bin!("grafc"));
    let command = command.current_dir(folder.path(".")).args(arguments);
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap()
}

#[test]
fn each_row_is_answered_before_the_next_is_written() {
    let folder = folder("");
    let mut grafc = spawn(&folder, &["sim", "valve.gct", "--trace", "-"]);
    let mut input = grafc.stdin.take().unwrap();
    let mut output = BufReader::new(grafc.stdout.take().unwrap());
    let mut answer = || {
        let mut line = String::new();
        output.read_line(&mut line).unwrap();
        line
    };
    input.write_all(b"t_ms,a,b\n0,0,0\n").unwrap();
    assert_eq!((answer().as_str(), answer().as_str()), ("t_ms,V,situation,flags\n", "0,0,1,\n"));
    input.write_all(b"10,1,0\n").unwrap();
    assert_eq!(answer(), "10,1,2,\n");
    input.write_all(b"20,0,1\n").unwrap();
    assert_eq!(answer(), "20,0,1,\n");
    drop(input);
    assert_eq!(grafc.wait().unwrap().code(), Some(0));
}

#[test]
fn a_reader_that_goes_away_has_seen_enough() {
    let mut trace = String::from("t_ms,a,b\n");
    for t in 0..200_000 {
        trace.push_str(&format!("{t},0,0\n"));
    }
    let folder = folder(&trace);
    let mut grafc = spawn(&folder, &["sim", "valve.gct", "--trace", "in.csv"]);
    let mut line = String::new();
    BufReader::new(grafc.stdout.take().unwrap()).read_line(&mut line).unwrap();
    assert_eq!(line, "t_ms,V,situation,flags\n");
    let output = grafc.wait_with_output().unwrap();
    assert_eq!((output.status.code(), output.stderr), (Some(0), Vec::new()));
}

/// What is sent to a run that writes a file leaves neither half of it nor a temporary one.
#[cfg(unix)]
#[test]
fn a_run_that_is_interrupted_leaves_nothing() {
    use std::os::unix::process::ExitStatusExt;
    let folder = folder("");
    let mut grafc = spawn(&folder, &["sim", "valve.gct", "--trace", "-", "-o", "out.csv"]);
    let mut input = grafc.stdin.take().unwrap();
    input.write_all(b"t_ms,a,b\n0,0,0\n").unwrap();
    while !folder.names().iter().any(|name| name.starts_with(".grafc-")) {
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    let killed = Command::new("kill").args(["-TERM", &grafc.id().to_string()]).status().unwrap();
    assert!(killed.success());
    // No row comes any more: it does not wait for one.
    assert_eq!(grafc.wait().unwrap().signal(), Some(15));
    drop(input);
    assert_eq!(folder.names(), ["in.csv", "valve.gct"]);
}

/// 12 MB of rows in less memory than a tenth of a kilobyte a row would take.
#[cfg(target_os = "linux")]
#[test]
fn memory_does_not_grow_with_the_trace() {
    const ROWS: usize = 900_000;
    let mut trace = String::from("t_ms,a,b\n");
    for row in 0..ROWS {
        trace.push_str(&format!("{},{},{}\n", row * 10, row % 2, row % 3 / 2));
    }
    let folder = folder(&trace);
    let arguments = ["sim", "valve.gct", "--trace", "in.csv", "-o", "out.csv"];
    let mut command = Command::new("sh");
    command.current_dir(folder.path(".")).args(["-c", "ulimit -v 90000 && exec \"$0\" \"$@\""]);
    let output = command.arg(assert_cmd::cargo::cargo_bin!("grafc")).args(arguments).output().unwrap();
    Run::of(output).is_done();
    assert_eq!(folder.read("out.csv").lines().count(), ROWS + 1);
}
