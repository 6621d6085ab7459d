//! `grafc generate-tests`: round trips with what is expected of them.

mod common;

use common::{FAULTY, Folder, VALVE};

/// From 1 to 2 by `a`, back by `b`; `a` and `b` at once go round without end, and are no trip. One row for the start, one for
/// each transition.
#[test]
fn a_round_trip() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    let run = folder.run(&["generate-tests", "valve.gct"]);
    let said = "valve.1.test.csv: 3 rows, (1) (2)\n2 transitions in 1 test with 3 rows; at least 1 test and 3 rows are needed\n";
    assert_eq!(run.is_done().out, said);
    let table = "t_ms,a,b,|,V,situation\n0,0,0,,0,1\n10,1,,,1,2\n20,0,1,,0,1\n";
    assert_eq!(folder.read("valve.1.test.csv"), table);
    assert!(folder.run(&["test"]).is_done().out.contains("1 passed"));
    folder.run(&["generate-tests", "valve.gct"]).ends(2, "`valve.1.test.csv` is there already");
    folder.run(&["generate-tests", "valve.gct", "--force", "--cover", "edges", "-q"]).is_done();
    // Elsewhere, and with another period.
    folder.run(&["generate-tests", "valve.gct", "-o", "tests", "--scan", "1s"]).is_done();
    assert!(folder.read("tests/valve.1.test.csv").contains("\n1000,1,"), "the second row");
}

/// The lamp is on one second after `a`, for two seconds. Of what may be either, an input is false.
#[test]
fn delays_take_their_times() {
    let chart = "chart C input a : bool output L : bool initial step 1 step 2 step 3 { L }
        transition (1) 1 -> 2 : ↑a transition (2) 2 -> 3 : 1s/X2 transition (3) 3 -> 1 : 2s/X3";
    let folder = Folder::new(&[("c.gct", chart)]);
    folder.run(&["generate-tests", "c.gct"]).is_done();
    let table = "t_ms,a,|,L,situation\n0,0,,0,1\n10,1,,0,2\n1010,0,,1,3\n3010,,,0,1\n";
    assert_eq!(folder.read("c.1.test.csv"), table);
    assert!(folder.run(&["test"]).is_done().out.contains("1 passed"));
}

/// While the motor runs for six seconds, a lamp changes each half second: one state with a dozen times.
#[test]
fn a_wait_lasts_while_a_lamp_blinks() {
    let chart = "chart C input go : bool output Lamp, Motor : bool
        grafcet B { initial step 1 step 2 { Lamp } transition (lit) 1 -> 2 : 500ms/X1 transition (dark) 2 -> 1 : 500ms/X2 }
        grafcet M { initial step 10 step 11 { Motor } transition (begin) 10 -> 11 : go transition (end) 11 -> 10 : 6s/X11 }";
    let folder = Folder::new(&[("c.gct", chart)]);
    let run = folder.run(&["generate-tests", "c.gct"]);
    assert!(run.is_done().out.contains("\n4 transitions in 1 test with "), "{}", run.out);
    // Started at 10 ms.
    assert!(folder.read("c.1.test.csv").ends_with("\n6000,,,0,1,1 11\n6010,0,,0,0,1 10\n"));
    assert!(folder.run(&["test"]).is_done().out.contains("1 passed"));
}

/// 1 divides into 2 and 3, which nothing leads out of: two tests, one for each.
#[test]
fn what_has_no_way_back_takes_a_test_of_its_own() {
    let chart = "chart C input a : bool initial step 1 step 2 step 3
        transition (1) 1 -> 2 : a transition (2) 1 -> 3 : not a allow W0416 \"meant\"";
    let folder = Folder::new(&[("c.gct", chart)]);
    let run = folder.run(&["generate-tests", "c.gct", "--cover", "situations"]);
    let said = "\
c.1.test.csv: 1 row, {3}
c.2.test.csv: 1 row, {2}
2 situations in 2 tests with 2 rows; at least 2 tests and 2 rows are needed
";
    assert_eq!(run.is_done().out, said);
}

#[test]
fn numbers_are_given_on_both_sides_of_what_they_are_compared_with() {
    let chart = "chart C input n : int output L : bool initial step 1 step 2 { L }
        transition (1) 1 -> 2 : [n > 7] transition (2) 2 -> 1 : [n < 0]";
    let folder = Folder::new(&[("c.gct", chart)]);
    folder.run(&["generate-tests", "c.gct"]).is_done();
    let table = "t_ms,n,|,L,situation\n0,7,,0,1\n10,8,,1,2\n20,-1,,0,1\n";
    assert_eq!(folder.read("c.1.test.csv"), table);
}

#[test]
fn what_never_happens_and_what_cannot_be_followed() {
    let chart = "chart C input a : bool initial step 1 step 2 transition (1) 1 -> 2 : a
        transition (2) 2 -> 1 : a and not a allow W0415 \"meant\" allow W0416 \"meant\" allow W0417 \"meant\"";
    let folder = Folder::new(&[("c.gct", chart), ("faulty.gct", FAULTY)]);
    let run = folder.run(&["generate-tests", "c.gct"]);
    assert!(run.is_done().out.ends_with("never: (2)\n"), "{}", run.out);
    assert!(run.out.contains("; no way back"), "{}", run.out);
    folder.run(&["generate-tests", "faulty.gct"]).ends(1, "error[E0201]");
    assert!(!folder.path("faulty.1.test.csv").exists());
    let chart = "chart C input n : int var m : int initial step 1 { m := n on activation } step 2
        transition 1 -> 2 : [m > 7]";
    let folder = Folder::new(&[("c.gct", chart)]);
    folder.run(&["generate-tests", "c.gct"]).ends(4, "open: the number `n` is stored or calculated with");
    folder.run(&["generate-tests", "-"]).ends(2, "lies in no folder");
}

#[test]
fn more_than_is_allowed_is_open() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    let run = folder.run(&["generate-tests", "valve.gct", "--max", "1", "--force"]);
    assert_eq!(run.code, 4, "{}", run.out);
    assert!(run.out.contains("open: there are more states"), "{}", run.out);
}
