//! What the steps of a sequential function chart do.
//!
//! What one step alone sets, or several that never hand over to each other, is an action of each. Of others the value as a
//! whole is found once, behind the chart, if all that it reads is known there; else each of the variable's steps computes
//! it as a whole: so it does not matter in which order steps are left and entered. Stored actions are done one after the other,
//! so none may see what another writes.

use super::expressions::Expressions;
use super::{Assignment, Reasons, SequenceStep, Wire, own};
use crate::analysis::Analysis;
use grafc_model::chart::{Continuous, Event, ExprId, ExprKind, StepId, VariableId, VariableKind};
use grafc_net::Net;
use index_vec::IndexVec;
use rustc_hash::{FxHashMap, FxHashSet};
use std::collections::BTreeMap;

/// What continuous actions set, and the steps with what they do.
pub(super) fn collect(
    analysis: &Analysis,
    mut steps: IndexVec<StepId, SequenceStep>,
    expressions: &mut Expressions,
    reasons: &mut Reasons,
) -> (Vec<Wire>, IndexVec<StepId, SequenceStep>) {
    let net = analysis.net();
    let wires = continuous(analysis, &mut steps, expressions, reasons);
    stored(net, &mut steps, expressions, reasons);
    (wires, steps)
}

fn continuous(
    analysis: &Analysis,
    steps: &mut IndexVec<StepId, SequenceStep>,
    expressions: &mut Expressions,
    reasons: &mut Reasons,
) -> Vec<Wire> {
    let net = analysis.net();
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
        let plain = match owner {
            Some(_) => actions.iter().any(|action| action.condition.is_none()),
            None => actions.iter().all(|action| action.condition.is_none()) && never_meet(analysis, &places),
        };
        if plain {
            places.into_iter().for_each(|step| steps[step].wires.push(wires.len()));
            let value = expressions.pool.truth(true);
            wires.push(Wire { target: expressions.declared(target), plain, value });
            continue;
        }
        let mut terms = Vec::new();
        for action in &actions {
            let active = expressions.active(action.step, owner);
            let condition = action.condition.map(|condition| expressions.formula(condition, owner, reasons));
            terms.push(expressions.pool.and([Some(active), condition].into_iter().flatten()));
        }
        let value = expressions.pool.or(terms);
        if owner.is_none() && net.variables[target].kind == VariableKind::Output && expressions.is_known_outside(value)
        {
            expressions.afterwards(target, value);
            continue;
        }
        places.into_iter().for_each(|step| steps[step].wires.push(wires.len()));
        wires.push(Wire { target: expressions.declared(target), plain, value });
    }
    wires
}

/// Whether of these steps at most one is active, and none is left for another of them: then it does not matter in which
/// order a tool lets their actions begin and end.
fn never_meet(analysis: &Analysis, steps: &[StepId]) -> bool {
    let Some((first, others)) = steps.split_first() else { return true };
    let shared = |c: &usize| others.iter().all(|s| analysis.components.of(*s).contains(c));
    let all: FxHashSet<StepId> = steps.iter().copied().collect();
    let leads_on = |s: &StepId| {
        let transitions = analysis.arcs.out_of_step(*s).iter();
        transitions.flat_map(|t| &analysis.net().transitions[*t].post).any(|after| all.contains(after))
    };
    analysis.components.of(*first).iter().any(shared) && !steps.iter().any(leads_on)
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
            Event::EachScan(..) => {
                reasons.add(action.span, "an action each scan");
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
