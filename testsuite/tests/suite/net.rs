//! The passes over nets keep the meaning: a net does at every stage what its chart does in the simulator, micro-step by
//! micro-step.
//!
//! Only the last pass is left out of this, because a place more in a ring takes a micro-step more; what it does is
//! written down by hand.

use grafc_diagnostics::Diagnostics;
use grafc_model::chart::{Chart, StepId, Value, VariableId};
use grafc_model::reaction::{Evolution, Flags, Profile, Response, Stimulus};
use grafc_model::simulate::Simulator;
use grafc_net::{Net, build, passes};
use grafc_testsuite::charts::{self, Case};
use grafc_testsuite::net_steps::{NetSteps, same};
use grafc_testsuite::random::profile;
use grafc_testsuite::random::{ChartKind, checked, low_bound, trace};
use index_vec::IndexVec;
use std::fmt::Write as _;

/// What can be seen after the start or a micro-step.
struct Seen {
    reaction: usize,
    active: Vec<StepId>,
    variables: IndexVec<VariableId, Value>,
    flags: Flags,
}

impl Seen {
    fn new(
        reaction: usize,
        active: &IndexVec<StepId, bool>,
        variables: &IndexVec<VariableId, Value>,
        flags: Flags,
    ) -> Self {
        let active = active.iter_enumerated().filter(|(_, active)| **active).map(|(s, _)| s).collect();
        Seen { reaction, active, variables: variables.clone(), flags: without_div0(flags) }
    }

    fn same(&self, other: &Seen) -> bool {
        self.reaction == other.reaction
            && self.active == other.active
            && self.flags == other.flags
            && self.variables.len() == other.variables.len()
            && self.variables.iter().zip(&other.variables).all(|(a, b)| same(*a, *b))
    }

    fn spell(&self, net: &Net) -> String {
        let labels: Vec<&str> = self.active.iter().map(|s| net.places[*s].label.as_str()).collect();
        let raised: Vec<&str> = self.flags.names().collect();
        format!("{{{}}} {:?} {raised:?}", labels.join(", "), self.variables.as_raw_slice())
    }
}

/// Passes have no say in DIV0, and the interpreter of nets does not raise it.
fn without_div0(flags: Flags) -> Flags {
    Flags { div0: false, ..flags }
}

fn run_chart(chart: &Chart, profile: Profile, stimuli: &[Stimulus]) -> (Vec<Seen>, Vec<Response>) {
    let mut simulator = Simulator::new(chart, profile);
    let mut seen = Vec::new();
    let mut responses = Vec::new();
    for (reaction, stimulus) in stimuli.iter().enumerate() {
        let mut response = simulator.react_observed(stimulus, &mut |s| {
            seen.push(Seen::new(reaction, s.state().situation(), s.state().variables(), s.flags()));
        });
        response.flags = without_div0(response.flags);
        responses.push(response);
    }
    (seen, responses)
}

fn run_net(net: &Net, profile: Profile, stimuli: &[Stimulus]) -> (Vec<Seen>, Vec<Response>) {
    let mut steps = NetSteps::new(net, profile);
    let mut seen = Vec::new();
    let mut responses = Vec::new();
    for (reaction, stimulus) in stimuli.iter().enumerate() {
        responses.push(steps.react(stimulus, &mut |s| {
            seen.push(Seen::new(reaction, s.situation(), s.variables(), s.flags()));
        }));
    }
    (seen, responses)
}

/// Runs a chart in the simulator and as a net at every stage but the last, and gives the flat net.
fn same_at_every_stage(chart: &Chart, profile: Profile, stimuli: &[Stimulus]) -> Result<Net, String> {
    let (expected, responses) = run_chart(chart, profile, stimuli);
    let mut fault = String::new();
    let mut look = |stage: &str, net: &Net| {
        let (actual, answers) = run_net(net, profile, stimuli);
        let place = (0..expected.len().max(actual.len())).find(|i| match (expected.get(*i), actual.get(*i)) {
            (Some(expected), Some(actual)) => !expected.same(actual),
            (_, _) => true,
        });
        if let Some(i) = place {
            let spelt = |seen: &[Seen]| seen.get(i).map_or("nothing".to_string(), |seen| seen.spell(net));
            let reaction = expected.get(i).or(actual.get(i)).map_or(0, |seen| seen.reaction);
            let _ = writeln!(fault, "  {stage}: reaction {reaction}, sight {i} of {profile:?}");
            let _ = writeln!(fault, "    simulator {}\n    net       {}", spelt(&expected), spelt(&actual));
        } else if let Some((row, (r, a))) =
            responses.iter().zip(&answers).enumerate().find(|(_, (r, a))| !same_response(r, a))
        {
            let _ =
                writeln!(fault, "  {stage}: reaction {row} of {profile:?}\n    simulator {r:?}\n    net       {a:?}");
        }
    };
    let mut net = build(chart);
    look("as built", &net);
    let mut diagnostics = Diagnostics::new();
    passes::run_and_look(&mut net, false, &mut diagnostics, |pass, net| look(pass.name, net));
    if !diagnostics.is_empty() {
        let _ = writeln!(fault, "  the passes said {diagnostics:?}");
    }
    if fault.is_empty() { Ok(net) } else { Err(fault) }
}

fn same_response(a: &Response, b: &Response) -> bool {
    a.situation == b.situation && a.flags == b.flags && a.outputs.iter().zip(&b.outputs).all(|(a, b)| same(*a, *b))
}

/// Runs every case in both kinds of evolution.
fn each(cases: &[Case]) {
    let mut faults = String::new();
    for case in cases {
        let run = |evolution| {
            let chart = charts::check(&case.name, &case.text)?;
            let stimuli = charts::stimuli(&case.name, &case.trace, &chart)?;
            same_at_every_stage(&chart, Profile { evolution, ..case.profile }, &stimuli)
        };
        for evolution in [Evolution::Stable, Evolution::Scan] {
            if let Err(fault) = run(evolution) {
                let _ = writeln!(faults, "{}\n{fault}", case.name);
            }
        }
    }
    assert!(faults.is_empty(), "{faults}");
}

#[test]
fn every_vector_is_the_same_at_every_stage() {
    let cases = charts::cases(&charts::vectors_folder());
    assert!(cases.len() >= 90, "vectors are missing: only {} were found", cases.len());
    each(&cases);
}

#[test]
fn every_chart_is_the_same_at_every_stage() {
    let cases = charts::cases(&charts::charts_folder());
    assert!(cases.len() >= 16, "charts are missing: only {} were found", cases.len());
    each(&cases);
}

#[test]
fn random_charts_are_the_same_at_every_stage() {
    let mut counts = Counts::default();
    for seed in 0..300 {
        let drawn = checked(seed, ChartKind::Hierarchical);
        let stimuli = trace(seed, &drawn.chart, 30);
        match same_at_every_stage(&drawn.chart, low_bound(profile(seed)), &stimuli) {
            Ok(net) => counts.count(&drawn.chart, &net),
            Err(fault) => panic!("seed {}\n{}\n{fault}", drawn.seed, drawn.text),
        }
    }
    // Each pass must have had something to do.
    let Counts { arcs, reordered, started, conflicts, frozen_with, further, within } = counts;
    let figures = [arcs, reordered, started, conflicts, frozen_with, further, within];
    assert!(reordered >= 1 && figures.iter().filter(|n| **n >= 3).count() >= 6, "{figures:?}");
}

/// In how many charts a pass had something to do.
#[derive(Default)]
struct Counts {
    /// A macro-step with arcs.
    arcs: u32,
    /// Orders that win in another order than that of the chart.
    reordered: u32,
    /// A start that is not what the chart marks.
    started: u32,
    /// Orders that disagree at the start.
    conflicts: u32,
    /// A grafcet that is frozen with another.
    frozen_with: u32,
    /// A grafcet that is frozen with one that does not enclose it directly.
    further: u32,
    /// A source transition in an enclosure: it has nothing else to keep it back.
    within: u32,
}

impl Counts {
    fn count(&mut self, chart: &Chart, net: &Net) {
        let around = |g: &grafc_model::chart::Grafcet| g.enclosing_step.map(|e| chart.steps[e].grafcet);
        let pairs = || chart.grafcets.iter().zip(&net.grafcets);
        let declared = |step: StepId| chart.orders.iter().position(|order| order.step == step);
        self.arcs += u32::from(!chart.macro_steps.is_empty());
        self.reordered +=
            u32::from(net.grafcets.iter().any(|g| !g.orders.iter().map(|o| declared(o.step)).is_sorted()));
        self.started +=
            u32::from(chart.steps.iter().zip(&net.places).any(|(step, place)| step.initial != place.initial));
        self.conflicts += u32::from(net.conflict_at_start);
        self.frozen_with += u32::from(net.grafcets.iter().any(|g| g.frozen_with.is_some()));
        self.further += u32::from(pairs().any(|(c, n)| n.frozen_with.is_some() && n.frozen_with != around(c)));
        self.within += u32::from(net.transitions.iter().any(|t| !t.within.is_empty() && t.pre.is_empty()));
    }
}

/// By hand: `1 -a-> 2 -b-> 1` gets a place `2_1` on the way back, from which the next micro-step leads on.
#[test]
fn a_broken_ring_takes_a_micro_step_more() {
    let text = "input a, b : bool
        output n : int
        initial step 1 { n := n + 1 on activation }
        step 2
        transition 1 -> 2 : ↑a
        transition 2 -> 1 : ↑b
    ";
    let chart = charts::check("ring", text).unwrap_or_else(|fault| panic!("{fault}"));
    let mut net = build(&chart);
    passes::run(&mut net, true, &mut Diagnostics::new());
    let at = |t_ms, a, b| Stimulus { t_ms, restart: false, inputs: vec![Value::Bool(a), Value::Bool(b)] };
    let (seen, responses) =
        run_net(&net, Profile::default(), &[at(0, false, false), at(10, true, false), at(20, false, true)]);
    let spelt: Vec<String> = seen
        .iter()
        .map(|seen| {
            let labels: Vec<&str> = seen.active.iter().map(|s| net.places[*s].label.as_str()).collect();
            format!("{}: {{{}}} {:?}", seen.reaction, labels.join(", "), seen.variables[VariableId::new(2)])
        })
        .collect();
    assert_eq!(
        spelt,
        [
            "0: {1} Int(1)",
            "0: {1} Int(1)",
            "1: {2} Int(1)",
            "1: {2} Int(1)",
            "2: {2_1} Int(1)",
            "2: {1} Int(2)",
            "2: {1} Int(2)",
        ]
    );
    let situations: Vec<&[StepId]> = responses.iter().map(|r| &r.situation[..]).collect();
    assert_eq!(situations, [[StepId::new(0)], [StepId::new(1)], [StepId::new(0)]]);
}
