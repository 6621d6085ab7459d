//! `grafc check`.

mod common;

use common::{DUBIOUS, FAULTY, Folder, VALVE};
use serde_json::Value;

#[test]
fn a_sound_chart_is_met_with_silence() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    assert_eq!(folder.run(&["check", "valve.gct"]).is_done().out, "");
    assert_eq!(folder.run(&["check", "valve.gct", "--format", "json"]).is_done().out, "");
    assert_eq!(folder.run_with(&["check", "-"], VALVE).is_done().out, "");
}

#[test]
fn all_charts_are_checked_and_counted() {
    let folder = Folder::new(&[("a.gct", FAULTY), ("b.gct", DUBIOUS), ("c.gct", VALVE), ("d.gct", FAULTY)]);
    let run = folder.run(&["check", "a.gct", "b.gct", "c.gct", "d.gct"]);
    run.ends(1, "a.gct:6:25").ends(1, "b.gct:6:25").ends(1, "d.gct:6:25");
    assert!(run.err.ends_with("\n2 errors, 1 warning\n"), "{}", run.err);
    assert_eq!(run.out, "");
    folder.run(&["check", "b.gct"]).ends(0, "W0403");
}

#[test]
fn json_goes_to_standard_output_one_object_a_line() {
    let folder = Folder::new(&[("a.gct", FAULTY), ("b.gct", DUBIOUS)]);
    let run = folder.run(&["check", "a.gct", "b.gct", "--format", "json"]);
    assert_eq!((run.code, run.err.as_str()), (1, ""));
    let messages: Vec<Value> = run.out.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!(messages.len(), 2);
    assert_eq!(messages[0]["code"], "E0201");
    assert_eq!(messages[0]["slug"], "unknown-name");
    assert_eq!(messages[0]["severity"], "error");
    assert_eq!(messages[0]["file"], "a.gct");
    assert_eq!(messages[0]["start"]["column"], 25);
    assert_eq!(messages[0]["end"]["column"], 32);
    assert_eq!(messages[1]["severity"], "warning");
    assert_eq!(messages[1]["file"], "b.gct");
}

#[test]
fn sarif_goes_to_standard_output_as_one_log() {
    let clean = VALVE.replace(": a\n", ": ↑a\n");
    let clean = clean.split_once("\nallow").expect("an allowance that nothing needs then").0;
    let folder = Folder::new(&[("a.gct", FAULTY), ("b.gct", DUBIOUS), ("c.gct", clean)]);
    let run = folder.run(&["check", "a.gct", "b.gct", "--format", "sarif"]);
    assert_eq!((run.code, run.err.as_str()), (1, ""));
    let log: Value = serde_json::from_str(&run.out).unwrap();
    assert_eq!(log["version"], "2.1.0");
    let results = log["runs"][0]["results"].as_array().unwrap();
    let rules = log["runs"][0]["tool"]["driver"]["rules"].as_array().unwrap();
    assert_eq!(rules.iter().map(|rule| rule["id"].as_str().unwrap()).collect::<Vec<_>>(), ["E0201", "W0403"]);
    assert_eq!(results.len(), 2);
    for result in results {
        assert_eq!(rules[result["ruleIndex"].as_u64().unwrap() as usize]["id"], result["ruleId"]);
    }
    assert_eq!(results[0]["locations"][0]["physicalLocation"]["artifactLocation"]["uri"], "a.gct");

    let clean: Value =
        serde_json::from_str(&folder.run(&["check", "c.gct", "--format", "sarif"]).is_done().out).unwrap();
    assert_eq!(clean["runs"][0]["results"], serde_json::json!([]));
}

#[test]
fn a_denied_warning_is_an_error() {
    let folder = Folder::new(&[("b.gct", DUBIOUS), ("c.gct", VALVE)]);
    for denied in [&["-D", "W0403"][..], &["-D", "warnings"], &["--deny", "W0401,W0403"], &["-D", "negated-edge"]] {
        let run = folder.run(&[&["check", "b.gct"], denied].concat());
        run.ends(1, "error[W0403]");
        assert!(run.err.ends_with("\n1 error\n"), "{}", run.err);
    }
    folder.run(&["check", "b.gct", "-D", "W0401"]).ends(0, "warning[W0403]");
    folder.run(&["check", "c.gct", "-D", "warnings"]).is_done();
    let run = folder.run(&["check", "b.gct", "-D", "warnings", "--format", "json"]);
    assert_eq!(serde_json::from_str::<Value>(&run.out).unwrap()["severity"], "error");
    assert_eq!(run.code, 1);
}

#[test]
fn an_allowed_warning_is_neither_shown_nor_denied() {
    let allowed = DUBIOUS.replace("not rise a", "not rise a { allow W0403 \"once a scan is enough\" }");
    let folder = Folder::new(&[("a.gct", &allowed), ("b.gct", DUBIOUS)]);
    assert_eq!(folder.run(&["check", "a.gct", "-D", "warnings"]).is_done().err, "");
    assert_eq!(folder.run(&["check", "b.gct", "-D", "warnings", "--allow", "W0403"]).is_done().err, "");
    let run = folder.run(&["check", "a.gct", "b.gct", "--allow", "W0403", "--format", "sarif"]);
    let log: Value = serde_json::from_str(&run.is_done().out).unwrap();
    let suppressions = |at: usize| &log["runs"][0]["results"][at]["suppressions"][0];
    assert_eq!(suppressions(0)["kind"], "inSource");
    assert_eq!(suppressions(0)["justification"], "once a scan is enough");
    assert_eq!(suppressions(1)["kind"], "external");
}

#[test]
fn what_cannot_be_denied_or_allowed_is_wrong_use() {
    let folder = Folder::new(&[("b.gct", DUBIOUS)]);
    folder.run(&["check", "b.gct", "-D", "W9999"]).ends(2, "no warning has the code `W9999`");
    folder.run(&["check", "b.gct", "--allow", "E0201"]).ends(2, "`E0201` is an error in any case");
    folder.run(&["check", "b.gct", "-D", "W0403", "--allow", "W0403"]).ends(2, "both denied and allowed");
}

#[test]
fn nothing_is_written_of_a_chart_with_a_denied_warning() {
    let folder = Folder::new(&[("b.gct", DUBIOUS)]);
    let st = ["b.gct", "--target", "st", "-o", "b.st"];
    folder.run(&[&st[..], &["-D", "W0403"]].concat()).ends(1, "error[W0403]");
    assert_eq!(folder.names(), ["b.gct"]);
    folder.run(&[&st[..], &["-D", "warnings", "--allow", "W0403"]].concat()).is_done();
    assert_eq!(folder.names(), ["b.gct", "b.st"]);
    // That of an encoding, which no check knows of.
    let deactivation = VALVE.replace("{ V }", "{ V := 1 on deactivation }");
    let folder = Folder::new(&[("v.gct", &deactivation)]);
    let overlap = ["v.gct", "--target", "st", "--encoding", "r-trigger", "-o", "v.st", "-D", "warnings"];
    folder.run(&overlap).ends(1, "error[W0413]");
    assert_eq!(folder.names(), ["v.gct"]);
}

#[test]
fn one_chart_that_cannot_be_read_does_not_hide_the_others() {
    let folder = Folder::new(&[("a.gct", FAULTY)]);
    folder.run(&["check", "missing.gct", "a.gct"]).ends(3, "cannot read `missing.gct`").ends(3, "E0201");
}

#[test]
fn no_colour_where_there_is_no_terminal() {
    let folder = Folder::new(&[("a.gct", FAULTY)]);
    assert!(!folder.run(&["check", "a.gct"]).err.contains('\u{1b}'));
}

#[test]
fn wrong_use_ends_with_2() {
    let folder = Folder::new(&[("a.gct", VALVE)]);
    folder.run(&["check"]).ends(2, "CHART");
    folder.run(&["check", "a.gct", "--format", "xml"]).ends(2, "possible values: human, json, sarif");
    folder.run(&["check", "-", "-"]).ends(2, "standard input is named twice");
    folder.run(&["check", "a.gct", "--target", "st"]).ends(2, "--target");
}

#[test]
fn syntax_errors_hide_no_certain_fault_and_cause_no_doubtful_one() {
    let text = "\
input a, a : bool
step ?
initial step 1
transition 1 -> 9 : a and ↑(a · ↑a)
transition 1 -> : b
transition 1 -> : a or
";
    let folder = Folder::new(&[("mixed.gct", text)]);
    let run = folder.run(&["check", "mixed.gct"]);
    run.ends(1, "mixed.gct:1:10").ends(1, "mixed.gct:2:6").ends(1, "mixed.gct:4:33").ends(1, "mixed.gct:6:23");
    assert!(run.err.contains("E0202") && run.err.contains("E0413"), "{}", run.err);
    // The step `9` and the variable `b` may stand in what could not be read.
    assert!(run.err.ends_with("\n4 errors\n"), "{}", run.err);
}
