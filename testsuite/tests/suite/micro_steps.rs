//! The scan program against the simulator, micro-step by micro-step: after each one the same steps are active, stored
//! variables have the same values and the same flags of orders and allocations are raised.
//!
//! A micro-step that changes none of these is left out on either side: the simulator ends each reaction with one, and a
//! program whose loop was proved needless has none. What a call publishes, DIV0 and LIVELOCK included, is compared too.
//!
//! Where steps overlap, a step that has been left is active for one micro-step beside its successor; it is not counted
//! then. A token goes round short rings at another pace: a ring of two steps gets a place more, and in a ring of three
//! the r-trigger keeps the third step inactive until the first one is. Stable situations are the same, and `random.rs`
//! compares these; here charts with such rings are left out.

#![allow(clippy::print_stdout, reason = "how much was compared")]

mod runs;

use fastrand::Rng;
use grafc_logic::{Encoding, Options};
use grafc_model::chart::{Chart, Expr, ExprKind, Mode, Node, StepId, Tables, Type, VariableId, VariableKind};
use grafc_model::reaction::{Evolution, Profile, Stimulus};
use grafc_testsuite::charts::{self, Case};
use grafc_testsuite::random::profile;
use grafc_testsuite::random::{ChartKind, checked, low_bound, trace};
use grafc_testsuite::runs::{caught, compile, overlapping};
use grafc_testsuite::ways::exact;
use runs::{Run, difference, evaluated, simulated};
use std::fmt::Write as _;

/// What was compared.
#[derive(Default, Debug)]
struct Counts {
    programs: usize,
    without_loop: usize,
    overlapping: usize,
    /// Changes seen, in both.
    changes: usize,
    /// Micro-steps, and those that changed nothing, of the simulator and of the programs.
    simulator: (usize, usize),
    program: (usize, usize),
}

impl Counts {
    fn add(&mut self, expected: &Run, actual: &Run) {
        self.programs += 1;
        self.changes += expected.seen.len();
        for (sum, run) in [(&mut self.simulator, expected), (&mut self.program, actual)] {
            *sum = (sum.0 + run.micro_steps, sum.1 + run.idle);
        }
    }
}

/// Compares all ways to lower a chart.
fn compare(chart: &Chart, profile: Profile, stimuli: &[Stimulus], counts: &mut Counts) -> Result<(), String> {
    let expected = simulated(chart, profile, stimuli);
    for (way, options) in exact(profile) {
        let program = caught(|| compile(chart, &options)).map_err(|fault| format!("{way}: {fault}"))?;
        let actual = evaluated(chart, &program, stimuli, |active| active);
        if let Some(fault) = difference(chart, &expected, &actual) {
            return Err(format!("{way}: {fault}"));
        }
        counts.add(&expected, &actual);
        counts.without_loop +=
            usize::from(program.repeat.is_none() && !chart.options.is_scan() && profile.evolution == Evolution::Stable);
    }
    // A bound counts the micro-steps of the overlap as well.
    if expected.responses.iter().any(|response| response.flags.livelock) {
        return Ok(());
    }
    let successors = successors(chart);
    if has_short_rings(&successors) {
        return Ok(());
    }
    for encoding in Encoding::ALL.into_iter().filter(|encoding| encoding.overlaps()) {
        for simplify in [true, false] {
            let options = Options { profile: Profile { bound: None, ..profile }, encoding, simplify };
            let way = format!("{} (simplified: {simplify})", encoding.name());
            let made = caught(|| overlapping(chart, &options)).map_err(|fault| format!("{way}: {fault}"))?;
            let (program, false) = made else { continue };
            let actual = evaluated(chart, &program, stimuli, |active| settled(&successors, active));
            if let Some(fault) = difference(chart, &expected, &actual) {
                return Err(format!("{way}: {fault}"));
            }
            counts.add(&expected, &actual);
            counts.overlapping += 1;
        }
    }
    Ok(())
}

/// Whether some token can come back in two or three micro-steps.
fn has_short_rings(successors: &[Vec<StepId>]) -> bool {
    let after = |s: StepId| successors[s.index()].iter().copied();
    (0..successors.len())
        .map(StepId::new)
        .any(|s| after(s).flat_map(after).any(|second| second == s || after(second).any(|third| third == s)))
}

/// The steps that a transition leads to from each step.
fn successors(chart: &Chart) -> Vec<Vec<StepId>> {
    let mut successors = vec![Vec::new(); chart.steps.len()];
    for transition in &chart.transitions {
        for before in &transition.pre {
            let before = match *before {
                Node::Step(s) => s,
                Node::Macro(m) => chart.exit(m),
            };
            let after = transition.post.iter().map(|after| match *after {
                Node::Step(s) => s,
                Node::Macro(m) => chart.entry(m),
            });
            successors[before.index()].extend(after.filter(|after| *after != before));
        }
    }
    successors
}

/// The steps that none of their successors is active with.
fn settled(successors: &[Vec<StepId>], active: Vec<StepId>) -> Vec<StepId> {
    let left = |s: &StepId| successors[s.index()].iter().any(|after| active.contains(after));
    active.iter().copied().filter(|s| !left(s)).collect()
}

fn each(cases: &[Case]) -> Counts {
    let (mut counts, mut faults) = (Counts::default(), String::new());
    for case in cases {
        let mut run = |evolution| {
            let chart = charts::check(&case.name, &case.text)?;
            let stimuli = charts::stimuli(&case.name, &case.trace, &chart)?;
            compare(&chart, Profile { evolution, ..case.profile }, &stimuli, &mut counts)
        };
        for evolution in [Evolution::Stable, Evolution::Scan] {
            if let Err(fault) = run(evolution) {
                let _ = writeln!(faults, "{}, {evolution:?}, {fault}", case.name);
            }
        }
    }
    println!("{counts:?}");
    assert!(faults.is_empty(), "{faults}");
    counts
}

#[test]
fn every_vector_goes_the_same_way() {
    let cases = charts::cases(&charts::vectors_folder());
    assert!(cases.len() >= 104, "vectors are missing: only {} were found", cases.len());
    let counts = each(&cases);
    assert!(counts.without_loop >= 20 && counts.overlapping >= 10, "{counts:?}");
}

#[test]
fn every_chart_goes_the_same_way() {
    let cases = charts::cases(&charts::charts_folder());
    assert!(cases.len() >= 16, "charts are missing: only {} were found", cases.len());
    let counts = each(&cases);
    assert!(counts.without_loop >= 6 && counts.overlapping >= 4, "{counts:?}");
}

/// Runs random charts of a kind, changed before they are run.
fn random(kind: ChartKind, seeds: std::ops::Range<u64>, rows: usize, change: impl Fn(&mut Tables, u64)) -> Counts {
    let mut counts = Counts::default();
    for seed in seeds {
        let mut drawn = checked(seed, kind);
        change(drawn.chart.edit(), seed);
        let stimuli = trace(seed, &drawn.chart, rows);
        if let Err(fault) = compare(&drawn.chart, low_bound(profile(seed)), &stimuli, &mut counts) {
            panic!("{kind:?}, seed {}: {fault}\n{}", drawn.seed, drawn.text);
        }
    }
    println!("{kind:?}: {counts:?}");
    counts
}

#[test]
fn flat_charts_go_the_same_way() {
    let counts = random(ChartKind::Flat, 5000..5150, 25, |_, _| ());
    assert!(counts.changes >= 10_000, "{counts:?}");
}

#[test]
fn hierarchical_charts_go_the_same_way() {
    let counts = random(ChartKind::Hierarchical, 5000..5150, 25, |_, _| ());
    assert!(counts.changes >= 10_000, "{counts:?}");
}

#[test]
fn plain_charts_go_the_same_way() {
    let counts = random(ChartKind::Plain, 5000..5100, 25, |_, _| ());
    assert!(counts.overlapping >= 50, "{counts:?}");
}

/// Conditions that read outputs of continuous actions, in charts that are written in place: nothing but states and
/// these outputs, each of which others have yet to read when it is written.
#[test]
fn plain_charts_that_read_their_outputs_go_the_same_way() {
    let counts = random(ChartKind::Plain, 6000..6150, 25, |chart, seed| {
        let mut rng = Rng::with_seed(seed ^ 0x7769_7265);
        chart.stored.clear();
        chart.variables.iter_mut().filter(|v| v.mode == Mode::Stored).for_each(|v| v.mode = Mode::Given);
        // Where an input decides on an output as well, the output does not follow a state.
        chart.continuous.iter_mut().for_each(|action| action.condition = action.condition.filter(|_| rng.f32() < 0.2));
        let outputs = chart.variables.iter_enumerated();
        let outputs = outputs.filter(|(_, v)| v.kind == VariableKind::Output && v.mode == Mode::Wire);
        let outputs: Vec<VariableId> = outputs.map(|(v, _)| v).collect();
        for transition in &mut chart.transitions {
            if outputs.is_empty() || rng.f32() < 0.4 {
                continue;
            }
            let mut push = |kind| chart.exprs.push(Expr { kind, ty: Type::Bool, span: transition.span });
            let output = push(ExprKind::Variable(outputs[rng.usize(0..outputs.len())]));
            let factor = if rng.bool() { output } else { push(ExprKind::Not(output)) };
            transition.condition = push(ExprKind::And(factor, transition.condition));
        }
    });
    assert!(counts.changes >= 2000, "{counts:?}");
}
