//! Rules about what may happen at once: they need conditions as formulas and the sets of steps that exclude each other,
//! so they run on the flat net and not with the checks of the chart.
//!
//! They warn of what is not *proved* never to happen. A proof is that two steps share a component, that one forces the
//! other away, or that two conditions contradict each other (see `together`). What the rules look at is bounded by the
//! size of the net: where very many actions or transitions compete, only those that stand near each other in the text
//! are compared.

mod allocation_conflict;
mod counter_race;
mod known;
mod non_exclusive_divergence;
mod orders_not_exclusive;
pub(crate) mod overlap;
mod pairs;
mod together;
mod witness;
mod words;

use grafc_diagnostics::Diagnostics;
use grafc_model::chart::{StepId, TransitionId};
use grafc_net::Net;
use known::Known;

/// A rule.
type Rule = fn(&mut Known, &mut Diagnostics);

/// The rules, in order of their codes.
const WARNINGS: &[Rule] =
    &[non_exclusive_divergence::check, counter_race::check, orders_not_exclusive::check, allocation_conflict::check];

/// What the rules say of a flat net, in order of place.
pub fn warn(net: &Net) -> Diagnostics {
    let mut known = Known::new(net);
    let mut diagnostics = Diagnostics::new();
    for rule in WARNINGS {
        rule(&mut known, &mut diagnostics);
    }
    diagnostics.sort_by_place();
    diagnostics
}

/// Transitions and steps after them that are not proved to be inactive whenever the transition clears.
pub(crate) fn may_reenter(net: &Net) -> Vec<(TransitionId, StepId)> {
    let known = Known::new(net);
    let mut found = Vec::new();
    for (t, transition) in net.transitions.iter_enumerated() {
        let new = transition.post.iter().filter(|s| !transition.pre.contains(s));
        found.extend(new.filter(|s| !transition.pre.iter().any(|p| known.never_together(*p, **s))).map(|s| (t, *s)));
    }
    found
}
