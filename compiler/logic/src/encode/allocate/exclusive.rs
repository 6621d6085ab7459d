//! Assignments that are never done in one micro-step, because they wait for one token at different places.

use super::{Position, Tokens, Trigger};
use grafc_model::chart::{StepId, TransitionId};
use grafc_net::net::Forced;
use grafc_net::{Arcs, Net};
use std::collections::{BTreeMap, BTreeSet};

/// Whether no two of them are ever done in one micro-step, because one component has its token only in one place.
///
/// The token is at one step before the micro-step and at one after it. So events at different steps exclude each other,
/// and so do activations of different steps; an event at one step excludes the activation of another if no transition
/// leads from the one to the other, and of the same step in any case.
pub(super) fn exclusive(net: &Net, tokens: Tokens, triggers: &[Trigger]) -> bool {
    let Some(component) = shared(net, tokens, triggers) else { return false };
    let holds = |s: &StepId| tokens.components.of(*s).contains(&component);
    // The steps that the token is at before, with the transitions that take it from there, or none for other events.
    let mut before: BTreeMap<StepId, Option<BTreeSet<TransitionId>>> = BTreeMap::new();
    let mut after: BTreeSet<StepId> = BTreeSet::new();
    for trigger in triggers {
        let fits = match trigger.position {
            Position::At(s) => before.insert(s, None).is_none(),
            Position::Through(t) => {
                let step = net.transitions[t].pre.iter().find(|s| holds(s));
                step.is_some_and(|s| match before.entry(*s).or_insert_with(|| Some(BTreeSet::new())) {
                    // Of the transitions after a step of a component at most one clears.
                    Some(transitions) => transitions.insert(t),
                    None => false,
                })
            }
            Position::To(s) => after.insert(s),
        };
        if !fits {
            return false;
        }
    }
    let before: BTreeSet<StepId> = before.into_keys().collect();
    after.iter().all(|s| !leads(net, tokens.arcs, &before, *s) && (before.is_empty() || !forced(net, *s)))
}

/// Whether a transition leads from one of the steps of `from` to `to`, another step.
fn leads(net: &Net, arcs: &Arcs, from: &BTreeSet<StepId>, to: StepId) -> bool {
    arcs.into_step(to).iter().any(|t| net.transitions[*t].pre.iter().any(|s| from.contains(s)))
}

/// Whether an order may bring the token of a component here from wherever it is.
fn forced(net: &Net, s: StepId) -> bool {
    let orders = &net.grafcets[net.places[s].grafcet].orders;
    orders.iter().any(|order| matches!(&order.forced, Forced::Steps(steps) if steps.binary_search(&s).is_ok()))
}

/// A component whose token all of them wait for.
fn shared(net: &Net, tokens: Tokens, triggers: &[Trigger]) -> Option<usize> {
    let of = |place: Position| -> Vec<usize> {
        match place {
            Position::At(s) | Position::To(s) => tokens.components.of(s).to_vec(),
            Position::Through(t) => {
                net.transitions[t].pre.iter().flat_map(|s| tokens.components.of(*s)).copied().collect()
            }
        }
    };
    let (first, others) = triggers.split_first()?;
    let mut shared = of(first.position);
    for other in others {
        let with = of(other.position);
        shared.retain(|c| with.contains(c));
    }
    shared.first().copied()
}
