//! Situations of small nets drawn at random, against all that their clearings can come to one by one.

use super::Reachable;
use crate::analysis::canonical::Canonical;
use crate::analysis::rivals::Rivals;
use crate::analysis::{Analysis, Conditions};
use crate::lower::Lowering;
use grafc_diagnostics::{Diagnostics, FileId};
use grafc_formula::exclusion::EdgeFacts;
use grafc_model::chart::{StepId, TransitionId};
use grafc_net::net::Forced;
use grafc_net::{Arcs, Net};
use std::collections::BTreeSet;
use std::fmt::Write;
use std::sync::Arc;

fn net(text: &str) -> Net {
    let (tree, diagnostics) = grafc_syntax::parse(FileId::default(), text);
    assert!(!diagnostics.has_errors(), "{text}\n{diagnostics:?}");
    let (chart, diagnostics) = grafc_model::check(&tree, "chart");
    let mut net = grafc_net::build(&chart.unwrap_or_else(|| panic!("{text}\n{diagnostics:?}")));
    grafc_net::passes::run(&mut net, false, &mut Diagnostics::new());
    net
}

/// The situations of all parts, also of those that nobody would ask about.
fn reachable(net: &Net) -> Reachable {
    let conditions = Conditions::new(Lowering::new(Arc::new(net.clone()), None, false));
    let facts = EdgeFacts::new(&conditions.lowering.edges);
    let arcs = Arcs::of(net, |_| true);
    let canonical = Canonical::new(net, &arcs);
    let rivals = Rivals::new(net, &arcs, &conditions, &facts);
    let parts = super::parts::parts(&canonical);
    Reachable::find(&canonical, &parts, &conditions, &facts, &rivals, &[], |_| true)
}

/// A condition of a net that is drawn: an input, perhaps denied, and perhaps what it reads of a step.
#[derive(Clone, Copy)]
struct Condition {
    input: Option<(usize, bool)>,
    step: Option<(usize, bool)>,
}

struct Drawn {
    text: String,
    before: Vec<u32>,
    after: Vec<u32>,
    conditions: Vec<Condition>,
}

const INPUTS: usize = 4;

/// A net of one grafcet with few arcs. Without `free` conditions, inputs decide of several transitions, and steps are
/// read.
fn draw(random: &mut fastrand::Rng, free: bool) -> Drawn {
    let steps = random.usize(2..7);
    let mut drawn = Drawn { text: String::new(), before: Vec::new(), after: Vec::new(), conditions: Vec::new() };
    let count = random.usize(1..7);
    let some = |random: &mut fastrand::Rng, least: usize| {
        let mut set = 0_u32;
        for _ in 0..random.usize(least..4).min(2 + random.usize(0..2)) {
            set |= 1 << random.usize(0..steps);
        }
        set
    };
    for number in 0..count {
        let (before, after) = (some(random, 1), some(random, 0));
        let input = if free { Some((number, true)) } else { Some((random.usize(0..INPUTS), random.bool())) };
        let step = (!free && random.usize(0..4) == 0).then(|| (random.usize(0..steps), random.bool()));
        drawn.before.push(before);
        drawn.after.push(after);
        drawn.conditions.push(Condition { input, step });
    }
    drawn.text += "input i0, i1, i2, i3, i4, i5, i6 : bool\n";
    for s in 0..steps {
        let word = if s == 0 || random.usize(0..4) == 0 { "initial step" } else { "step" };
        let _ = writeln!(drawn.text, "{word} {s}");
    }
    let list = |set: u32| (0..32).filter(|s| set >> s & 1 == 1).map(|s| s.to_string()).collect::<Vec<_>>().join(", ");
    for ((before, after), condition) in drawn.before.iter().zip(&drawn.after).zip(&drawn.conditions) {
        let literal = |name: String, value: bool| if value { name } else { format!("not {name}") };
        let input = condition.input.map(|(i, value)| literal(format!("i{i}"), value));
        let step = condition.step.map(|(s, value)| literal(format!("X{s}"), value));
        let text = input.into_iter().chain(step).collect::<Vec<_>>().join(" and ");
        let _ = writeln!(drawn.text, "transition {} -> {} : {text}", list(*before), list(*after));
    }
    drawn
}

/// All situations, by the rules R3 and R4 alone: for every row of inputs all clear that can.
fn all_situations(drawn: &Drawn, initial: u32) -> BTreeSet<u32> {
    let mut found = BTreeSet::from([initial]);
    let mut open = vec![initial];
    while let Some(situation) = open.pop() {
        for inputs in 0..1_u32 << 7 {
            let (mut left, mut come) = (0, 0);
            for ((before, after), condition) in drawn.before.iter().zip(&drawn.after).zip(&drawn.conditions) {
                let holds = |of: u32, literal: Option<(usize, bool)>| {
                    literal.is_none_or(|(place, value)| (of >> place & 1 == 1) == value)
                };
                if situation & before == *before && holds(inputs, condition.input) && holds(situation, condition.step) {
                    left |= before;
                    come |= after;
                }
            }
            let next = situation & !left | come;
            if found.insert(next) {
                open.push(next);
            }
        }
    }
    found
}

#[test]
fn every_situation_is_found_and_no_other_where_conditions_are_free() {
    let (mut exact, mut given_up, mut unsafe_nets) = (0, 0, 0);
    for seed in 0..1_500 {
        let mut random = fastrand::Rng::with_seed(seed);
        let free = seed % 2 == 0;
        let drawn = draw(&mut random, free);
        let net = net(&drawn.text);
        let label = |s: StepId| net.places[s].label.parse::<usize>().expect("a number");
        let initial = net.places.indices().filter(|s| net.places[*s].initial).map(|s| 1 << label(s)).sum();
        let situations = all_situations(&drawn, initial);
        let reachable = reachable(&net);
        let ids: Vec<StepId> = net.places.indices().collect();
        for part in reachable.parts() {
            let mut projected: BTreeSet<u32> = BTreeSet::new();
            let mask: u32 = part.steps.iter().map(|s| 1 << label(*s)).sum();
            projected.extend(situations.iter().map(|situation| situation & mask));
            let has = |situation: u32| {
                let wanted: Vec<(u16, bool)> =
                    part.steps.iter().zip(0..).map(|(s, n)| (n, situation >> label(*s) & 1 == 1)).collect();
                part.situations.has(&wanted)
            };
            assert!(projected.iter().all(|situation| has(*situation)), "seed {seed}\n{}", drawn.text);
            if free {
                assert_eq!(part.count(), Some(projected.len() as u64), "seed {seed}\n{}", drawn.text);
            }
            exact += 1;
        }
        given_up += ids.iter().filter(|s| reachable.part(**s).is_none()).count();
        // What is said of pairs, of transitions that enter and of rivals.
        for (a, b) in ids.iter().flat_map(|a| ids.iter().map(move |b| (*a, *b))).filter(|(a, b)| a != b) {
            let both = 1 << label(a) | 1 << label(b);
            let meets = situations.iter().any(|situation| situation & both == both);
            assert!(!meets || reachable.together(a, b) != Some(false), "seed {seed}\n{}", drawn.text);
        }
        for (t, transition) in net.transitions.iter_enumerated() {
            let before: u32 = transition.pre.iter().map(|s| 1 << label(*s)).sum();
            for s in transition.post.iter().filter(|s| !transition.pre.contains(s)) {
                let enters = situations.iter().any(|x| x & before == before && x >> label(*s) & 1 == 1);
                unsafe_nets += usize::from(enters);
                if let Some(part) = reachable.part(*s).filter(|_| free) {
                    assert_eq!(part.enters_active(t, *s), enters, "seed {seed}\n{}", drawn.text);
                }
            }
            for (u, other) in net.transitions.iter_enumerated().filter(|(u, _)| *u > t && free) {
                let shares = transition.pre.iter().any(|s| other.pre.contains(s));
                let around = |t: TransitionId| (drawn.before[t.index()], drawn.after[t.index()]);
                let Some(part) = transition.pre.first().and_then(|s| reachable.part(*s)) else { continue };
                if shares && around(t) != around(u) {
                    let both = drawn.before[t.index()] | drawn.before[u.index()];
                    assert_eq!(
                        part.meet(t, u),
                        situations.iter().any(|x| x & both == both),
                        "seed {seed}\n{}",
                        drawn.text
                    );
                }
            }
        }
    }
    assert!(exact > 1_500 && given_up < 500 && unsafe_nets > 500, "{exact} parts, {given_up} steps not, {unsafe_nets}");
}

#[test]
fn enclosing_steps_and_orders_only_begin_anew() {
    let text = "input a, b, c : bool
        grafcet G { initial step 0  enclosing step 1  step 9 { force H{4} }
          transition 0 -> 1 : a  transition 1 -> 9 : b  transition 9 -> 0 : c }
        grafcet X1/E { activated step 2  step 3  transition 2 -> 3 : c  transition 3 -> 2 : not c }
        grafcet H { initial step 5  step 4  step 6  transition 5 -> 6 : c  transition 4 -> 6 : a }";
    let net = net(text);
    let reachable = reachable(&net);
    let part = |label: &str| {
        let s = net.places.indices().find(|s| net.places[*s].label == label).expect(label);
        reachable.part(s).and_then(super::Reached::count)
    };
    assert_eq!(part("0"), Some(3), "0, 1 or 9");
    assert_eq!(part("2"), Some(3), "2, 3, or none while 1 is inactive");
    assert_eq!(part("4"), Some(3), "5, the forced 4, and 6 from either");
    assert!(net.grafcets.iter().flat_map(|g| &g.orders).any(|order| matches!(&order.forced, Forced::Steps(_))));
}

#[test]
fn work_is_counted() {
    // So many branches that are entangled with each other that the situations are too many.
    let mut text = "input a : bool\ninitial step 0\n".to_owned();
    let count = 60;
    for i in 1..=count {
        let _ = writeln!(text, "step a{i} step b{i} step c{i}");
    }
    let list = |letter: char| (1..=count).map(|i| format!("{letter}{i}")).collect::<Vec<_>>().join(", ");
    let _ = writeln!(text, "transition 0 -> {} : a", list('a'));
    for i in 1..=count {
        let j = (i * 37) % count + 1;
        let _ = writeln!(
            text,
            "transition a{i} -> b{i} : a\ntransition b{i}, c{j} -> a{i} : a\ntransition b{i} -> c{i} : not a"
        );
    }
    let analysis = Analysis::new(net(&text));
    let again = Analysis::new(net(&text));
    assert_eq!(analysis.reachable.parts().len(), again.reachable.parts().len());
}
