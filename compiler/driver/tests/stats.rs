//! `grafc stats`.

mod common;

use common::{DUBIOUS, FAULTY, Folder, VALVE};
use serde_json::{Value, json};

/// The row of an encoding, as numbers and words.
fn row<'t>(table: &'t str, encoding: &str) -> Vec<&'t str> {
    let row = table.lines().find(|line| line.starts_with(encoding)).unwrap_or_else(|| panic!("{table}"));
    row.split_whitespace().skip(1).collect()
}

#[test]
fn a_chart_has_a_row_for_each_encoding() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    let table = folder.run(&["stats", "valve.gct", "--evolution", "scan"]).is_done().out.clone();
    assert!(table.starts_with("Valve: 2 steps, 2 transitions, evolution scan\n\nencoding  "), "{table}");
    // clr_1 := X1 AND a; clr_2 := X2 AND b; X1 := clr_2 OR X1 AND NOT clr_1; X2 alike; V := X2: 3 + 3 + 4 + 4 + 2.
    // In the instruction list also LDN started, JMPCN, ST started, ST X1 of the first call.
    // In STL AN started, S started, S X1; a bare O in X1 and X2; A RESTART, JCN and four R; BE.
    assert_eq!(row(&table, "single-phase"), ["2", "0", "2", "0", "0", "none", "5", "16", "20"]);
    assert!(table.contains("\nin AWL\n  single-phase 28, "), "{table}");
    let names: Vec<&str> = table.lines().skip(3).take(5).filter_map(|line| line.split(' ').next()).collect();
    assert_eq!(names, ["single-phase", "r-trigger", "s-trigger", "sequent", "switch"]);
    assert_eq!(row(&table, "switch")[..2], ["0", "1"]);
    // A byte of state, V, four flags, the mark of the first call.
    assert!(table.contains("\nbytes in Rust\n  single-phase 12, ") && table.contains(", switch 7\n"), "{table}");
    let bits: usize = row(&table, "r-trigger")[0].parse().unwrap();
    assert!(bits > 2, "a ring of two steps gets a further one: {table}");
}

#[test]
fn where_evolutions_are_repeated_the_bound_is_shown() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    // Both inputs at once never let it rest, so there has to be a bound.
    let run = |arguments: &[&str]| row(&folder.run(arguments).is_done().out, "single-phase")[5].to_string();
    assert_eq!(run(&["stats", "valve.gct"]), "200");
    assert_eq!(run(&["stats", "valve.gct", "--bound", "7"]), "7");
}

#[test]
fn what_is_proved_of_evolutions_is_said() {
    // Once around takes an edge each, so nothing ever follows in the same reaction.
    let once = "input a : bool\ninitial step 1\nstep 2\ntransition 1 -> 2 : ↑a\ntransition 2 -> 1 : ↑a\n";
    // A contradiction on an input: 2 -> 1 cannot follow 1 -> 2, but 1 -> 2 may be followed by nothing.
    let ends = "input a : bool\ninitial step 1\nstep 2\ntransition 1 -> 2 : a\ntransition 2 -> 1 : not a\n";
    let folder = Folder::new(&[("once.gct", once), ("ends.gct", ends), ("valve.gct", VALVE)]);
    let run = |chart: &str| folder.run(&["stats", chart]).is_done().out.clone();
    assert!(run("once.gct").contains("one micro-step is always enough"), "{}", run("once.gct"));
    assert_eq!(row(&run("once.gct"), "single-phase")[5], "none");
    assert!(run("ends.gct").contains("one micro-step is always enough"), "{}", run("ends.gct"));
    assert!(
        run("valve.gct").contains("no bound is known: these may clear in a circle: `1 -> 2`"),
        "{}",
        run("valve.gct")
    );
}

#[test]
fn json_is_one_object_with_keys_that_stay() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    let run = folder.run(&["stats", "valve.gct", "--format", "json"]);
    let figures: Value = serde_json::from_str(&run.is_done().out).unwrap();
    assert!(run.out.ends_with("}\n") && run.out.lines().count() == 1, "{}", run.out);
    assert_eq!(
        keys(&figures),
        ["chart", "encodings", "evolution", "exclusion", "steps", "switch", "transients", "transitions"]
    );
    assert_eq!((&figures["chart"], &figures["evolution"]), (&json!("Valve"), &json!("stable")));
    assert_eq!((&figures["steps"], &figures["transitions"]), (&json!(2), &json!(2)));
    // As in one evolution a scan, and again := clr_1 OR clr_2.
    let single_phase = json!({
        "encoding": "single-phase", "state_bits": 2, "states": [], "auxiliary_bits": 3, "auxiliary_numbers": 0,
        "delays": 0, "loop": { "bound": 200 }, "statements": 6, "instructions": 19,
        // Of the 6 all but the output are in each micro-step: 200 times 5, the output, and 3 of the first call.
        "worst_case": { "micro_steps": 200, "statements": 1004 },
        // And 4 at the first call, 5 before each micro-step and 7 after it.
        "il_instructions": 35,
        // 28, an R of LIVELOCK, 3 for `again`, 6 before each micro-step and 7 after it.
        "awl_instructions": 45,
        // A word for the steps, V, four flags, the mark of the first call; aligned to the word.
        "rust_bytes": 12,
    });
    assert_eq!(figures["encodings"][0], single_phase);
    assert_eq!(figures["switch"]["states"][0]["steps"], json!(["1", "2"]));
    assert_eq!(keys(&figures["switch"]["states"][0]), ["idle", "name", "steps"]);
    assert_eq!(figures["switch"]["bits"], json!([]));

    let scan = folder.run(&["stats", "valve.gct", "--format", "json", "--evolution", "scan"]);
    let figures: Value = serde_json::from_str(&scan.is_done().out).unwrap();
    assert_eq!(figures["encodings"][0]["loop"], Value::Null);
}

fn keys(value: &Value) -> Vec<&str> {
    let mut keys: Vec<&str> = value.as_object().unwrap().keys().map(String::as_str).collect();
    keys.sort_unstable();
    keys
}

/// Every clearing of the source brings a further token, and two steps that wait for them may be active at once.
const SOURCE: &str = "\
chart Source
input  a, b, c : bool
output V : bool
grafcet G1 {
  initial step 1
  step 2 { V }
  step 3
  step 4
  step 5
  transition 1 -> 2 : a
  transition 2 -> 3 : b
  transition 3 -> 4 : c
  transition 4 -> 5 : b
  transition 5 -> 1 : not a
}
grafcet G2 {
  step 11
  step 12
  transition -> 11 : ↑a
  transition 11 -> 12 : b
  transition 12 -> : c
}
";

#[test]
fn switch_says_which_steps_share_a_variable() {
    let folder = Folder::new(&[("source.gct", SOURCE)]);
    let table = folder.run(&["stats", "source.gct"]).is_done().out.clone();
    let after = |heading: &str| -> Vec<Vec<&str>> {
        let lines = table.lines().skip_while(|line| *line != heading).skip(1).take_while(|line| !line.is_empty());
        lines.map(|line| line.split_whitespace().collect()).collect()
    };
    // A ring of five takes fewer lines as a number; of the other grafcet nothing is proved.
    let states = after("steps in switch");
    assert!(states.len() == 1 && states[0][0].starts_with("at_"), "{table}");
    assert_eq!(states[0][1..], ["1", "2", "3", "4", "5"], "{table}");
    let bits = after("steps that stay bits");
    assert_eq!(bits.iter().map(|line| line[0]).collect::<Vec<_>>(), ["11", "12"], "{table}");
    assert!(bits[0].join(" ").contains("`-> 11`"), "the source transition is to blame: {table}");
    let figures = folder.run(&["stats", "source.gct", "--format", "json"]);
    let figures: Value = serde_json::from_str(&figures.is_done().out).unwrap();
    assert_eq!(figures["switch"]["states"].as_array().map(Vec::len), Some(1));
    assert_eq!(figures["switch"]["states"][0]["steps"], json!(["1", "2", "3", "4", "5"]));
    assert_eq!(figures["switch"]["bits"][1]["step"], json!("12"));
    assert!(figures["switch"]["bits"][0]["because"].as_str().is_some_and(|why| why.contains("`-> 11`")), "{figures}");
}

/// Four short steps take fewer lines as bits, unless a comment wants a line each in any case.
#[test]
fn switch_says_nothing_of_shared_variables_where_there_are_none() {
    let four =
        SOURCE.replace("  step 5\n", "").replace("transition 4 -> 5 : b\n  transition 5 -> 1", "transition 4 -> 1");
    let folder = Folder::new(&[("four.gct", &four), ("said.gct", &four.replace("step 3", "step 3 \"three\""))]);
    let run = |chart: &str| folder.run(&["stats", chart]).is_done().out.clone();
    assert!(!run("four.gct").contains("steps in switch"), "{}", run("four.gct"));
    assert!(run("said.gct").contains("steps in switch"), "{}", run("said.gct"));
}

#[test]
fn lines_stay_within_a_hundred_columns() {
    let mut chart = "input a : bool\ninitial step 1\n".to_string();
    for s in 2..=400 {
        chart.push_str(&format!("step {s}\ntransition {} -> {s} : ↑a\n", s - 1));
    }
    chart.push_str("transition 400 -> 1 : ↑a\n");
    let folder = Folder::new(&[("ring.gct", &chart)]);
    let table = folder.run(&["stats", "ring.gct"]).is_done().out.clone();
    let longest = table.lines().map(|line| line.chars().count()).max();
    assert!(longest.is_some_and(|n| n <= 100), "{table}");
    assert!(table.lines().all(|line| line == line.trim_end()), "{table}");
    let steps: Vec<&str> = table.split_once("at_").unwrap().1.split_whitespace().skip(1).take(400).collect();
    let wanted: Vec<String> = (1..=400).map(|s| s.to_string()).collect();
    assert_eq!(steps, wanted, "each step once and in order");
}

#[test]
fn a_chart_with_errors_has_no_figures() {
    let folder = Folder::new(&[("faulty.gct", FAULTY), ("dubious.gct", DUBIOUS)]);
    let run = folder.run(&["stats", "faulty.gct"]);
    assert_eq!(run.ends(1, "E0201").out, "");
    let run = folder.run(&["stats", "dubious.gct"]);
    run.ends(0, "W0403").ends(0, "1 warning");
    assert!(run.out.contains("\nsingle-phase "), "{}", run.out);
    let run = folder.run(&["stats", "faulty.gct", "--format", "json"]);
    assert_eq!(run.ends(1, "\"code\":\"E0201\"").out, "");
}

#[test]
fn wrong_use_ends_with_2_and_a_missing_file_with_3() {
    let folder = Folder::new(&[("a.gct", VALVE)]);
    folder.run(&["stats"]).ends(2, "CHART");
    folder.run(&["stats", "a.gct", "--format", "sarif"]).ends(2, "possible values: human, json");
    folder.run(&["stats", "missing.gct"]).ends(3, "cannot read `missing.gct`");
    assert!(folder.run_with(&["stats", "-"], VALVE).is_done().out.starts_with("Valve: 2 steps"));
}

/// Two branches of which each is at one of two steps, so four situations; the other grafcet sees to the rest.
const TABLE: &str = "\
chart Saw
input a, b, c, d, stop : bool
output V, W, lamp, clamp, hold, horn : bool
retain output fault : bool
grafcet Safety {
  initial step S1
  step S2 { force Work{}   hold := 0 on activation }
  transition S1 -> S2 : stop { fault := 1 }
  transition S2 -> S1 : not stop
}
grafcet Work {
  initial step 1 { lamp if a   lamp if b   clamp := 0 on deactivation }
  step 2 { V   clamp := 1 on activation   hold := 1 on activation }
  step 3 { V if c   horn := 1 on activation   horn := 0 on deactivation }
  step 4 { W if d }
  step 5 { W }
  transition 1 -> 2, 4 : a and b
  transition 2 -> 3 : c and not d
  transition 4 -> 5 : d and not c
  transition 3, 5 -> 1 : not a
}
";

#[test]
fn outputs_are_listed_by_situation() {
    let folder = Folder::new(&[("saw.gct", TABLE)]);
    let run = folder.run(&["stats", "saw.gct", "--outputs", "-q"]);
    let expected = "\
Saw: 3 outputs of continuous actions, 4 of stored ones

            V   W   lamp
Safety: S1  -   -   -
Safety: S2  -   -   -
Work: 1     -   -   if
Work: 2 4   on  if  -
Work: 2 5   on  on  -
Work: 3 4   if  if  -
Work: 3 5   if  on  -

if
  V in 3 4   c
  V in 3 5   c
  W in 2 4   d
  W in 3 4   d
  lamp in 1  a or b

stored
  clamp  := false on deactivation of 1
         := true on activation of 2
         may stay on after Work{} by S2
  hold   := false on activation of S2
         := true on activation of 2
  horn   := true on activation of 3
         := false on deactivation of 3
  fault  := true when S1 -> S2 is cleared
         never reset
         keeps its value over a restart
";
    assert_eq!(run.is_done().out, expected);
    let json: Value =
        serde_json::from_str(&folder.run(&["stats", "saw.gct", "--outputs", "--format", "json", "-q"]).is_done().out)
            .unwrap();
    assert_eq!(keys(&json), ["chart", "outputs", "situations", "stored"]);
    assert_eq!(
        json["situations"][3],
        json!({ "grafcet": "Work", "steps": ["2", "4"], "whole": true, "on": ["V"], "if": { "W": ["d"] } })
    );
    assert_eq!(
        json["stored"][0],
        json!({
            "output": "clamp",
            "written": [":= false on deactivation of 1", ":= true on activation of 2"],
            "never_reset": false, "stays_on": [{ "grafcet": "Work", "by": "S2" }], "retain": false,
        })
    );
}

/// An order empties the enclosures of its grafcet with it, up to the innermost (R5a).
#[test]
fn what_an_order_empties_with_its_grafcet_stays_on_as_well() {
    let chart = "input a, b : bool
output V, W, U : bool
grafcet G1 {
  initial step 1
  enclosing step 2 { U := true on activation }
  transition 1 -> 2 : a
}
grafcet X2/G2 {
  activated enclosing step 3 { V := true on activation }
}
grafcet X3/G3 {
  activated step 4 { W := true on activation  W := false on deactivation }
  step 5 { W := true on activation }
  transition 4 -> 5 : a
}
grafcet S {
  initial step S1
  step S2 { force G1 {} }
  transition S1 -> S2 : b
}
";
    let folder = Folder::new(&[("in.gct", chart)]);
    let text = folder.run(&["stats", "in.gct", "--outputs", "--format", "json", "-q"]).is_done().out.clone();
    let json: Value = serde_json::from_str(&text).unwrap();
    let stays_on = |place: usize| json["stored"][place]["stays_on"].clone();
    assert_eq!(stays_on(0), json!([{ "grafcet": "G2", "by": "S2" }]));
    // Step 4 takes it back when it is left; step 5 does not.
    assert_eq!(stays_on(1), json!([{ "grafcet": "G3", "by": "S2" }]));
    assert_eq!(stays_on(2), json!([{ "grafcet": "G1", "by": "S2" }]));
}

/// Seven branches of two steps: 128 situations and the first one.
#[test]
fn where_situations_are_many_steps_are_listed() {
    use std::fmt::Write;
    let mut chart = "input a, b : bool\noutput V : bool\ninitial step 0\n".to_owned();
    let list = |k: u32| (1..=7).map(|branch| (10 * branch + k).to_string()).collect::<Vec<_>>().join(", ");
    for branch in 1..=7 {
        writeln!(chart, "step {branch}0 {{ V }}\nstep {branch}1\ntransition {branch}0 -> {branch}1 : a and not b")
            .unwrap();
    }
    writeln!(chart, "transition 0 -> {} : b and not a\ntransition {} -> 0 : b and not a", list(0), list(1)).unwrap();
    let folder = Folder::new(&[("wide.gct", chart.as_str())]);
    let run = folder.run(&["stats", "wide.gct", "--outputs", "-q"]);
    let lines: Vec<&str> = run.is_done().out.lines().filter(|line| line.starts_with("G1: ")).collect();
    assert_eq!(lines.len(), 15, "{}", run.out);
    assert_eq!(lines[..3], ["G1: 0 +   -", "G1: 10 +  on", "G1: 11 +  -"]);
    assert!(run.out.contains("A line with `+` is a step"), "{}", run.out);
}

#[test]
fn a_chart_with_errors_has_no_table() {
    let folder = Folder::new(&[("faulty.gct", FAULTY)]);
    let run = folder.run(&["stats", "faulty.gct", "--outputs"]);
    assert_eq!((run.code, run.out.as_str()), (1, ""));
}

/// A ring of so many steps, each with an output of its own: beyond 20,000 cells there is a list.
#[test]
fn where_the_table_would_be_large_there_is_a_list() {
    use std::fmt::Write;
    let chart = |steps: usize| {
        let mut chart = "input a, b : bool\ninitial step 0 { V0 }\n".to_owned();
        for step in 1..steps {
            writeln!(chart, "step {step} {{ V{step} if a }}").unwrap();
        }
        for step in 0..steps {
            let condition = if step % 2 == 0 { "a" } else { "b" };
            writeln!(chart, "transition {step} -> {} : {condition}", (step + 1) % steps).unwrap();
        }
        let outputs: Vec<String> = (0..steps).map(|step| format!("V{step}")).collect();
        format!("output {} : bool\n{chart}", outputs.join(", "))
    };
    let folder = Folder::new(&[("small.gct", &chart(140)), ("large.gct", &chart(142))]);
    let of = |name: &str| folder.run(&["stats", name, "--outputs", "-q"]).is_done().out.clone();
    assert!(of("small.gct").contains("\nG1: 1    -   if  -"), "140 times 140 cells");
    let large = of("large.gct");
    assert!(large.contains("\n\n  G1: 0    V0\n  G1: 1    V1 (if)\n  G1: 2    V2 (if)\n"), "{large}");
    assert!(large.contains("\nif\n  V1 in 1      a\n"), "{large}");
    assert!(large.len() < 40 * 142, "a line or two a situation");
}
