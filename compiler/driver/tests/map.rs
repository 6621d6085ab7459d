//! `grafc CHART --target T --map FILE`.

mod common;

use common::{FAULTY, Folder, VALVE};
use serde_json::Value;

fn map(folder: &Folder, name: &str) -> Value {
    serde_json::from_str(&folder.read(name)).expect("JSON")
}

/// The lines of an element, each by its number.
fn lines_of(map: &Value, kind: &str, name: &str) -> Vec<u64> {
    let elements = map["elements"].as_array().expect("a list");
    let found = elements.iter().find(|e| e["kind"] == kind && e["name"] == name).expect("the element");
    let runs = found["lines"].as_array().expect("a list");
    let number = |run: &Value, at: usize| run[at].as_u64().expect("a number");
    runs.iter().flat_map(|run| number(run, 0)..=number(run, 1)).collect()
}

/// The chart has six elements; where they are in it can be counted in its text.
#[test]
fn every_element_is_there_with_its_place() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    folder.run(&["valve.gct", "--target", "st", "-o", "valve.st", "--map", "valve.json"]).is_done();
    let map = map(&folder, "valve.json");
    for (field, value) in
        [("chart", "valve.gct"), ("output", "valve.st"), ("target", "st"), ("encoding", "single-phase")]
    {
        assert_eq!(map[field], value);
    }
    assert_eq!(map["version"], 1);
    let elements: Vec<String> = map["elements"]
        .as_array()
        .expect("a list")
        .iter()
        .map(|e| {
            let at = e["at"].as_str().map_or(String::new(), |at| format!(" at {at}"));
            let (from, to) = (&e["start"], &e["end"]);
            assert_eq!(from["line"], to["line"], "each stands on one line");
            let kind = e["kind"].as_str().expect("a kind");
            let name = e["name"].as_str().expect("a name");
            format!("{kind} {name}{at} {}:{}-{}", from["line"], from["column"], to["column"])
        })
        .collect();
    assert_eq!(
        elements,
        [
            "declaration a 3:8-9",
            "declaration b 3:11-12",
            "declaration V 4:8-9",
            "step 1 7:16-17",
            "step 2 8:8-9",
            "action V at 2 8:12-13",
            "transition 1 at 1 -> 2 10:3-28",
            "transition 2 at 2 -> 1 11:3-28",
        ]
    );
}

/// What is about an element can be read beside it in the code.
#[test]
fn lines_and_elements_are_one_table_in_two_orders() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    folder.run(&["valve.gct", "--target", "st", "-o", "valve.st", "--map", "valve.json"]).is_done();
    let (map, code) = (map(&folder, "valve.json"), folder.read("valve.st"));
    let code: Vec<&str> = code.lines().map(str::trim).collect();
    let texts = |kind: &str, name: &str| -> Vec<&str> {
        lines_of(&map, kind, name).into_iter().map(|line| code[line as usize - 1]).collect()
    };
    let clearing = texts("transition", "1").into_iter().find(|line| line.contains(":=")).expect("its clearing");
    assert!(clearing.starts_with("clr_1 := X1 AND a;") && clearing.ends_with("(* 1 -> 2 *)"), "{clearing}");
    assert!(texts("action", "V").contains(&"V := X2;"));
    assert!(texts("declaration", "V").contains(&"V := X2;"), "what writes it");
    assert!(texts("step", "2").iter().any(|line| line.starts_with("X2 := clr_1 OR (X2 AND NOT clr_2);")));
    assert!(texts("declaration", "a").iter().all(|line| line.starts_with("a, b : BOOL;")), "one line declares both");

    // The other order says the same.
    let elements = map["elements"].as_array().expect("a list");
    let mut pairs: Vec<(u64, u64)> = Vec::new();
    let mut before = 0;
    for run in map["lines"].as_array().expect("a list") {
        let (first, last) = (run["first"].as_u64().expect("a line"), run["last"].as_u64().expect("a line"));
        assert!(before < first && first <= last, "runs are in order and do not overlap");
        before = last;
        let elements = run["elements"].as_array().expect("a list");
        assert!(!elements.is_empty());
        pairs.extend((first..=last).flat_map(|l| elements.iter().map(move |e| (l, e.as_u64().expect("a place")))));
    }
    let mut others: Vec<(u64, u64)> = Vec::new();
    for (place, element) in (0..).zip(elements) {
        let (kind, name) = (element["kind"].as_str().expect("a kind"), element["name"].as_str().expect("a name"));
        others.extend(lines_of(&map, kind, name).into_iter().map(|line| (line, place)));
    }
    pairs.sort_unstable();
    others.sort_unstable();
    assert_eq!(pairs, others);
}

#[test]
fn a_map_changes_nothing_and_is_the_same_each_time() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    for target in ["st", "il", "awl", "scl", "rust", "js", "c"] {
        let plain = folder.run(&["valve.gct", "--target", target]).is_done().out.clone();
        let mapped = folder.run(&["valve.gct", "--target", target, "--map", "one.json"]).is_done().out.clone();
        assert_eq!(plain, mapped, "{target}");
        folder.run(&["valve.gct", "--target", target, "--map", "two.json"]).is_done();
        assert_eq!(folder.read("one.json"), folder.read("two.json"), "{target}");
        assert_eq!(map(&folder, "one.json")["output"], Value::Null, "{target}");
        // Nothing is said of lines that are not there.
        let count = plain.lines().count() as u64;
        let last = map(&folder, "one.json")["lines"].as_array().and_then(|runs| runs.last().cloned()).expect("a run");
        assert!(last["last"].as_u64().is_some_and(|line| line <= count), "{target}");
    }
}

#[test]
fn a_map_takes_the_place_of_nothing_else() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    for (arguments, diagnostics) in [
        (&["--target", "st", "-o", "valve.st", "--map", "./valve.st"][..], "one place"),
        (&["--target", "st", "--map", "-"], "one place"),
        (&["--target", "st", "--map", "valve.gct"], "would overwrite"),
        (&["--target", "plcopen", "--map", "valve.json"], "`--map` is an option of"),
        (&["--emit", "scan", "--map", "valve.json"], "cannot be used with"),
    ] {
        let run = folder.run(&[&["valve.gct"], arguments].concat());
        run.ends(2, diagnostics);
        assert!(!folder.path("valve.json").exists() && !folder.path("valve.st").exists(), "{arguments:?}");
    }
    assert_eq!(folder.read("valve.gct"), VALVE);
    let run = folder.run(&["valve.gct", "--target", "st", "-o", "valve.st", "--map", "-"]);
    assert!(run.is_done().out.starts_with("{\n  \"version\": 1,\n"), "the code is elsewhere");
}

#[test]
fn errors_stop_without_a_map() {
    let folder = Folder::new(&[("faulty.gct", FAULTY)]);
    folder.run(&["faulty.gct", "--target", "st", "-o", "f.st", "--map", "f.json"]).ends(1, "error[E0201]");
    assert!(!folder.path("f.json").exists() && !folder.path("f.st").exists());
}
