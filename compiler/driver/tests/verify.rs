//! `grafc verify`: forms, traces, exit codes. What it finds is tested in the test suite.

mod common;

use common::{FAULTY, Folder, VALVE};

/// 2 has no way out; nothing else is wrong.
const DEAD: &str =
    "chart Dead\ninput a : bool\ninitial step 1\nstep 2\ntransition (1) 1 -> 2 : ↑a\nallow W0416 \"meant\"\n";

/// Nothing is wrong.
const ROUND: &str = "chart Round\ninput a, b : bool\ninitial step 1\nstep 2\n\
                     transition (1) 1 -> 2 : a and not b\ntransition (2) 2 -> 1 : b\n";

#[test]
fn what_holds_ends_with_0_and_what_fails_with_1() {
    let folder = Folder::new(&[("round.gct", ROUND), ("dead.gct", DEAD), ("faulty.gct", FAULTY), ("valve.gct", VALVE)]);
    let round = folder.run(&["verify", "round.gct"]);
    assert!(round.is_done().out.starts_with("Round: 2 states\nholds  livelock\nholds  deadlock\n"), "{}", round.out);
    let dead = folder.run(&["verify", "dead.gct", "-q"]);
    dead.ends(1, "");
    let shown = "fails  deadlock: from {2} no other situation can be reached\n       0 ms: a = 0 -> {1}\n       1 ms: a = 1 -> {2}\n";
    assert!(dead.out.contains(shown), "{}", dead.out);
    assert!(dead.out.contains("note   home: from {2} no initial situation can be reached\n"), "{}", dead.out);
    // With both inputs the reaction goes round for ever.
    let valve = folder.run(&["verify", "valve.gct", "-q"]);
    valve.ends(1, "");
    assert!(valve.out.contains("fails  livelock"), "{}", valve.out);
    let faulty = folder.run(&["verify", "faulty.gct", "--traces", "traces"]);
    faulty.ends(1, "E0201");
    assert!(!folder.path("traces").exists() && faulty.out.is_empty());
}

#[test]
fn a_note_that_fails_is_no_fault() {
    let chart = "chart Both\ninput a, b : bool\ninitial step 1\nstep 2\nstep 3\n\
                 transition (1) 1 -> 2 : a\ntransition (2) 1 -> 3 : b\n\
                 transition (3) 2 -> 1 : not a\ntransition (4) 3 -> 1 : not b\n";
    let folder = Folder::new(&[("both.gct", chart)]);
    let found = folder.run(&["verify", "both.gct", "-q"]);
    assert!(found.is_done().out.contains("note   selection 1: two transitions after it are cleared together\n"));
}

#[test]
fn the_forms() {
    let folder = Folder::new(&[("dead.gct", DEAD)]);
    let json = folder.run(&["verify", "dead.gct", "-q", "--format", "json"]);
    let found: serde_json::Value = serde_json::from_str(&json.out).unwrap();
    assert_eq!((&found["version"], &found["states"], &found["complete"]), (&1.into(), &4.into(), &true.into()));
    assert_eq!(found["claims"][0], serde_json::json!({ "name": "livelock", "kind": "livelock", "answer": "holds" }));
    let deadlock = &found["claims"][1];
    assert_eq!(deadlock["answer"], "fails");
    let last = serde_json::json!({ "t_ms": 1, "inputs": { "a": true }, "situation": ["2"] });
    assert_eq!(deadlock["trace"][1], last);
    let junit = folder.run(&["verify", "dead.gct", "-q", "--format", "junit"]);
    junit.ends(1, "");
    assert!(junit.out.contains("<testcase name=\"deadlock\" classname=\"Dead\">"), "{}", junit.out);
    assert!(junit.out.contains("failures=\"1\" errors=\"0\""), "{}", junit.out);
}

#[test]
fn traces_are_files_that_sim_replays() {
    let folder = Folder::new(&[("dead.gct", DEAD)]);
    folder.run(&["verify", "dead.gct", "-q", "--traces", "found/traces"]).ends(1, "");
    assert_eq!(folder.read("found/traces/01-deadlock.trace.csv"), "t_ms,a\n0,0\n1,1\n");
    let run = folder.run(&["sim", "dead.gct", "-q", "--trace", "found/traces/01-deadlock.trace.csv"]);
    assert_eq!(run.is_done().out, "t_ms,situation,flags\n0,1,\n1,2,\n");
}

/// Each engine alone says the same of what it decides, and only the one that looks at all states of a small chart decides all.
#[test]
fn one_engine_may_be_asked_for() {
    let folder = Folder::new(&[("dead.gct", DEAD), ("round.gct", ROUND)]);
    for chart in ["dead.gct", "round.gct"] {
        let told = |engine: &str| {
            let out = folder.run(&["verify", chart, "-q", "--engine", engine]).out;
            let answers = out.lines().map(|line| line.split(" in ").next().unwrap_or_default().to_owned());
            answers.collect::<Vec<String>>()
        };
        let auto = told("auto");
        assert!(!auto.iter().any(|line| line.starts_with("open")), "{auto:?}");
        for engine in ["explicit", "symbolic", "sat"] {
            let alone = told(engine);
            let decided = alone.iter().filter(|line| line.starts_with("holds") || line.starts_with("fails"));
            let kind = |line: &str| {
                line.split_once("  ").map(|(_, what)| what.split(':').next().unwrap_or_default().to_owned())
            };
            for line in decided {
                let same = auto.iter().find(|other| kind(other) == kind(line));
                assert_eq!(same.map(|other| &other[..5]), Some(&line[..5]), "{engine}: {alone:#?}\n{auto:#?}");
            }
        }
        assert!(!told("explicit").iter().any(|line| line.starts_with("open")), "{chart}");
    }
    folder.run(&["verify", "round.gct", "--engine", "luck"]).ends(2, "possible values: auto, explicit, symbolic, sat");
    folder.run(&["verify", "round.gct", "--emit", "smv", "--engine", "sat"]).ends(2, "--engine");
}

#[test]
fn what_is_open_ends_with_4() {
    let sum = "input n : real\nvar sum : real\ninitial step 1 { sum := sum + n on activation }\nstep 2\n\
               transition 1 -> 2 : [sum < 5.0]\ntransition 2 -> 1 : [sum > 5.0]\n";
    let folder = Folder::new(&[("sum.gct", sum), ("round.gct", ROUND)]);
    let found = folder.run(&["verify", "sum.gct", "-q"]);
    found.ends(4, "");
    assert!(found.out.contains("open   deadlock: the number `n`"), "{}", found.out);
    folder.run(&["verify", "round.gct", "--time", "0"]).ends(2, "");
}

#[test]
fn circuits_for_engines_of_others() {
    let folder = Folder::new(&[("round.gct", ROUND), ("faulty.gct", FAULTY)]);
    // Two inputs beside `rests`; one file a language, and nothing proved.
    folder.run(&["verify", "round.gct", "-q", "--emit", "aiger", "-o", "round.aig"]).is_done();
    let aiger = std::fs::read(folder.path("round.aig")).unwrap();
    let header = aiger.split(|byte| *byte == b'\n').next().unwrap();
    assert!(header.starts_with(b"aig ") && header.split(|byte| *byte == b' ').nth(2) == Some(b"2"), "{header:?}");
    let smv = folder.run(&["verify", "round.gct", "-q", "--emit", "smv"]);
    assert!(smv.is_done().out.contains("MODULE main\nIVAR\n  i0 : boolean; -- a\n"), "{}", smv.out);
    let faulty = folder.run(&["verify", "faulty.gct", "--emit", "smv", "-o", "faulty.smv"]);
    faulty.ends(1, "E0201");
    assert!(!folder.path("faulty.smv").exists());
    folder.run(&["verify", "round.gct", "-o", "round.aig"]).ends(2, "--emit");
    folder.run(&["verify", "round.gct", "--emit", "smv", "--traces", "faults"]).ends(2, "--traces");
    folder.run(&["verify", "round.gct", "-q", "--emit", "smv", "-o", "round.gct"]).ends(2, "round.gct");
}

#[test]
fn a_real_number_has_no_circuit() {
    let chart = "chart Warm\ninput t : real\ninitial step 1\nstep 2\ntransition 1 -> 2 : [t > 8.5]\n\
                 transition 2 -> 1 : [t < 5.0]\n";
    let folder = Folder::new(&[("warm.gct", chart)]);
    let found = folder.run(&["verify", "warm.gct", "-q", "--emit", "aiger"]);
    found.ends(4, "real number");
    assert!(found.out.is_empty());
}
