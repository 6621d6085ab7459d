//! The long run's parts: mismatches become small, are kept and found again; the command says what it did.

use grafc_model::chart::{Chart, Event, ExprKind, Tables};
use grafc_model::reaction::{Evolution, Profile};
use grafc_testsuite::charts;
use grafc_testsuite::differential::long_run::{self, Draft, Plan, is_wrong};
use grafc_testsuite::differential::mismatch::{self, Mismatch};
use grafc_testsuite::executors::{Executor, Outcome, Task, select};
use grafc_testsuite::runs::simulate;
use std::process::{Command, Output};

const PLAN: Plan = Plan { charts: 40, seed: 0, size: 1, kind: None, scans: 30, threads: None };

/// An executor that misunderstands charts.
struct Wrong {
    name: &'static str,
    run: fn(Task) -> Outcome,
}

impl Executor for Wrong {
    fn name(&self) -> &str {
        self.name
    }

    fn about(&self) -> &str {
        "wrong on purpose"
    }

    fn run(&self, tasks: &[Task]) -> Vec<Outcome> {
        tasks.iter().map(|task| (self.run)(*task)).collect()
    }
}

fn another(task: Task, change: impl FnOnce(&mut Tables)) -> Outcome {
    let mut chart = task.chart.clone();
    change(chart.edit());
    Outcome::Ran(simulate(&chart, task.profile, task.stimuli))
}

/// The first chart that it gets wrong, shrunk. It evolves by the standard's profile, and has neither macro-steps nor
/// enclosures: of these a frame may stay that no single edit can take away.
fn shrunk(wrong: &Wrong) -> (Mismatch, Chart, usize) {
    let draft = (0..)
        .map(|seed| Draft { profile: Profile::default(), ..Draft::of(seed, &PLAN) })
        .find(|draft| {
            let chart = &draft.drawn.chart;
            if !chart.macro_steps.is_empty() || chart.grafcets.iter().any(|g| g.enclosing_step.is_some()) {
                return false;
            }
            let expected = simulate(&draft.drawn.chart, draft.profile, &draft.stimuli);
            is_wrong(wrong, &expected, &wrong.run(&[draft.task()])[0])
        })
        .expect("some chart shows it");
    let mismatch = mismatch::of(wrong, &draft);
    let chart = charts::check("shrunk", &mismatch.text).expect("a chart");
    let rows = mismatch.trace.lines().count() - 1;
    (mismatch, chart, rows)
}

/// Done as its step is activated and not as it is left: the action, one call, and what it takes to reach the step.
#[test]
fn an_action_at_the_wrong_event_is_shrunk_to_the_action() {
    let wrong = Wrong {
        name: "wrong:deactivation",
        run: |task| {
            another(task, |chart| {
                for action in &mut chart.stored {
                    if let Event::Deactivation(step) = action.event {
                        action.event = Event::Activation(step);
                    }
                }
            })
        },
    };
    let (mismatch, chart, rows) = shrunk(&wrong);
    assert_eq!((chart.stored.len(), chart.variables.len(), rows), (1, 1, 1), "{}", mismatch.show("wrong"));
    assert!(chart.steps.len() <= 2 && chart.transitions.len() <= 1, "{}", mismatch.show("wrong"));
    assert!(chart.continuous.is_empty() && chart.orders.is_empty() && chart.grafcets.len() == 1);
    // Both runs stand side by side, and the row is marked.
    let shown = mismatch.show("wrong");
    let last = shown.lines().last().expect("a row");
    assert!(last.ends_with("  <") && last.matches(" | ").count() == 2, "{shown}");
}

/// A millisecond late: a call starts the delay, and one at the very end of it shows the fault.
#[test]
fn a_late_delay_is_shrunk_to_its_beginning_and_its_end() {
    let wrong = Wrong {
        name: "wrong:late",
        run: |task| {
            another(task, |chart| {
                for expr in &mut chart.exprs {
                    if let ExprKind::Delay { on, .. } = &mut expr.kind {
                        on.ms += i64::from(on.ms > 0);
                    }
                }
            })
        },
    };
    let (mismatch, chart, rows) = shrunk(&wrong);
    let delays: Vec<i64> = chart
        .exprs
        .iter()
        .filter_map(|expr| match expr.kind {
            ExprKind::Delay { on, .. } => Some(on.ms),
            _ => None,
        })
        .collect();
    assert_eq!((delays.len(), rows), (1, 2), "{}", mismatch.show("wrong"));
    assert!(chart.steps.len() <= 2 && chart.transitions.len() <= 1, "{}", mismatch.show("wrong"));
    let times: Vec<i64> =
        mismatch.trace.lines().skip(1).map(|row| row.split(',').next().unwrap().parse().unwrap()).collect();
    assert_eq!(times[1] - times[0], delays[0], "{}", mismatch.show("wrong"));
}

/// A refusal stays one; of the calls one is left, since tools from outside take no empty lists.
#[test]
fn a_refusal_is_shrunk_to_its_cause() {
    let wrong = Wrong {
        name: "wrong:orders",
        run: |task| match task.chart.orders.len() {
            0 => another(task, |_| ()),
            _ => Outcome::Failed("forcing orders are beyond it".into()),
        },
    };
    let (mismatch, chart, rows) = shrunk(&wrong);
    assert_eq!(mismatch.actual, Err("forcing orders are beyond it".to_string()));
    let sizes = (chart.orders.len(), chart.grafcets.len(), chart.transitions.len(), rows);
    assert_eq!(sizes, (1, 2, 0, 1), "{}", mismatch.show("wrong"));
    // An initial step in each grafcet, and the one with the order.
    assert!(chart.steps.len() <= 3, "{}", mismatch.show("wrong"));
}

#[test]
fn a_mismatch_is_kept_as_a_vector() {
    let wrong = Wrong {
        name: "wrong:scan",
        run: |task| {
            let profile = Profile { evolution: Evolution::Scan, ..task.profile };
            Outcome::Ran(simulate(task.chart, profile, task.stimuli))
        },
    };
    let (mismatch, ..) = shrunk(&wrong);
    let folder = tempfile::tempdir().unwrap();
    mismatch.save(folder.path()).unwrap();
    let cases = charts::cases(folder.path());
    let [case] = &cases[..] else { panic!("{} cases", cases.len()) };
    let chart = charts::check(&case.name, &case.text).unwrap();
    let stimuli = charts::stimuli(&case.name, &case.trace, &chart).unwrap();
    let spelt = |profile| charts::spell(&chart, &stimuli, &simulate(&chart, profile, &stimuli));
    assert_eq!(spelt(case.profile), case.expected);
    assert_ne!(spelt(Profile { evolution: Evolution::Scan, ..case.profile }), case.expected);
}

#[test]
fn a_wrong_executor_is_found_whoever_takes_its_block() {
    let wrong = || -> Vec<Box<dyn Executor>> {
        vec![Box::new(Wrong { name: "wrong:scan", run: |task| another(task, |chart| chart.stored.clear()) })]
    };
    let threads = |n| Plan { charts: 90, threads: std::num::NonZero::new(n), ..PLAN };
    let mut heard = Vec::new();
    let one = long_run::run(&threads(1), &wrong(), |charts, _| heard.push(charts));
    let three = long_run::run(&threads(3), &wrong(), |_, _| ());
    assert_eq!(heard, [40, 80, 90]);
    assert!(one.mismatches() > 30, "{}", one.mismatches());
    assert_eq!(one.tallies[1].mismatches, three.tallies[1].mismatches);
    assert_eq!(one.coverage.to_string(), three.coverage.to_string());
}

#[test]
fn executors_are_chosen_by_name_and_by_group() {
    let names = |list: &str| -> Result<Vec<String>, String> {
        Ok(select(list)?.iter().map(|executor| executor.name().to_string()).collect())
    };
    assert_eq!(names("scan:switch-O0,net:built"), Ok(vec!["net:built".into(), "scan:switch-O0".into()]));
    assert_eq!(names("net").unwrap().len(), 7);
    assert_eq!(names("built-in").unwrap().len(), 1 + 7 + 8 + 1);
    let fault = names("net,nobody").unwrap_err();
    assert!(fault.starts_with("there is no executor `nobody`; there are simulator, net:built,"), "{fault}");
}

fn command(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_grafc-testsuite")).args(arguments).output().expect("the command runs")
}

#[test]
fn the_command_gives_a_table_and_json() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("figures.json");
    let file = path.to_str().unwrap();
    let run = command(&["diff", "--charts", "20", "--scans", "10", "--executors", "scan:switch", "--json", file]);
    let out = String::from_utf8(run.stdout).unwrap();
    assert_eq!(run.status.code(), Some(0), "{out}");
    assert!(out.contains("20 charts, 200 scans, 1 executors beside the simulator, 0 mismatches;"), "{out}");
    let figures: serde_json::Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    assert_eq!((&figures["charts"], &figures["mismatches"]), (&20.into(), &0.into()));
    assert_eq!(figures["executors"][1]["name"], "scan:switch");
    assert_eq!(figures["executors"][1]["scans"], 200);
    assert_eq!(figures["productions"]["transition (n)"].as_u64().map(|n| n > 5), Some(true));

    let run = command(&["diff", "--executors", "nobody"]);
    assert_eq!(run.status.code(), Some(2));
    assert!(String::from_utf8(run.stderr).unwrap().starts_with("error: there is no executor `nobody`"));
    let listed = String::from_utf8(command(&["executors"]).stdout).unwrap();
    assert!(listed.contains("matiec:st") && listed.contains("net:built"), "{listed}");
}
