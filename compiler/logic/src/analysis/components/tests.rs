//! Covers of charts whose components are known, and the rules for each component that is found in charts drawn at
//! random.

use super::{Cover, Reason, forced, search, written};
use crate::analysis::Conditions;
use crate::analysis::canonical::Canonical;
use crate::analysis::rivals::Rivals;
use crate::lower::Lowering;
use grafc_diagnostics::{Diagnostics, FileId};
use grafc_formula::exclusion::EdgeFacts;
use grafc_model::chart::{StepId, TransitionId};
use grafc_net::{Arcs, Net};
use rustc_hash::FxHashSet;
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

/// What the search alone finds, by the ids of the net.
struct Arranged {
    cover: Cover,
    reasons: Vec<(StepId, Reason)>,
    /// The component of each set.
    components: Vec<Vec<StepId>>,
}

fn search_alone(net: &Net) -> Arranged {
    let conditions = Conditions::new(Lowering::new(Arc::new(net.clone()), None, false));
    let facts = EdgeFacts::new(&conditions.lowering.edges);
    let arcs = Arcs::of(net, |_| true);
    let canonical = Canonical::new(net, &arcs);
    let rivals = Rivals::new(net, &arcs, &conditions, &facts);
    let arranged = search(&canonical, &rivals, &net.commanded(), &FxHashSet::default());
    let all = written(&canonical, &arranged, usize::MAX);
    let mut components: Vec<Vec<StepId>> =
        all.iter().map(|written| [written.set.steps.as_slice(), &written.others].concat()).collect();
    components.sort_by_key(|component| component[0]);
    let cover = super::components(net, all).1;
    let named = |reason: &Reason| reason.named(|s| canonical.step[s], |t| canonical.transition[t]);
    let mut reasons: Vec<_> = arranged.reasons.iter().map(|(s, reason)| (canonical.step[*s], named(reason))).collect();
    reasons.sort_by_key(|(s, _)| *s);
    Arranged { cover, reasons, components }
}

fn arranged(net: &Net) -> Arranged {
    let conditions = Conditions::new(Lowering::new(Arc::new(net.clone()), None, false));
    let (pool, of) = (&conditions.lowering.pool, &conditions.of_transition);
    let facts = EdgeFacts::new(&conditions.lowering.edges);
    let found = search_alone(net);
    check(net, &found, |a, b| {
        let around = |t: TransitionId| {
            let sorted = |steps: &[StepId]| steps.iter().copied().collect::<BTreeSet<_>>();
            (sorted(&net.transitions[t].pre), sorted(&net.transitions[t].post))
        };
        facts.exclude(pool, of[a], of[b]) || around(a) == around(b)
    });
    found
}

/// The rules for a component, word for word, and that the sets are a partition.
fn check(net: &Net, found: &Arranged, exclude: impl Fn(TransitionId, TransitionId) -> bool) {
    let cover = &found.cover;
    for (number, set) in cover.sets.iter().enumerate() {
        let component = &found.components[number];
        assert!(component.starts_with(&set.steps));
        let labels: Vec<&str> = component.iter().map(|s| net.places[*s].label.as_str()).collect();
        let members = |steps: &[StepId]| steps.iter().filter(|s| component.contains(s)).count();
        let grafcet = net.places[component[0]].grafcet;
        assert!(component.iter().all(|s| net.places[*s].grafcet == grafcet), "{labels:?}");
        let initial = component.iter().filter(|s| net.places[**s].initial).count();
        assert!(initial <= 1, "rule 1: {labels:?}");
        for (id, t) in net.transitions.iter_enumerated() {
            let (before, after) = (members(&t.pre), members(&t.post));
            let fits = if after > 0 { (before, after) == (1, 1) } else { before <= 1 };
            assert!(fits, "rule 2: {labels:?}, transition {}", id.index() + 1);
            for (other_id, other) in net.transitions.iter_enumerated().filter(|(other, _)| *other > id) {
                let both = component.iter().any(|s| t.pre.contains(s) && other.pre.contains(s));
                assert!(!both || exclude(id, other_id), "rule 3: {labels:?}");
            }
        }
        let links = component.iter().filter(|s| net.places[**s].activated).count();
        assert!(links <= 1 || net.places[component[0]].within.is_empty(), "rule 4: {labels:?}");
        for steps in forced(&net.grafcets[grafcet]) {
            assert!(members(steps) <= 1, "rule 5: {labels:?}");
        }
        if set.always_marked {
            assert_eq!(initial, 1, "{labels:?}");
            assert_eq!(component.len(), set.steps.len(), "{labels:?}");
            let keeps = |t: &grafc_net::net::Transition| members(&t.pre) == 0 || members(&t.post) == 1;
            assert!(net.transitions.iter().all(keeps), "{labels:?}");
            assert!(forced(&net.grafcets[grafcet]).all(|steps| members(steps) == 1), "{labels:?}");
            assert!(net.places[component[0]].within.is_empty(), "{labels:?}");
        }
    }
    for s in net.places.indices() {
        let holding = cover.sets.iter().filter(|set| set.steps.contains(&s)).count();
        assert_eq!(holding, usize::from(cover.of_step[s].is_some()));
        assert_eq!(found.reasons.iter().filter(|(other, _)| *other == s).count(), 1 - holding);
    }
    assert!(cover.sets.is_sorted_by_key(|set| set.steps[0]));
    assert!(cover.sets.iter().all(|set| set.steps.is_sorted()));
}

/// The sets in words, one after the other, and `!` behind those that always have a token.
fn sets(net: &Net, cover: &Cover) -> String {
    let label = |s: &StepId| net.places[*s].label.as_str();
    let set = |set: &crate::lower::cover::CoverSet| {
        let steps: Vec<&str> = set.steps.iter().map(label).collect();
        format!("{}{}", steps.join(" "), if set.always_marked { "!" } else { "" })
    };
    cover.sets.iter().map(set).collect::<Vec<_>>().join(" | ")
}

fn cover_of(text: &str) -> String {
    let net = net(text);
    sets(&net, &arranged(&net).cover)
}

/// Steps and transitions of a chart over inputs a to f: `1 2 3; 1 -> 2 : a; 2 -> 3 : b`, initial steps marked by `*`.
fn chart(steps: &str, transitions: &[&str]) -> String {
    let mut text = "input a, b, c, d, e, f : bool\n".to_owned();
    for step in steps.split_whitespace() {
        let (word, label) = step.strip_prefix('*').map_or(("step", step), |label| ("initial step", label));
        let _ = writeln!(text, "{word} {label}");
    }
    for transition in transitions {
        let _ = writeln!(text, "transition {transition}");
    }
    text
}

fn reasons(text: &str) -> Vec<(String, Reason)> {
    let net = net(text);
    let reasons = arranged(&net).reasons;
    reasons.iter().map(|(s, reason)| (net.places[*s].label.to_string(), *reason)).collect()
}

fn t(number: usize) -> TransitionId {
    TransitionId::from_usize(number - 1)
}

fn s(index: usize) -> StepId {
    StepId::from_usize(index)
}

#[test]
fn a_ring_is_one_set() {
    let ring = chart("*1 2 3", &["1 -> 2 : a", "2 -> 3 : b", "3 -> 1 : c"]);
    assert_eq!(cover_of(&ring), "1 2 3!");
    let without_start = chart("*9 1 2", &["1 -> 2 : a", "2 -> 1 : b"]);
    assert_eq!(cover_of(&without_start), "9! | 1 2", "no token ever comes to the ring");
}

#[test]
fn a_choice_stays_in_the_set_if_it_is_one() {
    let by = |second: &str| chart("*1 2 3", &["1 -> 2 : a", &format!("1 -> 3 : {second}"), "2 -> 1 : c", "3 -> 1 : d"]);
    assert_eq!(cover_of(&by("not a and b")), "1 2 3!");
    assert_eq!(cover_of(&by("b")), "");
    assert_eq!(
        reasons(&by("b")),
        [
            ("1".to_owned(), Reason::Together(t(1), t(2))),
            ("2".to_owned(), Reason::From(t(1))),
            ("3".to_owned(), Reason::From(t(2))),
        ]
    );
}

#[test]
fn branches_in_parallel_have_a_variable_each() {
    let figure_12_6 = chart(
        "*Y0 Y1 Y2 Y3 Y4 Y5 Y6 Y7",
        &[
            "Y0 -> Y1 : a",
            "Y1 -> Y2, Y5 : b",
            "Y2 -> Y4 : c",
            "Y2 -> Y3 : d and not c",
            "Y3 -> Y4 : e",
            "Y5 -> Y7 : f",
            "Y5 -> Y6 : d and not f",
            "Y6 -> Y7 : e",
            "Y4, Y7 -> Y0 : a",
        ],
    );
    assert_eq!(cover_of(&figure_12_6), "Y0 Y1 Y2 Y3 Y4! | Y5 Y6 Y7");
    let nested = chart(
        "*1 2 3 4 5 6 7 8",
        &["1 -> 2, 3 : a", "3 -> 4, 5, 6 : b", "4, 5, 6 -> 7 : c", "2, 7 -> 8 : d", "8 -> 1 : e"],
    );
    assert_eq!(cover_of(&nested), "1 2 8! | 3 4 7 | 5 | 6");
    let overlapping =
        chart("*1 2 3 4 5 6 7", &["1 -> 2, 3 : a", "2 -> 4, 5 : b", "3 -> 6 : c", "4, 6 -> 7 : d", "5, 7 -> 1 : e"]);
    assert_eq!(cover_of(&overlapping), "1 2 4 7! | 3 6 | 5", "3 6 without 2 4, 5 without 4 7");
}

#[test]
fn branches_one_after_the_other_share_a_variable() {
    let twice = chart(
        "*1 2 3 4 5 6 7 8 9 10",
        &["1 -> 2, 3 : a", "2, 3 -> 4 : b", "4 -> 5, 6, 7 : c", "5, 6, 7 -> 8 : d", "8 -> 9, 10 : e", "9, 10 -> 1 : f"],
    );
    assert_eq!(cover_of(&twice), "1 2 4 5 8 9! | 3 6 10 | 7");
    let at_once = chart("*1 2 3 4 5", &["1 -> 2, 3 : a", "2, 3 -> 4, 5 : b", "4, 5 -> 1 : c"]);
    assert_eq!(cover_of(&at_once), "1 2 4! | 3 5");
}

#[test]
fn tokens_that_come_and_go() {
    let dies = chart("*1 2 3", &["1 -> 2, 3 : a", "2 -> 1 : b", "3 -> : c"]);
    assert_eq!(cover_of(&dies), "1 2!");
    assert_eq!(reasons(&dies), [("3".to_owned(), Reason::Origin(t(1)))], "3 keeps its token while 2 loses it");
    let first_dies = chart("*1 2 3", &["1 -> 2, 3 : a", "2 -> : b", "3 -> 1 : c"]);
    assert_eq!(cover_of(&first_dies), "1 3!", "not the first branch, which does not lead back");
    let source = chart("*1 2 3", &["-> 2 : a", "2 -> 3 : b"]);
    assert_eq!(cover_of(&source), "1!");
    assert_eq!(reasons(&source), [("2".to_owned(), Reason::Source(t(1))), ("3".to_owned(), Reason::From(t(2)))]);
    let sink = chart("*1 2", &["1 -> 2 : a", "2 -> : b"]);
    assert_eq!(cover_of(&sink), "1 2", "the token may be lost");
}

#[test]
fn several_tokens_at_the_start() {
    let two = chart("*1 *2 3", &["1 -> 2 : a", "2 -> 3 : b", "3 -> 1 : c"]);
    assert_eq!(cover_of(&two), "");
    assert!(reasons(&two).contains(&("1".to_owned(), Reason::Initial(s(0), s(1)))));
    let parallel = chart("*1 2 *3 4", &["1, 3 -> 2, 4 : a", "2, 4 -> 1, 3 : b"]);
    assert_eq!(cover_of(&parallel), "1 2! | 3 4!");
    let shared = chart("*1 2 *3 *4 5", &["1, 3 -> 2 : a", "2 -> 1, 3 : b", "4, 3 -> 5 : not a and c", "5 -> 4, 3 : d"]);
    assert_eq!(cover_of(&shared), "1 2! | 3 5 | 4", "1 2 and 3 2 5 and 4 5: the one that has 3 may go on");
}

#[test]
fn a_step_too_many_after_a_join() {
    let pulse = chart("*1 2 3 4", &["1 -> 2, 3 : a", "2, 3 -> 1, 4 : b", "4 -> : c"]);
    assert_eq!(cover_of(&pulse), "1 2! | 3", "2 4 or 3 4 would lose 1");
    assert_eq!(reasons(&pulse).len(), 1);
}

#[test]
fn enclosures_start_with_at_most_one_token() {
    let enclosed = |second: &str| {
        format!(
            "input a, b, c : bool
             grafcet G {{ initial step 0  enclosing step 1  transition 0 -> 1 : a  transition 1 -> 0 : b }}
             grafcet X1/H {{
               activated step 2  {second} 3
               transition 2 -> 3 : c  transition 3 -> 2 : not c
             }}"
        )
    };
    assert_eq!(cover_of(&enclosed("step")), "0 1! | 2 3", "H may be empty");
    assert_eq!(cover_of(&enclosed("activated step")), "0 1!");
    let net = net(&enclosed("activated step"));
    let reasons = arranged(&net).reasons;
    assert!(reasons.contains(&(s(2), Reason::Links(s(2), s(3)))), "{reasons:?}");
}

#[test]
fn orders_force_at_most_one_token() {
    let forced = |situation: &str| {
        format!(
            "input a, b, c : bool
             grafcet G {{ initial step 0  step 1 {{ force H{{{situation}}} }}  transition 0 -> 1 : a  transition 1 -> 0 : b }}
             grafcet H {{
               initial step 2  step 3  step 4
               transition 2 -> 3 : c  transition 3 -> 4 : not c  transition 4 -> 2 : a
             }}"
        )
    };
    assert_eq!(cover_of(&forced("3")), "0 1! | 2 3 4!");
    assert_eq!(cover_of(&forced("*")), "0 1! | 2 3 4!");
    assert_eq!(cover_of(&forced("INIT")), "0 1! | 2 3 4!");
    assert_eq!(cover_of(&forced("")), "0 1! | 2 3 4", "H may be empty");
    assert_eq!(cover_of(&forced("2, 3")), "0 1!");
    let net = net(&forced("2, 3"));
    let reasons = arranged(&net).reasons;
    assert!(reasons.contains(&(s(2), Reason::Forced(s(2), s(3)))), "{reasons:?}");
}

/// Draws the text of a grafcet.
struct Draw {
    random: fastrand::Rng,
    /// The first letter of labels.
    word: char,
    steps: usize,
    transitions: Vec<String>,
}

impl Draw {
    fn new(seed: u64, word: char) -> Self {
        Draw { random: fastrand::Rng::with_seed(seed), word, steps: 0, transitions: Vec::new() }
    }

    fn step(&mut self) -> usize {
        self.steps += 1;
        self.steps - 1
    }

    fn list(&self, steps: &[usize]) -> String {
        steps.iter().map(|s| format!("{}{s}", self.word)).collect::<Vec<_>>().join(", ")
    }

    /// No two of these transitions clear together.
    fn transition(&mut self, before: &[usize], after: &[usize]) {
        let number = self.transitions.len();
        self.transitions.push(format!("transition {} -> {} : [n = {number}]", self.list(before), self.list(after)));
    }

    /// Steps one after the other, branches of which one is taken and branches in parallel, nested: the first step and
    /// the last.
    fn block(&mut self, depth: u32) -> (usize, usize) {
        let kind = if depth == 0 { 0 } else { self.random.u32(0..4) };
        if kind == 0 {
            let s = self.step();
            return (s, s);
        }
        let blocks: Vec<(usize, usize)> = (0..self.random.usize(2..4)).map(|_| self.block(depth - 1)).collect();
        if kind == 1 {
            for pair in blocks.windows(2) {
                self.transition(&[pair[0].1], &[pair[1].0]);
            }
            return (blocks[0].0, blocks[blocks.len() - 1].1);
        }
        let (first, last) = (self.step(), self.step());
        let (starts, ends): (Vec<usize>, Vec<usize>) = blocks.into_iter().unzip();
        if kind == 2 {
            for (start, end) in starts.iter().zip(&ends) {
                self.transition(&[first], &[*start]);
                self.transition(&[*end], &[last]);
            }
        } else {
            self.transition(&[first], &starts);
            self.transition(&ends, &[last]);
        }
        (first, last)
    }

    /// A few transitions between any steps, some of which may clear together with others.
    fn disturb(&mut self) {
        for _ in 0..self.random.usize(0..4) {
            let some = |draw: &mut Self| {
                let mut steps: Vec<usize> =
                    (0..draw.random.usize(0..3)).map(|_| draw.random.usize(0..draw.steps)).collect();
                steps.sort_unstable();
                steps.dedup();
                steps
            };
            let (before, after) = (some(self), some(self));
            if before.is_empty() && after.is_empty() {
                continue;
            }
            if self.random.u32(0..3) == 0 {
                let line = format!("transition {} -> {} : a", self.list(&before), self.list(&after));
                self.transitions.push(line);
            } else {
                self.transition(&before, &after);
            }
        }
    }

    /// Steps, one or two of them with a word before `step`, and transitions.
    fn text(&mut self, rare: &str) -> String {
        let mut text = String::new();
        for s in 0..self.steps {
            let word = if self.random.usize(0..self.steps) == 0 { rare } else { "step" };
            let _ = writeln!(text, "{word} {}", self.list(&[s]));
        }
        text + &self.transitions.join("\n")
    }
}

#[test]
fn nested_branches_are_covered() {
    let mut parallel = 0;
    for seed in 0..300 {
        let mut draw = Draw::new(seed, 's');
        let (first, last) = draw.block(4);
        draw.transition(&[last], &[first]);
        let text = format!("input n : dint  step start  transition start -> s{first} : 1\n{}", draw.text("step"));
        let text = text.replacen("step start", "initial step start", 1);
        let net = net(&text);
        let Arranged { cover, reasons, .. } = arranged(&net);
        assert_eq!(reasons, [], "seed {seed}\n{text}");
        // The sets are no more than the tokens there can be: one, and each branch after the first adds one.
        let forks: usize = net.transitions.iter().map(|t| t.post.len() - 1).sum();
        assert!(cover.sets.len() <= 1 + forks, "seed {seed}\n{text}");
        parallel += usize::from(cover.sets.len() > 2);
    }
    assert!(parallel > 100, "{parallel} charts with more than two sets");
}

#[test]
fn what_is_found_is_a_component() {
    let (mut covered, mut steps, mut sets, mut arrangements) = (0, 0, 0, 0);
    for seed in 0..600 {
        let mut draw = Draw::new(seed, 's');
        draw.block(3);
        let last = draw.steps - 1;
        draw.transition(&[last], &[0]);
        draw.disturb();
        let text = format!("input n : dint  input a : bool  initial step start\n{}", draw.text("initial step"));
        let net = net(&text);
        let Arranged { cover, reasons, .. } = arranged(&net);
        steps += net.places.len();
        covered += net.places.len() - reasons.len();
        sets += cover.sets.len();
        arrangements += usize::from(cover.sets.len() > 2);
    }
    assert!(covered * 2 > steps && sets > 1_000 && arrangements > 100, "{covered} of {steps} steps in {sets} sets");
}

#[test]
fn what_is_found_under_enclosures_and_orders_is_a_component() {
    let (mut covered, mut steps) = ([0; 2], [0; 2]);
    for seed in 0..400 {
        let mut inner = Draw::new(seed, 'i');
        let (first, last) = inner.block(3);
        inner.transition(&[last], &[first]);
        let mut forced = Draw::new(seed + 1_000, 'f');
        let (first, last) = forced.block(3);
        forced.transition(&[last], &[first]);
        let mut situation = || {
            let steps: Vec<usize> = (0..forced.steps).filter(|_| forced.random.usize(0..forced.steps) == 0).collect();
            forced.list(&steps)
        };
        let (one, other) = (situation(), situation());
        let text = format!(
            "input n : dint  input a, b, c : bool
             grafcet Top {{
               initial step 0  enclosing step 1  step 2 {{ force Forced{{{one}}} }}  step 3 {{ force Forced{{{other}}} }}
               transition 0 -> 1 : a  transition 1 -> 2 : b  transition 2 -> 3 : c  transition 3 -> 0 : a
             }}
             grafcet X1/Inner {{ activated step entry  transition entry -> i{} : 1\n{} }}
             grafcet Forced {{ initial step first\n{} }}",
            inner.random.usize(0..inner.steps),
            inner.text("activated step"),
            forced.text("initial step"),
        );
        let net = net(&text);
        let cover = arranged(&net).cover;
        for (s, place) in net.places.iter_enumerated() {
            let kind = usize::from(place.label.starts_with('f'));
            steps[kind] += 1;
            covered[kind] += usize::from(cover.of_step[s].is_some());
        }
    }
    for (covered, steps) in covered.into_iter().zip(steps) {
        assert!(covered * 4 > steps && covered < steps, "{covered} of {steps} steps");
    }
}

#[test]
fn wide_and_long_charts_are_covered() {
    let mut wide = "input a : bool  initial step 1\n".to_owned();
    let list = |word: &str| (0..20_000).map(|i| format!("{word}{i}")).collect::<Vec<_>>().join(", ");
    for i in 0..20_000 {
        let _ = writeln!(wide, "step b{i} step e{i} transition b{i} -> e{i} : a");
    }
    let _ = writeln!(wide, "transition 1 -> {} : a  transition {} -> 1 : a", list("b"), list("e"));
    let net = net(&wide);
    let found = search_alone(&net);
    assert_eq!(found.reasons, []);
    assert_eq!(found.cover.sets.len(), 20_000);
    assert_eq!(found.cover.sets[0].steps.len(), 3);
    assert!(found.cover.sets[1..].iter().all(|set| set.steps.len() == 2));
}
