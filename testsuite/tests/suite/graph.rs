//! `grafc graph` against a plain enumeration over the reference simulator.

use crate::tried::{self, Tried};
use grafc_logic::scan::Observed;
use grafc_logic::{Analysis, Options, compile_observed};
use grafc_model::chart::Chart;
use grafc_model::reaction::Profile;
use grafc_testsuite::charts::check;
use grafc_testsuite::enumeration::{Enumerated, Situation};
use grafc_verify::{Graph, Of, graph};
use std::collections::{BTreeMap, BTreeSet};

/// The graph of a chart, up to this number of states.
fn explored(chart: &Chart, profile: Profile, of: Of, most: usize) -> Graph {
    let mut net = grafc_net::build(chart);
    grafc_net::passes::run(&mut net, false, &mut grafc_diagnostics::Diagnostics::new());
    let options = Options { profile, ..Options::default() };
    let (program, _) = compile_observed(Analysis::new(net), &options, Observed::Transitions);
    graph(&program, of, most).expect("nothing that cannot be followed")
}

/// A graph in the form of what the enumeration gives.
fn as_enumerated(graph: &Graph, chart: &Chart) -> Enumerated {
    let place: BTreeMap<&str, usize> =
        chart.steps.iter_enumerated().map(|(id, step)| (step.label.as_str(), id.index())).collect();
    let situation =
        |id: usize| -> Situation { graph.nodes[id].steps.iter().map(|label| place[label.as_str()]).collect() };
    let inputs: Vec<&str> = chart
        .variables
        .iter()
        .filter(|v| v.kind == grafc_model::chart::VariableKind::Input)
        .map(|v| v.name.as_str())
        .collect();
    let vectors = |when: &str| -> BTreeSet<u32> {
        (0..1u32 << inputs.len()).filter(|vector| holds(when, &inputs, *vector)).collect()
    };
    let transition = |name: &String| -> usize {
        let named = |t: &grafc_model::chart::Transition| t.designation.as_ref().map(|d| format!("({d})"));
        match name.strip_prefix('#') {
            Some(number) => number.parse::<usize>().expect("a number") - 1,
            None => chart.transitions.iter().position(|t| named(t).as_ref() == Some(name)).expect("a transition"),
        }
    };
    Enumerated {
        initial: graph.initial.iter().map(|id| situation(*id)).collect(),
        situations: (0..graph.nodes.len()).map(situation).collect(),
        edges: graph
            .edges
            .iter()
            .map(|edge| ((situation(edge.from), situation(edge.to)), vectors(&edge.when)))
            .collect(),
        deadlocks: graph.deadlocks.iter().map(|id| situation(*id)).collect(),
        livelocks: graph
            .livelocks
            .iter()
            .map(|livelock| {
                let ring = livelock.ring.iter().map(transition).collect();
                ((livelock.from.map(situation), ring), vectors(&livelock.when))
            })
            .collect(),
    }
}

/// Whether a disjunction of conjunctions holds.
fn holds(when: &str, inputs: &[&str], vector: u32) -> bool {
    let literal = |text: &str| {
        let (name, wanted) = text.strip_prefix("not ").map_or((text, true), |name| (name, false));
        let place = inputs.iter().position(|input| *input == name).unwrap_or_else(|| panic!("an input: {name}"));
        (vector >> place & 1 == 1) == wanted
    };
    when == "true" || when.split(" or ").any(|term| term.split(" and ").all(literal))
}

#[track_caller]
fn agree(tried: &Tried) {
    let graph = explored(&tried.chart, tried.profile, Of::Situations, 1_000_000);
    assert!(graph.complete, "{}", tried.name);
    let found = as_enumerated(&graph, &tried.chart);
    assert_eq!(found, tried.found, "{} {:?}\n{}", tried.name, tried.profile, tried.text);
}

#[test]
fn charts_and_vectors_have_the_situations_that_trying_everything_finds() {
    let all = tried::charts_and_vectors();
    all.iter().for_each(agree);
    println_count("charts and vectors", all.len());
    assert!(all.len() > 30, "{} were compared", all.len());
}

#[test]
fn random_boolean_charts_have_the_situations_that_trying_everything_finds() {
    let all = tried::random();
    all.iter().for_each(agree);
    println_count("random charts", all.len());
    assert!(all.len() > 100, "{} were compared", all.len());
}

#[allow(clippy::print_stderr, reason = "shown with --nocapture")]
fn println_count(what: &str, count: usize) {
    eprintln!("{count} {what} compared");
}

/// By hand: two steps, two inputs. From 1, `a` leads to 2; from 2, `b` back to 1. With both at once the reaction goes round
/// for ever (R9).
const ROUND: &str = "\
chart Round
input a, b : bool
initial step 1
step 2
transition (1) 1 -> 2 : a
transition (2) 2 -> 1 : b
";

#[test]
fn a_ring_by_hand() {
    let chart = check("round", ROUND).expect("a chart");
    let graph = explored(&chart, Profile::default(), Of::Situations, 1_000);
    let labels: Vec<&[String]> = graph.nodes.iter().map(|node| &*node.steps).collect();
    // At the start `a` alone leads on to 2 at once.
    assert_eq!((labels, graph.initial), (vec![&["1".to_owned()][..], &["2".to_owned()]], vec![0, 1]));
    let edges: Vec<(usize, usize, &str)> =
        graph.edges.iter().map(|edge| (edge.from, edge.to, edge.when.as_str())).collect();
    assert_eq!(edges, [(0, 1, "a and not b"), (1, 0, "not a and b")]);
    let livelocks: Vec<_> = graph.livelocks.iter().map(|l| (l.from, l.when.as_str(), l.ring.join(" "))).collect();
    let ring = "(1) (2)".to_owned();
    assert_eq!(
        livelocks,
        [(None, "a and b", ring.clone()), (Some(0), "a and b", ring.clone()), (Some(1), "a and b", ring)]
    );
    assert!(graph.deadlocks.is_empty() && graph.complete && !graph.free_delays);
}

#[test]
fn a_step_without_a_way_out_is_a_deadlock() {
    let text = "chart Dead\ninput a : bool\ninitial step 1\nstep 2\ntransition 1 -> 2 : ↑a\n";
    let chart = check("dead", text).expect("a chart");
    let graph = explored(&chart, Profile::default(), Of::Situations, 1_000);
    assert_eq!((graph.initial, graph.deadlocks), (vec![0], vec![1]), "an edge needs a scan before it");
    // 1 with `a` false and true before, and 2 likewise.
    let states = explored(&chart, Profile::default(), Of::States, 1_000);
    assert_eq!((states.nodes.len(), states.states), (4, 4));
}

#[test]
fn a_delay_may_end_at_any_later_reaction_and_not_at_once() {
    // By hand: `a` leads to 2, where the delay begins; it cannot end in the same reaction. Of one operand the shorter time
    // ends first or with the longer one: 3 is never passed over for 4 without the shorter one.
    let text = "chart Delay\ninput a : bool\ninitial step 1\nstep 2\nstep 3\nstep 4\n\
                transition 1 -> 2 : a\ntransition 2 -> 3 : 1s/X2 and not 5s/X2\ntransition 2 -> 4 : 5s/X2\n";
    let chart = check("delay", text).expect("a chart");
    let graph = explored(&chart, Profile::default(), Of::Situations, 1_000);
    let edges: Vec<(String, String, &str)> = graph
        .edges
        .iter()
        .map(|edge| (graph.nodes[edge.from].steps.join(" "), graph.nodes[edge.to].steps.join(" "), edge.when.as_str()))
        .collect();
    let edge = |from: &str, to: &str, when| (from.to_owned(), to.to_owned(), when);
    assert_eq!(edges, [edge("1", "2", "a"), edge("2", "3", "true"), edge("2", "4", "true")]);
    assert!(graph.free_delays);
}

#[test]
fn numbers_that_are_given_are_parted_where_they_are_compared() {
    let text = "chart Numbers\ninput n : int\ninitial step 1\nstep 2\nstep 3\n\
                transition 1 -> 2 : [n > 5]\ntransition 2 -> 3 : [n = 9]\ntransition 3 -> 1 : [n < 0]\n";
    let chart = check("numbers", text).expect("a chart");
    let graph = explored(&chart, Profile::default(), Of::Situations, 1_000);
    let whens: Vec<&str> = graph.edges.iter().map(|edge| edge.when.as_str()).collect();
    // 1 -> 2 for more than 5 save 9, which leads on to 3; 2 -> 3 for 9; 3 -> 1 below 0.
    assert_eq!(graph.edges.len(), 4, "{whens:?}");
    let of = |from: &str, to: &str| {
        let found = graph.edges.iter().find(|edge| {
            graph.nodes[edge.from].steps == [from.to_owned()] && graph.nodes[edge.to].steps == [to.to_owned()]
        });
        found.map(|edge| edge.when.as_str()).unwrap_or_default().to_owned()
    };
    assert_eq!(of("2", "3"), "[n >= 9] and [n < 10]");
    assert_eq!(of("3", "1"), "[n < 0]");
    assert!(of("1", "3").contains("[n >= 9]"), "{whens:?}");
}

#[test]
fn what_cannot_be_followed_is_told_and_too_many_states_are_not_all() {
    let text = "chart Sum\ninput n : int\nvar sum : int\ninitial step 1 { sum := sum + n on activation }\nstep 2\n\
                transition 1 -> 2 : true\ntransition 2 -> 1 : [sum > 5]\n";
    let chart = check("sum", text).expect("a chart");
    let mut net = grafc_net::build(&chart);
    grafc_net::passes::run(&mut net, false, &mut grafc_diagnostics::Diagnostics::new());
    let (program, _) = compile_observed(Analysis::new(net), &Options::default(), Observed::Transitions);
    let beyond = graph(&program, Of::Situations, 1_000).expect_err("a number is added up");
    assert!(beyond.to_string().contains("`n`"), "{beyond}");
    let chart = check("round", ROUND).expect("a chart");
    let few = explored(&chart, Profile::default(), Of::Situations, 1);
    assert!(!few.complete && few.deadlocks.is_empty());
    // One state with 2^20 vectors that all count.
    let inputs: Vec<String> = (0..20).map(|n| format!("a{n}")).collect();
    let text = format!(
        "chart Parity\ninput {} : bool\ninitial step 1\nstep 2\ntransition 1 -> 2 : {}\ntransition 2 -> 1 : not a0\n",
        inputs.join(", "),
        inputs.join(" xor ")
    );
    let chart = check("parity", &text).expect("a chart");
    assert!(!explored(&chart, Profile::default(), Of::Situations, 10).complete);
}
