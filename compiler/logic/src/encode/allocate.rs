//! Stored actions (R7): every right side on old values, the last triggered assignment wins, and two that disagree raise
//! ALLOC_CONFLICT.
//!
//! Variables are written one after the other. What reads a variable is written before it; where the reading goes
//! round in a circle, one variable is copied first and the others read the copy.

use crate::analysis::components::Components;
use crate::lower::{Context, Lowering};
use crate::scan::{Flag, Origin, Role, Statement, VarId};
use grafc_formula::{Formula, FormulaId, Type};
use grafc_model::chart::{ExprId, ExprKind, Mode, StepId, TransitionId, VariableId};
use grafc_net::net::Forced;
use grafc_net::{Arcs, Net};
use rustc_hash::FxHashSet;
use std::collections::{BTreeMap, BTreeSet};

/// One assignment and when it is done.
#[derive(Clone, Copy)]
pub(crate) struct Trigger {
    /// True when it is done.
    pub(crate) when: FormulaId,
    /// The right side.
    pub(crate) value: ExprId,
    /// The action.
    pub(crate) origin: Origin,
    /// Where a token has to be for it to be done.
    pub(crate) position: Position,
    /// Whether its being done says by itself that another micro-step is needed.
    pub(crate) repeats: bool,
}

/// Where a token has to be for an event to occur.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Position {
    /// On a step before the micro-step: an event of that step, or its deactivation.
    At(StepId),
    /// On the steps before a transition, which it clears.
    Through(TransitionId),
    /// On a step after the micro-step and not before.
    To(StepId),
}

/// What is known of tokens.
#[derive(Clone, Copy)]
pub(crate) struct Tokens<'a> {
    pub(crate) components: &'a Components,
    pub(crate) arcs: &'a Arcs,
}

/// The assignments of a moment, by variable; of each variable in the order of R7.
pub(crate) type Triggers = BTreeMap<VariableId, Vec<Trigger>>;

/// The statements of all assignments. `again` is told where a value changes and nothing else tells it.
pub(crate) fn statements(
    lowering: &mut Lowering,
    cx: &mut Context,
    triggers: &Triggers,
    tokens: Option<Tokens>,
    again: Option<VarId>,
) -> Vec<Statement> {
    let mut statements = Vec::new();
    for (variable, copied) in order(lowering, triggers) {
        if copied {
            let source = lowering.symbols.declared(variable);
            let (name, ty) = (&lowering.net.variables[variable].name, lowering.net.variables[variable].ty);
            let copy = lowering.symbols.fresh(Role::Temporary, format!("before_{name}"), ty, None);
            let value = lowering.symbols.read(&mut lowering.pool, source);
            statements.push(Statement::assign(Origin::Actions(variable), copy, value));
            one_variable(lowering, cx, variable, &triggers[&variable], tokens, again, &mut statements);
            lowering.redirected.insert(variable, copy);
        } else {
            one_variable(lowering, cx, variable, &triggers[&variable], tokens, again, &mut statements);
        }
    }
    lowering.redirected.clear();
    statements
}

/// The order of writing, and which variables are copied before they are written.
fn order(lowering: &Lowering, triggers: &Triggers) -> Vec<(VariableId, bool)> {
    // For each variable those that must be written before it, because they read it, and the reverse.
    let mut readers: BTreeMap<VariableId, BTreeSet<VariableId>> = BTreeMap::new();
    let mut reads: BTreeMap<VariableId, BTreeSet<VariableId>> = BTreeMap::new();
    for (writer, list) in triggers {
        for trigger in list {
            for read in stored_reads(lowering, trigger.value) {
                if read != *writer && triggers.contains_key(&read) {
                    readers.entry(read).or_default().insert(*writer);
                    reads.entry(*writer).or_default().insert(read);
                }
            }
        }
    }
    let mut waiting: BTreeSet<VariableId> = triggers.keys().copied().collect();
    let mut ready: BTreeSet<VariableId> = waiting.iter().copied().filter(|v| !readers.contains_key(v)).collect();
    let mut order = Vec::with_capacity(waiting.len());
    while let Some(first) = waiting.first().copied() {
        let (variable, copied) = match ready.pop_first() {
            Some(variable) => (variable, false),
            None => (first, true),
        };
        waiting.remove(&variable);
        order.push((variable, copied));
        for read in reads.remove(&variable).unwrap_or_default() {
            if let Some(left) = readers.get_mut(&read) {
                left.remove(&variable);
                if left.is_empty() && waiting.contains(&read) {
                    ready.insert(read);
                }
            }
        }
    }
    order
}

/// The stored variables that a right side reads at the moment of writing; wires, edges and delays were fixed before.
fn stored_reads(lowering: &Lowering, root: ExprId) -> Vec<VariableId> {
    let net = &*lowering.net.clone();
    let mut found = Vec::new();
    let mut stack = vec![root];
    while let Some(e) = stack.pop() {
        match &net.exprs[e].kind {
            ExprKind::Variable(v) => {
                if net.variables[*v].mode == Mode::Stored {
                    found.push(*v);
                }
            }
            ExprKind::Rise(_) | ExprKind::Fall(_) | ExprKind::Delay { .. } => {}
            ExprKind::Literal(_)
            | ExprKind::StepActive(_)
            | ExprKind::StepTime(_)
            | ExprKind::MacroActive(_)
            | ExprKind::GrafcetActive(_)
            | ExprKind::Not(_)
            | ExprKind::And(..)
            | ExprKind::Or(..)
            | ExprKind::Xor(..)
            | ExprKind::Compare(..)
            | ExprKind::Arithmetic(..)
            | ExprKind::Negate(_)
            | ExprKind::Widen(_) => stack.extend(net.exprs[e].kind.operands()),
        }
    }
    found
}

fn one_variable(
    lowering: &mut Lowering,
    cx: &mut Context,
    variable: VariableId,
    triggers: &[Trigger],
    tokens: Option<Tokens>,
    again: Option<VarId>,
    out: &mut Vec<Statement>,
) {
    // A step that nothing leads to is never activated.
    let never = |t: &&Trigger| lowering.pool.as_truth(t.when) == Some(false);
    let triggers: Vec<Trigger> = triggers.iter().filter(|t| !never(t)).copied().collect();
    let triggers = triggers.as_slice();
    if triggers.is_empty() {
        return;
    }
    let exclusive = triggers.len() == 1 || tokens.is_some_and(|t| exclusive(&lowering.net, t, triggers));
    let literals: Option<Vec<FormulaId>> = triggers.iter().map(|t| literal(lowering, t.value)).collect();
    match literals {
        Some(literals) if exclusive || distinct(&literals) <= 2 => {
            constants(lowering, cx, variable, triggers, &literals, exclusive, again, out);
        }
        _ if exclusive => {
            let branches = triggers.iter().map(|t| branch(lowering, cx, variable, t, again)).collect();
            out.extend(choose(lowering, branches));
        }
        _ => one_after_the_other(lowering, cx, variable, triggers, again, out),
    }
}

fn distinct(literals: &[FormulaId]) -> usize {
    literals.iter().collect::<BTreeSet<_>>().len()
}

/// Whether no two of them are ever done in one micro-step, because one component has its token only in one place.
///
/// The token is at one step before the micro-step and at one after it. So events at different steps exclude each other,
/// and so do activations of different steps; an event at one step excludes the activation of another if no transition
/// leads from the one to the other, and of the same step in any case.
fn exclusive(net: &Net, tokens: Tokens, triggers: &[Trigger]) -> bool {
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

fn literal(lowering: &mut Lowering, value: ExprId) -> Option<FormulaId> {
    match lowering.net.exprs[value].kind {
        ExprKind::Literal(v) => Some(lowering.pool.constant(v, lowering.net.exprs[value].ty)),
        _ => None,
    }
}

/// All right sides are literals: one test for a conflict, and branches from the last to the first, so that the last
/// one wins. Neighbours that assign the same value share a branch.
#[allow(clippy::too_many_arguments)]
fn constants(
    lowering: &mut Lowering,
    cx: &mut Context,
    variable: VariableId,
    triggers: &[Trigger],
    literals: &[FormulaId],
    exclusive: bool,
    again: Option<VarId>,
    out: &mut Vec<Statement>,
) {
    if !exclusive {
        let mut by_value: BTreeMap<FormulaId, Vec<FormulaId>> = BTreeMap::new();
        for (trigger, literal) in triggers.iter().zip(literals) {
            by_value.entry(*literal).or_default().push(trigger.when);
        }
        let done: Vec<FormulaId> = by_value.into_values().map(|whens| lowering.pool.or(whens)).collect();
        if let [a, b] = done[..] {
            let conflict = lowering.pool.and([a, b]);
            out.extend(raise_conflict(lowering, Origin::Actions(variable), conflict));
        }
    }
    let mut runs: Vec<(Trigger, FormulaId, Vec<FormulaId>)> = Vec::new();
    for (trigger, literal) in triggers.iter().zip(literals) {
        match runs.last_mut() {
            Some((first, same, whens)) if same == literal && first.repeats == trigger.repeats => {
                first.origin = Origin::Actions(variable);
                whens.push(trigger.when);
            }
            _ => runs.push((*trigger, *literal, vec![trigger.when])),
        }
    }
    if !exclusive {
        runs.reverse();
    }
    let branches = runs
        .into_iter()
        .map(|(first, _, whens)| {
            let when = lowering.pool.or(whens);
            branch(lowering, cx, variable, &Trigger { when, ..first }, again)
        })
        .collect();
    out.extend(choose(lowering, branches));
}

/// The general case: the assignments in order on a new value, each compared with the one before.
fn one_after_the_other(
    lowering: &mut Lowering,
    cx: &mut Context,
    variable: VariableId,
    triggers: &[Trigger],
    again: Option<VarId>,
    out: &mut Vec<Statement>,
) {
    let declared = &lowering.net.variables[variable];
    let (name, ty) = (declared.name.clone(), declared.ty);
    let new = lowering.symbols.fresh(Role::Temporary, format!("new_{name}"), ty, None);
    let given = lowering.symbols.fresh(Role::Temporary, format!("given_{name}"), Type::Bool, None);
    let (read_new, read_given) =
        (lowering.symbols.read(&mut lowering.pool, new), lowering.symbols.read(&mut lowering.pool, given));
    let (yes, no) = (lowering.pool.truth(true), lowering.pool.truth(false));
    out.push(Statement::assign(Origin::Actions(variable), given, no));
    for (index, trigger) in triggers.iter().enumerate() {
        let origin = trigger.origin;
        cx.origin = origin;
        let (mut body, value) = lowering.branch_value(cx, trigger.value);
        if index == 0 {
            body.push(Statement::assign(origin, new, value));
        } else {
            let next = lowering.symbols.fresh(Role::Temporary, format!("next_{name}"), ty, None);
            body.push(Statement::assign(origin, next, value));
            let read_next = lowering.symbols.read(&mut lowering.pool, next);
            let differs = lowering.pool.differs(read_new, read_next);
            let conflict = lowering.pool.and([read_given, differs]);
            body.extend(raise_conflict(lowering, trigger.origin, conflict));
            body.push(Statement::assign(origin, new, read_next));
        }
        body.push(Statement::assign(origin, given, yes));
        out.extend(choose(lowering, vec![(trigger.when, body)]));
    }
    let target = lowering.symbols.declared(variable);
    let mut body = Vec::new();
    if triggers.iter().any(|t| !t.repeats) {
        body.extend(tell_again(lowering, Origin::Actions(variable), target, read_new, again));
    }
    body.push(Statement::assign(Origin::Actions(variable), target, read_new));
    out.extend(choose(lowering, vec![(read_given, body)]));
}

fn branch(
    lowering: &mut Lowering,
    cx: &mut Context,
    variable: VariableId,
    trigger: &Trigger,
    again: Option<VarId>,
) -> (FormulaId, Vec<Statement>) {
    let (target, origin) = (lowering.symbols.declared(variable), trigger.origin);
    cx.origin = origin;
    let (mut body, mut value) = lowering.branch_value(cx, trigger.value);
    if !trigger.repeats && again.is_some() {
        if matches!(lowering.pool.get(value), Formula::Arithmetic(..) | Formula::Negate(_)) {
            let name = format!("new_{}", lowering.net.variables[variable].name);
            let new = lowering.symbols.fresh(Role::Temporary, name, lowering.pool.ty(value), None);
            body.push(Statement::assign(origin, new, value));
            value = lowering.symbols.read(&mut lowering.pool, new);
        }
        body.extend(tell_again(lowering, origin, target, value, again));
    }
    body.push(Statement::assign(origin, target, value));
    (trigger.when, body)
}

/// `again := again OR value <> target`.
fn tell_again(
    lowering: &mut Lowering,
    origin: Origin,
    target: VarId,
    value: FormulaId,
    again: Option<VarId>,
) -> Option<Statement> {
    let again = again?;
    let old = lowering.symbols.read(&mut lowering.pool, target);
    let differs = lowering.pool.differs(old, value);
    let already = lowering.symbols.read(&mut lowering.pool, again);
    let value = lowering.pool.or([already, differs]);
    (value != already).then_some(Statement::assign(origin, again, value))
}

fn raise_conflict(lowering: &mut Lowering, origin: Origin, when: FormulaId) -> Vec<Statement> {
    if lowering.pool.as_truth(when) == Some(false) {
        return Vec::new();
    }
    let target = lowering.symbols.flag(Flag::AllocConflict);
    let value = lowering.pool.truth(true);
    choose(lowering, vec![(when, vec![Statement::assign(origin, target, value)])])
}

/// An IF with these branches, less those that are never taken and what follows one that always is: a source transition
/// on 1 whose clearing is not named, as in the r- and s-trigger, is done otherwise.
pub(crate) fn choose(lowering: &Lowering, branches: Vec<(FormulaId, Vec<Statement>)>) -> Vec<Statement> {
    let mut kept = Vec::with_capacity(branches.len());
    let mut otherwise = Vec::new();
    let mut asked = FxHashSet::default();
    for (when, body) in branches {
        // What has been asked before is not true any more.
        if !asked.insert(when) {
            continue;
        }
        match lowering.pool.as_truth(when) {
            Some(false) => {}
            Some(true) => {
                otherwise = body;
                break;
            }
            None => kept.push((when, body)),
        }
    }
    if kept.is_empty() { otherwise } else { vec![Statement::If { branches: kept, otherwise }] }
}
