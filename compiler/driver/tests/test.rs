//! `grafc test`: what is found, what is compared, how it is told.

mod common;

use common::{FAULTY, Folder, VALVE};

const OPENS: &str = "t_ms,a,b,|,V,situation\n0,0,0,,0,1\n10,1,,,1,2\n20,0,,,,\n30,,1,,0,1\n";

/// At 10 ms `a` opens the valve, at 30 ms `b` closes it.
const WRONG: &str = "t_ms,a,b,|,V,situation\n0,0,0,,0,1\n10,1,,,0,1\n20,0,,,1,\n30,,1,,1,2\n";

#[test]
fn tables_beside_a_chart_are_its_tests() {
    let folder = Folder::new(&[("valve.gct", VALVE), ("valve.test.csv", OPENS), ("valve.again.test.csv", OPENS)]);
    let all = "
running 2 tests
test valve::again.test.csv ... ok
test valve::test.csv ... ok

test result: ok. 2 passed; 0 failed; 0 filtered out
";
    assert_eq!(folder.run(&["test"]).is_done().out, all);
    assert_eq!(folder.run(&["test", "valve.gct"]).is_done().out, all);
    assert_eq!(folder.run(&["test", "."]).is_done().out, all);
    assert_eq!(folder.run(&["test", "valve.gct", "valve.test.csv", "."]).is_done().out, all);
    let one = folder.run(&["test", "valve.test.csv"]);
    assert!(one.is_done().out.contains("running 1 test\ntest valve::test.csv ... ok\n"), "{}", one.out);
    let list = folder.run(&["test", "--list"]);
    assert_eq!(list.is_done().out, "valve::again.test.csv: test\nvalve::test.csv: test\n");
}

#[test]
fn tests_are_chosen_by_parts_of_their_names() {
    let folder = Folder::new(&[("valve.gct", VALVE), ("valve.test.csv", OPENS), ("valve.again.test.csv", OPENS)]);
    let run = |options: &[&str]| folder.run(&[&["test"], options].concat()).is_done().out.clone();
    let again =
        "running 1 test\ntest valve::again.test.csv ... ok\n\ntest result: ok. 1 passed; 0 failed; 1 filtered out\n";
    assert!(run(&["--filter", "again"]).ends_with(again));
    assert!(run(&["--skip", "valve::test"]).ends_with(again));
    assert!(run(&["--exact", "--filter", "valve::again.test.csv"]).ends_with(again));
    assert!(run(&["--exact", "--filter", "again"]).ends_with("ok. 0 passed; 0 failed; 2 filtered out\n"));
    assert!(run(&["--filter", "again", "--filter", "test.csv"]).contains("2 passed"));
}

/// The file says 0 and 1, and the chart is in 2 with the valve open; so it goes on.
#[test]
fn each_cell_that_differs_is_told_with_its_place() {
    let folder = Folder::new(&[("valve.gct", VALVE), ("valve.test.csv", WRONG)]);
    let run = folder.run(&["test"]);
    assert_eq!((run.code, run.err.as_str()), (1, ""));
    for (message, place) in [
        ("at 10 ms `V` is 1, expected 0", "valve.test.csv:3:8"),
        ("at 10 ms `situation` is 2, expected 1", "valve.test.csv:3:10"),
        ("at 30 ms `V` is 0, expected 1", "valve.test.csv:5:8"),
        ("at 30 ms `situation` is 1, expected 2", "valve.test.csv:5:10"),
    ] {
        assert!(run.out.contains(&format!("error[E0607]: {message}\n  ┌─ {place}\n")), "{message}: {}", run.out);
    }
    assert_eq!(run.out.matches("E0607").count(), 4, "{}", run.out);
    assert!(
        run.out.starts_with(
            "\nrunning 1 test\ntest valve::test.csv ... FAILED\n\nfailures:\n\n---- valve::test.csv ----\n"
        )
    );
    let end = "\nfailures:\n    valve::test.csv\n\ntest result: FAILED. 0 passed; 1 failed; 0 filtered out\n";
    assert!(run.out.ends_with(end), "{}", run.out);
}

/// Fifty are told, the others counted.
#[test]
fn many_differences_are_counted() {
    let rows: String = (0..70).map(|row| format!("{},0,,1\n", row * 10)).collect();
    let folder = Folder::new(&[("valve.gct", VALVE), ("valve.test.csv", &format!("t_ms,a,|,V\n{rows}"))]);
    let run = folder.run(&["test"]);
    assert_eq!((run.code, run.out.matches("E0607").count()), (1, 50));
    assert!(run.out.contains("and 20 more errors in this table"), "{}", run.out);
}

/// After one second in 2 the counter is 1, step 2 has been active for 0 ms at 1000; nothing is active at the end.
#[test]
fn variables_steps_durations_and_nothing_are_expected_too() {
    let chart = "input a : bool var n : int output L : bool
        initial step 1 step 2 { n := n + 1 on activation   L }
        transition 1 -> 2 : 1s/X1 transition 2 -> : a";
    let table = "t_ms,a,|,n,X2,T2,L,situation,flags
0,0,,0,0,0,0,1,{}
1000,,,1,1,0,1,2,
1500,,,,,500,,,
1600,1,,1,0,0,0,{},{}
";
    let folder = Folder::new(&[("c.gct", chart), ("c.test.csv", table)]);
    folder.run(&["test", "-q"]).is_done();
    let wrong = table.replace("{},{}", "2,DIV0");
    std::fs::write(folder.path("c.test.csv"), wrong).unwrap();
    let run = folder.run(&["test"]);
    assert!(run.out.contains("at 1600 ms `situation` is {}, expected 2"), "{}", run.out);
    assert!(run.out.contains("at 1600 ms `flags` is {}, expected DIV0"), "{}", run.out);
}

#[test]
fn faults_of_a_table_are_told_together_and_the_chart_is_not_run_on_guesses() {
    let table = "t_ms,a,c,|,V,a,W,V\n0,0,0,,0,0,0,0\n10,x,0,,y,0,0,0\n5,1\n";
    let folder = Folder::new(&[("valve.gct", VALVE), ("valve.test.csv", table)]);
    let run = folder.run(&["test"]);
    for message in [
        "E0602]: the chart has no input `c`",
        "E0602]: `a` is an input of the chart: nothing is expected of it",
        "E0602]: the chart has no output or variable `W`",
        "E0601]: column `V` appears twice",
        "E0603]: `x` is not a value of `a`",
        "E0603]: `y` is not a value of `V`",
        "E0601]: the row has 2 cells, the header has 8",
    ] {
        assert!(run.out.contains(message), "{message}: {}", run.out);
    }
    assert!(!run.out.contains("E0607"), "{}", run.out);
    let fault = |table: &str| {
        std::fs::write(folder.path("valve.test.csv"), table).unwrap();
        let run = folder.run(&["test"]);
        assert_eq!(run.code, 1);
        run.out
    };
    assert!(fault("t_ms,a\n0,1\n").contains("error[E0601]: the test has no column `|`"));
    assert!(fault("t_ms,a,|,V\n0,1,,\n").contains("error[E0601]: the test expects nothing"));
    assert!(fault("t_ms,a,|,V\n").contains("error[E0601]: the test expects nothing"));
    assert!(fault("").contains("error[E0601]: the trace is empty"));
    std::fs::write(folder.path("valve.test.csv"), b"t_ms,a,|,V\n0,1,,\xff\n").unwrap();
    assert!(folder.run(&["test"]).out.contains("error[E0110]"));
}

/// A delay ends between two rows: nothing is wrong, but something is not seen.
#[test]
fn what_no_row_sees_is_warned_of() {
    let chart = "output L : bool initial step 1 step 2 { L } transition 1 -> 2 : 1s/X1";
    let folder = Folder::new(&[("c.gct", chart), ("c.test.csv", "t_ms,|,L\n0,,0\n2000,,1\n")]);
    let run = folder.run(&["test"]);
    assert!(run.is_done().out.contains("warning[W0601]: at 1000 ms a delay ends"), "{}", run.out);
    assert!(run.out.contains("help: add a row at this time"), "{}", run.out);
    assert!(!folder.run(&["test", "-q"]).is_done().out.contains("W0601"));
    let denied = folder.run(&["test", "-D", "W0601"]);
    assert_eq!(denied.code, 1);
    assert!(denied.out.contains("error[W0601]"), "{}", denied.out);
}

#[test]
fn folders_are_walked_and_a_test_belongs_to_the_nearest_name() {
    let folder = Folder::new(&[("valve.gct", VALVE), ("valve.test.csv", OPENS)]);
    for inner in ["sub", ".hidden"] {
        std::fs::create_dir(folder.path(inner)).unwrap();
        std::fs::write(folder.path(&format!("{inner}/valve.gct")), VALVE).unwrap();
        std::fs::write(folder.path(&format!("{inner}/valve.two.test.csv")), OPENS).unwrap();
        std::fs::write(folder.path(&format!("{inner}/valve.two.gct")), VALVE).unwrap();
        std::fs::write(folder.path(&format!("{inner}/valve.two.more.test.csv")), OPENS).unwrap();
    }
    #[cfg(unix)]
    std::os::unix::fs::symlink("..", folder.path("sub/around")).unwrap();
    let run = folder.run(&["test", "--list"]);
    let names = "sub/valve.two::more.test.csv: test\nsub/valve.two::test.csv: test\nvalve::test.csv: test\n";
    assert_eq!(run.is_done().out, names);
    std::fs::write(folder.path("sub/lost.test.csv"), OPENS).unwrap();
    let run = folder.run(&["test"]);
    run.ends(1, "error[E0608]: the test belongs to no chart").ends(1, "sub/lost.test.csv");
    assert!(run.out.contains("3 passed"), "{}", run.out);
}

#[test]
fn a_faulty_chart_does_not_keep_others_from_their_tests() {
    let folder = Folder::new(&[("faulty.gct", FAULTY), ("faulty.test.csv", OPENS)]);
    std::fs::write(folder.path("valve.gct"), VALVE).unwrap();
    std::fs::write(folder.path("valve.test.csv"), OPENS).unwrap();
    let run = folder.run(&["test"]);
    run.ends(1, "error[E0201]");
    assert!(
        run.out.ends_with("test result: FAILED. 1 passed; 0 failed; 0 filtered out; 1 file has errors\n"),
        "{}",
        run.out
    );
}

#[test]
fn wrong_use_and_refusals() {
    let folder = Folder::new(&[("valve.gct", VALVE), ("notes.txt", "")]);
    folder.run(&["test", "notes.txt"]).ends(2, "`notes.txt` is no chart, no test and no folder");
    folder.run(&["test", "none.gct"]).ends(3, "cannot read `none.gct`");
    folder.run(&["test", "none"]).ends(3, "cannot read `none`");
    assert!(folder.run(&["test"]).is_done().out.contains("running 0 tests\n"));
}

#[test]
fn junit() {
    let folder = Folder::new(&[("valve.gct", VALVE), ("valve.test.csv", OPENS), ("valve.2.test.csv", WRONG)]);
    let run = folder.run(&["test", "--junit", "tests.xml"]);
    assert_eq!(run.code, 1);
    let xml = folder.read("tests.xml");
    assert!(
        xml.contains("<testsuites name=\"grafc test\" tests=\"2\" skipped=\"0\" failures=\"1\" errors=\"0\">"),
        "{xml}"
    );
    assert!(xml.contains("<testcase name=\"test.csv\" classname=\"valve\"/>"), "{xml}");
    let failure = "<failure message=\"at 10 ms `V` is 1, expected 0\" type=\"E0607\">";
    assert!(xml.contains(failure), "{xml}");
    folder.run(&["test", "--junit", "again.xml"]);
    assert_eq!(xml, folder.read("again.xml"));
}

/// The valve is opened and not closed: (2) is never cleared, `b` is never true, the rest has happened. `a` was 0 and 1
/// while (1) was enabled, and decided it both ways.
#[test]
fn coverage_as_a_table_as_lcov_and_in_colours() {
    let table = "t_ms,a,|,V\n0,0,,0\n10,1,,1\n20,,,1\n";
    let folder = Folder::new(&[("valve.gct", VALVE), ("valve.test.csv", table)]);
    let run = folder.run(&["test", "--coverage", "--lcov", "valve.info", "--coverage-drawing", "valve.svg"]);
    let summary = "
coverage of valve.gct
  steps                 2 of 2      100 %
  transitions           1 of 2       50 %
  actions               1 of 1      100 %
  values of atoms       3 of 4       75 %
  deciding atoms        1 of 2       50 %
  valve.gct:11: transition (2) was never cleared
  valve.gct:11: `b` in the condition of transition (2) was never true
";
    assert!(run.is_done().out.ends_with(summary), "{}", run.out);
    // Step 1: at the start, and in the micro-step at 0 ms. Each reaction ends with a micro-step in which nothing changes.
    let lcov = folder.read("valve.info");
    for line in
        ["SF:valve.gct", "BRDA:10,0,1,1", "BRDA:11,0,1,0", "BRF:4", "BRH:3", "DA:10,1", "DA:11,0", "LF:4", "LH:3"]
    {
        assert!(lcov.lines().any(|other| other == line), "{line}: {lcov}");
    }
    assert!(lcov.starts_with("TN:\n") && lcov.ends_with("end_of_record\n"));
    let svg = folder.read("valve.svg");
    for class in [
        "class=\"step initial wholly\"",
        "class=\"step wholly\"",
        "class=\"transition never\"",
        "class=\"link before never\"",
    ] {
        assert!(svg.contains(class), "{class}: {svg}");
    }
}

/// One table after the other adds to what is covered.
#[test]
fn coverage_is_of_all_tests_of_a_chart() {
    let folder = Folder::new(&[
        ("valve.gct", VALVE),
        ("valve.1.test.csv", "t_ms,a,|,V\n0,0,,0\n10,1,,1\n"),
        ("valve.2.test.csv", OPENS),
    ]);
    let run = folder.run(&["test", "--coverage"]);
    assert!(run.is_done().out.contains("  transitions           2 of 2      100 %"), "{}", run.out);
    folder.run(&["test", "--coverage-drawing", "drawn/"]).is_done();
    assert!(folder.path("drawn/valve.coverage.svg").exists());
}

#[test]
fn what_is_read_is_not_written_over() {
    let table = "t_ms,a,|,V\n0,0,,0\n";
    let folder = Folder::new(&[("valve.gct", VALVE), ("valve.test.csv", table)]);
    for option in ["--junit", "--lcov", "--coverage-drawing"] {
        folder.run(&["test", option, "valve.gct"]).ends(2, "the output would overwrite `valve.gct`");
        folder.run(&["test", "valve.gct", option, "./valve.test.csv"]).ends(2, "would overwrite `valve.test.csv`");
    }
    assert_eq!((folder.read("valve.gct").as_str(), folder.read("valve.test.csv").as_str()), (VALVE, table));
}

/// From step 1 to transition (2), and from transition (1) to step 2.
#[test]
fn links_between_what_is_called_alike_have_their_own_colours() {
    let chart = "input a, b : bool
output V, W : bool
initial step 1
step 2 { V }
step 3 { W }
transition (1) 1 -> 2 : a and not b
transition (2) 1 -> 3 : b
transition (3) 2 -> 1 : not a
transition (4) 3 -> 1 : not b
";
    let folder = Folder::new(&[("c.gct", chart), ("c.test.csv", "t_ms,a,|,V\n0,0,,0\n10,1,,1\n")]);
    folder.run(&["test", "--coverage-drawing", "c.svg"]).is_done();
    let svg = folder.read("c.svg");
    for link in [
        "class=\"link after wholly\" data-from=\"1\" data-to=\"2\"",
        "class=\"link before never\" data-from=\"1\" data-to=\"2\"",
        "class=\"link after never\" data-from=\"2\" data-to=\"3\"",
    ] {
        assert!(svg.contains(link), "{link}: {svg}");
    }
}

/// Enclosed by 5, with an activation link of 51; the order of 1 holds G3 in 31 and lets it go.
#[test]
fn coverage_of_orders_and_activation_links() {
    let chart = "input m, n : bool
grafcet G1 {
  initial step 0 { force G3{31} }
  enclosing step 5
  transition 0 -> 5 : m
  transition 5 -> 0 : n
}
grafcet X5/G5 {
  activated step 51
}
grafcet G3 {
  initial step 30
  step 31
  transition 30 -> 31 : m
}
";
    let table = "t_ms,m,|,situation\n0,0,,0 31\n10,1,,5 51 31\n";
    let folder = Folder::new(&[("c.gct", chart), ("c.test.csv", table)]);
    let run = folder.run(&["test", "--coverage", "-q"]);
    assert!(run.is_done().out.contains("  orders                1 of 1      100 %\n"), "{}", run.out);
    assert!(run.out.contains("  activation links      1 of 1      100 %\n"), "{}", run.out);
    assert!(run.out.contains("c.gct:12: step `30` was never active"), "{}", run.out);
    std::fs::write(folder.path("c.test.csv"), "t_ms,m,|,situation\n0,0,,0 31\n").unwrap();
    let run = folder.run(&["test", "--coverage", "-q"]);
    assert!(run.out.contains("the activation link of step `51` was never taken"), "{}", run.out);
}

/// A test is a trace of `grafc sim`, which ends at the column `|`.
#[test]
fn sim_reads_a_test_as_a_trace() {
    let folder = Folder::new(&[("valve.gct", VALVE), ("valve.test.csv", WRONG)]);
    let run = folder.run(&["sim", "valve.gct", "--trace", "valve.test.csv"]);
    let result = "t_ms,V,situation,flags\n0,0,1,\n10,1,2,\n20,1,2,\n30,0,1,\n";
    assert_eq!(run.is_done().out, result);
}

/// The lamp goes on with an edge, and off ten seconds later.
const LAMP: &str = "\
chart Lamp
input  button : bool
output lamp : bool
initial step 1
step 2 { lamp }
transition (1) 1 -> 2 : ↑button
transition (2) 2 -> 1 : 10s/X2
";

fn lamp(scenarios: &str) -> Folder {
    Folder::new(&[("lamp.gct", &format!("{LAMP}{scenarios}"))])
}

/// The edge is at 1 s, so the light goes out at 11 s; the lines: 1 s, 10 s, 11 s.
#[test]
fn a_scenario_in_the_chart() {
    let folder = lamp(
        "scenario \"light\" {
  0s : button = 0 -> not lamp
  1s : button = 1 ↑ -> lamp, X2, T2 = 0s
  after 9s : -> lamp, T2 = 9s
  until not lamp within 1s -> X1
  after 0s : button = 1 -> X2
}
scenario \"again\" { 0s : -> not lamp }
",
    );
    let run = folder.run(&["test"]);
    let said = "\nrunning 2 tests\ntest lamp::light ... ok\ntest lamp::again ... ok\n\ntest result: ok. 2 passed; 0 failed; 0 filtered out\n";
    assert_eq!(run.is_done().out, said);
    assert!(
        folder.run(&["test", "--filter", "again"]).is_done().out.contains("running 1 test\ntest lamp::again ... ok")
    );
    // A scan of 7 ms: the edge is at 1001, the line at 10001, and 11001 is a scan; off it is then.
    folder.run(&["test", "--scan", "7ms", "--filter", "again"]).is_done();
}

/// At 1 s nothing is pressed, so step 2 is not active: `lamp` and `X2` are 0, `n` of the line is the duration 0.
#[test]
fn what_a_scenario_expects_and_is_not_is_told_with_its_place() {
    let folder =
        lamp("scenario \"dark\" {\n  1s : -> lamp, not X1\n  until X2 within 2s -> lamp\n  after 1s : -> lamp\n}\n");
    let run = folder.run(&["test"]);
    assert_eq!(run.code, 1);
    for (message, place) in [
        ("error[E0607]: at 1000 ms `lamp` is 0, expected 1", "lamp.gct:9:11"),
        ("error[E0607]: at 1000 ms `X1` is 1, expected 0", "lamp.gct:9:17"),
        ("error[E0611]: this was not so within 2000 ms", "lamp.gct:10:9"),
    ] {
        assert!(run.out.contains(message) && run.out.contains(place), "{message}: {}", run.out);
    }
    assert!(run.out.contains("note: at 3000 ms the situation was {1}"), "{}", run.out);
    assert!(run.out.contains("note: `X2` was 0"), "{}", run.out);
    // What is behind a line that was not reached is not run.
    assert_eq!(run.out.matches("error[").count(), 3, "{}", run.out);
}

/// A pulse is one scan long; what a later line says counts.
#[test]
fn a_pulse_is_over_in_the_next_scan() {
    let chart = "input a : bool output V : bool initial step 1 { V if a }
scenario \"s\" {
  0s : a = 1 ↑ -> V
  10ms : -> not V
  20ms : a = 1 ↑ -> V
  30ms : a = 1 -> V
  40ms : -> V
  45ms : a = 0 -> not V
}
";
    let folder = Folder::new(&[("c.gct", chart)]);
    folder.run(&["test"]).is_done();
}

#[test]
fn scenarios_beside_a_chart() {
    let folder = lamp("scenario \"own\" { 0s : -> X1 }\n");
    std::fs::write(folder.path("lamp.scenarios"), "// beside\nscenario \"beside\" { 1s : button = 1 -> lamp }\n")
        .unwrap();
    let run = folder.run(&["test"]);
    assert!(run.is_done().out.contains("test lamp::own ... ok\ntest lamp::beside ... ok\n"), "{}", run.out);
    let run = folder.run(&["test", "lamp.scenarios"]);
    assert!(run.is_done().out.contains("running 1 test\ntest lamp::beside ... ok\n"), "{}", run.out);
    let faulty = "scenario \"s\" { 0s : buton = 1 -> lamp }\nstep 7\nscenario \"t\" { 0s : -> lamp = 2 }\n";
    std::fs::write(folder.path("lamp.scenarios"), faulty).unwrap();
    let run = folder.run(&["test"]);
    run.ends(1, "error[E0201]")
        .ends(1, "lamp.scenarios:1:21")
        .ends(1, "error[E0610]: a file of scenarios has scenarios alone");
    run.ends(1, "lamp.scenarios:3:");
    assert!(run.out.ends_with("1 passed; 0 failed; 0 filtered out; 1 file has errors\n"), "{}", run.out);
}

#[test]
fn faults_of_scenarios_are_told_together() {
    let folder = lamp(
        "var n : int
scenario \"s\" {
  0s : lamp = 1, X1 = 1, button = 0 ↑, button = 3 -> n, nothing
  1s : -> n = 1.5, lamp
  500ms : -> lamp
  until ↑button within 1s
  until 3s/lamp within 1s
}
scenario \"s\" { 0s : button = 1 }
",
    );
    let run = folder.run(&["check", "lamp.gct"]);
    for message in [
        "error[E0610]: `lamp` is an output, and only inputs are given",
        "error[E0610]: `X1` is what the chart comes to, and only inputs are given",
        "error[E0610]: `↑` stands behind a Boolean input that is given 1",
        "error[E0610]: `n` is not Boolean",
        "error[E0201]",
        "error[E0604]: the time goes back from 1000 ms to 500 ms",
        "error[E0610]: `until` looks at what is after a scan",
        "error[E0202]: there are two scenarios `s`",
        "error[E0610]: the scenario expects nothing",
    ] {
        run.ends(1, message);
    }
    assert_eq!(run.err.matches("`until` looks at").count(), 2, "{}", run.err);
}

/// Code is the same with scenarios and without, in every target; a variable that only a scenario names is not used.
#[test]
fn scenarios_change_no_code() {
    let scenario = "scenario \"s\" { 0s : button = 1 -> lamp  until X1 and lamp within 1s }\n";
    for target in ["st", "il", "rust", "js", "c", "plcopen", "awl", "scl"] {
        let plain = lamp("").run(&["lamp.gct", "--target", target, "-q"]).out.clone();
        assert_eq!(lamp(scenario).run(&["lamp.gct", "--target", target, "-q"]).out, plain, "{target}");
        assert!(!plain.is_empty(), "{target}");
    }
    let folder = lamp("input spare : bool\nscenario \"s\" { 0s : spare = 1 -> not lamp  until spare within 1s }\n");
    folder.run(&["check", "lamp.gct"]).ends(0, "warning[W0419]: the input `spare` is never read");
}

#[test]
fn coverage_counts_scenarios() {
    let folder = lamp("scenario \"light\" { 0s : -> X1  1s : button = 1 ↑ -> X2  until X1 within 11s }\n");
    let run = folder.run(&["test", "--coverage"]);
    assert!(run.is_done().out.contains("  transitions           2 of 2      100 %"), "{}", run.out);
}

/// An assertion that is false in a scan fails a scenario, and a test that is a table; an assumption that is not kept is told.
#[test]
fn claims_are_looked_at_in_tests() {
    let folder =
        lamp("assert \"always dark\" : not lamp\nscenario \"s\" {\n  0s : -> X1\n  1s : button = 1 ↑ -> lamp\n}\n");
    let run = folder.run(&["test"]);
    assert_eq!(run.code, 1);
    assert!(run.out.contains("error[E0609]: at 1000 ms an assertion is false: always dark"), "{}", run.out);
    assert!(run.out.contains("lamp.gct:11:3"), "{}", run.out);
    std::fs::write(folder.path("lamp.test.csv"), "t_ms,button,|,lamp\n0,0,,0\n10,1,,1\n").unwrap();
    let run = folder.run(&["test", "lamp.test.csv"]);
    assert!(run.out.contains("error[E0609]: at 10 ms an assertion is false: always dark"), "{}", run.out);
    let folder = lamp("assume \"released\" : not button\nscenario \"s\" { 1s : button = 1 ↑ -> lamp }\n");
    let run = folder.run(&["test"]);
    assert!(
        run.is_done().out.contains("warning[W0602]: at 1000 ms the inputs break an assumption: released"),
        "{}",
        run.out
    );
}

/// The one that runs goes on to its end, the others are told as not run, and files are written.
#[cfg(unix)]
#[test]
fn tests_that_are_interrupted_tell_what_is_known() {
    use std::io::{BufRead, BufReader, Read};
    use std::process::{Command, Stdio};
    const COUNT: usize = 2000;
    let scenarios: String =
        (0..COUNT).map(|number| format!("scenario \"n{number:04}\" {{ after 100s : a = 0 -> not V }}\n")).collect();
    let folder = Folder::new(&[("valve.gct", VALVE), ("valve.scenarios", &scenarios)]);
    let mut command = Command::new(assert_cmd::cargo::cargo_bin!("grafc"));
    command.current_dir(folder.path(".")).args(["test", "--scan", "1ms", "--junit", "tests.xml"]);
    let mut grafc = command.stdout(Stdio::piped()).spawn().unwrap();
    let mut output = BufReader::new(grafc.stdout.take().unwrap());
    let mut text = String::new();
    while !text.contains("n0000 ... ok\n") {
        assert_ne!(output.read_line(&mut text).unwrap(), 0, "{text}");
    }
    assert!(Command::new("kill").args(["-INT", &grafc.id().to_string()]).status().unwrap().success());
    output.read_to_string(&mut text).unwrap();
    assert_eq!(grafc.wait().unwrap().code(), Some(4), "{text}");
    let passed = text.matches(" ... ok\n").count();
    let result =
        format!("\ntest result: INTERRUPTED. {passed} passed; 0 failed; 0 filtered out; {} not run\n", COUNT - passed);
    assert!(passed < COUNT && text.ends_with(&result), "{text}");
    let junit = folder.read("tests.xml");
    assert!(junit.contains(&format!("tests=\"{COUNT}\" skipped=\"{}\"", COUNT - passed)), "{}", &junit[..400]);
    assert_eq!(junit.matches("<skipped message=\"interrupted before it began\"/>").count(), COUNT - passed);
}
