//! `grafc CHART --emit STAGE` and `--dump-after PASS`: what lies between the stages, as text.

mod common;

use common::{DUBIOUS, FAULTY, Folder, VALVE};

/// A macro-step, and an enclosure that is forced.
const HIERARCHY: &str = "\
input a : bool
grafcet G1 {
  initial step 1
  macro step M2
  enclosing step 3 { force G4{6} }
  transition (go) 1 -> M2 : a
  transition M2 -> 3 : 1
}
expansion M2 { step E2  step S2  transition E2 -> S2 : a }
grafcet X3/G3 { activated step 5 }
grafcet G4 { initial step 6  step 7  transition 6 -> 7 : a }
";

const STAGES: [&str; 5] = ["ast", "model", "net", "logic", "scan"];

/// The lines below a heading, up to the next empty line.
fn below<'t>(text: &'t str, heading: &str) -> Vec<&'t str> {
    text.lines()
        .skip_while(|line| *line != heading)
        .skip(1)
        .take_while(|line| !line.is_empty())
        .map(str::trim)
        .collect()
}

#[test]
fn each_stage_says_what_it_knows() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    let emit = |stage: &str| folder.run(&["valve.gct", "--emit", stage]).is_done().out.clone();
    assert!(emit("ast").contains("    transition (1)\n      from 1\n      to 2\n      when a\n"), "{}", emit("ast"));
    assert_eq!(below(&emit("model"), "transitions"), ["(1): 1 -> 2 when a", "(2): 2 -> 1 when b"]);
    assert_eq!(below(&emit("model"), "continuous actions"), ["2: V"]);
    assert_eq!(below(&emit("net"), "places"), ["initial 1 of G1", "2 of G1"]);
    let logic = emit("logic");
    assert!(logic.contains("  clr_1 = X1 AND a\n") && logic.contains("  V = X2\n"), "{logic}");
    let scan = emit("scan");
    assert!(scan.contains("  clr_1 := X1 AND a  -- 1 -> 2\n") && scan.contains("\n  input a : bool\n"), "{scan}");
}

#[test]
fn the_text_goes_where_code_would_go() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    for stage in STAGES {
        let printed = folder.run(&["valve.gct", "--emit", stage]).is_done().out.clone();
        assert_eq!(folder.run(&["valve.gct", "--emit", stage, "-o", "out.txt"]).is_done().out, "");
        assert_eq!(folder.read("out.txt"), printed);
        assert_eq!(folder.run_with(&["-", "--emit", stage], VALVE).is_done().out, printed);
    }
    folder.run(&["valve.gct", "--emit", "net", "-o", "valve.gct"]).ends(2, "overwrite `valve.gct`");
    assert_eq!(folder.read("valve.gct"), VALVE);
}

#[test]
fn the_encoding_and_the_profile_reach_what_follows_them() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    let emit = |arguments: &[&str]| {
        let all: Vec<&str> = ["valve.gct", "--emit"].iter().chain(arguments).copied().collect();
        folder.run(&all).is_done().out.clone()
    };
    assert!(emit(&["scan", "--encoding", "switch"]).contains("  case at_G1\n    1:  -- step 1\n"));
    assert!(emit(&["logic", "--encoding", "switch"]).contains("  where at_G1 is\n    1:\n"));
    assert!(emit(&["scan", "--evolution", "scan"]).contains("\nmicro-step, once\n"));
    assert!(emit(&["scan", "--bound", "7"]).contains("\nmicro-step, repeated while again, at most 7 times"));
    assert_eq!(emit(&["model", "--encoding", "switch"]), emit(&["model"]));
}

#[test]
fn a_pass_leaves_no_trace_of_what_it_removes() {
    let folder = Folder::new(&[("h.gct", HIERARCHY)]);
    let after = |pass: &str| folder.run(&["h.gct", "--dump-after", pass]).is_done().out.clone();
    let text = after("expand-macro-steps");
    assert_eq!(below(&text, "facts"), ["no macro-steps"]);
    assert_eq!(
        below(&text, "transitions"),
        ["(go): 1 -> E2 when a", "#2: S2 -> 3 when true", "#3: E2 -> S2 when a", "#4: 6 -> 7 when a"]
    );
    assert_eq!(below(&text, "macro-steps"), ["M2: E2 to S2; places E2, S2"]);
    assert_eq!(below(&text, "orders"), ["3 forces G4{6}"]);
    assert!(text.contains("\n  G3 in 3, level 1\n"), "{text}");

    let text = after("flatten-enclosures");
    assert!(below(&text, "orders").is_empty() && !text.contains("G3 in 3"), "{text}");
    assert!(below(&text, "places").contains(&"activated 5 of G3, within 3"), "{text}");
    assert!(below(&text, "grafcets").contains(&"forced by 3: {6}"), "{text}");
    folder.run(&["h.gct", "--dump-after", "flatten-enclosures", "-o", "net.txt"]).is_done();
    assert_eq!(folder.read("net.txt"), text);
    assert_eq!(folder.run(&["h.gct", "--emit", "net"]).is_done().out, after("nest-children"));
}

#[test]
fn a_pass_that_some_encodings_need_is_shown_with_these() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    let run = folder.run(&["valve.gct", "--dump-after", "break-two-step-rings", "--encoding", "r-trigger"]);
    // Step 1 leads to step 2 and back.
    assert!(run.out.contains("auxiliary"), "{}", run.out);
    folder
        .run(&["valve.gct", "--dump-after", "break-two-step-rings"])
        .ends(2, "`break-two-step-rings` is not run with `--encoding single-phase`")
        .ends(2, "--encoding r-trigger");
}

#[test]
fn errors_stop_without_output() {
    let folder = Folder::new(&[("faulty.gct", FAULTY), ("broken.gct", "step { \n")]);
    for stage in &STAGES[1..] {
        let run = folder.run(&["faulty.gct", "--emit", stage, "-o", "out.txt"]);
        assert_eq!(run.ends(1, "error[E0201]").out, "");
    }
    assert_eq!(folder.run(&["faulty.gct", "--dump-after", "rank-orders", "-o", "out.txt"]).ends(1, "E0201").out, "");
    assert_eq!(folder.run(&["broken.gct", "--emit", "ast", "-o", "out.txt"]).ends(1, "error[E01").out, "");
    assert_eq!(folder.names(), ["broken.gct", "faulty.gct"]);
    // A tree does not know what names mean.
    let tree = folder.run(&["faulty.gct", "--emit", "ast"]);
    assert!(tree.is_done().out.contains("    when nowhere\n"), "{}", tree.out);
}

#[test]
fn warnings_do_not_stop() {
    let folder = Folder::new(&[("dubious.gct", DUBIOUS)]);
    let run = folder.run(&["dubious.gct", "--emit", "model"]);
    assert!(run.ends(0, "warning[W0403]").out.contains("when not ↑a"), "{}", run.out);
}

#[test]
fn wrong_use_ends_with_2() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    folder.run(&["valve.gct", "--emit", "bytecode"]).ends(2, "possible values: ast, model, net, logic, scan");
    folder
        .run(&["valve.gct", "--dump-after", "nothing"])
        .ends(2, "possible values: expand-macro-steps, rank-orders, settle-start");
    for (pair, what) in [
        (["--target", "st", "--emit", "net"], "'--target <TARGET>' cannot be used with '--emit <STAGE>'"),
        (["--emit", "net", "--emit", "scan"], "cannot be used multiple times"),
        (["--target", "st", "--dump-after", "rank-orders"], "cannot be used with '--dump-after <PASS>'"),
        (["--emit", "net", "--dump-after", "rank-orders"], "cannot be used with '--dump-after <PASS>'"),
        (["--emit", "net", "--pou", "program"], "'--emit <STAGE>' cannot be used with '--pou <KIND>'"),
        (["--dump-after", "rank-orders", "--task-interval", "1s"], "cannot be used with '--task-interval <DURATION>'"),
    ] {
        let all: Vec<&str> = ["valve.gct", "-o", "out.txt"].into_iter().chain(pair).collect();
        assert_eq!(folder.run(&all).ends(2, what).out, "");
    }
    folder.run(&["--emit", "net"]).ends(2, "CHART");
    folder.run(&["check", "valve.gct", "--emit", "net"]).ends(2, "--emit");
    assert_eq!(folder.names(), ["valve.gct"]);
}
