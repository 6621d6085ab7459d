//! Inputs that act on a chart as a whole: what they do is what a new start does, in every executor.

use grafc_logic::Options;
use grafc_model::chart::{Chart, ControlNames, Value, VariableKind};
use grafc_model::reaction::{Evolution, Profile, Response, Stimulus};
use grafc_testsuite::charts::{check, spell, stimuli};
use grafc_testsuite::compare::{first_difference, report};
use grafc_testsuite::controller::{instructions, ladder};
use grafc_testsuite::executors::jobs::Job;
use grafc_testsuite::executors::{Outcome, Task, all, is_here_or_skip};
use grafc_testsuite::expected::all_agree;
use grafc_testsuite::random::{ChartKind, checked, low_bound, profile, trace};
use grafc_testsuite::runs::{compile, simulate};
use grafc_testsuite::share::is_thorough;
use grafc_testsuite::ways::exact;

const HOIST: &str = "\
chart Hoist
input up, top : bool
input parts : int
output motor : bool
output trips, share : int
retain output total : int := 7
initial step 1
step 2 {
  motor
  trips := trips + 1 on activation
  total := total + 1 on activation
  share := 100 / parts on activation
}
transition 1 -> 2 : ↑up
transition 2 -> 1 : 5s/X2 or top
";

/// By R10 and the page on restarts: while `again` is true every call is an initial reaction, so no edge is seen in it; what
/// it leaves is what the next call starts from.
const TRACE: &str = "\
t_ms,up,top,parts,again,ack
0,0,0,0,0,0
100,1,0,0,0,0
200,1,0,0,0,1
300,1,0,0,1,0
400,0,0,4,1,0
500,1,0,4,1,0
600,1,0,4,0,0
700,0,0,4,0,0
800,1,0,4,0,0
3000,1,0,4,1,0
3100,0,0,0,0,0
4000,1,0,0,0,1
5800,1,0,0,0,0
8999,1,0,0,0,0
9000,1,0,0,0,0
9100,1,0,0,0,1
9200,1,0,0,1,0
";

const ANEW: &str = "\
t_ms,motor,trips,share,total,situation,flags
0,0,0,0,7,1,
100,1,1,0,8,2,DIV0
200,1,1,0,8,2,
300,0,0,0,7,1,
400,0,0,0,7,1,
500,0,0,0,7,1,
600,0,0,0,7,1,
700,0,0,0,7,1,
800,1,1,25,8,2,
3000,0,0,0,7,1,
3100,0,0,0,7,1,
4000,1,1,0,8,2,DIV0
5800,1,1,0,8,2,DIV0
8999,1,1,0,8,2,DIV0
9000,0,1,0,8,1,DIV0
9100,0,1,0,8,1,
9200,0,0,0,7,1,
";

/// The same where a reset leaves what is retained: the total goes on.
const KEPT: &str = "\
t_ms,motor,trips,share,total,situation,flags
0,0,0,0,7,1,
100,1,1,0,8,2,DIV0
200,1,1,0,8,2,
300,0,0,0,8,1,
400,0,0,0,8,1,
500,0,0,0,8,1,
600,0,0,0,8,1,
700,0,0,0,8,1,
800,1,1,25,9,2,
3000,0,0,0,9,1,
3100,0,0,0,9,1,
4000,1,1,0,10,2,DIV0
5800,1,1,0,10,2,DIV0
8999,1,1,0,10,2,DIV0
9000,0,1,0,10,1,DIV0
9100,0,1,0,10,1,
9200,0,0,0,10,1,
";

fn names(reset_keeps_retained: bool) -> ControlNames {
    let (reset, clear_flags) = (Some("again".into()), Some("ack".into()));
    ControlNames { reset, reset_keeps_retained, clear_flags, ..ControlNames::default() }
}

fn hoist(keeps: bool) -> Chart {
    let mut chart = check("hoist", HOIST).expect("a chart without errors");
    chart.control(&names(keeps)).expect("new names");
    chart
}

#[test]
fn a_reset_is_a_new_start_and_flags_are_lowered() {
    for (keeps, expected) in [(false, ANEW), (true, KEPT)] {
        let chart = hoist(keeps);
        let stimuli = stimuli("hoist", TRACE, &chart).expect("a trace without errors");
        all_agree(&chart, Profile::default(), &stimuli, expected).unwrap_or_else(|fault| panic!("{keeps}: {fault}"));
    }
}

/// A trace in which the controls are true now and then only.
fn rare(seed: u64, chart: &Chart) -> Vec<Stimulus> {
    let mut rng = fastrand::Rng::with_seed(seed ^ 0x636f_6e74);
    let inputs = chart.variables.iter_enumerated().filter(|(_, v)| v.kind == VariableKind::Input);
    let places: Vec<usize> =
        inputs.enumerate().filter(|(_, (id, _))| chart.controls.has(*id)).map(|(place, _)| place).collect();
    let mut stimuli = trace(seed, chart, 30);
    for stimulus in &mut stimuli {
        for place in &places {
            stimulus.inputs[*place] = Value::Bool(rng.f32() < 0.12);
        }
    }
    stimuli
}

#[test]
fn random_charts_agree() {
    let kinds = [ChartKind::Hierarchical, ChartKind::Flat, ChartKind::Hierarchical, ChartKind::Plain];
    let drawn: Vec<(u64, Chart)> = (7100..7180)
        .map(|seed: u64| {
            let mut chart = checked(seed, kinds[seed as usize % 4]).chart;
            chart.control(&names(seed % 3 == 0)).expect("names that random charts do not have");
            (seed, chart)
        })
        .collect();
    let traces: Vec<Vec<Stimulus>> = drawn.iter().map(|(seed, chart)| rare(*seed, chart)).collect();
    let mut ran = 0;
    for executor in all() {
        if !is_here_or_skip(executor.as_ref()) {
            continue;
        }
        // What costs seconds is asked of a part.
        let count = match executor.is_external() {
            false => drawn.len(),
            true if is_thorough() => 12,
            true => 4,
        };
        let tasks: Vec<Task> = drawn
            .iter()
            .zip(&traces)
            .take(count)
            .map(|((seed, chart), stimuli)| Task {
                chart,
                profile: low_bound(profile(*seed)),
                stimuli,
                turn: *seed as usize,
            })
            .collect();
        for (task, outcome) in tasks.iter().zip(executor.run(&tasks)) {
            let expected = simulate(task.chart, task.profile, task.stimuli);
            match outcome {
                Outcome::Ran(actual) => {
                    ran += 1;
                    if executor.difference(&expected, &actual).is_some() {
                        let report = report(task.chart, task.profile, task.stimuli, &expected, &actual);
                        panic!("{}, seed {}\n{report}", executor.name(), task.turn);
                    }
                }
                Outcome::PassedOver(_) => {}
                Outcome::Failed(fault) => panic!("{}, seed {}: {fault}", executor.name(), task.turn),
            }
        }
    }
    assert!(ran > 2 * drawn.len(), "{ran} runs");
}

/// What a run came to; none where there is no such text.
type Ran = Result<Option<Vec<Response>>, String>;

/// Instruction lists, and ladders of one micro-step a call, in the suite's own controller.
#[test]
fn instruction_lists_and_ladders_agree() {
    let mut ladders = 0;
    for seed in 7200..7240_u64 {
        let kind = if seed % 2 == 0 { ChartKind::Flat } else { ChartKind::Hierarchical };
        let mut chart = checked(seed, kind).chart;
        chart.control(&names(seed % 3 == 0)).expect("names that random charts do not have");
        let stimuli = rare(seed, &chart);
        let agree = |profile: Profile, run: &dyn Fn(&Job) -> Ran| {
            let ways = exact(profile);
            let program = compile(&chart, &ways[seed as usize % ways.len()].1).expect("a scan program");
            let job = Job { program, stimuli: stimuli.clone() };
            let Some(actual) = run(&job).unwrap_or_else(|said| panic!("seed {seed}: {said}")) else { return false };
            let expected = simulate(&chart, profile, &stimuli);
            let report = || report(&chart, profile, &stimuli, &expected, &actual);
            assert_eq!(first_difference(&expected, &actual), None, "seed {seed}\n{}", report());
            true
        };
        agree(low_bound(profile(seed)), &|job| instructions::run(job).map(Some));
        ladders += usize::from(agree(Profile { evolution: Evolution::Scan, ..low_bound(profile(seed)) }, &|job| {
            ladder::run(job)
        }));
    }
    assert!(ladders >= 25, "only {ladders} ladders ran");
}

/// A name is taken once; both controls need one of their own.
#[test]
fn a_name_that_is_there_is_an_error() {
    let mut chart = check("hoist", HOIST).expect("a chart without errors");
    let fault = |names: ControlNames, chart: &mut Chart| {
        let found = chart.control(&names).expect_err("a name that is taken");
        found.iter().map(|one| (one.code.as_str(), one.message.clone())).collect::<Vec<_>>()
    };
    let twice =
        ControlNames { reset: Some("top".into()), clear_flags: Some("motor".into()), ..ControlNames::default() };
    assert_eq!(
        fault(twice, &mut chart),
        [
            ("E0216", "`--reset-input top` names what is there already".to_owned()),
            ("E0216", "`--clear-flags-input motor` names what is there already".to_owned()),
        ]
    );
    let same = ControlNames { reset: Some("x".into()), clear_flags: Some("x".into()), ..ControlNames::default() };
    assert_eq!(fault(same, &mut chart), [("E0216", "`--clear-flags-input x` names what is there already".to_owned())]);
}

/// What a chart may not declare, it may not be given either: E0203 and E0204 are the rules for its own names.
#[test]
fn a_name_that_a_chart_could_not_declare_is_an_error() {
    let text = "\
        input Button : bool output Ä : bool
        grafcet Left {
          initial step 1 step Fill macro step M3
          transition 1 -> Fill : Button transition Fill -> M3 : 1 transition M3 -> 1 : 1
          expansion M3 { step E3 step S3 transition E3 -> S3 : 1 }
        }";
    let mut chart = check("names", text).expect("a chart without errors");
    let mut fault = |name: &str| {
        let names = ControlNames { reset: Some(name.into()), ..ControlNames::default() };
        let found = chart.control(&names).expect_err(name);
        assert!(
            found.iter().all(|one| one.code.as_str() == "E0216" && one.help.iter().any(|h| h.contains("another name")))
        );
        found.iter().map(|one| one.message.clone()).collect::<Vec<_>>().join("; ")
    };
    for (name, said) in [
        ("BUTTON", "and `Button` differ only by case"),
        ("ä", "and `Ä` differ only by case"),
        ("X1", "names what is there already: the activity of step `1`"),
        ("x1", "and `X1`, the activity of step `1`, differ only by case"),
        ("T1", "names what is there already: the duration of step `1`"),
        ("XFILL", "and `XFill`, the activity of step `Fill`, differ only by case"),
        ("XM3", "names what is there already: the activity of macro-step `M3`"),
        ("XS3", "names what is there already: the activity of step `S3`"),
        ("XLeft", "names what is there already: the activity of grafcet `Left`"),
    ] {
        assert_eq!(fault(name), format!("`--reset-input {name}` {said}"));
    }
    let both = ControlNames { reset: Some("r".into()), clear_flags: Some("R".into()), ..ControlNames::default() };
    let mut given = chart.clone();
    let found = given.control(&both).expect_err("one name");
    let said: Vec<_> = found.iter().map(|one| one.message.as_str()).collect();
    assert_eq!(said, ["`--clear-flags-input R` and `r` differ only by case"]);
    // Only steps have a duration, and only labels have an activity.
    for free in ["TM3", "TLeft", "X2", "Fill", "x", "T"] {
        let names = ControlNames { reset: Some(free.into()), ..ControlNames::default() };
        chart.clone().control(&names).unwrap_or_else(|_| panic!("{free}"));
    }
}

/// A change of a control is no input event: the level action below counts changes of inputs of the chart alone.
#[test]
fn a_control_is_no_input_of_the_chart() {
    let text = "input a : bool output n : int initial step 1 { n := n + 1 on event a }";
    let mut chart = check("events", text).expect("a chart without errors");
    chart.control(&ControlNames { clear_flags: Some("ack".into()), ..ControlNames::default() }).expect("a new name");
    let stimuli =
        stimuli("events", "t_ms,a,ack\n0,0,0\n10,1,0\n20,1,1\n30,1,0\n40,0,0\n50,1,1\n", &chart).expect("rows");
    let expected = "t_ms,n,situation,flags\n0,0,1,\n10,1,1,\n20,1,1,\n30,1,1,\n40,1,1,\n50,2,1,\n";
    assert_eq!(spell(&chart, &stimuli, &simulate(&chart, Profile::default(), &stimuli)), expected);
    let responses = grafc_testsuite::runs::evaluate(&chart, &Options::default(), &stimuli).expect("a program");
    assert_eq!(spell(&chart, &stimuli, &responses), expected);
}
