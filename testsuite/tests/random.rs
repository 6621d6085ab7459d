//! Seeded random charts: texts that hold what they should, and executors that agree.
//!
//! A long run is `cargo run --release -p grafc-testsuite --bin differential -- --charts 1000 --rows 30`.

use grafc_diagnostics::FileId;
use grafc_testsuite::differential::coverage::Coverage;
use grafc_testsuite::differential::{caught, evaluate, first_difference, profile, report, simulate};
use grafc_testsuite::random::{Kind, checked, trace};

const ROWS: usize = 30;

#[test]
fn the_scan_program_agrees_with_the_simulator() {
    let mut coverage = Coverage::default();
    let mut rejected = 0;
    for seed in 0..150 {
        let drawn = checked(seed, Kind::Flat);
        rejected += drawn.rejected;
        let (chart, profile) = (&drawn.chart, profile(seed));
        let stimuli = trace(seed, chart, ROWS);
        let expected = simulate(chart, profile, &stimuli);
        match caught(|| evaluate(chart, profile, &stimuli)) {
            Err(fault) => panic!("seed {}: {fault}\n{}", drawn.seed, drawn.text),
            Ok(actual) if first_difference(&expected, &actual).is_some() => {
                let report = report(chart, profile, &stimuli, &expected, &actual);
                panic!("seed {}\n{}\n{report}", drawn.seed, drawn.text);
            }
            Ok(_) => coverage.count(chart, profile, &expected),
        }
    }
    assert!(rejected <= 15, "{rejected} of the texts drawn had errors");
    // The charts must be about something.
    for (what, least) in [
        ("ran: situation changed 5 times or more", 60),
        ("ran: outputs changed", 100),
        ("edge of an input", 60),
        ("edge of an activity", 20),
        ("edge of an expression", 20),
        ("on-delay", 40),
        ("on-delay with off-delay", 20),
        ("off-delay", 20),
        ("duration of a step", 40),
        ("division", 20),
        ("macro-step", 15),
        ("source transition", 15),
        ("sink transition", 10),
        ("synchronisation", 40),
        ("parallel branches", 40),
        ("self-loop", 10),
        ("several initial steps", 60),
        ("action on event", 30),
        ("action on clearing", 30),
        ("action on activation", 40),
        ("action on deactivation", 20),
        ("continuous variable read", 30),
        ("assignment condition", 60),
        ("LIVELOCK", 3),
        ("ALLOC_CONFLICT", 3),
        ("DIV0", 3),
    ] {
        assert!(coverage.of(what) >= least, "only {} charts: {what}\n{coverage}", coverage.of(what));
    }
}

#[test]
fn hierarchical_charts_run() {
    let mut coverage = Coverage::default();
    let mut rejected = 0;
    for seed in 0..100 {
        let drawn = checked(seed, Kind::Hierarchical);
        rejected += drawn.rejected;
        let stimuli = trace(seed, &drawn.chart, ROWS);
        let run = simulate(&drawn.chart, profile(seed), &stimuli);
        coverage.count(&drawn.chart, profile(seed), &run);
    }
    assert!(rejected <= 20, "{rejected} of the texts drawn had errors");
    for what in ["enclosure", "forcing of steps", "freezing", "forcing to the initial situation", "FORCE_CONFLICT"] {
        assert!(coverage.of(what) >= 3, "only {} charts: {what}\n{coverage}", coverage.of(what));
    }
}

#[test]
fn the_same_seed_gives_the_same_chart() {
    for seed in 0..20 {
        let (one, two) = (checked(seed, Kind::Flat), checked(seed, Kind::Flat));
        assert_eq!(one.text, two.text);
        assert_eq!(trace(seed, &one.chart, ROWS), trace(seed, &two.chart, ROWS));
    }
}

#[test]
fn formatting_keeps_the_meaning() {
    for seed in 0..60 {
        let kind = if seed % 3 == 0 { Kind::Hierarchical } else { Kind::Flat };
        let drawn = checked(seed, kind);
        let (tree, _) = grafc_syntax::parse(FileId::default(), &drawn.text);
        let formatted = grafc_syntax::format(&drawn.text, &tree);
        let (tree, said) = grafc_syntax::parse(FileId::default(), &formatted);
        assert!(!said.has_errors(), "seed {seed}: {said:?}\n{formatted}");
        assert_eq!(grafc_syntax::format(&formatted, &tree), formatted, "seed {seed}: not a fixed point");
        let chart = grafc_model::check(&tree, "random").0.unwrap_or_else(|| panic!("seed {seed}\n{formatted}"));
        let stimuli = trace(seed, &drawn.chart, ROWS);
        let profile = profile(seed);
        assert_eq!(
            first_difference(&simulate(&drawn.chart, profile, &stimuli), &simulate(&chart, profile, &stimuli)),
            None,
            "seed {seed}: formatting changed what the chart does\n{}\n{formatted}",
            drawn.text
        );
    }
}
