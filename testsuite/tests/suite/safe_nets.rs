//! Nets in which no step is ever entered while it is active: that is proved, and nothing else is, whatever the order of
//! declaration is.
//!
//! The nets are in `safe_nets/nets.txt`, with invariants found by hand.

use grafc::{Document, Options, Product};
use grafc_backends::Target;
use grafc_backends::plcopen::{self, Body};
use grafc_diagnostics::{Code, Diagnostics, FileId};
use grafc_logic::{Encoding, Method, Options as Lowering, exclusion, sets};
use grafc_model::chart::StepId;
use grafc_model::reaction::{Evolution, Profile};
use grafc_testsuite::charts::field_cases;
use grafc_testsuite::random::trace;
use grafc_testsuite::runs::simulate;
use std::collections::BTreeSet;
use std::fmt::Write;
use std::path::Path;

const ORDERS: u64 = 40;

const INPUTS: [&str; 4] = ["a", "b", "c", "d"];

struct Net {
    name: String,
    /// With whether each is initial.
    steps: Vec<(String, bool)>,
    transitions: Vec<Transition>,
    invariants: Vec<Vec<String>>,
}

struct Transition {
    before: Vec<String>,
    after: Vec<String>,
    condition: String,
}

fn nets() -> Vec<Net> {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("safe_nets/nets.txt");
    let text = std::fs::read_to_string(file).expect("the nets");
    text.lines().filter(|line| !line.starts_with('#')).map(net).collect()
}

fn net(line: &str) -> Net {
    let columns: Vec<&str> = line.split('|').map(str::trim).collect();
    let [name, steps, transitions, invariants] = columns[..] else { panic!("four columns in {line}") };
    let list = |text: &str| text.split(',').map(str::to_owned).collect::<Vec<_>>();
    let step = |text: &str| (text.trim_end_matches('*').to_owned(), text.ends_with('*'));
    // A condition may hold blanks: a transition goes on up to the next word with an arrow in it.
    let mut arrows: Vec<String> = Vec::new();
    for word in transitions.split_whitespace() {
        match arrows.last_mut().filter(|_| !word.contains('>')) {
            Some(last) => *last += &format!(" {word}"),
            None => arrows.push(word.to_owned()),
        }
    }
    let transition = |(number, text): (usize, &String)| {
        let (arrow, condition) = text.split_once(':').unwrap_or((text, INPUTS[number % INPUTS.len()]));
        let (before, after) = arrow.split_once('>').expect("an arrow");
        Transition { before: list(before), after: list(after), condition: condition.to_owned() }
    };
    Net {
        name: name.to_owned(),
        steps: steps.split_whitespace().map(step).collect(),
        transitions: arrows.iter().enumerate().map(transition).collect(),
        invariants: invariants.split_whitespace().map(|sum| sum.split('+').map(str::to_owned).collect()).collect(),
    }
}

impl Net {
    /// The items of a chart in an order drawn at random, and in each transition its steps.
    fn items(&self, order: u64) -> String {
        let mut random = fastrand::Rng::with_seed(order);
        let mut items: Vec<String> = Vec::new();
        for (label, initial) in &self.steps {
            items.push(format!("{}step {label}", if *initial { "initial " } else { "" }));
        }
        for transition in &self.transitions {
            let (mut before, mut after) = (transition.before.clone(), transition.after.clone());
            random.shuffle(&mut before);
            random.shuffle(&mut after);
            items.push(format!("transition {} -> {} : {}", before.join(", "), after.join(", "), transition.condition));
        }
        random.shuffle(&mut items);
        items.join("\n") + "\n"
    }

    fn chart(&self, order: u64) -> String {
        format!("input a, b, c, d : bool\n{}", self.items(order))
    }
}

/// The sets of steps that `switch` can hold in one state each.
fn sets_of(document: &Document) -> BTreeSet<BTreeSet<String>> {
    let (chart, analysis) = (document.chart().expect("a chart"), document.analysis().expect("an analysis"));
    sets(analysis).map(|steps| steps.iter().map(|s| chart.steps[*s].label.to_string()).collect()).collect()
}

/// The warnings of what may happen together.
fn said_of(document: &Document) -> Vec<Code> {
    let diagnostics = document.warnings().iter().map(|message| message.code);
    diagnostics.filter(|code| [Code::W0409, Code::W0410, Code::W0411, Code::W0412].contains(code)).collect()
}

fn draw(text: &str) -> Result<String, Diagnostics> {
    let profile = Profile { evolution: Evolution::Scan, ..Profile::default() };
    let body = plcopen::Options { body: Body::Sfc, ..plcopen::Options::default() };
    let lowering = Lowering { profile, encoding: Encoding::default(), simplify: true };
    let options = Options::new(lowering, Product::Code(Target::Plcopen(body)));
    let (made, diagnostics) = grafc::compile(FileId::default(), text, "chart", &options);
    made.map(|made| made.text).ok_or(diagnostics)
}

#[test]
fn nine_nets_are_safe_in_forty_orders() {
    let nets = nets();
    assert_eq!(nets.len(), 9);
    for net in &nets {
        let mut known: Option<BTreeSet<BTreeSet<String>>> = None;
        for order in 0..ORDERS {
            let text = net.chart(order);
            let document = Document::new("chart", text.as_str());
            assert_eq!(said_of(&document), [], "{}\n{text}", net.name);
            let drawn = draw(&text);
            assert!(drawn.is_ok(), "{}: {:?}\n{text}", net.name, drawn.err());
            let sets = sets_of(&document);
            let covered: usize = sets.iter().map(BTreeSet::len).sum();
            assert_eq!(covered, net.steps.len(), "{}: {sets:?}\n{text}", net.name);
            assert_eq!(*known.get_or_insert_with(|| sets.clone()), sets, "{}\n{text}", net.name);
        }
    }
}

/// Exactly the pairs of steps that no situation holds are proved to exclude each other; those of an invariant are among
/// them.
#[test]
fn pairs_are_proved_to_exclude_each_other_where_they_do() {
    for net in nets() {
        for order in 0..ORDERS {
            let text = net.chart(order);
            let document = Document::new("chart", text.as_str());
            let (chart, analysis) = (document.chart().expect("a chart"), document.analysis().expect("an analysis"));
            let id = |label: &str| chart.steps.indices().find(|s| chart.steps[*s].label == label).expect("a step");
            let mut together = BTreeSet::new();
            for seed in 0..30 {
                // Scan by scan each situation of the net is seen.
                let profile = Profile { evolution: Evolution::Scan, ..Profile::default() };
                for response in simulate(chart, profile, &trace(seed, chart, 60)) {
                    let active: Vec<StepId> =
                        chart.steps.indices().filter(|s| response.situation.contains(s)).collect();
                    together.extend(active.iter().flat_map(|a| active.iter().map(|b| (*a, *b))));
                    for invariant in &net.invariants {
                        let sum = invariant.iter().filter(|label| active.contains(&id(label))).count();
                        assert_eq!(sum, 1, "{}: {invariant:?} in {active:?}", net.name);
                    }
                }
            }
            for (a, b) in chart.steps.indices().flat_map(|a| chart.steps.indices().map(move |b| (a, b))) {
                let labels = (&chart.steps[a].label, &chart.steps[b].label);
                if a != b {
                    let seen = together.contains(&(a, b));
                    assert_eq!(analysis.never_together(a, b), !seen, "{}: {labels:?}\n{text}", net.name);
                }
            }
        }
    }
}

/// Steps that exclude each other may force a grafcet into different situations (W0411).
#[test]
fn orders_of_steps_that_exclude_each_other_do_not_disagree() {
    for net in nets() {
        for order in 0..ORDERS {
            let invariant = &net.invariants[order as usize % net.invariants.len()];
            let mut items = net.items(order);
            for (number, label) in invariant.iter().enumerate() {
                let forced = ["P1", "P2"][number % 2];
                let with = format!("step {label} {{ force Forced{{{forced}}} }}\n");
                items = items.replacen(&format!("step {label}\n"), &with, 1);
            }
            let text = format!(
                "input a, b, c, d : bool\ngrafcet Net {{\n{items}}}\n\
                 grafcet Forced {{ initial step P1  step P2  transition P1 -> P2 : a  transition P2 -> P1 : b }}\n"
            );
            let document = Document::new("chart", text.as_str());
            assert!(!document.diagnostics().has_errors(), "{:?}\n{text}", document.diagnostics());
            assert_eq!(said_of(&document), [], "{}\n{text}", net.name);
        }
    }
}

#[test]
fn what_was_used_is_told() {
    let of = |text: &str| {
        let document = Document::new("chart", text);
        let analysis = document.analysis().expect("an analysis");
        exclusion(analysis).map(|(_, steps)| steps).collect::<Vec<_>>()
    };
    assert_eq!(exclusion(Document::new("chart", "initial step 1").analysis().expect("one")).count(), 3);
    let methods = [Method::OneToken, Method::AllSituations, Method::Search];
    let document = Document::new("chart", "initial step 1");
    let told: Vec<Method> = exclusion(document.analysis().expect("one")).map(|(method, _)| method).collect();
    assert_eq!(told, methods);
    let ring = "input a : bool\ninitial step 1\nstep 2\ntransition 1 -> 2 : a\ntransition 2 -> 1 : not a\n";
    assert_eq!(of(ring), [2, 0, 0]);
    let fork =
        "input a : bool\ninitial step 1\nstep 2\nstep 3\ntransition 1 -> 2, 3 : a\ntransition 2, 3 -> 1 : not a\n";
    assert_eq!(of(fork), [0, 3, 0]);
    // So many steps that not all situations are looked for.
    let mut wide = "input a : bool\ninitial step 0\n".to_owned();
    let branches: Vec<String> = (1..=400).map(|i| i.to_string()).collect();
    branches.iter().for_each(|label| writeln!(wide, "step {label}").expect("a text"));
    let list = branches.join(", ");
    let _ = writeln!(wide, "transition 0 -> {list} : a\ntransition {list} -> 0 : not a");
    assert_eq!(of(&wide), [0, 0, 401]);
}

/// Plants that need the same proofs.
#[test]
fn plants_are_proved() {
    let plants = ["two_joins_of_one_fork", "conditional_parallel_branch", "four_stations_in_pairs", "pallet_stations"];
    let cases: Vec<_> = field_cases().into_iter().filter(|case| plants.contains(&case.name.as_str())).collect();
    assert_eq!(cases.len(), plants.len());
    for case in cases {
        let document = Document::new(&*case.name, case.text.as_str());
        assert_eq!(said_of(&document), [], "{}", case.name);
        let covered: usize = sets_of(&document).iter().map(BTreeSet::len).sum();
        assert_eq!(covered, document.chart().expect("a chart").steps.len(), "{}", case.name);
        let drawn = draw(&case.text);
        assert!(drawn.is_ok(), "{}: {:?}", case.name, drawn.err());
    }
}
