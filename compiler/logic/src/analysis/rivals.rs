//! Transitions after one step that are not proved by their conditions to exclude each other.
//!
//! A condition is looked at together with the steps before its transition, since it matters only while these are active:
//!
//! ```text
//! 1 -> 3 : a and not X2     1, 2 -> 3 : a       exclude each other: where the second is enabled, X2 is true
//! ```
//!
//! Two transitions between the same steps do no harm to each other: whether one or both clear, the token goes the same
//! way. That is so unless an action or an order waits for the clearing of one of them.

use super::Conditions;
use grafc_formula::exclusion::EdgeFacts;
use grafc_model::chart::{StepId, TransitionId};
use grafc_net::{Arcs, Net};
use index_vec::IndexVec;
use rustc_hash::FxHashSet;

/// Of more transitions after one step not all pairs are compared.
const COMPARED: usize = 128;

/// Of more transitions after one step pairs are compared in plain sight only, without decision diagrams.
const DIAGRAMS: usize = 64;

/// Transitions that may clear together although they share a step before them, as far as conditions tell.
pub(crate) struct Rivals {
    /// Those of each transition.
    of: IndexVec<TransitionId, Vec<TransitionId>>,
    /// Steps with so many transitions after them that these are not compared.
    many: FxHashSet<StepId>,
}

impl Rivals {
    pub(crate) fn new(net: &Net, arcs: &Arcs, conditions: &Conditions, facts: &EdgeFacts) -> Rivals {
        let mut rivals =
            Rivals { of: net.transitions.iter().map(|_| Vec::new()).collect(), many: FxHashSet::default() };
        let awaited: FxHashSet<TransitionId> = net.awaited_clearings().collect();
        // A pair that shares several steps is looked at once.
        let mut seen = FxHashSet::default();
        for s in net.places.indices() {
            let leaving = arcs.leaving(s);
            if leaving.len() > COMPARED {
                rivals.many.insert(s);
                continue;
            }
            for (i, a) in leaving.iter().enumerate() {
                for b in &leaving[i + 1..] {
                    let several = |t: TransitionId| net.transitions[t].pre.len() > 1;
                    if several(*a) && several(*b) && !seen.insert((*a, *b)) {
                        continue;
                    }
                    let thoroughly = leaving.len() <= DIAGRAMS;
                    if !exclude(net, conditions, facts, *a, *b, thoroughly) && !alike(net, &awaited, *a, *b) {
                        rivals.of[*a].push(*b);
                        rivals.of[*b].push(*a);
                    }
                }
            }
        }
        rivals
    }

    /// Those of a transition.
    pub(crate) fn of(&self, t: TransitionId) -> &[TransitionId] {
        &self.of[t]
    }

    /// All pairs, each once.
    pub(crate) fn pairs(&self) -> impl Iterator<Item = (TransitionId, TransitionId)> + '_ {
        self.of.iter_enumerated().flat_map(|(a, list)| list.iter().filter(move |b| a < **b).map(move |b| (a, *b)))
    }

    /// Whether there are so many transitions after a step that they are not compared.
    pub(crate) fn many(&self, s: StepId) -> bool {
        self.many.contains(&s)
    }
}

/// Whether two transitions are never cleared together, by their conditions and what these say of the steps before.
fn exclude(
    net: &Net,
    conditions: &Conditions,
    facts: &EdgeFacts,
    a: TransitionId,
    b: TransitionId,
    thoroughly: bool,
) -> bool {
    let (pool, both) = (&conditions.lowering.pool, [conditions.of_transition[a], conditions.of_transition[b]]);
    if !thoroughly {
        return facts.exclude_plainly(pool, both[0], both[1]);
    }
    if facts.exclude(pool, both[0], both[1]) {
        return true;
    }
    let step = |v| conditions.lowering.situation.step_of(v);
    let active = |s: &StepId| net.transitions[a].pre.contains(s) || net.transitions[b].pre.contains(s);
    let known = |v| step(v).is_some_and(|s| active(&s));
    if !both.iter().any(|c| facts.variables(pool, *c).any(known)) {
        return false;
    }
    let cases = facts.cases(pool, &both, &known);
    cases.is_some_and(|cases| cases.iter().all(|case| case.iter().any(|(_, value)| !value)))
}

/// Whether it makes no difference if one of them clears or both.
fn alike(net: &Net, awaited: &FxHashSet<TransitionId>, a: TransitionId, b: TransitionId) -> bool {
    let sorted = |steps: &[StepId]| {
        let mut steps = steps.to_vec();
        steps.sort_unstable();
        steps
    };
    let [one, other] = [a, b].map(|t| &net.transitions[t]);
    let sizes = |t: &grafc_net::net::Transition| (t.pre.len(), t.post.len());
    ![a, b].iter().any(|t| awaited.contains(t))
        && sizes(one) == sizes(other)
        && sorted(&one.pre) == sorted(&other.pre)
        && sorted(&one.post) == sorted(&other.post)
}
