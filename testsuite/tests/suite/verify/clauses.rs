//! The engine that asks a solver of clauses: long charts, and the other engines beside it.

use super::{all_replay, answer, check, program, say, verified_by};
use grafc_model::chart::Chart;
use grafc_model::reaction::Profile;
use grafc_testsuite::charts::{cases, charts_folder, vectors_folder};
use grafc_testsuite::random::{ChartKind, checked, low_bound};
use grafc_testsuite::scaling::SHAPES;
use grafc_verify::{Answer, Kind, Limit, Method, Reason, Subject, Verified, verify};
use std::time::{Duration, Instant};

/// Whether a claim is about what can still be reached, which this engine leaves to others.
fn is_of_what_follows(kind: Kind) -> bool {
    matches!(kind, Kind::Deadlock | Kind::Home | Kind::Leads)
}

/// In rings and branches of one token each, in which all conditions can come true, every step is entered, every transition
/// cleared, and nothing is entered twice; after each edge a reaction comes to rest. What is 12 rings of 10 has 10^12
/// situations; the last step of a long ring is as many reactions away as there are steps.
#[test]
fn long_rings_and_wide_branches() {
    let sizes = if cfg!(debug_assertions) { [120, 120, 12] } else { [465, 120, 20] };
    for (shape, size) in ["ring", "rings", "parallel"].into_iter().zip(sizes) {
        let text = SHAPES.iter().find(|other| other.name == shape).map(|shape| (shape.write)(size)).expect("a shape");
        let chart = check(shape, &text).expect("a chart");
        let found = verified_by(&chart, Profile::default(), Method::Sat);
        assert!(found.verdicts.len() > 2 * size, "{shape}");
        for verdict in found.verdicts.iter().filter(|verdict| !is_of_what_follows(verdict.claim.kind)) {
            assert_eq!(verdict.answer, Answer::Holds, "{shape}: {}", verdict.claim.name);
        }
    }
}

/// A ring with claims of its own: by hand.
#[test]
fn claims_on_a_ring() {
    let mut text = String::from("input a : bool output Y : bool initial step 0\n");
    (1..30).for_each(|step| text.push_str(&format!("step {step} {}\n", if step == 29 { "{ Y }" } else { "" })));
    (0..30).for_each(|step| text.push_str(&format!("transition {step} -> {} : ↑a\n", (step + 1) % 30)));
    text.push_str(
        "assert \"one\" : not (X3 and X17)\nassert \"low\" : not Y\nreach \"high\" : Y\nreach \"two\" : X3 and X4\nassert X3 leads to X5\n",
    );
    let chart = check("ring", &text).expect("a chart");
    let found = verified_by(&chart, Profile::default(), Method::Sat);
    assert_eq!(*answer(&found, "one"), Answer::Holds);
    assert_eq!(*answer(&found, "high"), Answer::Holds);
    assert_eq!(*answer(&found, "two"), Answer::Fails(None));
    // 29 edges, each but the first after a reaction without.
    let Answer::Fails(Some(trace)) = answer(&found, "low") else { panic!("it is not so: {:?}", found.verdicts) };
    assert!(trace.rows.len() >= 58, "{}", trace.rows.len());
    assert!(all_replay("ring", &chart, Profile::default(), &found) >= 1);
    // Each step can be left by an edge, and after 30 of them it is the first one again.
    assert_eq!(*answer(&found, "deadlock"), Answer::Holds);
    assert_eq!(*answer(&found, "home"), Answer::Holds);
    // What leads to what is left open.
    assert_eq!(*answer(&found, "X3 leads to X5"), Answer::Open(Reason::Limit(Limit::Depth)));
}

/// Two transitions at once are looked for, and found where nothing else leads there.
#[test]
fn a_selection_that_is_seldom() {
    let text = "input a, b, c, d, e, f, g, h : bool initial step 1 step 2 step 3
        transition 1 -> 2 : a and b and c and d transition 1 -> 3 : e and f and g and h
        transition 2 -> 1 : not a transition 3 -> 1 : not e and not a";
    let chart = check("selection", text).expect("a chart");
    let found = verified_by(&chart, Profile::default(), Method::Sat);
    let Answer::Fails(Some(trace)) = answer(&found, "selection 1") else { panic!("{:?}", found.verdicts) };
    // The initial reaction goes on as far as it can (R10).
    assert_eq!(trace.rows.len(), 1);
    // Then both are active, and the step before them may be entered once more.
    assert!(matches!(answer(&found, "reentry 1"), Answer::Fails(Some(_))));
    assert!(all_replay("selection", &chart, Profile::default(), &found) >= 2);
}

/// Two tokens in a ring of three: each step that is entered while it is active is left at once.
#[test]
fn what_is_left_at_once_is_not_entered_twice() {
    let text = "input a : bool initial step 1 initial step 2 step 3
        transition 1 -> 2 : ↑a transition 2 -> 3 : ↑a transition 3 -> 1 : ↑a";
    let found = verified_by(&check("ring", text).expect("a chart"), Profile::default(), Method::Sat);
    for step in 1..=3 {
        assert_eq!(*answer(&found, &format!("reentry {step}")), Answer::Holds);
    }
}

/// Assumptions that allow nothing at the start are told.
#[test]
fn assumptions_without_inputs() {
    let text = "input a, b : bool initial step 1 step 2 transition 1 -> 2 : a transition 2 -> 1 : b
        assume a assume not a";
    let found = verified_by(&check("barred", text).expect("a chart"), Profile::default(), Method::Sat);
    assert!(found.barred.is_some());
}

fn by(chart: &Chart, profile: Profile, method: Method, time: Duration) -> Verified {
    let end = Instant::now() + time;
    let mut stop = |_| (Instant::now() >= end).then_some(Limit::Time);
    verify(Subject { chart, program: &program(chart, profile), profile }, method, &mut stop)
}

/// Charts of the whole language, with delays and numbers: where two engines have an answer, it is the same.
#[test]
fn engines_never_contradict_each_other() {
    let profile = low_bound(Profile::default());
    let kinds = [ChartKind::Flat, ChartKind::Hierarchical, ChartKind::Boolean];
    let drawn = (0..if cfg!(debug_assertions) { 24 } else { 400 }).map(|seed| {
        let drawn = checked(90_000 + seed, kinds[seed as usize % 3]);
        (format!("seed {}", drawn.seed), drawn.chart, profile)
    });
    let known = cases(&charts_folder()).into_iter().chain(cases(&vectors_folder()));
    let known = known.map(|case| (case.name.clone(), check(&case.name, &case.text).expect("a chart"), case.profile));
    let mut compared = 0;
    for (name, chart, profile) in drawn.chain(known) {
        let time = Duration::from_millis(400);
        let by_clauses = by(&chart, profile, Method::Sat, time);
        all_replay(&name, &chart, profile, &by_clauses);
        for method in [Method::Explicit, Method::Symbolic] {
            let other = by(&chart, profile, method, time);
            for (a, b) in by_clauses.verdicts.iter().zip(&other.verdicts) {
                assert_eq!(a.claim, b.claim, "{name}");
                match (&a.answer, &b.answer) {
                    (Answer::Open(_), _) | (_, Answer::Open(_)) => continue,
                    (Answer::Holds, Answer::Holds) | (Answer::Fails(_), Answer::Fails(_)) => compared += 1,
                    (Answer::Holds, Answer::Fails(_)) | (Answer::Fails(_), Answer::Holds) => {
                        panic!("{name}: {} is {:?} by clauses, {:?} by {method:?}", a.claim.name, a.answer, b.answer)
                    }
                }
            }
        }
    }
    say(&format!("{compared} answers compared"));
    assert!(compared > 3_000, "{compared} answers compared");
}
