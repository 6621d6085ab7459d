//! Charts with bounds derived by hand, micro-step by micro-step: `k: what changes in micro-step k`. Where a bound can
//! be reached, a cause that were missing from the graph would make the number too small.

use super::Transients;
use grafc_diagnostics::{Diagnostics, FileId};

fn transients(text: &str) -> Transients {
    let (tree, diagnostics) = grafc_syntax::parse(FileId::default(), text);
    assert!(!diagnostics.has_errors(), "{diagnostics:?}");
    let (chart, diagnostics) = grafc_model::check(&tree, "chart");
    let mut net = grafc_net::build(&chart.unwrap_or_else(|| panic!("{diagnostics:?}")));
    grafc_net::passes::run(&mut net, false, &mut Diagnostics::new());
    crate::Analysis::new(net).transients().clone()
}

const INPUTS: &str = "input a, b, c : bool  output p, q, w : bool  var n : int  const long : time := 2s\n";

/// The bound of a chart over inputs `a`, `b`, `c`, outputs `p`, `q`, `w` and the number `n`.
#[track_caller]
fn longest(text: &str, bound: impl Into<Option<u32>>) -> Transients {
    let found = transients(&format!("{INPUTS}{text}"));
    assert_eq!(found.longest, bound.into(), "{text}\n{found:?}");
    found
}

/// The numbers of transitions, from 1.
fn numbers(transitions: &[grafc_model::chart::TransitionId]) -> Vec<usize> {
    transitions.iter().map(|t| t.index() + 1).collect()
}

#[test]
fn nothing_ever_changes() {
    // 1: nothing
    assert!(longest("initial step 1", 1).single);
    assert!(longest("initial step 1 step 2 transition 1 -> 2 : 0", 1).single);
    assert!(longest("initial step 1 step 2 transition 1 -> 2 : a and not a", 1).single);
}

#[test]
fn a_ring_on_edges_of_inputs() {
    // 1: one clears, the operand changes; 2: nothing
    assert!(longest("initial step 1 step 2 transition 1 -> 2 : ↑a transition 2 -> 1 : ↑a", 2).single);
    assert!(
        longest("initial step 1 step 2 transition 1 -> 2 : ↑a and b transition 2 -> 1 : c and ↓(a or b)", 2).single
    );
}

#[test]
fn a_chain_of_levels() {
    // 1: 1 -> 2; 2: 2 -> 3; 3: 3 -> 4; 4: nothing
    let found = longest(
        "initial step 1 step 2 step 3 step 4 transition 1 -> 2 : a transition 2 -> 3 : b transition 3 -> 4 : a",
        4,
    );
    assert_eq!((numbers(&found.chain), found.single), (vec![1, 2, 3], false));
    assert!(found.ends_within(4) && !found.ends_within(3));
}

#[test]
fn a_ring_of_levels_on_different_inputs() {
    // with a and b true it never ends
    let found = longest("initial step 1 step 2 transition 1 -> 2 : a transition 2 -> 1 : b", None);
    assert_eq!((numbers(&found.cycle), found.single), (vec![1, 2], false));
    assert!(!found.ends_within(u32::MAX));
}

#[test]
fn levels_that_exclude_each_other() {
    // 1: one of them, and the next does not hold in this reaction
    for (one, other) in [
        ("a", "not a"),
        ("a and b", "c and not (b or c)"),
        ("[n = 1] and a", "not a and [n = 1]"),
        ("1s/a", "not 1s/a"),
        ("a and b", "not a or not b"),
    ] {
        let text = format!("initial step 1 step 2 transition 1 -> 2 : {one} transition 2 -> 1 : {other}");
        assert!(longest(&text, 2).single, "{one}, {other}");
    }
    let number = "input m : int  initial step 1 step 2 transition 1 -> 2 : [m = 1] transition 2 -> 1 :";
    for (other, bound) in [("[m = 2]", Some(2)), ("[m <> 1]", Some(2)), ("[m > 2]", Some(2)), ("[m < 2]", None)] {
        assert_eq!(transients(&format!("{number} {other}")).longest, bound, "{other}");
    }
}

#[test]
fn reals_that_are_no_numbers() {
    // x < 1 and x >= 1 exclude each other; neither holds of what is no number, so `not [x < 1]` is another thing
    let chart = |one: &str, other: &str| {
        let text =
            format!("input x, y : real  initial step 1 step 2 transition 1 -> 2 : {one} transition 2 -> 1 : {other}");
        transients(&text).longest
    };
    assert_eq!(chart("[x < y]", "not [x < y]"), Some(2));
    assert_eq!(chart("not [x < y]", "not [x >= y]"), None);
}

#[test]
fn a_ring_that_no_value_of_an_input_lets_through() {
    // a: 4 -> 1, 1 -> 2, 2 -> 3, nothing; not a: 2 -> 3, 3 -> 4, 4 -> 1, nothing
    longest(
        "initial step 1 step 2 step 3 step 4
         transition 1 -> 2 : a transition 2 -> 3 : b transition 3 -> 4 : not a transition 4 -> 1 : c",
        4,
    );
    // two such rings, on different inputs, 1: both go on; 2: both; 3: nothing or as above
    longest(
        "grafcet A { initial step 1 step 2 step 3 step 4
           transition 1 -> 2 : a transition 2 -> 3 : b transition 3 -> 4 : not a transition 4 -> 1 : 1 }
         grafcet B { initial step 11 step 12 step 13 step 14
           transition 11 -> 12 : c transition 12 -> 13 : a transition 13 -> 14 : not c transition 14 -> 11 : 1 }",
        4,
    );
}

#[test]
fn an_edge_of_an_activity() {
    // vector 1d. 1: 1 -> 2; 2: the operand X2, 2 -> 3, 10 -> 11; 3: the operand X2; 4: nothing
    longest(
        "initial step 1 initial step 10 step 2 step 3 step 11
         transition 1 -> 2 : a transition 2 -> 3 : 1 transition 10 -> 11 : ↑X2",
        4,
    );
    // vector 1k. 1: 1 -> 2; 2: the operand X1, 10 -> 11; 3: nothing
    longest("initial step 1 initial step 10 step 2 step 11 transition 1 -> 2 : ↑a transition 10 -> 11 : ↓X1", 3);
    // the same with more to it. 1: 1 -> 2; 2: the operand, 10 -> 11; 3: 11 -> 12; 4: nothing
    longest(
        "initial step 1 initial step 10 step 2 step 11 step 12
         transition 1 -> 2 : ↑a transition 10 -> 11 : ↑X2 transition 11 -> 12 : 1",
        4,
    );
}

#[test]
fn an_edge_is_over_after_a_micro_step() {
    // 1: the operand a; 2: 1 -> 2; 3: nothing
    longest("initial step 1 step 2 transition 1 -> 2 : not ↑a and b", 3);
    // 1: the operand a, 1 -> 2; 2: 2 -> 3; 3: nothing
    longest("initial step 1 step 2 step 3 transition 1 -> 2 : ↑a transition 2 -> 3 : not ↑a and b", 3);
    // 1: operand a; 2: 10 -> 11, since the edge is over
    longest("initial step 1 step 2 transition 1 -> 2 : not ↑a xor b", 3);
}

#[test]
fn a_counter_decides() {
    // vector 3g: it ends, but only the numbers say so
    longest(
        "initial step 0 step 1 { n := n + 1 on activation } step 2 step 3
         transition 0 -> 1 : ↑a transition 1 -> 2 : [n < 3] transition 2 -> 1 : 1 transition 1 -> 3 : [n >= 3]",
        None,
    );
}

#[test]
fn an_activity_in_a_condition() {
    // 1: 1 -> 2; 2: 7 -> 8; 3: nothing
    for (steps, condition) in [
        ("initial step 1 step 2 transition 1 -> 2 : ↑a", "X2"),
        ("initial step 1 step 2 transition 1 -> 2 : ↑a", "not X1"),
        ("step 2 transition -> 2 : ↑a", "XG"),
        ("initial step 2 transition 2 -> : ↑a", "not XG"),
        ("initial step 1 step 2 { w } transition 1 -> 2 : ↑a", "w"),
        ("initial step 1 { w } step 2 transition 1 -> 2 : ↑a", "not w"),
        ("initial step 1 initial step 3 { w if X2 } step 2 transition 1 -> 2 : ↑a", "w and b"),
        ("initial step 1 initial step 3 { w if X1 } step 2 transition 1 -> 2 : ↑a", "not (w or b)"),
        ("initial step 1 step 2 { p := 1 on activation } transition 1 -> 2 : ↑a", "p"),
        ("initial step 1 step 2 { n := n + 1 on activation } transition 1 -> 2 : ↑a", "[n * 2 > 3]"),
        ("initial step 1 { n := 5 on deactivation } step 2 transition 1 -> 2 : ↑a", "[n - 1 = 4]"),
        ("initial step 1 step 2 transition 1 -> 2 : ↑a { n := 5 }", "[n < 9] xor b"),
        ("initial step 1 step 2 transition 1 -> 2 : ↑a", "not [T1 >= 2s]"),
        ("initial step 1 step 2 transition 1 -> 2 : ↑a", "X2/2s"),
        ("initial step 1 step 2 transition 1 -> 2 : ↑a", "not 2s/X1"),
        (
            "initial step 1 macro step M2 transition 1 -> M2 : ↑a
             expansion M2 { macro step M3 step E2 step S2 transition E2 -> M3 : 0 transition M3 -> S2 : 0 }
             expansion M3 { step E3 step S3 transition E3 -> S3 : 0 }",
            "XM2",
        ),
        (
            "macro step M2
             expansion M2 { macro step M3 step E2 step S2 transition E2 -> M3 : 0 transition M3 -> S2 : 0 }
             expansion M3 { step E3 step S3 transition E3 -> S3 : 0 transition -> E3 : ↑a }",
            "XM2",
        ),
        (
            "macro step M3 expansion M3 { initial step E3 step S3 transition E3 -> S3 : 0 transition E3 -> : ↑a }",
            "not XM3",
        ),
    ] {
        let waiting = format!("grafcet Z {{ initial step 7 step 8 transition 7 -> 8 : {condition} }}");
        longest(&format!("grafcet G {{ {steps} }} {waiting}"), 3);
    }
}

#[test]
fn a_delay_needs_time_to_pass() {
    // vector 5g. 1: the delay has run out and r holds: 27 -> 28; 2: 28 -> 27; 3: nothing, for the delay starts again
    let found = longest("initial step 27 step 28 transition 27 -> 28 : 4s/X27 transition 28 -> 27 : b", 3);
    assert!(!found.single);
    // 1: 27 -> 28; 2: nothing
    for delay in ["4s/X28", "long/(X28 and a)", "1s/(2s/X28)", "[T28 >= 2s]", "[long <= T28]", "not [T28 < long]"] {
        longest(&format!("initial step 27 step 28 transition 27 -> 28 : ↑a transition 28 -> 27 : {delay}"), 2);
    }
    // An off-delay or a denied one holds at once. 1: 27 -> 28; 2: 28 -> 27; 3: nothing
    for delay in ["4s/X28/1s", "X28/1s", "not 4s/X28", "[T28 < 2s]", "[T28 >= 0s]", "not [T28 > 0s]", "[T27 <= 2s]"] {
        longest(&format!("initial step 27 step 28 transition 27 -> 28 : ↑a transition 28 -> 27 : {delay}"), 3);
    }
    // The delay of another step has run out before. 1: 10 -> 11; 2: 11 -> 12; 3: nothing
    longest(
        "grafcet A { initial step 1 } grafcet B { initial step 10 step 11 step 12
         transition 10 -> 11 : ↑a transition 11 -> 12 : 4s/X1 }",
        3,
    );
}

#[test]
fn what_one_micro_step_must_not_leave_out() {
    // A delay of an activity begins in the second micro-step, and only there.
    let found = longest("initial step 1 step 2 transition 1 -> 2 : ↑a transition 2 -> 1 : 4s/X2", 2);
    assert!(!found.single && found.single_but_delays);
    // A delay of inputs has begun in the first.
    assert!(longest("initial step 1 step 2 transition 1 -> 2 : 4s/(a and b)", 2).single);
    // A duration is read, not kept.
    assert!(longest("initial step 1 step 2 transition 1 -> 2 : ↑a transition 2 -> 1 : [T2 >= 4s]", 2).single);
    // DIV0 is seen in the second micro-step.
    let division = "initial step 1 { w if [6 / n > 1] } step 2 transition 1 -> 2 : ↑a { n := 0 }";
    assert!(!longest(division, 2).single_but_delays);
    // The operand of an edge falls in the second micro-step, and nothing else changes.
    let edge = "initial step 1 step 2 transition 1 -> 2 : ↑a transition 2 -> 1 : ↓(X1 and a) and ↓b";
    assert!(!longest(edge, 3).single_but_delays);
    // A level in an event counts in the first micro-step only.
    assert!(longest("initial step 1 { n := n + 1 on event a or ↑b }", 2).single);
}

#[test]
fn a_clearing_again_and_again() {
    // vector 9d: each micro-step counts
    assert_eq!(numbers(&longest("step 1 transition -> 1 : a { n := n + 1 }", None).cycle), [1]);
    // vector 9b. 1: the source activates 1; 2: 1 -> 2, and the source keeps 1; 3: nothing
    longest("step 1 step 2 transition -> 1 : a transition 1 -> 2 : b", 3);
    // 1: 1 is activated, n counts; 2: the same value again: nothing
    longest("step 1 transition -> 1 : a { n := 7 }", 2);
    // 1: the action on activation wins, n := 9; 2: n := 7; 3: nothing
    longest("step 1 { n := 9 on activation } transition -> 1 : a { n := 7 }", 3);
    // A transition that clears once does its action once. 1: 1 -> 2; 2: nothing
    longest("initial step 1 step 2 transition 1 -> 2 : a { n := n + 1 }", 2);
}

#[test]
fn an_action_that_hides_another_stops() {
    // 1: both are done, the second wins: n = 2; 2: only the first: n = 1; 3: nothing
    let hidden = "grafcet A { step 1 transition -> 1 : 1 { n := 1 } }";
    longest(&format!("{hidden} grafcet B {{ initial step 7 step 8 transition 7 -> 8 : ↑a {{ n := 2 }} }}"), 3);
    longest(
        &format!("{hidden} grafcet B {{ initial step 7 step 8 {{ n := 2 on activation }} transition 7 -> 8 : ↑a }}"),
        3,
    );
    // 1: both; 2: the second has no step before it, or its condition holds no more; 3: nothing
    longest(&format!("{hidden} grafcet B {{ initial step 7 step 8 transition 7 -> 8 : 1 {{ n := 2 }} }}"), 3);
    for (condition, action) in [("not X8", ""), ("not p", "p := 1 on activation")] {
        longest(
            &format!(
                "{hidden} grafcet B {{ step 2 transition -> 2 : {condition} {{ n := 2 }} }}
                 grafcet C {{ initial step 7 step 8 {{ {action} }} transition 7 -> 8 : ↑a }}"
            ),
            3,
        );
    }
    // 1: 4 is activated, both are done; 2: the second is frozen, be it with what it is within; 3: nothing
    longest(
        &format!(
            "{hidden} grafcet B {{ initial enclosing step 9 }}
             grafcet X9/D {{ initial activated step 2 transition -> 2 : 1 {{ n := 2 }} }}
             grafcet C {{ initial step 3 step 4 {{ force B{{*}} }} transition 3 -> 4 : ↑a }}"
        ),
        3,
    );
    longest(
        &format!(
            "{hidden} grafcet B {{ step 2 transition -> 2 : 1 {{ n := 2 }} }}
             grafcet C {{ initial step 3 step 4 {{ force B{{*}} }} transition 3 -> 4 : ↑a }}"
        ),
        3,
    );
    // 1: 3 is deactivated, both are done; 2: the second is not within an active step; 3: nothing
    longest(
        &format!(
            "{hidden} grafcet C {{ initial enclosing step 3 transition 3 -> : ↑a }}
             grafcet X3/B {{ initial activated step 2 transition -> 2 : 1 {{ n := 2 }} }}"
        ),
        3,
    );
}

#[test]
fn a_step_kept_active() {
    // 0 and 1 have been active for 1 s. 1: 0 -> 1 and 1 -> 2, 1 stays; 2: 1 -> 2 again, 1 goes; 3: nothing
    longest("initial step 0 initial step 1 step 2 transition 0 -> 1 : 1s/X1 transition 1 -> 2 : 1s/X1", 3);
    // 1: 1 is activated; 2: 1 -> 9, and the loop keeps 1; 3: 1 -> 9, for X9 ends the loop; 4: nothing
    for end in ["X9", "w"] {
        let steps = "initial step 0 step 1 step 9 { w } transition 0 -> 1 : ↑a transition 1 -> 9 : 1";
        longest(&format!("{steps} transition 1 -> 1 : not {end}"), 4);
    }
    // 1: 1 and 5; 2: 5 goes, the loop keeps 1, 9 comes; 3: 1 goes; 4: nothing
    longest(
        "initial step 0 step 1 step 5 step 9
         transition 0 -> 1, 5 : ↑a transition 1, 5 -> 1 : 1 transition 1 -> 9 : 1",
        4,
    );
}

#[test]
fn an_event_of_an_edge() {
    // 1: 1 -> 2; 2: the operand X2, p := 1; 3: the operand p; 4: nothing
    let steps = "initial step 1 step 2 transition 1 -> 2 : ↑a";
    for event in ["↑X2", "↑X2 and b", "↑X2 or b", "not b or ↓X1"] {
        let text = format!(
            "grafcet A {{ {steps} }} grafcet B {{ initial step 5 {{ p := 1 on event {event} q := a on event ↑p }} }}"
        );
        longest(&text, 4);
    }
}

#[test]
fn enclosures() {
    // 1: 5 and its link 51; 2: 51 -> 52; 3: nothing
    let outer = "grafcet A { initial step 0 enclosing step 5 transition 0 -> 5 : ↑a transition 5 -> 0 : ↓a }";
    longest(&format!("{outer} grafcet X5/B {{ activated step 51 step 52 transition 51 -> 52 : 1 }}"), 3);
    // the same with a source transition
    longest(&format!("{outer} grafcet X5/B {{ activated step 51 step 52 transition -> 52 : 1 }}"), 3);
    // 1: 5 and 51 go; 2: the operand X51; 3: nothing
    longest(
        "grafcet A { initial enclosing step 5 transition 5 -> : ↑a } grafcet X5/B { initial activated step 51 }
         grafcet C { initial step 7 step 8 transition 7 -> 8 : ↓X51 }",
        3,
    );
    // a nested one. 1: 5, 51, 61; 2: 61 -> 62; 3: nothing
    longest(
        &format!(
            "{outer} grafcet X5/B {{ activated enclosing step 51 }}
             grafcet X51/C {{ activated step 61 step 62 transition 61 -> 62 : 1 }}"
        ),
        3,
    );
    // vector 7f, a transient enclosing step. 1: 5, 51; 2: 5 -> 6; 3: nothing
    longest(
        "grafcet A { initial step 0 enclosing step 5 step 6 transition 0 -> 5 : ↑a transition 5 -> 6 : 1 }
         grafcet X5/B { activated step 51 { p := 1 on deactivation } }",
        3,
    );
}

#[test]
fn a_step_within_must_be_reached_first() {
    // 1: 0 -> 1 with 10; 2: 10 -> 11; 3: 1 -> 0; 4: nothing unless a: 0 -> 1 again. So it is a circle ...
    longest(
        "grafcet A { initial step 0 enclosing step 1 transition 0 -> 1 : a transition 1 -> 0 : X11 }
         grafcet X1/B { activated step 10 step 11 transition 10 -> 11 : 1 }",
        None,
    );
    // ... that a delay within breaks. 1: 11 -> 12; 2: 1 -> 0; 3: 0 -> 1 with 10; 4: 10 -> 11; 5: nothing
    longest(
        "grafcet A { initial step 0 enclosing step 1 transition 0 -> 1 : a transition 1 -> 0 : X12 and b }
         grafcet X1/B { activated step 10 step 11 step 12 transition 10 -> 11 : c transition 11 -> 12 : 2s/X11 }",
        5,
    );
}

#[test]
fn orders() {
    let forcing = |situation: &str| {
        format!(
            "grafcet A {{ initial step 0 step 1 {{ force B{{{situation}}} }}
               transition 0 -> 1 : ↑a transition 1 -> 0 : ↑b }}"
        )
    };
    // 1: 1, and B is forced; 2: the operand; 3: nothing
    for (situation, edge) in [("12", "↑X12"), ("12", "↓X10"), ("", "↓X10")] {
        longest(
            &format!(
                "{} grafcet B {{ initial step 10 step 12 }}
                 grafcet C {{ initial step 7 step 8 transition 7 -> 8 : {edge} }}",
                forcing(situation)
            ),
            3,
        );
    }
    // It is that already. 1: 1; 2: nothing
    longest(
        &format!(
            "{} grafcet B {{ initial step 10 }} grafcet C {{ initial step 7 step 8 transition 7 -> 8 : not X10 }}",
            forcing("INIT")
        ),
        2,
    );
    // 1: 1 -> 0, the end of the order; 2: 12 -> 13; 3: nothing
    let free = |situation: &str| {
        let a = forcing(situation).replace("transition 0 -> 1 : ↑a", "");
        a.replace("initial step 0 step 1", "step 0 initial step 1")
    };
    longest(&format!("{} grafcet B {{ initial step 10 step 12 step 13 transition 12 -> 13 : 1 }}", free("12")), 3);
    longest(&format!("{} grafcet B {{ step 12 transition -> 12 : 1 }}", free("")), 3);
    // What is not forced is not there to clear. 1: 1 -> 0; 2: nothing
    longest(&format!("{} grafcet B {{ initial step 10 step 13 transition 10 -> 13 : ↑c or X0 }}", free("")), 3);
    longest(&format!("{} grafcet B {{ initial step 10 step 13 transition 10 -> 13 : c }}", free("")), 2);
    // 1: 1 -> 0, the end of freezing; 2: 10 -> 11; 3: 11 -> 12; 4: nothing
    longest(
        &format!(
            "{} grafcet B {{ initial step 10 step 11 step 12 transition 10 -> 11 : 1 transition 11 -> 12 : 1 }}",
            free("*")
        ),
        4,
    );
    // Freezing and its end reach what is within: 1: 1 -> 0; 2: 20 -> 21; 3: nothing
    for situation in ["*", "10", "INIT"] {
        longest(
            &format!(
                "{} grafcet B {{ initial enclosing step 10 step 11 }}
                 grafcet X10/C {{ initial activated step 20 step 21 transition 20 -> 21 : 1 }}",
                free(situation)
            ),
            3,
        );
    }
}

#[test]
fn an_order_of_a_transient_step() {
    // vector 6e. 1: 1, B{12}; 2: 1 -> 2, the end of the order; 3: 12 -> 13; 4: nothing
    longest(
        "grafcet A { initial step 0 step 1 { force B{12} } step 2 transition 0 -> 1 : ↑a transition 1 -> 2 : 1 }
         grafcet B { initial step 10 step 11 step 12 step 13
           transition 10 -> 11 : ↑b transition 11 -> 12 : ↑c transition 12 -> 13 : 1 }",
        4,
    );
}

#[test]
fn an_order_that_another_hid() {
    // 1: 1 goes, B is forced to 13 in place of 12; 2: 7 -> 8; 3: nothing
    for between in ["", "grafcet D { step 2 { force B{} } transition -> 2 : ↑c }"] {
        longest(
            &format!(
                "grafcet A {{ initial step 1 {{ force B{{12}} }} transition 1 -> : ↑a }} {between}
                 grafcet E {{ initial step 3 {{ force B{{13}} }} }}
                 grafcet B {{ initial step 10 step 12 step 13 }}
                 grafcet C {{ initial step 7 step 8 transition 7 -> 8 : X13 }}"
            ),
            3,
        );
    }
}

#[test]
fn an_order_on_an_enclosure() {
    // vector 6r. 1: 5, and 52 in place of 51; 2: the operand X52, 7 -> 8; 3: nothing
    longest(
        "grafcet A { initial step 1 { force B{52} } }
         grafcet D { initial step 4 enclosing step 5 transition 4 -> 5 : ↑a }
         grafcet X5/B { activated step 51 step 52 }
         grafcet C { initial step 7 step 8 transition 7 -> 8 : ↑X52 }",
        3,
    );
}

#[test]
fn where_many_arcs_meet() {
    // 1: the hub; 2: every branch; 3: nothing
    let mut text = String::from("step hub ");
    for i in 0..40 {
        text += &format!("initial step i{i} step o{i} transition i{i} -> hub : ↑a transition hub -> o{i} : 1 ");
    }
    longest(&text, 3);
}
