//! Small charts whose automata are known.

use crate::call::Beyond;
use crate::{Automaton, Kind, Machine, convert, explore, kiss2, product, system};
use grafc_diagnostics::{Diagnostics, FileId};
use grafc_logic::{Analysis, Options};

fn analysis(text: &str) -> Analysis {
    let (tree, parsed) = grafc_syntax::parse(FileId::default(), text);
    assert!(!parsed.has_errors(), "{parsed:?}");
    let (chart, found) = grafc_model::check(&tree, "chart");
    let chart = chart.unwrap_or_else(|| panic!("{found:?}"));
    let mut net = grafc_net::into_net(chart);
    grafc_net::passes::run(&mut net, false, &mut Diagnostics::new());
    Analysis::new(net)
}

fn explored(text: &str) -> Result<Machine, Beyond> {
    explore(&grafc_logic::compile(analysis(text), &Options::default()).0, 1000)
}

fn machine(text: &str) -> Machine {
    explored(text).expect("a machine")
}

/// What stands at the vertices of an automaton.
fn vertices(automaton: &Automaton) -> Vec<String> {
    let outputs =
        |outputs: &[(String, String)]| outputs.iter().map(|(name, when)| format!(" {name}={when}")).collect::<String>();
    automaton.vertices.iter().map(|vertex| format!("{}{}", vertex.name, outputs(&vertex.outputs))).collect()
}

const VALVE: &str = "input a, b : bool output V : bool initial step 1 step 2 { V }
transition 1 -> 2 : a and not b transition 2 -> 1 : b";

/// A chart of constants is a Moore automaton as it stands.
#[test]
fn a_simple_chart_is_a_moore_automaton() {
    let moore = convert(&machine(VALVE), Kind::Moore);
    assert_eq!(vertices(&moore), ["1", "2 V=1"]);
    let arcs: Vec<_> = moore.arcs.iter().map(|arc| (arc.from, arc.to, arc.when.as_str())).collect();
    assert_eq!(arcs, [(0, 0, "¬a + b"), (0, 1, "a · ¬b"), (1, 0, "b"), (1, 1, "¬b")]);
}

/// The serial adder: as a Moore automaton it has a vertex for each carry and sum, as a Mealy or an extended one a vertex for
/// each carry.
#[test]
fn the_adder_has_two_vertices() {
    let text = "chart Adder evolution scan input x1, x2 : bool output s : bool
initial step p0s0  step p0s1 { s }  step p1s0  step p1s1 { s }
transition p0s0 -> p0s1 : x1 xor x2   transition p0s0 -> p1s0 : x1 and x2
transition p0s1 -> p0s0 : not x1 and not x2   transition p0s1 -> p1s0 : x1 and x2
transition p1s0 -> p0s1 : not x1 and not x2   transition p1s0 -> p1s1 : x1 and x2
transition p1s1 -> p0s1 : not x1 and not x2   transition p1s1 -> p1s0 : x1 xor x2";
    let adder = machine(text);
    assert_eq!(adder.states.len(), 4);
    assert_eq!(convert(&adder, Kind::Mealy).vertices.len(), 4);
    let minimal = convert(&adder, Kind::Minimal);
    assert_eq!((minimal.before, minimal.vertices.len()), (4, 2));
    let extended = convert(&adder, Kind::Extended);
    assert_eq!(vertices(&extended), ["p0s0 s=¬x1 · x2 + x1 · ¬x2", "p1s0 s=¬x1 · ¬x2 + x1 · x2"]);
    // And back: each carry with each sum.
    assert_eq!(convert(&minimal.machine, Kind::Moore).vertices.len(), 4);
}

/// What is remembered of an edge is a state; what is never asked for is none.
#[test]
fn states_are_told_apart_by_what_comes_of_them() {
    let text = "input a, b : bool output V : bool var n : bool initial step 1 step 2 { V  n := b on activation }
transition 1 -> 2 : rise a transition 2 -> 1 : rise a";
    let machine = machine(text);
    let names: Vec<_> = machine.states.iter().map(|state| state.name.as_str()).collect();
    // Whether `a` was true counts for the next edge. In the first call there is no edge, as if it had been true.
    assert_eq!(names, ["1'1", "1'2", "2'1", "2'2"]);
    assert_eq!(machine.initial, 0);
    assert_eq!(convert(&machine, Kind::Minimal).vertices.len(), 4);
}

#[test]
fn numbers_and_delays_are_beyond() {
    let number = "input a : bool var n : int initial step 1 { n := n + 1 on activation } transition 1 -> 1 : a";
    assert!(matches!(explored(number), Err(Beyond::Number(_))));
    let delay =
        "input a : bool output V : bool initial step 1 step 2 { V } transition 1 -> 2 : 3s/a transition 2 -> 1 : 1";
    assert!(matches!(explored(delay), Err(Beyond::Delay(_))));
}

#[test]
fn two_machines_differ_by_the_shortest_way() {
    let other = VALVE.replace("2 -> 1 : b", "2 -> 1 : b and not a");
    let difference = product(&machine(VALVE), &machine(&other)).expect_err("they differ");
    assert_eq!(difference.inputs, [[true, false], [true, true]]);
    assert_eq!(product(&machine(VALVE), &machine(VALVE)), Ok(2));
}

#[test]
fn a_table_has_a_row_for_each_cube() {
    let table = kiss2(&machine(VALVE), 100).expect("a table");
    let expected = "\
.i 2\n.o 1\n.p 5\n.s 2\n.r 1\n.ilb a b\n.ob V\n0- 1 1 0\n11 1 1 0\n10 1 2 1\n-1 2 1 0\n-0 2 2 1\n.e\n";
    assert_eq!(table, expected);
    assert_eq!(kiss2(&machine(VALVE), 4), Err(Beyond::Rows(4)));
}

/// A head that starts two graphs and waits for both.
#[test]
fn graphs_call_and_wait_for_each_other() {
    let text = "input b0, b2, b5, bj : bool output z1, z2 : bool
initial step 0  step 1 { z1 }  step 2  step 3 { z2 }  step 4
transition 0 -> 1, 3 : b0  transition 1 -> 2 : b2  transition 3 -> 4 : b5  transition 2, 4 -> 0 : bj";
    let system = system(&analysis(text));
    let told: Vec<String> = system
        .graphs
        .iter()
        .map(|graph| {
            let name = |vertex: usize| graph.vertices[vertex].label.as_str();
            let arc = |arc| -> String {
                let arc: &crate::GraphArc = arc;
                format!("{}->{} {}", name(arc.from), name(arc.to), system.label(arc))
            };
            format!("{}: {}", graph.name, graph.arcs.iter().map(arc).collect::<Vec<_>>().join("; "))
        })
        .collect();
    assert_eq!(told, ["A0: 0->1 b0; 1->2 b2; 2->0 A1 = 4 · bj", "A1: -->3 A0 = 0 · b0; 3->4 b5; 4->- A0 = 2 · bj"]);
}
