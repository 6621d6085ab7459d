//! Small charts, one a kind of claim; the answers are worked out from the rules.

use super::{answer, fails, holds, rows, verified_by};
use grafc_model::reaction::Profile;
use grafc_testsuite::charts::check;
use grafc_verify::{Answer, Method, Verified};

#[track_caller]
fn of(text: &str) -> Verified {
    let chart = check("by hand", text).expect("a chart without errors");
    let found = verified_by(&chart, Profile::default(), Method::Explicit);
    // Both engines know the same, and traces are as long.
    let other = verified_by(&chart, Profile::default(), Method::Symbolic);
    if !found.verdicts.iter().any(|verdict| matches!(verdict.answer, Answer::Open(_))) {
        assert_eq!((found.searched, found.verdicts.len()), (other.searched, other.verdicts.len()));
    }
    for (one, other) in found.verdicts.iter().zip(&other.verdicts) {
        match (&one.answer, &other.answer) {
            (Answer::Fails(Some(one)), Answer::Fails(Some(other))) => assert_eq!(one.rows.len(), other.rows.len()),
            // What cannot be followed is met in another order.
            (Answer::Open(_), Answer::Open(_)) => {}
            (one_answer, other) => assert_eq!(one_answer, other, "{}", one.claim.name),
        }
    }
    found
}

#[test]
fn a_reaction_that_does_not_end() {
    // From 1 `a` leads to 2, from 2 `b` back: with both it goes round for ever, already at the start.
    let found = of("chart Round\ninput a, b : bool\ninitial step 1\nstep 2\n\
                    transition (1) 1 -> 2 : a\ntransition (2) 2 -> 1 : b\n");
    assert_eq!(rows(fails(&found, "livelock")), ["0 11 -> LIVELOCK"]);
    assert!(found.stops_at_livelock);
    holds(&found, "deadlock");
    holds(&found, "dead-transition (2)");
}

#[test]
fn a_step_without_a_way_out() {
    // The edge of `a` needs a reaction before it (R10).
    let found = of("chart Dead\ninput a : bool\ninitial step 1\nstep 2\ntransition 1 -> 2 : ↑a\n");
    assert_eq!(rows(fails(&found, "deadlock")), ["0 0 -> 1", "1 1 -> 2"]);
    assert_eq!(rows(fails(&found, "home")), ["0 0 -> 1", "1 1 -> 2"]);
    holds(&found, "livelock");
}

#[test]
fn what_counts_only_is_no_way_out_of_a_deadlock() {
    // In 2 the variable goes on changing; the situation does not.
    let found = of("chart Counts\ninput a : bool\nvar n : bool\ninitial step 1\nstep 2 { n := not n on event ↑a }\n\
                    transition 1 -> 2 : a\n");
    assert_eq!(fails(&found, "deadlock").rows.len(), 1);
}

#[test]
fn without_transitions_nobody_asks_for_a_deadlock() {
    let found = of("chart Still\noutput O : bool\ninitial step 1 { O }\n");
    assert!(found.verdicts.iter().all(|verdict| verdict.claim.name != "deadlock"));
    holds(&found, "home");
    holds(&found, "dead-step 1");
}

#[test]
fn what_is_never_cleared_and_never_active() {
    // `b` and `not b` never hold at once; so 3 is never active, and what leaves it never clears.
    let found = of("chart Never\ninput a, b : bool\ninitial step 1\nstep 2\nstep 3\n\
                    transition (1) 1 -> 2 : a\ntransition (2) 2 -> 1 : not a\ntransition (3) 2 -> 3 : b and not b\n\
                    transition (4) 3 -> 1 : b\n");
    assert_eq!(*answer(&found, "dead-transition (3)"), Answer::Fails(None));
    assert_eq!(*answer(&found, "dead-transition (4)"), Answer::Fails(None));
    assert_eq!(*answer(&found, "dead-step 3"), Answer::Fails(None));
    holds(&found, "dead-transition (2)");
    holds(&found, "home");
}

#[test]
fn a_step_that_is_passed_through_is_not_dead() {
    // 2 is never active after a reaction, only on the way (all micro-steps count).
    let found = of("chart Passing\ninput a : bool\ninitial step 1\nstep 2\nstep 3\n\
                    transition (1) 1 -> 2 : a\ntransition (2) 2 -> 3 : 1\ntransition (3) 3 -> 1 : not a\n");
    holds(&found, "dead-step 2");
    holds(&found, "dead-transition (2)");
}

#[test]
fn two_branches_at_once() {
    // (1) and (2) clear together if both inputs are true; after 4 they exclude each other.
    let found =
        of("chart Selection\ninput a, b : bool\ninitial step 1\nstep 2\nstep 3\ninitial step 4\nstep 5\nstep 6\n\
                    transition (1) 1 -> 2 : a\ntransition (2) 1 -> 3 : b\n\
                    transition (3) 4 -> 5 : a\ntransition (4) 4 -> 6 : not a and b\n");
    assert_eq!(rows(fails(&found, "selection 1")), ["0 11 -> 2 3 5"]);
    holds(&found, "selection 4");
}

#[test]
fn a_step_that_is_entered_while_it_is_active() {
    // 1 and 2 are active from the start; `a` leads from 1 to 2, which stays active. What leads from 4 to itself deactivates
    // and activates it: that is no reentry.
    let found = of("chart Reentry\ninput a : bool\ninitial step 1\ninitial step 2\nstep 3\ninitial step 4\n\
                    transition (1) 1 -> 2 : a\ntransition (2) 2 -> 3 : 0\ntransition (3) 4 -> 4 : ↑a\n");
    assert_eq!(rows(fails(&found, "reentry 2")), ["0 1 -> 2 4"]);
    holds(&found, "reentry 4");
}

#[test]
fn what_leaves_and_enters_at_once_is_no_reentry() {
    // With `a` both clear: 2 is left and entered (rule 5).
    let found = of("chart Pass\ninput a : bool\ninitial step 1\ninitial step 2\nstep 3\n\
                    transition (1) 1 -> 2 : a\ntransition (2) 2 -> 3 : a\n");
    holds(&found, "reentry 2");
}

#[test]
fn actions_that_disagree() {
    // Both steps are entered at once, and store different values (vector 3b is another way to it).
    let found = of("chart Conflict\ninput a : bool\nvar n : int\ninitial step 1\n\
                    step 2 { n := 1 on activation }\nstep 3 { n := 2 on activation }\n\
                    transition (1) 1 -> 2, 3 : a\n");
    assert_eq!(rows(fails(&found, "conflict of allocations")), ["0 1 -> 2 3"]);
    holds(&found, "conflict of orders");
}

#[test]
fn orders_that_disagree() {
    // Vector 6f: two orders on one grafcet, {} and {11}, in force at once.
    let found = of("chart Orders\ninput m : bool\n\
                    grafcet G1 { initial step 0  step 1 { force G2{} }  step 2 { force G2{11} }  transition 0 -> 1, 2 : m }\n\
                    grafcet G2 { initial step 10  step 11  transition 10 -> 11 : m }\n");
    assert_eq!(fails(&found, "conflict of orders").rows.len(), 1);
    holds(&found, "conflict of allocations");
}

#[test]
fn delays_have_real_times() {
    // By hand: 2 is left to 4 after 5 s; to 3 between 3 s and 5 s with `b`. From 4 there is no way out.
    let found = of("chart Delays\ninput a, b : bool\ninitial step 1\nstep 2\nstep 3\nstep 4\n\
                    transition (1) 1 -> 2 : a\ntransition (2) 2 -> 3 : b and 3s/X2 and not 5s/X2\n\
                    transition (3) 2 -> 4 : 5s/X2\ntransition (4) 3 -> 1 : not a\n");
    assert_eq!(rows(fails(&found, "deadlock")), ["0 10 -> 2", "5000 10 -> 4"]);
    holds(&found, "dead-transition (2)");
    holds(&found, "selection 2");
}

#[test]
fn an_order_of_delays_that_no_times_allow() {
    // Both begin with `a`. That 3 s from 2 end before 2 s from 12 no times allow, so (5) never clears: the real times are
    // those of two clocks that began together.
    let found = of(
        "chart Together\ninput a : bool\ninitial step 1\nstep 2\nstep 3\ninitial step 11\nstep 12\nstep 13\nstep 4\n\
                    transition (1) 1 -> 2 : a\ntransition (2) 2 -> 3 : 3s/X2\n\
                    transition (3) 11 -> 12 : a\ntransition (4) 12 -> 13 : 2s/X12\n\
                    transition (5) 3 -> 4 : X12\n",
    );
    assert_eq!(*answer(&found, "dead-transition (5)"), Answer::Fails(None));
    holds(&found, "dead-transition (2)");
    holds(&found, "dead-transition (4)");
}

#[test]
fn a_longer_way_that_times_allow() {
    // 3 s from 2 can end before 2 s from 12 only if 12 is entered once more meanwhile: four reactions, by hand at 0, 1, 2,
    // and 3000 ms.
    let found =
        of("chart Again\ninput a, b : bool\ninitial step 1\nstep 2\nstep 3\ninitial step 11\nstep 12\nstep 4\n\
                    transition (1) 1 -> 2 : a\ntransition (2) 2 -> 3 : 3s/X2\n\
                    transition (3) 11 -> 12 : a and not b\ntransition (4) 12 -> 11 : b\n\
                    transition (5) 3 -> 4 : X12 and not 2s/X12\n");
    holds(&found, "dead-transition (5)");
    holds(&found, "dead-step 4");
}

#[test]
fn a_number_that_is_stored_as_given_is_taken_bit_by_bit() {
    // From 6 on it goes round, adding up for longer than the bound; all of the 32 774 numbers up to 5 are a state in 2.
    // Diagrams of so many sums take minutes, so one engine alone is asked.
    let chart = check(
        "by hand",
        "chart Sum\ninput n : int\nvar sum : int\ninitial step 1 { sum := sum + n on activation }\nstep 2\n\
                    transition 1 -> 2 : true\ntransition 2 -> 1 : [sum > 5]\n",
    );
    let found = verified_by(&chart.expect("a chart without errors"), Profile::default(), Method::Explicit);
    assert_eq!((fails(&found, "livelock").rows.len(), fails(&found, "deadlock").rows.len()), (1, 1));
    assert_eq!((found.searched.states, found.searched.limit), (32_774.0, None));
}

#[test]
fn two_numbers_that_are_added_are_taken_bit_by_bit() {
    // Some two numbers come to -1; no number is less than itself, and one below the least of all wraps around to the most.
    let chart = check(
        "by hand",
        "chart Sums\ninput n, m : dint\ninitial step 1\nstep 2\nstep 3\nstep 4\n\
         transition (1) 1 -> 2 : [n + m = -1]\ntransition (2) 1 -> 3 : [n < n]\n\
         transition (3) 2 -> 4 : [n < n - 1] and [m > 0]\n",
    );
    let found = verified_by(&chart.expect("a chart without errors"), Profile::default(), Method::Auto);
    holds(&found, "dead-transition (1)");
    holds(&found, "dead-transition (3)");
    assert_eq!(*answer(&found, "dead-transition (2)"), Answer::Fails(None));
    // 4 has no way out, and only these two numbers lead there.
    assert_eq!(rows(fails(&found, "deadlock")), ["0 -21474836482147483647 -> 4"]);
}

#[test]
fn a_number_that_only_counts_makes_no_difference() {
    // `shown` counts on for ever; nothing asks for it.
    let found = of("chart Shown\ninput a : bool\noutput shown : dint\ninitial step 1\n\
                    step 2 { shown := shown + 1 on activation }\n\
                    transition (1) 1 -> 2 : ↑a\ntransition (2) 2 -> 1 : ↓a\n");
    holds(&found, "deadlock");
    holds(&found, "home");
    // 1, with `a` and without, and 2 with it.
    assert_eq!((found.searched.states, found.searched.limit), (3.0, None));
}

#[test]
fn a_number_that_counts_on_is_looked_at_as_far_as_it_counts() {
    // `n` goes on counting where nothing asks for it any more; 4 is entered with 3 alone.
    let text = "chart On\ninput a, b : bool\nvar n : dint\ninitial step 1\n\
                step 2 { n := n + 1 on activation }\nstep 3\nstep 4\n\
                transition (1) 1 -> 2 : ↑a\ntransition (2) 2 -> 1 : ↓a\n\
                transition (3) 1 -> 3 : ↑b and not a and [n = 3]\ntransition (4) 3 -> 1 : ↓b\n\
                transition (5) 3 -> 4 : [n < 3]\n";
    let chart = check("by hand", text).expect("a chart without errors");
    let found = verified_by(&chart, Profile::default(), Method::Symbolic);
    holds(&found, "livelock");
    holds(&found, "deadlock");
    holds(&found, "dead-transition (3)");
    holds(&found, "selection 1");
    assert_eq!(*answer(&found, "dead-transition (5)"), Answer::Fails(None));
}

#[test]
fn numbers_stand_in_traces() {
    // Only 9 leads to 3, which has no way out.
    let found = of("chart Numbers\ninput n : int\ninitial step 1\nstep 2\nstep 3\n\
                    transition 1 -> 2 : [n > 5]\ntransition 2 -> 3 : [n = 9]\ntransition 2 -> 1 : [n < 0]\n");
    assert_eq!(rows(fails(&found, "deadlock")), ["0 9 -> 3"]);
}
