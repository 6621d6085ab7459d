//! Transitions after one step that may be cleared in one micro-step (IEC 60848, 6.2.3).

use super::questions::Questions;
use super::witness::{self, Case, SearchResult};
use crate::analysis::Analysis;
use grafc_model::chart::{StepId, TransitionId};
use rustc_hash::FxHashSet;

/// Where very many transitions follow a step, one is compared with this many that come after it in the text.
const NEAR: usize = 16;

/// More pairs after one step are not looked at: of the others it is not known whether they are cleared together.
const LOOKED_AT_PAIRS: usize = 128;

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
        let mut pairs: Vec<Clash> = Vec::new();
        let rivals = rivals(analysis, step).into_iter().filter(|(a, b)| !analysis.never_clear_together(*a, *b));
        for (number, (first, second)) in rivals.enumerate() {
            if pairs.len() >= LISTED {
                break;
            }
            if seen.insert((first, second)) {
                pairs.extend(if number < LOOKED_AT_PAIRS {
                    clash(asked, first, second)
                } else {
                    Some(Clash { first, second, case: None })
                });
            }
        }
        if !pairs.is_empty() {
            found.push(Clashes { step, pairs });
        }
    }
    found
}

/// The pairs after a step that conditions do not exclude, in the order of the text.
fn rivals(analysis: &Analysis, step: StepId) -> Vec<(TransitionId, TransitionId)> {
    let after = analysis.arcs.leaving(step);
    let mut pairs = Vec::new();
    for (i, &first) in after.iter().enumerate() {
        if analysis.rivals.many(step) {
            let conditions = &analysis.conditions.of_transition;
            let near = after[i + 1..].iter().take(NEAR);
            let open = near.filter(|second| !analysis.exclude(conditions[first], conditions[**second]));
            pairs.extend(open.map(|second| (first, *second)));
            continue;
        }
        let rivals = analysis.rivals.of(first).iter();
        let mut others: Vec<TransitionId> =
            rivals.copied().filter(|second| *second > first && after.binary_search(second).is_ok()).collect();
        others.sort_unstable();
        pairs.extend(others.into_iter().map(|second| (first, second)));
    }
    pairs
}

/// None if two rivals are never cleared in one micro-step, or if it makes no difference.
fn clash(asked: &mut Questions, first: TransitionId, second: TransitionId) -> Option<Clash> {
    let analysis = asked.analysis;
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
