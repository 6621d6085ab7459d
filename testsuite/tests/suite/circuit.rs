//! The circuit of a scan program: clock by clock it does what the program does, bit by bit.

use grafc_logic::scan::{Claimed, Program};
use grafc_logic::{Analysis, Extras, Options, compile_with};
use grafc_model::chart::{Type, Value};
use grafc_model::reaction::{Profile, Response, Stimulus};
use grafc_testsuite::abc::Abc;
use grafc_testsuite::charts::{cases, charts_folder, check, vectors_folder};
use grafc_testsuite::random::{ChartKind, checked, profile, trace};
use grafc_testsuite::runs::{self, compile};
use grafc_verify::circuit::{Beyond, Circuit, Literal, aiger, circuit, of, smv};
use std::collections::{BTreeSet, HashMap};

const LANES: usize = 64;

/// A circuit that is run in 64 lanes, each at its own call.
struct Run<'c> {
    circuit: &'c Circuit,
    inputs: HashMap<&'c str, usize>,
    /// What is given: inputs and latches, in the order of the nodes.
    order: Vec<(usize, Source)>,
    given: Vec<u64>,
    latches: Vec<u64>,
    nodes: Vec<u64>,
}

#[derive(Clone, Copy)]
enum Source {
    Input(usize),
    Latch(usize),
}

impl<'c> Run<'c> {
    fn new(circuit: &'c Circuit) -> Self {
        let inputs = circuit.inputs.iter().enumerate();
        let mut order: Vec<(usize, Source)> = inputs
            .clone()
            .map(|(place, input)| (input.literal.node(), Source::Input(place)))
            .chain(circuit.latches.iter().enumerate().map(|(place, latch)| (latch.now.node(), Source::Latch(place))))
            .collect();
        order.sort_unstable_by_key(|(node, _)| *node);
        Run {
            circuit,
            inputs: inputs.map(|(place, input)| (input.name.as_str(), place)).collect(),
            order,
            given: vec![0; circuit.inputs.len()],
            latches: circuit.latches.iter().map(|latch| if latch.initial { u64::MAX } else { 0 }).collect(),
            nodes: Vec::new(),
        }
    }

    fn set(&mut self, input: &str, lane: usize, value: bool) {
        // Inputs that are reals are none of the circuit.
        let place = self.inputs[input];
        self.given[place] = self.given[place] & !(1 << lane) | u64::from(value) << lane;
    }

    fn clock(&mut self) {
        let words = self.order.iter().map(|(_, source)| match source {
            Source::Input(place) => self.given[*place],
            Source::Latch(place) => self.latches[*place],
        });
        self.nodes = self.circuit.graph.evaluate(words);
        self.latches = self.circuit.latches.iter().map(|latch| of(&self.nodes, latch.next)).collect();
    }

    fn holds(&self, literal: Literal, lane: usize) -> bool {
        of(&self.nodes, literal) >> lane & 1 == 1
    }

    fn situation(&self, lane: usize) -> Vec<usize> {
        let active = self.circuit.situation.iter().enumerate().filter(|(_, step)| self.holds(**step, lane));
        active.map(|(place, _)| place).collect()
    }
}

/// Situation and outputs as the circuit has them.
fn shown(program: &Program, response: &Response) -> (Vec<usize>, Vec<Vec<bool>>) {
    let types: Vec<Type> = program.of_role(grafc_logic::scan::Role::Output).map(|(_, v)| v.ty).collect();
    let bits = |(value, ty): (&Value, &Type)| match (value, ty) {
        (Value::Bool(value), _) => vec![*value],
        (Value::Int(n), Type::Int | Type::Uint) => (0..16).map(|bit| n >> bit & 1 == 1).collect(),
        (Value::Int(n), _) => (0..32).map(|bit| n >> bit & 1 == 1).collect(),
        (Value::Time(n), _) => (0..64).map(|bit| n >> bit & 1 == 1).collect(),
        (Value::Real(_), _) => Vec::new(),
    };
    let situation = response.situation.iter().map(|step| step.index()).collect();
    (situation, response.outputs.iter().zip(&types).map(bits).collect())
}

/// 64 traces in the circuit, against the evaluator, up to a livelock; how many calls were compared.
fn agree(name: &str, program: &Program, circuit: &Circuit, traces: &[Vec<Stimulus>]) -> usize {
    let input_names: Vec<(&str, Type)> =
        program.of_role(grafc_logic::scan::Role::Input).map(|(_, v)| (v.name.as_str(), v.ty)).collect();
    let expected: Vec<Vec<Response>> = traces
        .iter()
        .map(|trace| {
            let responses = runs::run(program, trace);
            let livelocked = responses.iter().position(|response| response.flags.livelock);
            responses[..livelocked.unwrap_or(responses.len())].to_vec()
        })
        .collect();
    let mut run = Run::new(circuit);
    let mut next = vec![0; traces.len()];
    let mut compared = 0;
    while (0..traces.len()).any(|lane| next[lane] < expected[lane].len()) {
        for (lane, trace) in traces.iter().enumerate() {
            let rests = run.latches[0] >> lane & 1 == 1;
            let Some(stimulus) = trace.get(next[lane]).filter(|_| rests) else { continue };
            for ((name, ty), value) in input_names.iter().zip(&stimulus.inputs) {
                match value {
                    Value::Bool(value) => run.set(name, lane, *value),
                    Value::Int(n) | Value::Time(n) => {
                        let width = if *ty == Type::Time {
                            64
                        } else if matches!(ty, Type::Int | Type::Uint) {
                            16
                        } else {
                            32
                        };
                        (0..width).for_each(|bit| run.set(&format!("{name}[{bit}]"), lane, n >> bit & 1 == 1));
                    }
                    Value::Real(_) => {}
                }
            }
        }
        run.clock();
        for lane in 0..traces.len() {
            if !run.holds(circuit.rests, lane) || next[lane] >= expected[lane].len() {
                continue;
            }
            let outputs: Vec<Vec<bool>> =
                circuit.outputs.iter().map(|bits| bits.iter().map(|bit| run.holds(*bit, lane)).collect()).collect();
            let found = (run.situation(lane), outputs);
            let call = next[lane];
            assert_eq!(found, shown(program, &expected[lane][call]), "{name}: call {call} of trace {lane}");
            next[lane] += 1;
            compared += 1;
        }
    }
    compared
}

fn traces(seed: u64, chart: &grafc_model::chart::Chart, rows: usize) -> Vec<Vec<Stimulus>> {
    let one = |lane: usize| {
        let mut stimuli = trace(seed * LANES as u64 + lane as u64, chart, rows);
        stimuli.iter_mut().for_each(|stimulus| stimulus.restart = false);
        stimuli
    };
    (0..LANES).map(one).collect()
}

#[test]
fn charts_without_delays() {
    let (mut charts, mut compared) = (0, 0);
    let kinds = [ChartKind::Boolean, ChartKind::Flat, ChartKind::Hierarchical];
    let drawn = (0..30).map(|seed| {
        let drawn = checked(seed, kinds[seed as usize % 3]);
        (format!("seed {seed}"), drawn.chart, profile(seed))
    });
    let known = cases(&vectors_folder()).into_iter().chain(cases(&charts_folder())).map(|case| {
        let chart = check(&case.name, &case.text).expect("a chart without errors");
        (case.name, chart, case.profile)
    });
    for (seed, (name, chart, profile)) in drawn.chain(known).enumerate() {
        let Ok(program) = compile(&chart, &Options { profile, ..Options::default() }) else { continue };
        if !program.timers.is_empty() {
            continue;
        }
        let circuit = match circuit(&program) {
            Ok(circuit) => circuit,
            Err(Beyond::Real(_)) => continue,
            Err(beyond) => panic!("{name}: {beyond}"),
        };
        charts += 1;
        compared += agree(&name, &program, &circuit, &traces(seed as u64, &chart, 6));
    }
    assert!(charts >= 30 && compared >= 8_000, "{charts} charts, {compared} calls");
}

/// Delays are free: what inputs and ends at random lead to is in the graph, and nearly all of that is led to.
#[test]
fn charts_with_delays() {
    let mut rng = fastrand::Rng::with_seed(1);
    let (mut charts, mut all) = (0, 0);
    for seed in 0..36 {
        let drawn = checked(seed, ChartKind::Flat);
        let profile = Profile { evolution: profile(seed).evolution, ..Profile::default() };
        let Ok(program) = runs::compile_observed(
            &drawn.chart,
            &Options { profile, ..Options::default() },
            grafc_logic::scan::Observed::Transitions,
        ) else {
            continue;
        };
        if program.timers.is_empty() {
            continue;
        }
        let (Ok(circuit), Ok(graph)) =
            (circuit(&program), grafc_verify::graph(&program, grafc_verify::Of::Situations, 200))
        else {
            continue;
        };
        if !graph.complete || !graph.livelocks.is_empty() {
            continue;
        }
        let known: BTreeSet<Vec<String>> = graph.nodes.iter().map(|node| node.steps.clone()).collect();
        let mut run = Run::new(&circuit);
        let mut met = BTreeSet::new();
        for _ in 0..200 {
            for word in &mut run.given {
                *word = rng.u64(..);
            }
            run.clock();
            for lane in (0..LANES).filter(|lane| run.holds(circuit.rests, *lane)) {
                let steps = run.situation(lane).into_iter().map(|step| program.steps.raw[step].label.to_string());
                met.insert(steps.collect::<Vec<String>>());
            }
        }
        let beyond: Vec<_> = met.difference(&known).collect();
        assert!(beyond.is_empty(), "seed {seed}: {beyond:?} is not in the graph\n{}", drawn.text);
        charts += 1;
        all += usize::from(met.len() == known.len());
    }
    assert!(charts >= 2 && 2 * all >= charts, "{all} of {charts} charts");
}

/// The circuit of a chart with its claims.
fn with_claims(chart: &str) -> Circuit {
    let chart = check("proved", chart).expect("a chart without errors");
    let mut net = grafc_net::build(&chart);
    grafc_net::passes::run(&mut net, false, &mut grafc_diagnostics::Diagnostics::new());
    let extras = Extras { claims: Claimed::All, ..Extras::default() };
    let (program, _) = compile_with(Analysis::new(net), &Options::default(), extras);
    circuit(&program).expect("a circuit")
}

/// A lamp that two buttons switch, with a count of how often; 40 times at most.
const LAMP: &str = "input up, down : bool output L : bool var n : int
    initial step 1
    step 2 { L  n := n + 1 on activation }
    step 3 { n := 0 on activation }
    transition 1 -> 2 : ↑up and [n < 40]
    transition 2 -> 1 : down and not up
    transition 1 -> 3 : down and [n = 40] and not ↑up
    transition 3 -> 1 : 5s/X3 and not down
    ";

#[test]
fn abc_proves_what_holds_and_finds_what_does_not() {
    let claims = [
        ("assert [n <= 40]", true),
        ("assert [n < 40]", false),
        ("assert not L or X2", true),
        ("assert not (X2 and down and up)", false),
        ("assume not (up and down) assert not (X2 and down and up)", true),
        ("assume not (↑up and down) assert after X3 : [n = 0]", true),
        ("assert not X3", false),
    ];
    let Some(abc) = Abc::find_or_skip() else { return };
    for (claim, holds) in claims {
        assert_eq!(abc.proves(&aiger(&with_claims(&format!("{LAMP}{claim}")))), Ok(holds), "{claim}");
    }
}

/// As the language has it; no tool reads it here.
#[test]
fn the_text_of_smv_names_everything() {
    let text = smv(&with_claims(&format!("{LAMP}assume not (up and down) assert [n <= 40]")));
    for line in ["MODULE main", "IVAR", "  l0 : boolean; -- rests", "  init(l0) := TRUE;"] {
        assert!(text.lines().any(|other| other == line), "{line}\n{text}");
    }
    assert!(text.contains(": boolean; -- up\n") && text.contains("boolean; -- n[15]\n"));
}
