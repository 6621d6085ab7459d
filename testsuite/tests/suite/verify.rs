//! `grafc verify` against a plain enumeration over the reference simulator, against long random runs, and by hand.

use crate::tried::{self, Tried};
use grafc_logic::scan::{Claimed, Observed, Program};
use grafc_logic::{Analysis, Extras, Options, compile_with};
use grafc_model::chart::Chart;
use grafc_model::reaction::{Profile, Stimulus};
use grafc_model::simulate::Simulator;
use grafc_testsuite::charts::{check, stimuli};
use grafc_testsuite::random::{ChartKind, checked, low_bound, trace};
use grafc_testsuite::sights::Sights;
use grafc_verify::{Answer, Kind, Limit, Method, Reason, Subject, Trace, Verified, verify};
use std::time::{Duration, Instant};

/// The program of a chart, of which transitions are shown.
fn program(chart: &Chart, profile: Profile) -> Program {
    let mut net = grafc_net::build(chart);
    grafc_net::passes::run(&mut net, false, &mut grafc_diagnostics::Diagnostics::new());
    let options = Options { profile, ..Options::default() };
    let extras = Extras { saved: true, observed: Observed::Transitions, claims: Claimed::All, ..Extras::default() };
    compile_with(Analysis::new(net), &options, extras).0
}

fn verified(chart: &Chart, profile: Profile) -> Verified {
    verified_by(chart, profile, Method::Auto)
}

fn verified_by(chart: &Chart, profile: Profile, method: Method) -> Verified {
    verify(Subject { chart, program: &program(chart, profile), profile }, method, &mut |_| None)
}

/// As far as this time goes.
fn verified_for(chart: &Chart, profile: Profile, time: Duration) -> Verified {
    let end = Instant::now() + time;
    let mut stop = |_| (Instant::now() >= end).then_some(Limit::Time);
    verify(Subject { chart, program: &program(chart, profile), profile }, Method::Auto, &mut stop)
}

/// The answer to a claim by its name.
#[track_caller]
fn answer<'v>(verified: &'v Verified, name: &str) -> &'v Answer {
    let found = verified.verdicts.iter().find(|verdict| verdict.claim.name == name);
    &found.unwrap_or_else(|| panic!("no claim {name}: {:?}", verified.verdicts)).answer
}

#[track_caller]
fn holds(verified: &Verified, name: &str) {
    assert_eq!(*answer(verified, name), Answer::Holds, "{name}");
}

#[track_caller]
fn fails<'v>(verified: &'v Verified, name: &str) -> &'v Trace {
    match answer(verified, name) {
        Answer::Fails(Some(trace)) => trace,
        other => panic!("{name}: {other:?}"),
    }
}

/// The rows of a trace as `t_ms inputs -> situation`.
fn rows(trace: &Trace) -> Vec<String> {
    let bit = |value: &grafc_model::chart::Value| grafc_verify::cell(*value);
    let row = |row: &grafc_verify::Row| {
        let inputs: Vec<String> = row.inputs.iter().map(bit).collect();
        let steps = row.steps.as_ref().map_or("LIVELOCK".to_owned(), |steps| steps.join(" "));
        format!("{} {} -> {steps}", row.t_ms, inputs.join(""))
    };
    trace.rows.iter().map(row).collect()
}

/// The trace as a file, read again and run by the simulator, shows the fault in its last row, and not before.
fn replays(name: &str, chart: &Chart, profile: Profile, kind: Kind, element: Option<usize>, trace: &Trace) {
    let stimuli = stimuli(name, &trace.csv(), chart).expect("a trace");
    let (mut simulator, mut sights) = (Simulator::new(chart, profile), Sights::default());
    for (place, stimulus) in stimuli.iter().enumerate() {
        let is_last = place + 1 == stimuli.len();
        sights.react(chart, &mut simulator, stimulus, place == 0);
        let shown = match kind {
            Kind::Livelock => sights.livelock,
            Kind::Conflict if element == Some(1) => sights.force_conflict,
            Kind::Conflict => sights.alloc_conflict,
            Kind::Selection => element.is_some_and(|s| sights.selection.contains(&s)),
            Kind::Reentry => element.is_some_and(|s| sights.reentry.contains(&s)),
            // What is claimed of the situation no trace can show.
            Kind::Deadlock | Kind::Home | Kind::DeadTransition | Kind::DeadStep => is_last,
            // They are about what the chart says, and have tests of their own.
            Kind::Assert | Kind::Leads | Kind::Reach => is_last,
        };
        assert_eq!(shown, is_last, "{name}: {kind:?} {element:?} in row {place} of\n{}", trace.csv());
        if let (false, Some(steps)) = (sights.livelock, &trace.rows[place].steps) {
            let active = simulator.state().situation().iter_enumerated().filter(|(_, active)| **active);
            let active: Vec<&str> = active.map(|(s, _)| chart.steps[s].label.as_str()).collect();
            assert_eq!(active, *steps, "{name}: row {place}");
        }
    }
}

/// The place of a claim's element among all of its kind.
fn element(chart: &Chart, kind: Kind, element: &str) -> usize {
    match kind {
        Kind::Conflict => usize::from(element == "orders"),
        Kind::DeadTransition => {
            let named = |t: &grafc_model::chart::Transition| t.designation.as_ref().map(|d| format!("({d})"));
            let number = element.strip_prefix('#').map(|number| number.parse::<usize>().expect("a number") - 1);
            let by_name = || chart.transitions.iter().position(|t| named(t).as_deref() == Some(element));
            number.or_else(by_name).expect("a transition")
        }
        Kind::DeadStep | Kind::Selection | Kind::Reentry => {
            chart.steps.iter().position(|step| step.label == element).expect("a step")
        }
        Kind::Livelock | Kind::Deadlock | Kind::Home | Kind::Assert | Kind::Leads | Kind::Reach => {
            unreachable!("a claim on all of the chart")
        }
    }
}

/// Each claim that fails replays.
fn all_replay(name: &str, chart: &Chart, profile: Profile, verified: &Verified) -> usize {
    let mut count = 0;
    for verdict in &verified.verdicts {
        if let Answer::Fails(Some(trace)) = &verdict.answer {
            let kind = verdict.claim.kind;
            let place = verdict.claim.element.as_deref().map(|of| element(chart, kind, of));
            replays(name, chart, profile, kind, place, trace);
            count += 1;
        }
    }
    count
}

/// Every answer is the one that trying everything gives; how many traces replay.
#[track_caller]
fn agree(tried: &Tried, decided: &mut Decided) -> usize {
    let mut by = |method| as_expected(tried, method, decided);
    by(Method::Explicit) + by(Method::Symbolic) + by(Method::Sat) + by(Method::Auto)
}

/// Of what is asked of micro-steps, how much the solver of clauses answers, and how much it leaves open.
#[derive(Default)]
struct Decided {
    answered: usize,
    open: usize,
}

fn as_expected(tried: &Tried, method: Method, decided: &mut Decided) -> usize {
    let Tried { name, text, chart, profile, everywhere: expected, .. } = tried;
    let verified = verified_by(chart, *profile, method);
    let seen = &expected.sights;
    for verdict in &verified.verdicts {
        let kind = verdict.claim.kind;
        let place = || element(chart, kind, verdict.claim.element.as_deref().expect("an element"));
        let fails = match kind {
            Kind::Livelock => seen.livelock,
            Kind::Deadlock => expected.stuck,
            Kind::Home => expected.homeless,
            Kind::Conflict if place() == 1 => seen.force_conflict,
            Kind::Conflict => seen.alloc_conflict,
            Kind::DeadTransition => !seen.cleared.contains(&place()),
            Kind::DeadStep => !seen.active.contains(&place()),
            Kind::Selection => seen.selection.contains(&place()),
            Kind::Reentry => seen.reentry.contains(&place()),
            Kind::Assert | Kind::Leads | Kind::Reach => continue,
        };
        let is_as_expected = match &verdict.answer {
            Answer::Holds => !fails,
            Answer::Fails(trace) => fails && trace.is_none() == matches!(kind, Kind::DeadTransition | Kind::DeadStep),
            // A reaction that counts up without end is followed by one engine alone, and what can still be reached by two.
            Answer::Open(reason) => {
                matches!(method, Method::Symbolic | Method::Sat) && matches!(reason, Reason::Limit(_))
            }
        };
        if method == Method::Sat && !matches!(kind, Kind::Deadlock | Kind::Home) {
            match verdict.answer {
                Answer::Holds | Answer::Fails(_) => decided.answered += 1,
                Answer::Open(_) => decided.open += 1,
            }
        }
        assert!(
            is_as_expected,
            "{name} {method:?} {profile:?}: {} is {:?}\n{text}",
            verdict.claim.name, verdict.answer
        );
    }
    // What is not asked never happens.
    let asked = |kind: Kind| verified.verdicts.iter().filter(|v| v.claim.kind == kind).count();
    assert_eq!((asked(Kind::DeadStep), asked(Kind::DeadTransition)), (chart.steps.len(), chart.transitions.len()));
    assert!(asked(Kind::Selection) >= seen.selection.len() && asked(Kind::Reentry) >= seen.reentry.len());
    assert_eq!(asked(Kind::Deadlock), usize::from(!chart.transitions.is_empty()));
    all_replay(name, chart, *profile, &verified)
}

#[test]
fn charts_and_vectors_have_the_answers_that_trying_everything_gives() {
    let (all, mut decided) = (tried::charts_and_vectors(), Decided::default());
    for tried in all {
        agree(tried, &mut decided);
    }
    let (compared, Decided { answered, open }) = (all.len(), decided);
    say(&format!("{compared} charts and vectors compared; by clauses {answered} answers, {open} open"));
    assert!(compared > 30, "{compared} were compared");
    assert!(answered > 50 * open, "by clauses {answered} answers, {open} open");
}

#[test]
fn random_boolean_charts_have_the_answers_that_trying_everything_gives() {
    let (all, mut decided) = (tried::random(), Decided::default());
    let traces: usize = all.iter().map(|tried| agree(tried, &mut decided)).sum();
    let (compared, Decided { answered, open }) = (all.len(), decided);
    say(&format!(
        "{compared} random charts compared, {traces} traces replayed; by clauses {answered} answers, {open} open"
    ));
    assert!(compared > 80 && traces > 80, "{compared} were compared, {traces} replayed");
    assert!(answered > 50 * open, "by clauses {answered} answers, {open} open");
}

/// Twelve rings of ten steps, each moved on by the edge of an input: 10^12 situations, and whether each input was true.
#[test]
fn ten_to_the_twelfth_situations_are_counted() {
    use std::fmt::Write as _;
    let mut text = String::from("chart Rings\n");
    for ring in 1..=12 {
        let _ = write!(text, "input a{ring} : bool\ngrafcet G{ring} {{ initial step {ring}00\n");
        (1..10).for_each(|step| _ = writeln!(text, "step {}", 100 * ring + step));
        (0..10).for_each(|step| {
            _ = writeln!(text, "transition {} -> {} : ↑a{ring}", 100 * ring + step, 100 * ring + (step + 1) % 10);
        });
        text.push_str("}\n");
    }
    text.push_str("assert \"one\" : not (X105 and X106)\nassert \"free\" : not (X105 and X205)\n");
    let found = verified(&check("rings", &text).expect("a chart"), Profile::default());
    assert_eq!((found.searched.states, found.searched.limit), (4_096e12, None));
    holds(&found, "one");
    // Five edges of both: five calls with the inputs true, each after one with them false.
    assert_eq!(fails(&found, "free").rows.len(), 10);
    assert!(found.verdicts.iter().all(|verdict| !matches!(verdict.answer, Answer::Open(_))));
}

/// What is said never to happen does not, and what is said to happen replays: charts of the whole language, with delays.
#[test]
fn what_holds_survives_random_runs() {
    let (count, scans, time) = if cfg!(debug_assertions) { (30, 300, 500) } else { (400, 100_000, 1_500) };
    let (mut decided, mut open, mut traces) = (0, 0, 0);
    for seed in 0..count {
        let kind = if seed % 2 == 0 { ChartKind::Flat } else { ChartKind::Hierarchical };
        let drawn = checked(50_000 + seed, kind);
        let (chart, name) = (&drawn.chart, format!("seed {}", drawn.seed));
        let profile = low_bound(Profile::default());
        let verified = verified_for(chart, profile, Duration::from_millis(time));
        traces += all_replay(&name, chart, profile, &verified);
        let mut sights = Sights::default();
        let mut simulator = Simulator::new(chart, profile);
        for (place, stimulus) in trace(seed, chart, scans).into_iter().enumerate() {
            // A restart is no reaction, and after a reaction that does not end nothing is claimed.
            sights.react(chart, &mut simulator, &Stimulus { restart: false, ..stimulus }, place == 0);
            if simulator.flags().livelock {
                break;
            }
        }
        for verdict in &verified.verdicts {
            let kind = verdict.claim.kind;
            let place = || element(chart, kind, verdict.claim.element.as_deref().expect("an element"));
            let is_seen = match kind {
                Kind::Livelock => sights.livelock,
                Kind::Conflict if place() == 1 => sights.force_conflict,
                Kind::Conflict => sights.alloc_conflict,
                Kind::Selection => sights.selection.contains(&place()),
                Kind::Reentry => sights.reentry.contains(&place()),
                Kind::DeadTransition => sights.cleared.contains(&place()),
                Kind::DeadStep => sights.active.contains(&place()),
                Kind::Deadlock | Kind::Home | Kind::Assert | Kind::Leads | Kind::Reach => continue,
            };
            let is_of_never = matches!(kind, Kind::DeadTransition | Kind::DeadStep);
            match &verdict.answer {
                Answer::Holds if !is_of_never => assert!(!is_seen, "{name}: {}\n{}", verdict.claim.name, drawn.text),
                Answer::Fails(_) if is_of_never => assert!(!is_seen, "{name}: {}\n{}", verdict.claim.name, drawn.text),
                Answer::Holds | Answer::Fails(_) => {}
                Answer::Open(_) => {
                    open += 1;
                    continue;
                }
            }
            decided += 1;
        }
    }
    say(&format!("{decided} answers, {open} open, {traces} traces replayed"));
    assert!(decided > 5 * count, "{decided} answers, {open} open");
}

#[allow(clippy::print_stderr, reason = "shown with --nocapture")]
fn say(what: &str) {
    eprintln!("{what}");
}

mod by_hand;
mod claims;
mod clauses;
mod plants;
mod textbook;
