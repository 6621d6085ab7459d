//! Seeded random charts: texts that hold what they should, and executors that agree.
//!
//! A long run is `cargo run --release -p grafc-testsuite -- diff --charts 20000`.

use grafc_diagnostics::FileId;
use grafc_testsuite::compare::first_difference;
use grafc_testsuite::differential::long_run::{Draft, Plan, run};
use grafc_testsuite::differential::mismatch;
use grafc_testsuite::executors::select;
use grafc_testsuite::random::profile;
use grafc_testsuite::random::{ChartKind, Draw, checked, checked_draw, trace};
use grafc_testsuite::runs::simulate;

const ROWS: usize = 25;

/// A run of charts with children holds nothing else, and its steps command.
#[test]
fn commanded_charts_have_children() {
    for seed in 0..60 {
        let drawn = checked(seed, ChartKind::Commanded);
        assert!(drawn.chart.grafcets.iter().any(|grafcet| grafcet.child), "{}", drawn.text);
        let pulses = ["start ", "run ", "kill ", "freeze ", "resume "];
        assert!(pulses.iter().any(|pulse| drawn.text.contains(pulse)), "{}", drawn.text);
    }
}

#[test]
fn all_built_in_executors_agree_with_the_simulator() {
    let plan = Plan { charts: 320, seed: 0, size: 1, kind: None, scans: ROWS, threads: None };
    let mut executors = select("built-in").expect("the built-in executors");
    // 64 traces of each chart take a long time: a few charts are run so in `lanes.rs`.
    executors.retain(|executor| !matches!(executor.name(), "simulator" | "lanes"));
    let summary = run(&plan, &executors, |_, _| ());
    for (executor, tally) in executors.iter().zip(&summary.tallies[1..]) {
        if let Some(seed) = tally.mismatches.first() {
            panic!("{}", mismatch::of(executor.as_ref(), &Draft::of(*seed, &plan)).show(executor.name()));
        }
        // The encodings whose steps overlap are seldom without a warning: a tenth of the charts is asked for.
        let least = if executor.limits() == "none" || executor.name().starts_with("net:") { 320 } else { 16 };
        assert!(tally.charts >= least, "{} ran only {} charts", executor.name(), tally.charts);
    }
    let coverage = &summary.coverage;
    assert!(summary.rejected <= 20, "{} of the texts drawn had errors", summary.rejected);
    // The charts must be about something.
    for (what, least) in [
        ("ran: situation changed 5 times or more", 150),
        ("ran: outputs changed", 200),
        ("edge of an input", 150),
        ("edge of an activity", 40),
        ("edge of an expression", 40),
        ("on-delay", 80),
        ("on-delay with off-delay", 40),
        ("off-delay", 40),
        ("duration of a step", 80),
        ("division", 40),
        ("macro-step", 30),
        ("source transition", 30),
        ("sink transition", 20),
        ("synchronisation", 80),
        ("parallel branches", 80),
        ("self-loop", 20),
        ("several initial steps", 100),
        ("action on event", 60),
        ("action on clearing", 60),
        ("action on activation", 80),
        ("action on deactivation", 40),
        ("continuous variable read", 60),
        ("assignment condition", 100),
        ("enclosure", 40),
        ("forcing of steps", 20),
        ("freezing", 10),
        ("forcing to the initial situation", 10),
        ("LIVELOCK", 6),
        ("ALLOC_CONFLICT", 6),
        ("FORCE_CONFLICT", 3),
        ("DIV0", 6),
    ] {
        assert!(coverage.of(what) >= least, "only {} charts: {what}\n{coverage}", coverage.of(what));
    }
    // Thousands of charts have all of it; hundreds lack no rule, and hardly a spelling. Of what pulse orders do, which few
    // of them have, they may lack a little: each is what a vector is about.
    let (of_pulses, others): (Vec<_>, Vec<_>) =
        coverage.uncovered().into_iter().partition(|what| what.starts_with("R15 "));
    assert!(coverage.rules().all(|(what, count)| count > 0 || what.starts_with("R15 ")), "{others:?}");
    assert!(others.len() <= 3 && of_pulses.len() <= 4, "{others:?}, {of_pulses:?}");
}

#[test]
fn larger_charts_are_larger() {
    let steps = |size| -> usize {
        (0..30).map(|seed| checked_draw(seed, Draw { kind: ChartKind::Hierarchical, size }).chart.steps.len()).sum()
    };
    assert!(steps(4) > 3 * steps(1), "{} and {} steps", steps(4), steps(1));
}

#[test]
fn the_same_seed_gives_the_same_chart() {
    for seed in 0..20 {
        let (one, two) = (checked(seed, ChartKind::Flat), checked(seed, ChartKind::Flat));
        assert_eq!(one.text, two.text);
        assert_eq!(trace(seed, &one.chart, ROWS), trace(seed, &two.chart, ROWS));
    }
}

#[test]
fn formatting_keeps_the_meaning() {
    for seed in 0..60 {
        let kind = if seed % 3 == 0 { ChartKind::Hierarchical } else { ChartKind::Flat };
        let drawn = checked(seed, kind);
        let (tree, _) = grafc_syntax::parse(FileId::default(), &drawn.text);
        let formatted = grafc_syntax::format(&drawn.text, &tree);
        let (tree, diagnostics) = grafc_syntax::parse(FileId::default(), &formatted);
        assert!(!diagnostics.has_errors(), "seed {seed}: {diagnostics:?}\n{formatted}");
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
