//! Assignments of which several may be done at once: the last one wins, and the flag tells if another gave another value.
//!
//! ```text
//! IF c3 THEN v := e3; ELSIF c2 THEN v := e2; ELSIF c1 THEN v := e1; END_IF;
//! ALLOC_CONFLICT := ALLOC_CONFLICT OR (c1 AND (v <> e1)) OR (c2 AND (v <> e2));
//! ```
//!
//! All that are done agree if each of them gave the value that stays. Right sides with operators are computed before, from
//! old values.

use super::{Trigger, branch_with, tell_again};
use crate::encode::choose::{choose, raise};
use crate::lower::{Context, Lowering};
use crate::scan::{Flag, Origin, Role, Statement, VarId};
use ecow::eco_format;
use grafc_formula::{Formula, FormulaId, Type};
use grafc_model::chart::VariableId;
use indexmap::IndexMap;
use rustc_hash::{FxBuildHasher, FxHashMap};

/// The statements of all assignments of a variable.
pub(super) fn write(
    lowering: &mut Lowering,
    cx: &mut Context,
    variable: VariableId,
    triggers: &[Trigger],
    again: Option<VarId>,
    out: &mut Vec<Statement>,
) {
    // Each right side is lowered once: what it defines, the lowering defines only once.
    let mut lowered = Vec::with_capacity(triggers.len());
    for trigger in triggers {
        cx.origin = trigger.origin;
        lowered.push(lowering.branch_value(cx, trigger.value));
    }
    let divides = |(body, _): &(Vec<Statement>, FormulaId)| body.iter().any(|s| matches!(s, Statement::Divide(_)));
    if lowered.iter().any(divides) {
        return one_after_the_other(lowering, variable, triggers, lowered, again, out);
    }
    let (values, before) = right_sides(lowering, variable, triggers, lowered);
    out.extend(before);
    let both = triggers.iter().zip(&values);
    let branches =
        both.rev().map(|(t, value)| branch_with(lowering, variable, t, (Vec::new(), *value), again)).collect();
    out.extend(choose(lowering, branches));
    let mut done: IndexMap<FormulaId, Vec<FormulaId>, FxBuildHasher> = IndexMap::default();
    for (trigger, value) in triggers.iter().zip(&values).take(triggers.len() - 1) {
        done.entry(*value).or_default().push(trigger.when);
    }
    let target = lowering.symbols.declared(variable);
    let stays = lowering.symbols.read(&mut lowering.pool, target);
    let flag = lowering.symbols.flag(Flag::AllocConflict);
    let mut terms = vec![lowering.symbols.read(&mut lowering.pool, flag)];
    for (value, whens) in done {
        let (when, other) = (lowering.pool.or(whens), lowering.pool.differs(stays, value));
        terms.push(lowering.pool.and([when, other]));
    }
    let raised = lowering.pool.or(terms);
    out.push(Statement::assign(Origin::Actions(variable), flag, raised));
}

/// The right sides as variables or constants that the writing leaves as they are, and the statements that find them.
fn right_sides(
    lowering: &mut Lowering,
    variable: VariableId,
    triggers: &[Trigger],
    lowered: Vec<(Vec<Statement>, FormulaId)>,
) -> (Vec<FormulaId>, Vec<Statement>) {
    let target = lowering.symbols.declared(variable);
    let (mut values, mut before) = (Vec::with_capacity(triggers.len()), Vec::new());
    let mut known: FxHashMap<FormulaId, FormulaId> = FxHashMap::default();
    for (trigger, (body, value)) in triggers.iter().zip(lowered) {
        before.extend(body);
        let written = matches!(lowering.pool.get(value), Formula::Variable(v) if *v == target);
        if lowering.pool.is_leaf(value) && !written {
            values.push(value);
            continue;
        }
        let read = *known.entry(value).or_insert_with(|| {
            let declared = &lowering.net.variables[variable];
            let (name, ty) = (eco_format!("new_{}", declared.name), declared.ty);
            let new = lowering.symbols.fresh(Role::Temporary, name, ty, None);
            before.push(Statement::assign(trigger.origin, new, value));
            lowering.symbols.read(&mut lowering.pool, new)
        });
        values.push(read);
    }
    (values, before)
}

/// The assignments in order on a new value, each compared with the one before: a right side that divides is computed only
/// where it is stored, since it may raise a flag.
fn one_after_the_other(
    lowering: &mut Lowering,
    variable: VariableId,
    triggers: &[Trigger],
    lowered: Vec<(Vec<Statement>, FormulaId)>,
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
    for (index, (trigger, (mut body, value))) in triggers.iter().zip(lowered).enumerate() {
        let origin = trigger.origin;
        if index == 0 {
            body.push(Statement::assign(origin, new, value));
        } else {
            let next = lowering.symbols.fresh(Role::Temporary, format!("next_{name}"), ty, None);
            body.push(Statement::assign(origin, next, value));
            let read_next = lowering.symbols.read(&mut lowering.pool, next);
            let differs = lowering.pool.differs(read_new, read_next);
            let conflict = lowering.pool.and([read_given, differs]);
            body.extend(raise(lowering, Flag::AllocConflict, trigger.origin, conflict));
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
