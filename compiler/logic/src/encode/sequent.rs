//! Sequents (Shalyto's method 4): for each transition `IF` it clears, the steps before it are reset and those after it
//! set.
//!
//! A step that is left and entered at once stays active (rule 5), so where that can happen all resets come before all
//! sets. Where it cannot, because every step lies in a component, a transition is one `IF`; and where nothing else looks
//! at clearings, the `IF` tests steps and condition itself, in such an order that a step is written only after all
//! transitions have read it. Where the order is circular, one step is copied and the copy read.

use super::in_order::{Bundle, in_order};
use super::task::Task;
use crate::encode::by_grafcet::headed;
use crate::encode::choose::choose;
use crate::encode::clearings::{Clearings, clears};
use crate::encode::settle;
use crate::lower::Lowering;
use crate::scan::{Heading, Origin, Part, Statement, VarId};
use grafc_model::chart::{StepId, TransitionId};
use std::collections::BTreeMap;

/// Resets and sets, on whatever variable holds a step's next activity.
pub(super) fn moves(
    lowering: &mut Lowering,
    task: &Task,
    clearings: &Clearings,
    target: impl Fn(&Lowering, StepId) -> Option<VarId>,
) -> Vec<Statement> {
    let net = &*lowering.net.clone();
    let entered = |s: &StepId| !task.arcs.entering(*s).is_empty();
    let both_at_once = |s: &StepId| entered(s) && !task.components.covers(*s);
    let (mut resets, mut sets) = (Vec::new(), Vec::new());
    for (t, transition) in net.transitions.iter_enumerated() {
        let write = |lowering: &mut Lowering, s: &StepId, active: bool| {
            let value = lowering.pool.truth(active);
            target(lowering, *s).map(|target| Statement::assign(Origin::Transition(t), target, value))
        };
        let mut early = Vec::new();
        let mut late = Vec::new();
        for s in transition.left() {
            let list = if both_at_once(&s) { &mut early } else { &mut late };
            list.extend(write(lowering, &s, false));
        }
        for s in &transition.post {
            late.extend(write(lowering, s, true));
        }
        for (list, body) in [(&mut resets, early), (&mut sets, late)] {
            if !body.is_empty() {
                list.extend(choose(lowering, vec![(clearings.cleared[t], body)]));
            }
        }
    }
    resets.extend(sets);
    resets
}

/// Transitions as one chain of `IF`s without anything latched; none if something else has to know what clears.
pub(super) fn in_place(lowering: &mut Lowering, task: &Task) -> Option<Vec<Statement>> {
    let net = &*lowering.net.clone();
    let covered = net.places.indices().all(|s| task.components.covers(s));
    let alone = net.stored.is_empty() && !settle::acted_on(net).iter().any(|acted_on| *acted_on);
    if !covered || !alone {
        return None;
    }
    let (frozen, statements) = settle::frozen(lowering);
    // Of the transitions after a step of a component at most one clears, so they are alternatives. A transition after
    // several steps belongs to the first.
    let mut after: BTreeMap<StepId, Vec<TransitionId>> = BTreeMap::new();
    for (t, transition) in net.transitions.iter_enumerated() {
        let nothing_moves = transition.left().is_empty() && transition.entered().is_empty();
        if let Some(first) = transition.pre.first().filter(|_| !nothing_moves) {
            after.entry(*first).or_default().push(t);
        }
    }
    let mut blocks = Vec::new();
    for transitions in after.into_values() {
        let mut branches = Vec::new();
        for t in transitions {
            let factors = clears(lowering, t, task.conditions[t], &frozen, task.simplify);
            branches.push((lowering.pool.and(factors), moved(lowering, task, t)));
        }
        let statements = choose(lowering, branches);
        blocks.push(Bundle::new(lowering, statements, |v| lowering.situation.step_of(v).is_some()));
    }
    let (mut out, mut moving) = (Vec::new(), Vec::new());
    crate::encode::heading::heading(&mut out, Heading::FrozenGrafcets, statements);
    if let Some(target) = task.again.filter(|_| lowering.edges.is_empty()) {
        moving.push(Statement::assign(Origin::Chart, target, lowering.pool.truth(false)));
    }
    in_order(lowering, blocks, &mut moving);
    headed(&mut out, lowering, Part::Transitions, moving);
    Some(out)
}

/// What a clearing does.
fn moved(lowering: &mut Lowering, task: &Task, t: TransitionId) -> Vec<Statement> {
    let transition = &lowering.net.transitions[t];
    let mut body = Vec::new();
    let leaving = transition.left().into_iter().map(|s| (s, false));
    let coming = transition.entered().into_iter().map(|s| (s, true));
    for (s, active) in leaving.chain(coming) {
        let value = lowering.pool.truth(active);
        body.extend(lowering.situation.bit(s).map(|target| Statement::assign(Origin::Transition(t), target, value)));
    }
    if let Some(target) = task.again {
        body.push(Statement::assign(Origin::Transition(t), target, lowering.pool.truth(true)));
    }
    body.iter_mut().take(1).for_each(Statement::tell);
    body
}
