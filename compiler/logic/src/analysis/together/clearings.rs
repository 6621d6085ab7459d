//! Transitions after one step that may be cleared in one micro-step (IEC 60848, 6.2.3).

use super::questions::Questions;
use super::witness::{self, Case, SearchResult};
use grafc_model::chart::{StepId, TransitionId};
use rustc_hash::FxHashSet;

/// A transition is compared with this many that follow it after the same step.
const NEAR: usize = 16;

/// More pairs after one step are not looked for.
const LISTED: usize = 4;

/// More steps before a transition are not looked at.
const LOOKED_AT: usize = 8;

/// The pairs after one step; at least one.
#[derive(Clone)]
pub(crate) struct Clashes {
    pub(crate) step: StepId,
    pub(crate) pairs: Vec<Clash>,
}

/// Two transitions that may be cleared together, and a case in which they are, if one was found.
#[derive(Clone)]
pub(crate) struct Clash {
    pub(crate) first: TransitionId,
    pub(crate) second: TransitionId,
    pub(crate) case: Option<Case>,
}

pub(super) fn find(asked: &mut Questions) -> Vec<Clashes> {
    let analysis = asked.analysis;
    let mut found = Vec::new();
    // Pairs that share several steps are looked at once.
    let mut seen = FxHashSet::default();
    for step in analysis.net.places.indices() {
        let after = analysis.arcs.leaving(step);
        let mut pairs: Vec<Clash> = Vec::new();
        for (i, &first) in after.iter().enumerate() {
            for &second in after[i + 1..].iter().take(NEAR) {
                if pairs.len() < LISTED && seen.insert((first, second)) {
                    pairs.extend(clash(asked, first, second));
                }
            }
        }
        if !pairs.is_empty() {
            found.push(Clashes { step, pairs });
        }
    }
    found
}

/// None if they are never cleared in one micro-step, or if it makes no difference.
fn clash(asked: &mut Questions, first: TransitionId, second: TransitionId) -> Option<Clash> {
    let analysis = asked.analysis;
    let conditions = &analysis.conditions.of_transition;
    if analysis.exclude(conditions[first], conditions[second]) {
        return None;
    }
    let [a, b] = [first, second].map(|t| &analysis.net.transitions[t]);
    if sorted(&a.pre) == sorted(&b.pre) && sorted(&a.post) == sorted(&b.post) {
        return None;
    }
    let [before_a, before_b] = [a, b].map(|t| &t.pre[..t.pre.len().min(LOOKED_AT)]);
    if before_a.iter().any(|a| before_b.iter().any(|b| analysis.never_together(*a, *b))) {
        return None;
    }
    let active: Vec<StepId> = before_a.iter().chain(before_b).copied().collect();
    match witness::search(asked, &[a.condition, b.condition], &active) {
        SearchResult::Case(case) => Some(Clash { first, second, case: Some(case) }),
        SearchResult::Impossible => None,
        SearchResult::Unknown => Some(Clash { first, second, case: None }),
    }
}

fn sorted(steps: &[StepId]) -> Vec<StepId> {
    let mut steps = steps.to_vec();
    steps.sort_unstable();
    steps
}
