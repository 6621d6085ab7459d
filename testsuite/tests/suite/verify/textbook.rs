//! Graphs of the textbook (A. A. Shalyto, *Logical control*, 12.4), as charts of ours: what the text says of them.

use super::{fails, holds, program, rows, verified};
use grafc_model::reaction::Profile;
use grafc_testsuite::charts::check;
use grafc_verify::{Graph, Kind, Of, graph};

#[track_caller]
fn explored(text: &str) -> Graph {
    let chart = check("textbook", text).expect("a chart without errors");
    graph(&program(&chart, Profile::default()), Of::Situations, 1_000).expect("all can be followed")
}

/// The situations, by the numbers of the states of both automata, and what leads from one to another.
fn nodes_and_edges(graph: &Graph) -> (Vec<String>, Vec<(String, String)>) {
    let name = |id: usize| -> String {
        graph.nodes[id].steps.iter().map(|label| label.trim_start_matches(char::is_alphabetic)).collect()
    };
    let mut nodes: Vec<String> = (0..graph.nodes.len()).map(name).collect();
    let mut edges: Vec<_> = graph.edges.iter().map(|edge| (name(edge.from), name(edge.to))).collect();
    nodes.sort();
    edges.sort();
    (nodes, edges)
}

fn pairs(text: &str) -> Vec<(String, String)> {
    let pair = |pair: &str| pair.split_once('-').map(|(from, to)| (from.to_owned(), to.to_owned()));
    let mut pairs: Vec<_> = text.split_whitespace().filter_map(pair).collect();
    pairs.sort();
    pairs
}

/// Calling automata that exchange the numbers of their states (figure 12.36), for `xi` and `xj` never both true: each waits
/// for the other one to be back in its state 0.
const CALLING: &str = "\
chart Calling
input xi, xj : bool

initial step A0
step A1
initial step B0
step B1
step B2

transition A0 -> A1 : xi and not xj
transition A1 -> A0 : XB0 and xj and not xi
transition B0 -> B1 : XA1 and xi and not xj
transition B1 -> B2 : xj and not xi
transition B1 -> B0 : not xi and not xj
transition B2 -> B0 : XA0
";

/// At Y0 = 1, Y1 = 2 nothing can move: the \"deadly embrace\". The node `12` of the graph has no way out (figure 12.37).
#[test]
fn calling_automata_lock_each_other() {
    let graph = explored(CALLING);
    let (nodes, edges) = nodes_and_edges(&graph);
    // By hand: `10` is passed through with `xi`, and stays where neither is true.
    assert_eq!(nodes, ["00", "10", "11", "12"]);
    assert_eq!(edges, pairs("00-11 10-00 10-11 11-10 11-12"));
    assert!(edges.iter().all(|(from, _)| from != "12"));
    assert_eq!(graph.deadlocks.len(), 1);
    assert_eq!(graph.nodes[graph.deadlocks[0]].steps, ["A1", "B2"]);
    let found = verified(&check("calling", CALLING).expect("a chart"), Profile::default());
    assert_eq!(rows(fails(&found, "deadlock")), ["0 10 -> A1 B1", "1 01 -> A1 B2"]);
    holds(&found, "livelock");
}

/// Nested automata: one lower graph, once, which runs in the vertices 0 and 2 of the upper one (figure 12.34).
fn nested(waits: &str) -> String {
    format!(
        "chart Nested\ninput x0, xi, xj : bool\n\n\
         initial step U0\nstep U1\nstep U2\ninitial step L0\nstep L1\n\n\
         transition U0 -> U1 : ↑x0{waits}\ntransition U1 -> U2 : ↑x0\ntransition U2 -> U0 : ↑x0{waits}\n\
         transition L0 -> L1 : (XU0 or XU2) and xi and not xj\n\
         transition L1 -> L0 : (XU0 or XU2) and xj and not xi\n"
    )
}

/// The upper automaton may leave a process where it is; the graph of reachable markings has each state of the one with each
/// of the other (figure 12.35).
#[test]
fn a_lower_graph_stands_still_while_the_upper_one_is_elsewhere() {
    let text = nested("");
    let (nodes, edges) = nodes_and_edges(&explored(&text));
    assert_eq!(nodes, ["00", "01", "10", "11", "20", "21"]);
    let expected = "00-01 00-10 00-11 01-00 01-10 01-11 10-20 10-21 11-20 11-21 20-21 20-00 20-01 21-20 21-00 21-01";
    assert_eq!(edges, pairs(expected));
}

/// The same with the lower graph as a child: it does not stand still while the upper one is at 1, but begins anew at 2;
/// from 2 to 0 the one vertex hands over to the other, and it goes on.
#[test]
fn a_child_that_two_vertices_run_begins_anew_but_for_a_hand_over() {
    let text = "chart Nested
        input x0, xi, xj : bool
        grafcet U {
          initial step U0 { run L } step U1 step U2 { run L }
          transition U0 -> U1 : ↑x0 transition U1 -> U2 : ↑x0 transition U2 -> U0 : ↑x0
        }
        child grafcet L of U {
          initial step L0 step L1
          transition L0 -> L1 : xi and not xj transition L1 -> L0 : xj and not xi
        }";
    let (nodes, edges) = nodes_and_edges(&explored(text));
    assert_eq!(nodes, ["00", "01", "1", "20", "21"]);
    assert_eq!(edges, pairs("00-01 00-1 01-00 01-1 1-20 1-21 20-00 20-01 20-21 21-00 21-01 21-20"));
}

/// \"A process begun is finished\": the upper arcs wait for it, and graph and tests shrink (figure 12.38).
#[test]
fn where_a_process_begun_is_finished_the_graph_shrinks() {
    let text = nested(" and XL0 and not xi");
    let (nodes, edges) = nodes_and_edges(&explored(&text));
    assert_eq!(nodes, ["00", "01", "10", "20", "21"]);
    assert_eq!(edges, pairs("00-01 00-10 01-00 10-20 10-21 20-21 20-00 21-20"));
    // From everywhere the circle closes: one test a circle.
    let found = verified(&check("nested", &text).expect("a chart"), Profile::default());
    assert!(
        found
            .verdicts
            .iter()
            .filter(|v| v.claim.kind != Kind::Reentry)
            .all(|v| v.answer == grafc_verify::Answer::Holds)
    );
}
