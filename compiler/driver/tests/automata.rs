//! `grafc automata`: forms, limits, exit codes. What it finds is tested in its crate and in the test suite.

mod common;

use common::{FAULTY, Folder, VALVE};

/// A head that starts another graph and waits for it; `n` is a number.
const PARALLEL: &str = "\
chart Two
input go, done, back : bool
output V : bool
var n : int
initial step 1
step 2 \"left\"
step 3 { V  n := n + 1 on activation }
step 4
transition 1 -> 2, 3 : go
transition 3 -> 4 : done
transition 2, 4 -> 1 : back
allow W0424 \"no matter\"
";

fn folder() -> Folder {
    Folder::new(&[("valve.gct", VALVE), ("two.gct", PARALLEL), ("faulty.gct", FAULTY)])
}

#[test]
fn the_graphs_of_a_chart() {
    let folder = folder();
    let expected = "\
Two: 2 graphs, 5 vertices

A0
1  initial
   go -> 2
2
   A1 = 4 · back -> 1

A1
3  { V  n := n + 1 on activation }
   done -> 4
4
   A0 = 2 · back -> -
-  initial
   A0 = 1 · go -> 3
";
    assert_eq!(folder.run(&["automata", "two.gct", "-q"]).is_done().out, expected);
    let json = folder.run(&["automata", "two.gct", "-q", "--format", "json"]);
    let system: serde_json::Value = serde_json::from_str(&json.is_done().out).unwrap();
    assert_eq!((&system["version"], &system["chart"]), (&1.into(), &"Two".into()));
    assert_eq!(system["graphs"][1]["arcs"][0]["states"][0], serde_json::json!({ "graph": 0, "vertex": 0 }));
    let dot = folder.run(&["automata", "two.gct", "-q", "--format", "dot"]);
    assert!(dot.out.starts_with("digraph \"Two\" {\n"), "{}", dot.out);
    assert!(dot.out.contains("1 -> 0 [label=\"A1 = 4 · back\"];"), "{}", dot.out);
    folder.run(&["automata", "two.gct", "-q", "--format", "svg", "-o", "two.svg"]).is_done();
    assert!(folder.read("two.svg").contains("<svg"));
}

#[test]
fn a_chart_as_an_automaton() {
    let folder = folder();
    let expected = "\
Valve: Moore automaton, 2 vertices, 2 loops, 2 arcs
The chart has 2 states; both do the same, in 2 pairs of their product.

1  initial
   ¬a + b -> 1
   a · ¬b -> 2
2  { V }
   ¬a · b -> 1
   ¬b + a -> 2
";
    // With both, the valve opens and closes without end, and a call that is given up ends where it began.
    let valve = VALVE.replace("1 -> 2 : a", "1 -> 2 : a and not b").replace("2 -> 1 : b", "2 -> 1 : b and not a");
    std::fs::write(folder.path("valve.gct"), valve).unwrap();
    assert_eq!(folder.run(&["automata", "valve.gct", "-q", "--as", "moore"]).is_done().out, expected);
    let mealy = folder.run(&["automata", "valve.gct", "-q", "--as", "mealy", "--format", "kiss2"]);
    assert_eq!(mealy.is_done().out.lines().next(), Some(".i 2"));
    // A table is of one automaton in any case.
    assert_eq!(folder.run(&["automata", "valve.gct", "-q", "--format", "kiss2"]).is_done().out, mealy.out);
    let json = folder.run(&["automata", "valve.gct", "-q", "--as", "extended", "--format", "json"]);
    let extended: serde_json::Value = serde_json::from_str(&json.is_done().out).unwrap();
    assert_eq!(extended["vertices"][0]["outputs"][0], serde_json::json!({ "name": "V", "when": "a · ¬b" }));
    assert_eq!((&extended["kind"], &extended["pairs_of_the_product"]), (&"extended".into(), &2.into()));
    let minimal = folder.run(&["automata", "valve.gct", "-q", "--as", "minimal"]);
    assert!(minimal.is_done().out.contains("   a · ¬b / V -> 2\n"), "{}", minimal.out);
}

#[test]
fn what_is_no_automaton_is_said() {
    let folder = folder();
    folder.run(&["automata", "two.gct", "--as", "moore"]).ends(4, "`n` is a number").ends(4, "without `--as`");
    folder.run(&["automata", "valve.gct", "--as", "moore", "--max", "1"]).ends(4, "more than 1 states");
    folder.run(&["automata", "faulty.gct", "-o", "out.txt"]).ends(1, "faulty.gct:6:25");
    assert!(!folder.path("out.txt").exists());
    folder.run(&["automata", "valve.gct", "-o", "valve.gct"]).ends(2, "overwrite");
}
