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
use grafc_testsuite::executors::{Outcome, Task, select};
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

/// A condition of an arc: an input, an output on an arc of the other automaton, or the activity of a state.
#[derive(Clone, Copy)]
enum Asked {
    Input(usize),
    Output(usize),
    State(usize),
}

/// An arc of a random automaton, with what it asks for and what that must be.
struct Arc {
    from: usize,
    to: usize,
    when: Vec<(Asked, bool)>,
    publishes: bool,
}

/// Two automata as tables, each with an output on arcs and one at states, and where they are.
struct Tables {
    arcs: [Vec<Arc>; 2],
    states: [usize; 2],
    at: [usize; 2],
    published: [bool; 2],
    is_scan: bool,
}

impl Tables {
    fn random(seed: u64) -> Tables {
        let mut rng = Rng::with_seed(seed);
        let states = [rng.usize(2..=4), rng.usize(2..=4)];
        let mut arcs: [Vec<Arc>; 2] = Default::default();
        for (of, arcs) in arcs.iter_mut().enumerate() {
            for _ in 0..rng.usize(2..=8) {
                let mut when = Vec::new();
                for _ in 0..rng.usize(1..=2) {
                    let asked = match rng.u8(0..8) {
                        0..5 => Asked::Input(rng.usize(0..3)),
                        5 | 6 => Asked::Output(1 - of),
                        _ => Asked::State(rng.usize(0..states[1 - of])),
                    };
                    when.push((asked, rng.u8(0..3) > 0));
                }
                let (from, to) = (rng.usize(0..states[of]), rng.usize(0..states[of]));
                arcs.push(Arc { from, to, when, publishes: rng.bool() });
            }
        }
        Tables { arcs, states, at: [0; 2], published: [false; 2], is_scan: seed % 2 == 1 }
    }

    fn text(&self) -> String {
        let evolution = if self.is_scan { "scan" } else { "stable" };
        let mut text =
            format!("chart M evolution {evolution}\ninput i0, i1, i2 : bool\noutput y0, y1, z0, z1 : bool\n");
        for of in [0, 1] {
            text += &format!("automaton A{of} {{\n");
            for state in 0..self.states[of] {
                let initial = if state == 0 { "initial " } else { "" };
                let moore = if state % 2 == 1 { format!(" {{ z{of} }}") } else { String::new() };
                text += &format!("  {initial}state {of}{state}{moore}\n");
            }
            for arc in &self.arcs[of] {
                let asked = arc.when.iter().map(|(asked, wanted)| {
                    let name = match asked {
                        Asked::Input(place) => format!("i{place}"),
                        Asked::Output(other) => format!("y{other}"),
                        Asked::State(state) => format!("X{}{state}", 1 - of),
                    };
                    format!("{}{name}", if *wanted { "" } else { "not " })
                });
                let when = asked.collect::<Vec<_>>().join(" and ");
                let publishes = if arc.publishes { format!(" {{ y{of} }}") } else { String::new() };
                text += &format!("  arc {of}{} -> {of}{} : {when}{publishes}\n", arc.from, arc.to);
            }
            // So that there is one, whatever the arcs.
            text += &format!("  arc {of}0 -> {of}0 : i0 and not i0 {{ y{of} }}\n}}\n");
        }
        text
    }

    /// Each takes its first arc that it can take; whether anything is another than it was.
    fn step(&mut self, inputs: &[bool]) -> bool {
        let (at, published) = (self.at, self.published);
        for of in [0, 1] {
            let holds = |(asked, wanted): &(Asked, bool)| {
                let is = match asked {
                    Asked::Input(place) => inputs[*place],
                    Asked::Output(other) => published[*other],
                    Asked::State(state) => at[1 - of] == *state,
                };
                is == *wanted
            };
            let arc = self.arcs[of].iter().find(|arc| arc.from == at[of] && arc.when.iter().all(holds));
            let publishes = arc.is_some_and(|arc| arc.publishes);
            self.at[of] = arc.map_or(at[of], |arc| arc.to);
            self.published[of] = publishes || published[of] && !self.is_scan;
        }
        (at, published) != (self.at, self.published)
    }

    /// What is published after a call.
    fn call(&mut self, inputs: &[bool]) -> [bool; 4] {
        if self.is_scan {
            self.step(inputs);
        } else {
            self.published = [false; 2];
            // R9: at most 200 micro-steps.
            for _ in 0..200 {
                if !self.step(inputs) {
                    break;
                }
            }
        }
        let [y0, y1] = self.published;
        [y0, y1, self.at[0] % 2 == 1, self.at[1] % 2 == 1]
    }
}

/// Random automata that read each other's outputs and states, in both evolutions: the simulator and all that is built in do
/// what the tables say.
#[test]
fn automata_do_what_their_arcs_say() {
    let mut executors = select("built-in").expect("the built-in executors");
    executors.retain(|executor| executor.name() != "lanes");
    let mut charts = Vec::new();
    for seed in 0..120 {
        let mut tables = Tables::random(seed);
        let text = tables.text();
        let chart = check("automata", &text).unwrap_or_else(|fault| panic!("{text}\n{fault}"));
        let mut rng = Rng::with_seed(seed);
        let stimuli: Vec<Stimulus> = (0..30)
            .map(|call| {
                let inputs = (0..3).map(|_| Value::Bool(rng.bool())).collect();
                Stimulus { t_ms: 10 * call, restart: false, inputs }
            })
            .collect();
        let expected: Vec<Vec<Value>> = stimuli
            .iter()
            .map(|stimulus| {
                let inputs: Vec<bool> = stimulus.inputs.iter().map(|value| *value == Value::Bool(true)).collect();
                tables.call(&inputs).map(Value::Bool).to_vec()
            })
            .collect();
        charts.push((text, chart, stimuli, expected));
    }
    let tasks: Vec<Task> = charts
        .iter()
        .enumerate()
        .map(|(turn, (_, chart, stimuli, _))| Task { chart, profile: Profile::default(), stimuli, turn })
        .collect();
    for executor in &executors {
        let mut ran = 0;
        for ((text, _, _, expected), outcome) in charts.iter().zip(executor.run(&tasks)) {
            match outcome {
                Outcome::PassedOver(_) => {}
                Outcome::Failed(said) => panic!("{}: {said}\n{text}", executor.name()),
                Outcome::Ran(responses) => {
                    ran += 1;
                    let actual: Vec<Vec<Value>> = responses.into_iter().map(|response| response.outputs).collect();
                    assert_eq!(&actual, expected, "{}\n{text}", executor.name());
                }
            }
        }
        // Where two arcs leave a state, the encodings whose steps overlap are not for it.
        let is_for_all = executor.limits() == "none" || executor.name().starts_with("net:");
        assert!(ran == charts.len() || !is_for_all, "{} ran only {ran}", executor.name());
    }
}

/// The serial adder as a Mealy automaton of the language has two states, and is the Moore automaton of four.
#[test]
fn the_adder_as_a_mealy_automaton() {
    let (mealy, moore) = (of_the_book("mealy.gct"), of_the_book("adder.gct"));
    assert_eq!(mealy.states.len(), 2);
    assert!(product(&mealy, &moore).is_ok());
}
