//! The micro-step of a small chart: everything is computed in every micro-step, which takes fewer lines than to find out
//! what has to be.
//!
//! ```text
//! next := at;
//! clr_1_2 := …                                      what an action or a short set waits for
//! CASE at OF  3: IF condition THEN next := 4; …     transitions: read the old situation, write the next one
//! IF next <> 5 THEN inner := 0; …                   enclosures and orders (R5), from the top down
//! again := again OR (next <> at);
//! stored actions (R7)                               from both
//! at := next;
//! IF clr_1_2 THEN short := 2; …
//! ```
//!
//! A set of few steps needs no arms and, if no enclosure or order acts on it, no next state: its transitions are latched.

use super::moves::{changes_of, home};
use super::{assign_number, copy, differs, next_in_set, origin_around, uncovered, value_of};
use crate::encode::by_grafcet::sorted;
use crate::encode::choose::choose;
use crate::encode::clearings::{Clearings, StepEvents, clears};
use crate::encode::heading::heading;
use crate::encode::input_event::InputEvent;
use crate::encode::pulses::Pulses;
use crate::encode::state_case::StateCase;
use crate::encode::task::Task;
use crate::encode::{settle, stored};
use crate::lower::cover::FEW;
use crate::lower::situation::{Holder, Set};
use crate::lower::{Context, Lowering};
use crate::scan::{Heading, Origin, Part, Role, Statement, Told};
use ecow::eco_format;
use grafc_formula::{FormulaId, Type};
use grafc_model::chart::{GrafcetId, StepId, TransitionId};
use index_vec::IndexVec;
use indexmap::IndexMap;
use rustc_hash::{FxBuildHasher, FxHashMap, FxHashSet};
use std::collections::BTreeMap;

/// All that follows the memory of edges.
pub(super) fn micro_step(
    lowering: &mut Lowering,
    cx: &mut Context,
    task: &Task,
    input_event: &mut InputEvent,
) -> Vec<Statement> {
    let mut out = Vec::new();
    let (frozen, freezing) = settle::frozen(lowering);
    heading(&mut out, Heading::FrozenGrafcets, freezing);
    let acted_on = settle::acted_on(&lowering.net);
    let sets = lowering.situation.sets.iter();
    let is_short = |set: &Set| set.steps.len() < FEW && !set.steps.iter().any(|s| acted_on[*s]);
    let short: Vec<bool> = sets.map(is_short).collect();
    let (mut clearings, moves) = transitions(lowering, task, &frozen, &short, &mut out);
    let mut acting = Vec::new();
    let mut pulses = lowering.net.has_commands().then(|| Pulses::new(lowering, task, input_event, &mut acting));
    acting.extend(settled(lowering, task, &short, &mut clearings, pulses.as_mut()));
    heading(&mut out, Heading::EnclosuresAndOrders, acting);
    out.extend(tell(lowering, task, &short, &clearings, pulses.as_ref()));
    let step_events = StepEvents::new(lowering, &clearings, task.components);
    let actions = stored::actions(lowering, cx, task, &clearings, step_events, input_event);
    heading(&mut out, Heading::StoredActions, actions);
    let situation = situation(lowering, &short, moves, &clearings);
    sorted(&mut out, lowering, Part::Situation, situation);
    out.extend(pulses.into_iter().flat_map(|pulses| pulses.remembered));
    out
}

/// What short sets become, and when: of each set the values in order of the steps.
type Moves = BTreeMap<(usize, i64), Vec<FormulaId>>;

/// The transitions: in the arms of their first step where only states with a next one hang on them, else latched.
fn transitions<'a>(
    lowering: &mut Lowering,
    task: &Task<'a>,
    frozen: &settle::Frozen,
    short: &[bool],
    out: &mut Vec<Statement>,
) -> (Clearings<'a>, Moves) {
    let net = &*lowering.net.clone();
    let awaited: FxHashSet<TransitionId> = net.awaited_clearings().collect();
    let (mut latched, mut moves, mut of_short) = (Vec::new(), Vec::new(), Moves::new());
    let mut branches: FxHashMap<StepId, Vec<(FormulaId, Vec<Statement>)>> = FxHashMap::default();
    let mut clearings = Clearings::with(task.arcs, net, IndexVec::new());
    for (t, transition) in net.transitions.iter_enumerated() {
        let factors = clears(lowering, t, task.conditions[t], frozen, task.simplify);
        let origin = Origin::Transition(t);
        let mut body = Vec::new();
        let changes = changes_of(lowering, t);
        for (set, value) in changes.iter().filter(|(set, _)| !short[*set]) {
            body.push(assign_number(lowering, origin, lowering.situation.sets[*set].next, *value));
        }
        let in_arm = home(lowering, t).is_some_and(|set| !short[set])
            && !changes.iter().any(|(set, _)| short[*set])
            && !awaited.contains(&t);
        if let Some(first) = transition.pre.first().filter(|_| in_arm) {
            let own = lowering.active(*first);
            body.iter_mut().take(1).for_each(Statement::tell);
            let few = home(lowering, t).is_some_and(|set| lowering.situation.sets[set].steps.len() < FEW);
            if few && !body.is_empty() {
                // Of the transitions of a set at most one clears, so they need not be alternatives.
                let when = lowering.pool.and(factors);
                moves.extend(choose(lowering, vec![(when, body)]));
            } else if !body.is_empty() {
                let when = lowering.pool.and(factors.into_iter().filter(|f| *f != own));
                branches.entry(*first).or_default().push((when, body));
            }
            let never = lowering.pool.truth(false);
            clearings.cleared.push(never);
            continue;
        }
        let value = lowering.pool.and(factors);
        let cleared = if lowering.pool.as_truth(value).is_some() {
            value
        } else {
            let name = eco_format!("clr_{}", lowering.transition_word(t));
            let target = lowering.symbols.fresh(Role::Temporary, name, Type::Bool, None);
            latched.push(Statement::Assign { target, value, origin, told: Told::All });
            lowering.symbols.read(&mut lowering.pool, target)
        };
        clearings.cleared.push(cleared);
        if !body.is_empty() {
            moves.extend(choose(lowering, vec![(cleared, body)]));
        }
        for (set, value) in changes.into_iter().filter(|(set, _)| short[*set]) {
            of_short.entry((set, value)).or_default().push(cleared);
        }
    }
    // All next states begin as the state is: a transition may write several of them.
    let sets = lowering.situation.sets.clone();
    let with_next = || sets.iter().zip(short).filter(|(_, short)| !**short).map(|(set, _)| set);
    let mut moving = Vec::new();
    for set in with_next() {
        moving.push(copy(lowering, Origin::Step(set.steps[0]), set.next, set.variable));
    }
    for set in with_next() {
        let mut arms = StateCase::default();
        for s in &set.steps {
            arms.add(lowering, *s, choose(lowering, branches.remove(s).unwrap_or_default()));
        }
        moving.extend(arms.case(set.variable));
    }
    moving.extend(moves);
    sorted(out, lowering, Part::TransitionsThatClear, latched);
    sorted(out, lowering, Part::Transitions, moving);
    (clearings, of_short)
}

/// Enclosures and orders, grafcet by grafcet from the top down (R5).
fn settled(
    lowering: &mut Lowering,
    task: &Task,
    short: &[bool],
    clearings: &mut Clearings,
    mut pulses: Option<&mut Pulses>,
) -> Vec<Statement> {
    let net = &*lowering.net.clone();
    let acted_on = settle::acted_on(net);
    let mut out = Vec::new();
    for g in &net.hierarchy {
        let around = settle::around(lowering, *g, |lowering, e| uncovered::next(lowering, clearings, e));
        let known = &clearings.next;
        let mut next = |lowering: &mut Lowering, s: StepId| known[s].unwrap_or_else(|| next_in_set(lowering, s));
        let in_force = settle::orders(lowering, task.components, *g, around, &mut next, &mut out);
        let pulses = pulses.as_deref_mut();
        out.extend(uncovered::settle(lowering, clearings, &acted_on, *g, (around, in_force.as_ref()), pulses));
        for (index, is_short) in short.iter().enumerate() {
            if lowering.situation.sets[index].grafcet == *g && !is_short {
                enclose(lowering, *g, index, around, &mut out);
                if let Some(in_force) = &in_force {
                    force(lowering, *g, index, around, in_force, &mut out);
                }
            }
        }
        // Events of covered steps compare the state with the next one, which is final now.
        for s in &net.grafcets[*g].steps {
            if matches!(lowering.situation.holder(*s), Holder::State { set, .. } if !short[set]) {
                clearings.next[*s] = Some(next_in_set(lowering, *s));
            }
        }
    }
    out
}

/// A set is emptied with the step around it, and starts with that (R5a).
fn enclose(lowering: &mut Lowering, g: GrafcetId, index: usize, around: Option<FormulaId>, out: &mut Vec<Statement>) {
    let Some(around) = around else { return };
    let net = &*lowering.net.clone();
    let set = lowering.situation.sets[index].clone();
    let origin = origin_around(net, g);
    let gone = lowering.pool.not(around);
    let mut branches = vec![(gone, vec![assign_number(lowering, origin, set.next, set.idle)])];
    if let Some(first) = set.steps.iter().copied().find(|s| lowering.net.places[*s].activated) {
        let active = lowering.one_active(net.within(g));
        let fresh = lowering.pool.not(active);
        branches.push((fresh, vec![assign_number(lowering, origin, set.next, value_of(lowering, first))]));
    }
    out.extend(choose(lowering, branches));
}

/// The order in force sets a situation (R5b).
fn force(
    lowering: &mut Lowering,
    g: GrafcetId,
    index: usize,
    around: Option<FormulaId>,
    in_force: &settle::InForce,
    out: &mut Vec<Statement>,
) {
    let set = lowering.situation.sets[index].clone();
    // Of all orders one is in force, so those that ask for the same share a branch.
    let mut asked: IndexMap<i64, Vec<FormulaId>, FxBuildHasher> = IndexMap::default();
    for (when, steps) in &in_force.orders {
        let member = steps.iter().find(|s| set.steps.binary_search(s).is_ok());
        asked.entry(member.map_or(set.idle, |s| value_of(lowering, *s))).or_default().push(*when);
    }
    let mut branches = Vec::with_capacity(asked.len());
    for (value, whens) in asked {
        let any = lowering.pool.or(whens);
        let when = lowering.pool.and(around.into_iter().chain([any]));
        branches.push((when, vec![assign_number(lowering, Origin::Orders(g), set.next, value)]));
    }
    out.extend(choose(lowering, branches));
}

/// Another micro-step is needed where a state or a bit changes (R8); edges have spoken before.
fn tell(
    lowering: &mut Lowering,
    task: &Task,
    short: &[bool],
    clearings: &Clearings,
    pulses: Option<&Pulses>,
) -> Option<Statement> {
    let again = task.again?;
    let commanded = lowering.net.commanded();
    let told = |t: TransitionId| {
        let is_commanded = commanded[lowering.net.transitions[t].grafcet];
        is_commanded || changes_of(lowering, t).iter().any(|(set, _)| !short[*set])
    };
    let told: IndexVec<TransitionId, bool> = lowering.net.transitions.indices().map(told).collect();
    let in_short = |s| matches!(lowering.situation.holder(s), Holder::State { set, .. } if short[set]);
    let in_short: IndexVec<StepId, bool> = lowering.net.places.indices().map(in_short).collect();
    let mut terms = Vec::new();
    if !lowering.edges.is_empty() {
        terms.push(lowering.symbols.read(&mut lowering.pool, again));
    }
    for (set, _) in lowering.situation.sets.clone().iter().zip(short).filter(|(_, short)| !**short) {
        terms.push(differs(lowering, set.variable, set.next));
    }
    terms.extend(clearings.changes(lowering, task, |s| in_short[s], |t| told[t]));
    terms.extend(uncovered::commanded(lowering, clearings, pulses));
    if terms.len() == 1 && !lowering.edges.is_empty() {
        return None;
    }
    Some(Statement::assign(Origin::Chart, again, lowering.pool.or(terms)))
}

/// The next situation becomes the situation.
fn situation(lowering: &mut Lowering, short: &[bool], mut moves: Moves, clearings: &Clearings) -> Vec<Statement> {
    let mut out = Vec::new();
    for (index, set) in lowering.situation.sets.clone().into_iter().enumerate() {
        let first = Origin::Step(set.steps[0]);
        if !short[index] {
            out.push(copy(lowering, first, set.variable, set.next));
            continue;
        }
        let values: Vec<(i64, Origin)> = set.steps.iter().map(|s| (value_of(lowering, *s), Origin::Step(*s))).collect();
        for (value, origin) in values.into_iter().chain([(set.idle, first)]) {
            let Some(whens) = moves.remove(&(index, value)) else { continue };
            let when = lowering.pool.or(whens);
            let mut body = vec![assign_number(lowering, origin, set.variable, value)];
            if value != set.idle {
                body.iter_mut().for_each(Statement::tell);
            }
            out.extend(choose(lowering, vec![(when, body)]));
        }
    }
    out.extend(uncovered::commit(lowering, clearings, Told::Comment));
    out
}
