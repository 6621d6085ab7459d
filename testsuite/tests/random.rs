//! Seeded random charts: texts that hold what they should, and executors that agree.
//!
//! A long run is `cargo run --release -p grafc-testsuite --bin differential -- --charts 1000 --rows 30`.

use grafc_diagnostics::FileId;
use grafc_logic::{Encoding, Options};
use grafc_model::reaction::{Profile, Response, Stimulus};
use grafc_testsuite::differential::coverage::Coverage;
use grafc_testsuite::differential::{
    caught, evaluate, exact, first_difference, first_other_situation, profile, report, simulate, stable_situations,
};
use grafc_testsuite::random::{Drawn, Kind, checked, trace};

const ROWS: usize = 25;

#[test]
fn the_scan_program_agrees_with_the_simulator() {
    let mut coverage = Coverage::default();
    let mut rejected = 0;
    for seed in 0..100 {
        let drawn = checked(seed, Kind::Flat);
        rejected += drawn.rejected;
        let (chart, profile) = (&drawn.chart, profile(seed));
        let stimuli = trace(seed, chart, ROWS);
        let expected = simulate(chart, profile, &stimuli);
        agrees(&drawn, profile, &stimuli, &expected);
        coverage.count(chart, profile, &expected);
    }
    assert!(rejected <= 15, "{rejected} of the texts drawn had errors");
    // The charts must be about something.
    for (what, least) in [
        ("ran: situation changed 5 times or more", 40),
        ("ran: outputs changed", 66),
        ("edge of an input", 40),
        ("edge of an activity", 13),
        ("edge of an expression", 13),
        ("on-delay", 26),
        ("on-delay with off-delay", 13),
        ("off-delay", 13),
        ("duration of a step", 26),
        ("division", 13),
        ("macro-step", 10),
        ("source transition", 10),
        ("sink transition", 6),
        ("synchronisation", 26),
        ("parallel branches", 26),
        ("self-loop", 6),
        ("several initial steps", 40),
        ("action on event", 20),
        ("action on clearing", 20),
        ("action on activation", 26),
        ("action on deactivation", 13),
        ("continuous variable read", 20),
        ("assignment condition", 40),
        ("LIVELOCK", 2),
        ("ALLOC_CONFLICT", 2),
        ("DIV0", 2),
    ] {
        assert!(coverage.of(what) >= least, "only {} charts: {what}\n{coverage}", coverage.of(what));
    }
}

/// Every exact way to lower a chart does what the simulator does.
fn agrees(drawn: &Drawn, profile: Profile, stimuli: &[Stimulus], expected: &[Response]) {
    for (way, options) in exact(profile) {
        match caught(|| evaluate(&drawn.chart, &options, stimuli)) {
            Err(fault) => panic!("seed {}, {way}: {fault}\n{}", drawn.seed, drawn.text),
            Ok(actual) if first_difference(expected, &actual).is_some() => {
                let report = report(&drawn.chart, profile, stimuli, expected, &actual);
                panic!("seed {}, {way}\n{}\n{report}", drawn.seed, drawn.text);
            }
            Ok(_) => {}
        }
    }
}

#[test]
fn the_scan_program_agrees_on_hierarchical_charts() {
    let mut coverage = Coverage::default();
    let mut rejected = 0;
    for seed in 0..150 {
        let drawn = checked(seed, Kind::Hierarchical);
        rejected += drawn.rejected;
        let stimuli = trace(seed, &drawn.chart, ROWS);
        let run = simulate(&drawn.chart, profile(seed), &stimuli);
        agrees(&drawn, profile(seed), &stimuli, &run);
        coverage.count(&drawn.chart, profile(seed), &run);
    }
    assert!(rejected <= 30, "{rejected} of the texts drawn had errors");
    for what in ["enclosure", "forcing of steps", "freezing", "forcing to the initial situation", "FORCE_CONFLICT"] {
        assert!(coverage.of(what) >= 3, "only {} charts: {what}\n{coverage}", coverage.of(what));
    }
}

/// R- and S-trigger end where the rules end, unless there is a warning that they may not.
#[test]
fn overlapping_steps_reach_the_same_stable_situations() {
    let mut without_warning = 0;
    for seed in 0..100 {
        let drawn = checked(seed, Kind::Plain);
        let profile = Profile::default();
        let stimuli = trace(seed, &drawn.chart, ROWS);
        let expected = simulate(&drawn.chart, profile, &stimuli);
        agrees(&drawn, profile, &stimuli, &expected);
        for encoding in [Encoding::RTrigger, Encoding::STrigger] {
            let options = Options { profile, encoding, simplify: true };
            let run = caught(|| stable_situations(&drawn.chart, &options, &stimuli));
            let run = run.unwrap_or_else(|fault| panic!("seed {}, {}: {fault}", drawn.seed, encoding.name()));
            let Some(run) = run else { continue };
            without_warning += 1;
            let row = first_other_situation(&expected, &run);
            assert_eq!(row, None, "seed {}, {}\n{}", drawn.seed, encoding.name(), drawn.text);
        }
    }
    assert!(without_warning >= 80, "only {without_warning} of 200 runs had no warning");
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
