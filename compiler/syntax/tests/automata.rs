//! Automata: `automaton`, `state` and `arc` are words in their places, and names in all others.

mod common;

use common::{chart, faults, show};
use grafc_syntax::ast::*;
use grafc_syntax::format;

const LOCK: &str = "\
input x1, x2 : bool
output z, y1, y2 : bool

automaton A0 \"a lock\" {
  initial state 0 { z }
  state 1 \"open\"

  arc 0 -> 1 : x1 { y1   y2 }
  arc (2) \"back\" 1 -> 0 : x2 { n := n + 1   y1   allow W0417 \"meant\" }
}
";

fn automaton(chart: &Chart) -> &Grafcet {
    let found =
        chart.items.iter().find_map(|item| if let Item::Grafcet(grafcet) = item { Some(grafcet) } else { None });
    found.expect("an automaton")
}

#[test]
fn states_and_arcs() {
    let chart = chart(LOCK);
    let automaton = automaton(&chart);
    assert!(automaton.automaton);
    assert_eq!((automaton.name.text.as_str(), automaton.items.len()), ("A0", 4));
    let [Item::Step(first), Item::Step(second), Item::Transition(arc), Item::Transition(back)] = &automaton.items[..]
    else {
        panic!("{:?}", automaton.items)
    };
    assert!(first.is_initial() && !second.is_initial());
    assert_eq!((first.label.text.as_str(), first.actions.len(), second.label.text.as_str()), ("0", 1, "1"));
    let texts = |names: &[Name]| names.iter().map(|name| name.text.to_string()).collect::<Vec<_>>();
    assert_eq!((texts(arc.outputs()), arc.actions().len()), (vec!["y1".into(), "y2".into()], 0));
    assert_eq!((texts(back.outputs()), back.actions().len(), back.allows().len()), (vec!["y1".into()], 1, 1));
    assert_eq!(show(&chart, arc.condition), "x1");
    assert_eq!(back.designation().map(|name| name.text.as_str()), Some("2"));
}

#[test]
fn the_canonical_form_keeps_the_words() {
    assert_eq!(format(LOCK, &chart(LOCK)), LOCK);
    let loose = LOCK.replace("\n  ", "\n").replace("   ", " ").replace("arc 0", "arc\n0");
    assert_eq!(format(&loose, &chart(&loose)), LOCK);
}

#[test]
fn the_words_are_names_elsewhere() {
    let names = "input automaton, state, arc : bool
initial step state { arc if automaton }
step arc
transition state -> arc : state and arc
transition arc -> state : automaton";
    let chart = chart(names);
    assert_eq!(chart.items.len(), 5);
    let inside =
        "automaton automaton { initial state state { arc } state arc arc state -> arc : state and arc { arc state } }";
    let inside = common::chart(inside);
    let automaton = automaton(&inside);
    assert_eq!((automaton.name.text.as_str(), automaton.items.len()), ("automaton", 3));
    let Item::Transition(arc) = &automaton.items[2] else { panic!("an arc") };
    assert_eq!(arc.outputs().len(), 2);
    // Outside of an automaton nothing is published on a transition.
    assert!(!faults("transition 1 -> 2 : a { y }").is_empty());
    assert!(!faults("grafcet G { state 1 }").is_empty());
}
