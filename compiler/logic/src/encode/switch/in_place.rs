//! Charts in which nothing has to wait: a transition writes the states and switches their outputs itself.

use super::super::in_order::{Bundle, in_order};
use super::moves::changes_of;
use super::{assign_number, assign_truth};
use crate::encode::by_grafcet::headed;
use crate::encode::choose::choose;
use crate::encode::clearings::clears;
use crate::encode::heading::heading;
use crate::encode::outputs::Followers;
use crate::encode::settle;
use crate::encode::state_case::StateCase;
use crate::encode::task::Task;
use crate::lower::Lowering;
use crate::scan::{Heading, Origin, Part, Statement, VarId};
use grafc_formula::FormulaId;
use grafc_model::chart::{StepId, TransitionId, VariableId};
use rustc_hash::FxHashSet;
use std::collections::BTreeMap;

/// The transitions of a chart in which nothing has to wait.
pub(super) fn in_place(lowering: &mut Lowering, task: &Task) -> Vec<Statement> {
    let net = &*lowering.net.clone();
    let (frozen, freezing) = settle::frozen(lowering);
    let mut branches: BTreeMap<StepId, Vec<(FormulaId, Vec<Statement>)>> = BTreeMap::new();
    for (t, transition) in net.transitions.iter_enumerated() {
        // A transition stands in the arm of a step before it, if a state holds one. No set covers a step that a transition
        // without steps before it leads to.
        let in_state = |s: &&StepId| lowering.situation.bit(**s).is_none();
        let Some(first) = transition.pre.iter().find(in_state).or(transition.pre.first()).copied() else { continue };
        let changes = changes_of(lowering, t);
        let own = lowering.situation.bit(first).is_none().then(|| lowering.active(first));
        let factors = clears(lowering, t, task.conditions[t], &frozen, task.simplify);
        let when = lowering.pool.and(factors.into_iter().filter(|f| Some(*f) != own));
        let mut body = Vec::new();
        for (set, value) in &changes {
            body.push(assign_number(lowering, Origin::Transition(t), lowering.situation.sets[*set].variable, *value));
        }
        // A step that is left is none that is entered, since a set of its own holds it.
        let leaves = transition.left().into_iter().map(|s| (s, false));
        let enters = transition.entered().into_iter().map(|s| (s, true));
        for (s, active) in leaves.chain(enters) {
            if let Some(bit) = lowering.situation.bit(s) {
                body.push(assign_truth(lowering, Origin::Transition(t), bit, active));
            }
        }
        let moves = !body.is_empty();
        if let Some(followers) = task.followers {
            body.extend(switched(lowering, followers, t));
        }
        if let Some(again) = task.again.filter(|_| moves) {
            body.push(assign_truth(lowering, Origin::Transition(t), again, true));
        }
        body.iter_mut().take(1).for_each(Statement::tell);
        if !body.is_empty() {
            branches.entry(first).or_default().push((when, body));
        }
    }
    let mut out = Vec::new();
    heading(&mut out, Heading::FrozenGrafcets, freezing);
    let mut moving = Vec::new();
    if let Some(again) = task.again.filter(|_| lowering.edges.is_empty()) {
        moving.push(assign_truth(lowering, Origin::Chart, again, false));
    }
    // A condition reads states, and outputs that follow a state: as they were before the micro-step (R3).
    let states = lowering.situation.sets.iter().map(|set| set.variable);
    let wires = task.followers.iter().flat_map(|followers| followers.of_set.iter().flatten());
    let bits = net.places.indices().filter_map(|s| lowering.situation.bit(s));
    let written: FxHashSet<VarId> = states.chain(wires.map(|v| lowering.symbols.declared(*v))).chain(bits).collect();
    let mut blocks = Vec::new();
    for set in lowering.situation.sets.clone() {
        let mut arms = StateCase::default();
        for s in &set.steps {
            arms.add(lowering, *s, choose(lowering, branches.remove(s).unwrap_or_default()));
        }
        if let Some(case) = arms.case(set.variable) {
            blocks.push(Bundle::new(lowering, vec![case], |v| written.contains(&v)));
        }
    }
    for branches in branches.into_values() {
        let statements = choose(lowering, branches);
        blocks.push(Bundle::new(lowering, statements, |v| written.contains(&v)));
    }
    in_order(lowering, blocks, &mut moving);
    headed(&mut out, lowering, Part::Transitions, moving);
    out
}

/// The outputs that a clearing switches.
fn switched(lowering: &mut Lowering, followers: &Followers, t: TransitionId) -> Vec<Statement> {
    let net = &*lowering.net.clone();
    let transition = &net.transitions[t];
    // Of each wire whether the step left leaves it true for certain, and whether the step entered makes it so.
    let mut wires: BTreeMap<VariableId, (Option<bool>, bool)> = BTreeMap::new();
    let mut origins: BTreeMap<VariableId, Origin> = BTreeMap::new();
    for s in transition.left() {
        for (wire, conditions) in followers.on_step(net, s) {
            wires.entry(wire).or_default().0 = Some(conditions.is_empty());
            origins.insert(wire, followers.origin(net, s, wire));
        }
    }
    for s in transition.entered() {
        for (wire, conditions) in followers.on_step(net, s) {
            wires.entry(wire).or_default().1 |= conditions.is_empty();
            origins.insert(wire, followers.origin(net, s, wire));
        }
    }
    let mut out = Vec::new();
    for (wire, change) in wires {
        let value = match change {
            (Some(true), true) | (None, false) => continue,
            (_, entered) => entered,
        };
        let target = lowering.symbols.declared(wire);
        out.push(assign_truth(lowering, origins[&wire], target, value));
    }
    out
}
