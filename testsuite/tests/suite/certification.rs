//! Generated tests: they cover every transition of every chart that can be cleared, as the reference simulator counts it,
//! and Rust and MATIEC do what they expect.

use grafc_diagnostics::FileId;
use grafc_logic::scan::Observed;
use grafc_logic::{Analysis, Options, compile_observed};
use grafc_model::chart::Chart;
use grafc_model::reaction::{Profile, Stimulus};
use grafc_testing::coverage::Coverage;
use grafc_testing::{Certified, Cover, certify, table};
use grafc_testsuite::charts::{Case, cases, charts_folder, check, field_cases, vectors_folder};
use grafc_testsuite::executors::{Outcome, Task, find_or_skip};
use grafc_testsuite::runs::simulate;
use grafc_testsuite::share::share;
use grafc_verify::{Moves, Times, moves};
use std::sync::LazyLock;

const PERIOD: i64 = 10;
const MOST: usize = 300;

/// A chart that can be followed, and how it moves: in calls that are this far apart, and at any times.
struct Followed {
    name: String,
    chart: Chart,
    profile: Profile,
    real: Moves,
    free: Moves,
}

impl Followed {
    fn new(Case { name, text, profile, .. }: Case) -> Option<Self> {
        let chart = check(&name, &text).expect("a chart without errors");
        let mut net = grafc_net::build(&chart);
        grafc_net::passes::run(&mut net, false, &mut grafc_diagnostics::Diagnostics::new());
        let options = Options { profile, ..Options::default() };
        let (program, _) = compile_observed(Analysis::new(net), &options, Observed::Transitions);
        let real = moves(&program, Times::Real(PERIOD), MOST).ok()?;
        let free = moves(&program, Times::Free, MOST).ok()?;
        Some(Followed { name, chart, profile, real, free })
    }

    fn certified(&self, cover: Cover) -> Certified {
        certify(&self.chart, self.profile, cover, PERIOD, (&self.real, &self.free))
    }
}

/// All charts that can be followed, which is done once for all who ask.
fn followed() -> &'static [Followed] {
    static ALL: LazyLock<Vec<Followed>> = LazyLock::new(|| {
        let mut charts = cases(&charts_folder());
        charts.extend(cases(&vectors_folder()));
        charts.extend(field_cases());
        charts.into_iter().filter_map(Followed::new).collect()
    });
    &ALL
}

/// The charts with the tests that clear transitions, made once for all who ask.
fn of_transitions() -> impl Iterator<Item = (&'static Followed, &'static Certified)> {
    static ALL: LazyLock<Vec<Certified>> =
        LazyLock::new(|| followed().iter().map(|chart| chart.certified(Cover::Transitions)).collect());
    followed().iter().zip(ALL.iter())
}

/// Restarts and flags apart, all that a test expects holds, and together the tests clear what can be cleared.
#[test]
fn each_transition_that_can_be_cleared_is() {
    let (mut complete, mut open, mut tests, mut rows, mut fewest) = (0, 0, 0, 0, 0);
    let mut lacking = Vec::new();
    for (Followed { name, chart, profile, .. }, made) in of_transitions() {
        let mut coverage = Coverage::new(chart);
        for test in &made.tests {
            let said = table(chart, *profile, (FileId::new(0), &test.text), Some(&mut coverage));
            assert!(said.is_empty(), "{name}: {said:?}\n{}", test.text);
        }
        let cleared = chart.transitions.indices().filter(|t| coverage.cleared(*t) > 0).count();
        assert!(cleared >= made.covered, "{name}: {} are said to be covered, and {cleared} are cleared", made.covered);
        let totals = made.totals;
        assert!(totals.tests >= totals.fewest_tests && totals.rows >= totals.fewest_rows, "{name}: {totals:?}");
        if made.complete && made.open.is_empty() {
            assert_eq!(cleared + made.dead.len(), chart.transitions.len(), "{name}");
            complete += 1;
        } else {
            open += 1;
            lacking.push(format!("{name}: {:?}{}", made.open, if made.complete { "" } else { ", too many states" }));
        }
        (tests, rows, fewest) = (tests + totals.tests, rows + totals.rows, fewest + totals.fewest_rows);
    }
    shown(&format!(
        "{complete} charts covered, {open} not: {tests} tests, {rows} rows, at least {fewest}\n{}",
        lacking.join("\n")
    ));
    // Where a number counts on without end, so do the states.
    assert!(complete > 130 && open * 5 < complete, "{complete} were covered, {open} not");
}

#[test]
fn situations_and_edges_are_covered_too() {
    for cover in [Cover::Situations, Cover::Edges] {
        let mut covered = 0;
        for of in followed() {
            let (Followed { name, chart, profile, .. }, made) = (of, of.certified(cover));
            for test in &made.tests {
                let said = table(chart, *profile, (FileId::new(0), &test.text), None);
                assert!(said.is_empty(), "{name}: {said:?}\n{}", test.text);
            }
            covered += usize::from(made.complete && made.open.is_empty());
        }
        shown(&format!("{cover:?}: {covered} charts covered"));
        assert!(covered > 100, "{cover:?}: {covered}");
    }
}

/// What a controller does with the rows of a test is what the test expects: by the reference, which made it. Controllers take
/// turns, a chart each.
fn agrees(executor: &str, turn: usize) {
    let Some(executor) = find_or_skip(executor) else { return };
    let mut tasks: Vec<(&str, Task)> = Vec::new();
    for (of, made) in of_transitions().skip(turn).step_by(2) {
        for (turn, test) in made.tests.iter().enumerate() {
            let stimuli: &[Stimulus] = &test.stimuli;
            tasks.push((&of.name, Task { chart: &of.chart, profile: of.profile, stimuli, turn }));
        }
    }
    let tasks = share(turn, tasks);
    let given: Vec<Task> = tasks.iter().map(|(_, task)| *task).collect();
    let mut ran = 0;
    for ((name, task), outcome) in tasks.iter().zip(executor.run(&given)) {
        let responses = match outcome {
            Outcome::Ran(responses) => responses,
            Outcome::PassedOver(_) => continue,
            Outcome::Failed(fault) => panic!("{name}: {fault}"),
        };
        let expected = simulate(task.chart, task.profile, task.stimuli);
        assert_eq!(executor.difference(&expected, &responses), None, "{name}: {:?}", task.stimuli);
        ran += 1;
    }
    shown(&format!("{}: {ran} tests replayed", executor.name()));
    assert!(ran * 10 > tasks.len() * 9, "{}: only {ran} of {} ran", executor.name(), tasks.len());
}

#[test]
fn rust_does_what_the_tests_expect() {
    agrees("rust", 0);
}

#[test]
fn matiec_does_what_the_tests_expect() {
    agrees("matiec:st", 1);
}

#[allow(clippy::print_stderr, reason = "shown with --nocapture")]
fn shown(text: &str) {
    eprintln!("{text}");
}
