//! What the steps of a sequential function chart set by continuous actions.
//!
//! What one step alone sets, or several that never hand over to each other, is an action of each. Of others the value as a
//! whole is found once, behind the chart, if all that it reads is known there; else each of the variable's steps computes
//! it as a whole: so it does not matter in which order steps are left and entered. What a step sets from a time on, or
//! for a time, has a qualifier of its own.

use super::expressions::Expressions;
use super::{During, Hold, Reasons, SequenceStep, own};
use crate::analysis::Analysis;
use grafc_diagnostics::Span;
use grafc_formula::{Comparison, FormulaId, Type, Value};
use grafc_model::chart::{Continuous, ExprId, ExprKind, Mode, StepId, VariableId, VariableKind, below};
use grafc_model::reaction::Evolution;
use grafc_net::Net;
use index_vec::IndexVec;
use rustc_hash::FxHashSet;
use std::collections::BTreeMap;

/// Notes with the steps what continuous actions set.
pub(super) fn continuous(
    analysis: &Analysis,
    steps: &mut IndexVec<StepId, SequenceStep>,
    expressions: &mut Expressions,
    reasons: &mut Reasons,
) {
    let net = analysis.net();
    let mut of: BTreeMap<VariableId, Vec<&Continuous>> = BTreeMap::new();
    for action in &net.continuous {
        of.entry(action.target).or_default().push(action);
    }
    for (variable, actions) in of {
        let mut by_step: BTreeMap<StepId, Vec<&Continuous>> = BTreeMap::new();
        for action in &actions {
            by_step.entry(action.step).or_default().push(action);
        }
        let places: Vec<StepId> = by_step.keys().copied().collect();
        let target = expressions.declared(variable);
        let reads = actions.iter().filter(|action| reads_stored(net, action));
        let reads: Vec<Span> = reads.map(|action| action.span).collect();
        if reads.is_empty() && (places.len() == 1 || never_meet(analysis, &places)) {
            for (step, own) in by_step {
                let during = expressions.during(step, &own, reasons);
                steps[step].holds.push(Hold { target, during });
            }
            continue;
        }
        let owner = own(&places).filter(|_| reads.is_empty());
        let value = expressions.whole(&actions, owner, reasons);
        if net.variables[variable].kind == VariableKind::Output && expressions.is_known_outside(value) {
            expressions.afterwards(variable, value);
            continue;
        }
        for span in reads {
            reasons.add(span, "reads what an action stores in the same scan");
        }
        places.into_iter().for_each(|step| steps[step].holds.push(Hold { target, during: During::Value(value) }));
    }
}

/// Whether the condition of an action reads what is stored: the value is that at the end of the scan.
fn reads_stored(net: &Net, action: &Continuous) -> bool {
    let roots = action.condition.into_iter();
    roots.flat_map(|root| below(&net.exprs, root)).any(|id| match net.exprs[id].kind {
        ExprKind::Variable(variable) => net.variables[variable].mode == Mode::Stored,
        _ => false,
    })
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

impl Expressions<'_> {
    /// While what a step sets a variable that no other sets at the same time.
    fn during(&mut self, step: StepId, actions: &[&Continuous], reasons: &mut Reasons) -> During {
        match actions {
            _ if actions.iter().any(|action| action.condition.is_none()) => During::Step,
            [Continuous { condition: Some(condition), .. }] => match self.timed(*condition, step) {
                Some(during) => during,
                None => During::Value(self.whole(actions, Some(step), reasons)),
            },
            _ => During::Value(self.whole(actions, Some(step), reasons)),
        }
    }

    /// The value of what several actions set, in terms of the situation.
    fn whole(&mut self, actions: &[&Continuous], owner: Option<StepId>, reasons: &mut Reasons) -> FormulaId {
        let mut terms = Vec::new();
        for action in actions {
            let active = self.active(action.step, owner);
            let condition = action.condition.map(|condition| self.formula(condition, owner, reasons));
            terms.push(self.pool.and([Some(active), condition].into_iter().flatten()));
        }
        self.pool.or(terms)
    }

    /// A condition that compares the time of a step with a certain one.
    fn timed(&mut self, condition: ExprId, step: StepId) -> Option<During> {
        let (mut id, mut negated) = (condition, false);
        while let ExprKind::Not(inner) = self.net.exprs[id].kind {
            (id, negated) = (inner, !negated);
        }
        let is_time = |id: ExprId| self.net.exprs[id].kind == ExprKind::StepTime(step);
        let is_active = |id: ExprId| self.net.exprs[id].kind == ExprKind::StepActive(step);
        let (late, limit) = match self.net.exprs[id].kind {
            ExprKind::Compare(Comparison::GreaterEqual, a, b) if is_time(a) => (true, self.limit(b)?),
            ExprKind::Compare(Comparison::LessEqual, a, b) if is_time(b) => (true, self.limit(a)?),
            ExprKind::Compare(Comparison::Less, a, b) if is_time(a) => (false, self.limit(b)?),
            ExprKind::Compare(Comparison::Greater, a, b) if is_time(b) => (false, self.limit(a)?),
            // Scan by scan a delay begins a scan after its step.
            ExprKind::Delay { on, operand, off }
                if is_active(operand) && off.ms == 0 && self.profile.evolution == Evolution::Stable =>
            {
                let constant = on.constant.map(|constant| self.declared(constant));
                let limit = match constant {
                    Some(constant) => self.pool.variable(constant, Type::Time),
                    None => self.pool.constant(Value::Time(on.ms), Type::Time),
                };
                (true, limit)
            }
            _ => return None,
        };
        Some(if late != negated { During::From(limit) } else { During::For(limit) })
    }

    /// A time that stays as it is, if it is more than none.
    fn limit(&mut self, id: ExprId) -> Option<FormulaId> {
        let variable = match self.net.exprs[id].kind {
            ExprKind::Literal(Value::Time(ms)) if ms > 0 => {
                return Some(self.pool.constant(Value::Time(ms), Type::Time));
            }
            ExprKind::Variable(variable) => variable,
            _ => return None,
        };
        let declared = &self.net.variables[variable];
        let is_some =
            declared.kind == VariableKind::Constant && matches!(declared.initial(), Value::Time(ms) if ms > 0);
        is_some.then(|| self.pool.variable(self.declared(variable), Type::Time))
    }
}
