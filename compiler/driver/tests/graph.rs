//! `grafc graph`: forms, limits, exit codes. What it finds is tested in the test suite.

mod common;

use common::{DUBIOUS, FAULTY, Folder, VALVE};

#[test]
fn the_forms() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    let text = folder.run(&["graph", "valve.gct", "-q"]);
    text.ends(0, "");
    // From 1, `a` leads to 2 unless `b` leads back at once: that reaction does not end.
    assert!(text.out.starts_with("Valve: 2 situations, 2 states, 2 edges\n"), "{}", text.out);
    assert!(text.out.contains("\n0  {1}  initial\n   a and not b -> 1  {2}\n"), "{}", text.out);
    assert!(text.out.contains("\n   a and b LIVELOCK by (1) (2)\n"), "{}", text.out);

    let json = folder.run(&["graph", "valve.gct", "-q", "--format", "json"]);
    let graph: serde_json::Value = serde_json::from_str(&json.out).unwrap();
    assert_eq!(graph["version"], 1);
    assert_eq!(graph["situations"][1]["steps"][0], "2");
    assert_eq!(graph["edges"][0], serde_json::json!({ "from": 0, "to": 1, "when": "a and not b" }));
    let start = serde_json::json!({ "from": null, "when": "a and b", "ring": ["(1)", "(2)"] });
    assert_eq!(graph["livelock"][0], start);

    let dot = folder.run(&["graph", "valve.gct", "-q", "--format", "dot"]);
    assert!(dot.out.starts_with("digraph \"Valve\" {\n") && dot.out.contains("0 -> 1 [label=\"a and not b\"];"));

    folder.run(&["graph", "valve.gct", "-q", "--format", "svg", "-o", "graph.svg"]).is_done();
    let svg = folder.read("graph.svg");
    assert!(svg.contains("<g class=\"state initial\" data-state=\"0\"") && svg.contains("LIVELOCK"), "{svg}");

    let states = folder.run(&["graph", "valve.gct", "-q", "--of", "states", "--format", "json"]);
    let states: serde_json::Value = serde_json::from_str(&states.out).unwrap();
    assert_eq!(states["situations"].as_array().map(Vec::len), Some(2));
}

#[test]
fn what_is_not_decided_ends_with_4_and_errors_with_1() {
    let sum = "input n : int\nvar sum : int\ninitial step 1 { sum := sum + n on activation }\nstep 2\n\
               transition 1 -> 2 : [sum < 5]\ntransition 2 -> 1 : [sum > 5]\n";
    let folder = Folder::new(&[("valve.gct", VALVE), ("faulty.gct", FAULTY), ("sum.gct", sum), ("edge.gct", DUBIOUS)]);
    let few = folder.run(&["graph", "valve.gct", "-q", "--max", "1"]);
    few.ends(4, "");
    assert!(few.out.contains("there are more"), "{}", few.out);
    folder.run(&["graph", "sum.gct", "-q"]).ends(4, "`n`");
    let faulty = folder.run(&["graph", "faulty.gct", "-o", "graph.txt"]);
    faulty.ends(1, "E0201");
    assert!(!folder.path("graph.txt").exists());
    folder.run(&["graph", "valve.gct", "-o", "valve.gct"]).ends(2, "overwrite");
    folder.run(&["graph", "edge.gct"]).ends(0, "W04");
}
