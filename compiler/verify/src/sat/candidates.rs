//! What may hold at every clock, and would help to prove the rest: that a set of steps has one token, or that two truths go
//! together in all that was seen. What is guessed wrongly is taken out by induction, so anything may be guessed.

use super::run::Run;
use crate::circuit::{Graph, Literal, Watched};
use grafc_logic::scan::{Program, StepId};
use std::collections::BTreeSet;

/// So many words of cases are compared: of each 64 places all clocks of some reactions.
const MOST_SAMPLES: usize = 256;
const CLOCKS: usize = 64;

/// So many truths are compared with each other.
const MOST_TRUTHS: usize = 500;

/// So many are guessed.
const MOST: usize = 12_000;

/// That at most one step, or one at least once the chart has begun, is active: of each set that is known to be exclusive, and
/// of each that has one step before and one after each transition beside it.
pub(super) fn of_tokens(program: &Program, watched: &mut Watched) -> Vec<Literal> {
    let mut sets: Vec<Vec<usize>> = Vec::new();
    let exclusive = program.restoring.iter().flat_map(|restoring| &restoring.exclusive);
    sets.extend(exclusive.map(|set| set.steps.iter().map(|s| s.index()).collect()));
    sets.extend(components(program));
    let mut claims = Vec::new();
    let (begun, standing) = (watched.begun, watched.standing.clone());
    let graph = &mut watched.circuit.graph;
    for set in sets {
        let (mut one, mut two) = (Literal::FALSE, Literal::FALSE);
        for s in set {
            let both = graph.and(one, standing[s]);
            two = graph.or(two, both);
            one = graph.or(one, standing[s]);
        }
        claims.extend([!two, graph.or(!begun, one)]);
    }
    claims.retain(|claim| *claim != Literal::TRUE);
    claims.sort_unstable();
    claims.dedup();
    claims
}

/// So much is looked at to find sets of steps.
const MOST_LOOKED_AT: usize = 1_000_000;

/// Sets of steps that each transition takes one from and puts one into, or that it leaves alone: each step in one at least,
/// where there is one.
fn components(program: &Program) -> Vec<Vec<usize>> {
    let steps = program.steps.len();
    let of_chart = |list: &[StepId]| -> Vec<usize> { list.iter().map(|s| s.index()).filter(|s| *s < steps).collect() };
    let around = program.elements.transitions.indices().map(|t| {
        let (before, after) = program.elements.around(t);
        [of_chart(before), of_chart(after)]
    });
    let around: Vec<[Vec<usize>; 2]> = around.collect();
    let mut beside: Vec<Vec<usize>> = vec![Vec::new(); steps];
    for (t, sides) in around.iter().enumerate() {
        sides.iter().flatten().for_each(|s| beside[*s].push(t));
    }
    let (mut found, mut covered, mut looked_at) = (Vec::new(), vec![false; steps], 0);
    for seed in 0..steps {
        if covered[seed] || looked_at > MOST_LOOKED_AT {
            continue;
        }
        let (mut set, mut open) = (BTreeSet::from([seed]), vec![seed]);
        let mut is_one = true;
        while let Some(step) = open.pop().filter(|_| is_one) {
            for t in &beside[step] {
                let [before, after] = [0, 1].map(|side| {
                    looked_at += around[*t][side].len();
                    around[*t][side].iter().filter(|s| set.contains(s)).count()
                });
                is_one &= before <= 1 && after <= 1;
                // What goes into the set comes from it, and what leaves it stays in it.
                let missing = match (before, after) {
                    (0, 1) => around[*t][0].first(),
                    (1, 0) => around[*t][1].first(),
                    _ => None,
                };
                if let Some(missing) = missing
                    && set.insert(*missing)
                {
                    open.push(*missing);
                }
            }
        }
        if is_one {
            set.iter().for_each(|s| covered[*s] = true);
            found.push(set.into_iter().collect());
        }
    }
    found
}

/// What was seen at many clocks: the latches, in words of 64 cases.
pub(super) struct Samples(Vec<Vec<u64>>);

impl Samples {
    /// From places that were reached, a few clocks at random.
    pub(super) fn new(watched: &Watched, places: &[Vec<u64>]) -> Samples {
        let mut run = Run::new(watched);
        let mut rng = fastrand::Rng::with_seed(2);
        let initial = run.initial();
        let mut samples = vec![initial.clone()];
        let mut words = |places: &[Vec<u64>]| {
            // A place a case, or several.
            let mut latches = initial.clone();
            for (case, place) in places.iter().cycle().take(64).enumerate() {
                for (word, held) in latches.iter_mut().zip(place) {
                    *word = *word & !(1 << case) | (held & 1) << case;
                }
            }
            run.latches = latches;
            for _ in 0..CLOCKS {
                samples.push(run.latches.clone());
                let inputs: Vec<u64> = watched.circuit.inputs.iter().map(|_| rng.u64(..)).collect();
                run.look(&inputs);
                run.advance(run.of(watched.circuit.assumed));
            }
        };
        let step = places.len().div_ceil(64 * MOST_SAMPLES / CLOCKS).max(1);
        let chosen: Vec<Vec<u64>> = places.iter().step_by(step).cloned().collect();
        words(&[]);
        chosen.chunks(64).for_each(&mut words);
        Samples(samples)
    }

    /// In which cases something holds that depends on latches alone.
    fn signature(&self, run: &mut Run, of: &[Literal]) -> Vec<Vec<u64>> {
        let mut words = vec![Vec::with_capacity(self.0.len()); of.len()];
        for latches in &self.0 {
            run.latches.clone_from(latches);
            run.look(&[]);
            for (word, literal) in words.iter_mut().zip(of) {
                word.push(run.of(*literal));
            }
        }
        words
    }

    /// Those that are true in all that was seen.
    pub(super) fn agree(&self, watched: &Watched, claims: Vec<Literal>) -> Vec<Literal> {
        let words = self.signature(&mut Run::new(watched), &claims);
        let holds = |(claim, words): (Literal, Vec<u64>)| words.iter().all(|word| *word == u64::MAX).then_some(claim);
        claims.into_iter().zip(words).filter_map(holds).collect()
    }

    /// Of each truth that it stays what it is, or goes together with whether the chart has begun, or rests; and of all pairs,
    /// that one implies or excludes the other.
    pub(super) fn of_pairs(&self, watched: &mut Watched) -> [Vec<Literal>; 2] {
        let firsts = [watched.begins, watched.begun];
        let mut truths: Vec<Literal> = watched.standing.iter().chain(&watched.truths).copied().collect();
        truths.sort_unstable();
        truths.dedup();
        truths.retain(|truth| truth.node() != 0);
        let words = self.signature(&mut Run::new(watched), &truths);
        let graph = &mut watched.circuit.graph;
        let (mut claims, mut of_pairs) = (Vec::new(), Vec::new());
        let mut varies = Vec::new();
        for (truth, words) in truths.iter().zip(&words) {
            if words.iter().all(|word| *word == 0) {
                claims.push(!*truth);
            } else if words.iter().all(|word| *word == u64::MAX) {
                claims.push(*truth);
            } else {
                varies.push((*truth, words));
            }
        }
        let is_first = |truth: &Literal| firsts.contains(truth);
        for (place, (a, a_words)) in varies.iter().enumerate() {
            for (b, b_words) in &varies[..place] {
                let out = if is_first(a) || is_first(b) {
                    &mut claims
                } else if varies.len() <= MOST_TRUTHS && of_pairs.len() < MOST {
                    &mut of_pairs
                } else {
                    continue;
                };
                pair(graph, (*a, a_words), (*b, b_words), out);
            }
        }
        [claims, of_pairs]
    }
}

fn pair(graph: &mut Graph, (a, a_words): (Literal, &[u64]), (b, b_words): (Literal, &[u64]), out: &mut Vec<Literal>) {
    let never = |test: fn(u64, u64) -> u64| a_words.iter().zip(b_words).all(|(a, b)| test(*a, *b) == 0);
    if never(|a, b| a & b) {
        out.push(!graph.and(a, b));
    }
    if never(|a, b| a & !b) {
        out.push(!graph.and(a, !b));
    }
    if never(|a, b| !a & b) {
        out.push(!graph.and(!a, b));
    }
    if never(|a, b| !a & !b) {
        out.push(!graph.and(!a, !b));
    }
}

#[cfg(test)]
mod tests {
    use super::super::by_hand::ring;
    use super::*;

    #[test]
    fn what_goes_together_is_guessed() {
        let mut watched = ring();
        let samples = Samples::new(&watched, &[]);
        let [a, b, c] = [0, 1, 2].map(|place| watched.circuit.latches[place].now);
        let [_, pairs] = samples.of_pairs(&mut watched);
        let graph = &mut watched.circuit.graph;
        let mut expected: Vec<Literal> = [(a, b), (a, c), (b, c)].map(|(a, b)| !graph.and(a, b)).to_vec();
        expected.sort_unstable();
        let mut found = pairs;
        found.sort_unstable();
        assert_eq!(found, expected, "no two, and each of them is empty at times");
        // At the start, too.
        assert_eq!(samples.agree(&watched, vec![a, !b, expected[0]]), [expected[0]]);
    }
}
