//! Stored actions (R7): every right side on old values, the last triggered assignment wins, and two that disagree raise
//! ALLOC_CONFLICT.
//!
//! Variables are written one after the other, in the order of the chart. What reads a variable is written before it, and
//! says so where the chart has it behind; where the reading goes round in a circle, one variable is copied first and the
//! others read the copy.

mod exclusive;
mod last_wins;
mod order;

use crate::analysis::components::Components;
use crate::encode::choose::{choose, raise};
use crate::lower::{Context, Lowering};
use crate::scan::{Choice, Flag, Origin, Role, Statement, Told, VarId};
use exclusive::exclusive;
use grafc_formula::{Formula, FormulaId};
use grafc_model::chart::{ExprId, ExprKind, StepId, TransitionId, VariableId};
use grafc_net::Arcs;
use order::{Turn, order};
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
    for Turn { variable, copied, before } in order(lowering, triggers) {
        if copied {
            let source = lowering.symbols.declared(variable);
            let (name, ty) = (&lowering.net.variables[variable].name, lowering.net.variables[variable].ty);
            let copy = lowering.symbols.fresh(Role::Temporary, format!("before_{name}"), ty, None);
            let value = lowering.symbols.read(&mut lowering.pool, source);
            statements.push(Statement::assign(Origin::Actions(variable), copy, value));
            one_variable(lowering, cx, variable, &triggers[&variable], tokens, again, &mut statements);
            lowering.redirected.insert(variable, copy);
        } else {
            let start = statements.len();
            one_variable(lowering, cx, variable, &triggers[&variable], tokens, again, &mut statements);
            if let Some(read) = before {
                say_why(lowering, variable, read, &mut statements[start..]);
            }
        }
    }
    lowering.redirected.clear();
    statements
}

/// Says beside what is written of a variable that it reads another before that is written. Statements nest no deeper than
/// lowering nests them.
fn say_why(lowering: &Lowering, variable: VariableId, read: VariableId, statements: &mut [Statement]) {
    let (writes, reads) = (lowering.symbols.declared(variable), lowering.symbols.declared(read));
    for statement in statements {
        match statement {
            Statement::Assign { target, value, told, .. } => {
                let of_it = |f: &FormulaId| matches!(lowering.pool.get(*f), Formula::Variable(v) if *v == reads);
                if *target == writes && lowering.pool.below(*value).iter().any(of_it) {
                    *told = Told::Before(read);
                }
            }
            Statement::If(choice) => {
                let Choice { branches, otherwise } = &mut **choice;
                branches.iter_mut().for_each(|(_, body)| say_why(lowering, variable, read, body));
                say_why(lowering, variable, read, otherwise);
            }
            Statement::Heading(_) | Statement::Divide(_) | Statement::CallTimer { .. } | Statement::Case { .. } => {}
        }
    }
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
        _ => last_wins::write(lowering, cx, variable, triggers, again, out),
    }
}

fn distinct(literals: &[FormulaId]) -> usize {
    literals.iter().collect::<BTreeSet<_>>().len()
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
            out.extend(raise(lowering, Flag::AllocConflict, Origin::Actions(variable), conflict));
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

fn branch(
    lowering: &mut Lowering,
    cx: &mut Context,
    variable: VariableId,
    trigger: &Trigger,
    again: Option<VarId>,
) -> (FormulaId, Vec<Statement>) {
    cx.origin = trigger.origin;
    let value = lowering.branch_value(cx, trigger.value);
    branch_with(lowering, variable, trigger, value, again)
}

/// The branch of an assignment, of the statements that find its value, and of that.
fn branch_with(
    lowering: &mut Lowering,
    variable: VariableId,
    trigger: &Trigger,
    (mut body, mut value): (Vec<Statement>, FormulaId),
    again: Option<VarId>,
) -> (FormulaId, Vec<Statement>) {
    let (target, origin) = (lowering.symbols.declared(variable), trigger.origin);
    if !trigger.repeats && again.is_some() {
        if matches!(lowering.pool.get(value), Formula::Arithmetic(..) | Formula::Negate(_)) {
            let name = format!("new_{}", lowering.net.variables[variable].name);
            let new = lowering.symbols.fresh(Role::Temporary, name, lowering.pool.ty(value), None);
            body.push(Statement::assign(origin, new, value));
            value = lowering.symbols.read(&mut lowering.pool, new);
        }
        body.extend(tell_again(lowering, origin, target, value, again));
    }
    let told = if matches!(origin, Origin::Action(_)) { Told::Name } else { Told::Nothing };
    body.push(Statement::Assign { target, value, origin, told });
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
