//! What the steps of a sequential function chart do.
//!
//! A continuous action becomes a part of the value of its variable, which each of the variable's steps computes as a
//! whole: so it does not matter in which order steps are left and entered. Stored actions are done one after the other,
//! so none may see what another writes.

use super::expressions::Expressions;
use super::{Assignment, Reasons, SequenceStep, Wire, own};
use grafc_model::chart::{Continuous, Event, ExprId, ExprKind, StepId, VariableId};
use grafc_net::Net;
use index_vec::IndexVec;
use rustc_hash::{FxHashMap, FxHashSet};
use std::collections::BTreeMap;

/// What continuous actions set, and the steps with what they do.
pub(super) fn collect(
    net: &Net,
    mut steps: IndexVec<StepId, SequenceStep>,
    expressions: &mut Expressions,
    reasons: &mut Reasons,
) -> (Vec<Wire>, IndexVec<StepId, SequenceStep>) {
    let wires = continuous(net, &mut steps, expressions, reasons);
    stored(net, &mut steps, expressions, reasons);
    (wires, steps)
}

fn continuous(
    net: &Net,
    steps: &mut IndexVec<StepId, SequenceStep>,
    expressions: &mut Expressions,
    reasons: &mut Reasons,
) -> Vec<Wire> {
    let mut of: BTreeMap<VariableId, Vec<&Continuous>> = BTreeMap::new();
    for action in &net.continuous {
        of.entry(action.target).or_default().push(action);
    }
    let mut wires = Vec::new();
    for (target, actions) in of {
        let mut places: Vec<StepId> = actions.iter().map(|action| action.step).collect();
        places.sort_unstable();
        places.dedup();
        let owner = own(&places);
        let mut terms = Vec::new();
        for action in &actions {
            let active = expressions.active(action.step, owner);
            let condition = action.condition.map(|condition| expressions.formula(condition, owner, reasons));
            terms.push(expressions.pool.and([Some(active), condition].into_iter().flatten()));
        }
        let plain = owner.is_some() && actions.iter().any(|action| action.condition.is_none());
        let value = expressions.pool.or(terms);
        places.into_iter().for_each(|step| steps[step].wires.push(wires.len()));
        wires.push(Wire { target: expressions.declared(target), plain, value });
    }
    wires
}

fn stored(net: &Net, steps: &mut IndexVec<StepId, SequenceStep>, expressions: &mut Expressions, reasons: &mut Reasons) {
    let written: FxHashSet<VariableId> = net.stored.iter().map(|action| action.target).collect();
    let mut on_activation: FxHashMap<VariableId, bool> = FxHashMap::default();
    for action in &net.stored {
        let (step, activation) = match action.event {
            Event::Activation(step) => (step, true),
            Event::Deactivation(step) => (step, false),
            Event::Event(..) => {
                reasons.add(action.span, "an action on an event");
                continue;
            }
            Event::Clearing(_) => {
                reasons.add(action.span, "an action on a clearing");
                continue;
            }
        };
        if activation && net.places[step].initial {
            reasons.add(
                action.span,
                "an action on the activation of an initial step, which some tools leave out at the start",
            );
        }
        if *on_activation.entry(action.target).or_insert(activation) != activation {
            reasons.add(action.span, "stores on deactivation what another action stores on activation");
        }
        if reads(net, action.value).any(|read| read != action.target && written.contains(&read)) {
            reasons.add(action.span, "reads what another action stores");
        }
        let value = expressions.formula(action.value, Some(step), reasons);
        let target = expressions.declared(action.target);
        steps[step].stored.push(Assignment { on_activation: activation, target, value });
    }
}

/// The variables that an expression reads.
fn reads(net: &Net, root: ExprId) -> impl Iterator<Item = VariableId> + '_ {
    let mut seen = FxHashSet::default();
    let mut open = vec![root];
    std::iter::from_fn(move || {
        while let Some(id) = open.pop() {
            if !seen.insert(id) {
                continue;
            }
            open.extend(net.exprs[id].kind.operands());
            if let ExprKind::Variable(variable) = net.exprs[id].kind {
                return Some(variable);
            }
        }
        None
    })
}
