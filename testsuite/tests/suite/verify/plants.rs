//! Plants of others: which claims are answered, against the table in the book. They are not ours to keep here; where they are
//! not available, the test says so and does nothing.

use super::{Verified, program, verified_for};
use grafc_model::reaction::Profile;
use grafc_testsuite::plants::plants;
use grafc_testsuite::xmi::collection_or_skip;
use grafc_verify::{Answer, Limit, Reason};
use std::time::Duration;

/// How many claims hold, fail, and are open.
fn counts(verified: &Verified) -> [usize; 3] {
    let of = |is: fn(&Answer) -> bool| verified.verdicts.iter().filter(|verdict| is(&verdict.answer)).count();
    [
        of(|answer| matches!(answer, Answer::Holds)),
        of(|answer| matches!(answer, Answer::Fails(_))),
        of(|answer| matches!(answer, Answer::Open(_))),
    ]
}

/// The rows of the table: names of files, and the figures of each.
fn table() -> Vec<(String, [usize; 3])> {
    let book = std::fs::read_to_string(grafc_testsuite::binary::root().join("docs/verification.md")).expect("the book");
    let rows = book.lines().skip_while(|line| !line.starts_with("| chart of AGRAFE")).skip(2);
    let row = |line: &str| {
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        let number = |place: usize| cells[place].parse::<usize>().expect("a number");
        (cells[1].trim_matches('`').to_string(), [number(3), number(4), number(5)])
    };
    rows.take_while(|line| line.starts_with('|')).map(row).collect()
}

#[test]
fn charts_of_agrafe_are_answered_as_the_book_says() {
    let Some(collection) = collection_or_skip() else { return };
    let plants = plants(collection).expect("charts that are imported");
    let rows = table();
    assert!(rows.len() >= 15, "{} rows", rows.len());
    for (name, expected) in rows {
        let plant = plants.iter().find(|plant| plant.name == name).unwrap_or_else(|| panic!("no chart {name}"));
        // The largest takes longer than a debug build may.
        let is_large = program(&plant.chart, Profile::default()).steps.len() > 60;
        if is_large && cfg!(debug_assertions) {
            continue;
        }
        let verified = verified_for(&plant.chart, Profile::default(), Duration::from_secs(600));
        assert_eq!(counts(&verified), expected, "{name}");
        for verdict in &verified.verdicts {
            let is_reason = |reason: &Reason| matches!(reason, Reason::Limit(Limit::Numbers));
            assert!(
                !matches!(&verdict.answer, Answer::Open(reason) if !is_reason(reason)),
                "{name}: {:?}",
                verdict.answer
            );
        }
    }
}
