//! Charts as automata: whatever the kind, call by call it is what the simulator does; no automaton is smaller than the
//! smallest; and what the textbook says of its locks.

use fastrand::Rng;
use grafc_automata::{Kind, Machine, convert, explore, kiss2, product};
use grafc_diagnostics::FileId;
use grafc_logic::Options;
use grafc_model::chart::{Chart, Value};
use grafc_model::reaction::{Profile, Stimulus};
use grafc_model::simulate::Simulator;
use grafc_testsuite::binary::root;
use grafc_testsuite::charts::{Case, cases, charts_folder, check, vectors_folder};
use grafc_testsuite::markdown::blocks;
use grafc_testsuite::runs::compile;
use std::collections::BTreeMap;

const KINDS: [Kind; 4] = [Kind::Moore, Kind::Mealy, Kind::Extended, Kind::Minimal];

fn machine(chart: &Chart, profile: Profile) -> Option<Machine> {
    let program = compile(chart, &Options { profile, ..Options::default() }).ok()?;
    explore(&program, 400).ok()
}

/// Calls with random inputs: what the chart publishes, the machine publishes.
fn agree(name: &str, chart: &Chart, profile: Profile, machine: &Machine, calls: usize) {
    let (mut rng, mut simulator, mut state) =
        (Rng::with_seed(calls as u64), Simulator::new(chart, profile), machine.initial);
    for call in 0..calls {
        let inputs: Vec<bool> = machine.inputs.iter().map(|_| rng.bool()).collect();
        let values = inputs.iter().map(|value| Value::Bool(*value)).collect();
        let response = simulator.react(&Stimulus { t_ms: call as i64, restart: false, inputs: values });
        let (to, published) = machine.call(state, &inputs);
        let expected: Vec<Value> = published.into_iter().map(Value::Bool).collect();
        assert_eq!(response.outputs, expected, "{name}, call {call}");
        state = to;
    }
}

/// How many classes of states there are, found by telling states apart letter by letter until nothing changes.
fn classes(machine: &Machine) -> usize {
    let letters: Vec<Vec<bool>> = (0..1usize << machine.inputs.len())
        .map(|letter| (0..machine.inputs.len()).map(|input| letter >> input & 1 == 1).collect())
        .collect();
    let mut of = vec![0; machine.states.len()];
    loop {
        let mut known: BTreeMap<Vec<(usize, Vec<bool>)>, usize> = BTreeMap::new();
        let next: Vec<usize> = (0..machine.states.len())
            .map(|state| {
                let mut seen: Vec<(usize, Vec<bool>)> = letters
                    .iter()
                    .map(|letter| machine.call(state, letter))
                    .map(|(to, outputs)| (of[to], outputs))
                    .collect();
                seen.push((of[state], Vec::new()));
                let count = known.len();
                *known.entry(seen).or_insert(count)
            })
            .collect();
        let count = known.len();
        if count == of.iter().max().map_or(0, |most| most + 1) {
            return count;
        }
        of = next;
    }
}

fn tried(name: &str, chart: &Chart, profile: Profile) -> bool {
    let Some(machine) = machine(chart, profile) else { return false };
    agree(name, chart, profile, &machine, 300);
    for kind in KINDS {
        // That it is the same is proved as it is made; here it is run.
        let automaton = convert(&machine, kind);
        agree(name, chart, profile, &automaton.machine, 100);
        if matches!(kind, Kind::Minimal | Kind::Extended) && machine.inputs.len() <= 6 && machine.states.len() <= 60 {
            assert_eq!(automaton.vertices.len(), classes(&machine), "{name}");
        }
    }
    true
}

#[test]
fn charts_of_the_suite() {
    let all = cases(&charts_folder()).into_iter().chain(cases(&vectors_folder()));
    let count = all.filter(|case: &Case| {
        let chart = check(&case.name, &case.text).expect("a chart without errors");
        tried(&case.name, &chart, case.profile)
    });
    assert!(count.count() > 40);
}

/// A chart of the suite as a machine.
fn lock(name: &str) -> Machine {
    let text = std::fs::read_to_string(charts_folder().join(format!("{name}.gct"))).expect("a chart");
    machine(&check(name, &text).expect("a chart without errors"), Profile::default()).expect("a machine")
}

/// The charts in the book, by their files.
fn of_the_book(file: &str) -> Machine {
    let page = std::fs::read_to_string(root().join("docs/automata.md")).expect("the chapter");
    let blocks = blocks(&page);
    let block = blocks.iter().find(|block| block.value("file") == Some(file)).expect("a block of this file");
    machine(&check(file, &block.text).expect("a chart without errors"), Profile::default()).expect("a machine")
}

/// The locks 12.1, in its three disciplines, 12.2 and 12.3: as charts, as automata of each kind, and as charts that are made
/// of their tables, they do the same.
#[test]
fn locks_are_charts_and_automata() {
    for name in ["lock_12_1_v1", "lock_12_1_v2", "lock_12_1_v3", "lock_12_2", "lock_12_3", "lock_extended"] {
        let chart = lock(name);
        for kind in KINDS {
            let automaton = convert(&chart, kind).machine;
            let table = kiss2(&automaton, 100_000).expect("a table");
            let (text, found) = grafc_import::import(FileId::default(), &table, &grafc_import::Options::default());
            let text = text.unwrap_or_else(|| panic!("{found:?}"));
            let again = machine(&check(name, &text).expect("a chart without errors"), Profile::default());
            assert!(product(&chart, &again.expect("a machine")).is_ok(), "{name}, {kind:?}");
        }
    }
}

/// 12.3 as one graph in the plane: 14 vertices, 14 loops and 26 arcs; 8 vertices, once equivalent ones are merged. The chart
/// of three branches in parallel comes to as many.
#[test]
fn the_lock_in_any_order_has_eight_vertices() {
    let planar = of_the_book("lock_planar.gct");
    assert_eq!((planar.states.len(), planar.count()), (14, (14, 26)));
    let minimal = convert(&planar, Kind::Minimal);
    assert_eq!((minimal.before, minimal.vertices.len(), minimal.machine.count().0), (14, 8, 8));
    let parallel = lock("lock_12_3");
    assert!(product(&planar, &parallel).is_ok());
    assert_eq!(convert(&parallel, Kind::Minimal).vertices.len(), 8);
}

/// The serial adder: four vertices as a Moore automaton, two as a Mealy automaton and as an extended one.
#[test]
fn the_adder_is_two_vertices_of_an_extended_automaton() {
    let adder = of_the_book("adder.gct");
    assert_eq!(adder.states.len(), 4);
    assert_eq!(convert(&adder, Kind::Moore).vertices.len(), 4);
    let minimal = convert(&adder, Kind::Minimal);
    assert_eq!(minimal.vertices.len(), 2);
    let extended = convert(&minimal.machine, Kind::Extended);
    let sums: Vec<&str> = extended.vertices.iter().map(|vertex| vertex.outputs[0].1.as_str()).collect();
    assert_eq!(sums, ["¬x1 · x2 + x1 · ¬x2", "¬x1 · ¬x2 + x1 · x2"]);
}

/// A random automaton as a block, and as the grafcet that it means, its conditions excluding each other by hand: both do the
/// same, whatever the arcs, with outputs at states; and of those at arcs, the table says what is published.
#[test]
fn blocks_of_the_language() {
    for seed in 0..40u64 {
        let mut rng = Rng::with_seed(seed);
        let states = rng.usize(2..=5);
        let arcs: Vec<(usize, usize, &str, bool)> = (0..rng.usize(1..=12))
            .map(|_| {
                let when = ["a", "b", "a and b", "a or c", "not c", "not a and b", "rise b", "1"][rng.usize(0..8)];
                (rng.usize(0..states), rng.usize(0..states), when, rng.bool())
            })
            .collect();
        let heading = "chart M evolution scan\ninput a, b, c : bool\noutput y, z : bool\n";
        let (mut block, mut grafcet) = (format!("{heading}automaton A {{\n"), heading.to_owned());
        for state in 0..states {
            let initial = if state == 0 { "initial " } else { "" };
            let moore = if state % 2 == 1 { " { z }" } else { "" };
            block += &format!("  {initial}state {state}{moore}\n");
            grafcet += &format!("{initial}step {state}{moore}\n");
        }
        for (from, to, when, publishes) in &arcs {
            block += &format!("  arc {from} -> {to} : {when}{}\n", if *publishes { " { y }" } else { "" });
        }
        let publishes = arcs.iter().any(|arc| arc.3);
        for state in 0..states {
            let mut before: Vec<&str> = Vec::new();
            for (_, to, when, published) in arcs.iter().filter(|arc| arc.0 == state) {
                let others: String = before.iter().map(|other| format!(" and not ({other})")).collect();
                let given = if publishes { format!(" {{ y := {} }}", u8::from(*published)) } else { String::new() };
                grafcet += &format!("transition {state} -> {to} : ({when}){others}{given}\n");
                before.push(when);
            }
            if publishes {
                let others: String = before.iter().map(|other| format!(" and not ({other})")).collect();
                grafcet += &format!("transition {state} -> {state} : 1{others} {{ y := 0 }}\n");
            }
        }
        block += "}\n";
        let of = |text: &str| {
            let chart = check("block", text).unwrap_or_else(|fault| panic!("{text}\n{fault}"));
            machine(&chart, Profile::default()).expect("a machine")
        };
        let (one, other) = (of(&block), of(&grafcet));
        assert!(product(&one, &other).is_ok(), "{block}\n{grafcet}");
    }
}

/// The serial adder as a Mealy automaton of the language has two states, and is the Moore automaton of four.
#[test]
fn the_adder_as_a_mealy_automaton() {
    let (mealy, moore) = (of_the_book("mealy.gct"), of_the_book("adder.gct"));
    assert_eq!(mealy.states.len(), 2);
    assert!(product(&mealy, &moore).is_ok());
}
