//! Claims that are written in charts; the answers are worked out from the rules.

use super::{answer, fails, holds, rows, verified_by};
use grafc_model::reaction::Profile;
use grafc_testsuite::charts::check;
use grafc_verify::{Answer, Method, Verified};

#[track_caller]
fn of(text: &str) -> Verified {
    let chart = check("claims", text).expect("a chart without errors");
    let found = verified_by(&chart, Profile::default(), Method::Explicit);
    let other = verified_by(&chart, Profile::default(), Method::Symbolic);
    assert_eq!(found.barred.is_some(), other.barred.is_some());
    if found.barred.is_some() {
        return found;
    }
    for (one, other) in found.verdicts.iter().zip(&other.verdicts) {
        match (&one.answer, &other.answer) {
            (Answer::Fails(Some(one)), Answer::Fails(Some(other))) => assert_eq!(one.rows.len(), other.rows.len()),
            // What leads to what, and what may end, only one of them follows.
            (_, Answer::Open(_)) => {}
            (one_answer, other) => assert_eq!(one_answer, other, "{}", one.claim.name),
        }
    }
    found
}

const LIFT: &str = "chart Lift\ninput up, down, call_up, call_down : bool\noutput Lift, Lower : bool\n\
                    initial step 1\nstep 2 { Lift }\nstep 3 { Lower }\n\
                    transition (1) 1 -> 2 : call_up and not up\ntransition (2) 1 -> 3 : call_down and not down\n\
                    transition (3) 2 -> 1 : up\ntransition (4) 3 -> 1 : down\n";

#[test]
fn an_assertion_holds_where_the_inputs_are_assumed_to() {
    // Both calls at once lead to both steps; so it is the interlock that makes it true.
    let claim = "assert \"never both\" : not (Lift and Lower)\n";
    let found = of(&format!("{LIFT}{claim}"));
    assert_eq!(rows(fails(&found, "never both")), ["0 0011 -> 2 3"]);
    let found = of(&format!("{LIFT}{claim}assume not (call_up and call_down)\n"));
    holds(&found, "never both");
    holds(&found, "selection 1");
}

#[test]
fn an_assertion_is_about_the_inputs_of_the_reaction() {
    // In 2 `up` is never true after a reaction: it would lead on. With `down` it may be.
    let found = of(&format!("{LIFT}assert \"up\" : not (X2 and up)\nassert \"down\" : not (X2 and down)\n"));
    holds(&found, "up");
    assert_eq!(fails(&found, "down").rows.len(), 1);
}

#[test]
fn after_a_step_is_in_each_state_with_it() {
    let found = of(&format!("{LIFT}assert \"lifts\" : Lift or not X2\nassert after X2 : Lift and not up\n"));
    holds(&found, "lifts");
    assert!(
        found
            .verdicts
            .iter()
            .all(|verdict| !matches!(verdict.answer, Answer::Fails(_)) || verdict.claim.kind.is_note())
    );
}

#[test]
fn edges_of_inputs_make_the_last_inputs_a_part_of_the_state() {
    // `a` never rises and never falls: so what it was at the start it stays.
    let chart = "chart Edges\ninput a : bool\ninitial step 1\nstep 2\ninitial step 3\nstep 4\n\
                 transition (1) 1 -> 2 : a\ntransition (2) 3 -> 4 : X2 and not a\n";
    let found = of(chart);
    holds(&found, "dead-transition (2)");
    let found = of(&format!("{chart}assume \"it falls never\" : not ↓a\n"));
    assert_eq!(*answer(&found, "dead-transition (2)"), Answer::Fails(None));
    holds(&found, "dead-transition (1)");
}

#[test]
fn what_is_wanted_is_reached_or_not() {
    let found =
        of(&format!("{LIFT}reach \"both\" : X2 and X3\nreach \"down\" : X3\nassume not (call_up and call_down)\n"));
    assert_eq!(*answer(&found, "both"), Answer::Fails(None));
    holds(&found, "down");
}

#[test]
fn where_a_chart_may_end_is_no_deadlock() {
    let chart = "chart End\ninput a, b : bool\ninitial step 1\nstep 2\nstep 3\n\
                 transition (1) 1 -> 2 : a and not b\ntransition (2) 1 -> 3 : b and not a\n";
    assert_eq!(fails(&of(chart), "deadlock").rows.len(), 1);
    holds(&of(&format!("{chart}final X2 or X3\n")), "deadlock");
    // 3 is still one.
    assert_eq!(rows(fails(&of(&format!("{chart}final X2\n")), "deadlock")), ["0 01 -> 3"]);
}

#[test]
fn one_step_leads_to_another_as_long_as_it_can_be_reached() {
    // From 2, `b` leads to 3 and `c` to 4, from where there is no way to 3.
    let chart = "chart Leads\ninput a, b, c : bool\ninitial step 1\nstep 2\nstep 3\nstep 4\n\
                 transition (1) 1 -> 2 : ↑a\ntransition (2) 2 -> 3 : ↑b\ntransition (3) 2 -> 4 : ↑c and not b\n\
                 transition (4) 3 -> 1 : 1\n";
    let found = of(&format!("{chart}assert \"to 3\" : X2 leads to X3\n"));
    // 3 is passed through, so it is in no state at all: from 2 itself it cannot be reached.
    assert_eq!(rows(fails(&found, "to 3")), ["0 000 -> 1", "1 100 -> 2"]);
    let found = of(&format!("{chart}assert \"to 1\" : X2 leads to X1\n"));
    let trace = fails(&found, "to 1");
    assert_eq!((trace.rows.len(), trace.rows[2].steps.as_deref()), (3, Some(&["4".to_owned()][..])));
    let found = of(&format!("{chart}assert \"to 1\" : X2 leads to X1\nassume not ↑c\n"));
    holds(&found, "to 1");
    // 4 leads nowhere, but not every state comes after 3.
    let found = of(&format!("{chart}assert \"from 3\" : X3 leads to X1\n"));
    holds(&found, "from 3");
}

#[test]
fn a_livelock_before_it_is_reached_loses_it() {
    // From 2, `b` and `c` at once go round for ever between 2 and 5; 3 could be reached by `d`.
    let found = of("chart Round\ninput a, b, c, d : bool\ninitial step 1\nstep 2\nstep 5\nstep 3\n\
                    transition (1) 1 -> 2 : ↑a and not b\ntransition (2) 2 -> 5 : b\ntransition (3) 5 -> 2 : c\n\
                    transition (4) 2 -> 3 : d and not b\nassert \"to 3\" : X2 leads to X3\n");
    let trace = fails(&found, "to 3");
    assert_eq!(trace.rows.len(), 3);
    assert_eq!(trace.rows[2].steps, None);
}

#[test]
fn assumptions_that_allow_nothing_are_told() {
    let found = of(&format!("{LIFT}assume up\nassume not up\n"));
    assert!(found.barred.as_ref().is_some_and(|trace| trace.rows.is_empty()));
    // After `up` it has to be false, by the one, and true, by the other.
    let found = of(&format!("{LIFT}assume not ↓up\nassume not up or ↑up\n"));
    assert!(found.barred.is_some());
    assert!(of(LIFT).barred.is_none());
}
