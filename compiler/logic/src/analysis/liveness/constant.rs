//! Conditions that always hold, or never: `a and not a`, `0`, `a or not a`.
//!
//! Most conditions name each of their operands once and hold no constant; whatever their operators are, such a condition
//! can be true and can be false. Only the others are given to the decision diagrams. A constant of the chart counts as
//! unknown: what it switches off is meant.

use crate::analysis::together::questions::Questions;
use grafc_model::chart::{Event, ExprId, ExprKind, TransitionId, Value, below};
use grafc_net::Net;
use rustc_hash::FxHashSet;

/// A condition that is constant.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Constant {
    pub(crate) condition: ExprId,
    pub(crate) value: bool,
    /// The transition that it belongs to; none if it is that of an action.
    pub(crate) transition: Option<TransitionId>,
}

/// All of them, but those that are written as `1` or `true`.
pub(super) fn find(asked: &mut Questions) -> Vec<Constant> {
    let net = asked.analysis.net();
    let transitions = net.transitions.iter_enumerated().map(|(t, transition)| (transition.condition, Some(t)));
    let assigned = net.continuous.iter().filter_map(|action| Some((action.condition?, None)));
    let events = net.awaited().filter_map(|event| match event {
        Event::Event(_, event) | Event::EachScan(_, Some(event)) => Some((event, None)),
        Event::EachScan(_, None) | Event::Activation(_) | Event::Deactivation(_) | Event::Clearing(_) => None,
    });
    let all: Vec<(ExprId, Option<TransitionId>)> = transitions.chain(assigned).chain(events).collect();
    let suspicious = all.into_iter().filter(|(condition, _)| is_suspicious(asked.analysis.net(), *condition));
    let suspicious: Vec<_> = suspicious.collect();
    let constant = |(condition, transition)| {
        let value = truth(asked, condition)?;
        Some(Constant { condition, value, transition })
    };
    suspicious.into_iter().filter_map(constant).collect()
}

/// What a condition always is, if that is proved.
fn truth(asked: &mut Questions, condition: ExprId) -> Option<bool> {
    let formula = asked.formula(condition);
    let known = asked.truth(formula);
    if known.is_some() {
        return known;
    }
    if asked.exclude(formula, formula) {
        return Some(false);
    }
    let opposite = asked.literal(formula, false);
    asked.exclude(opposite, opposite).then_some(true)
}

/// Whether a condition may be constant: it names something twice, holds a constant, or compares twice.
fn is_suspicious(net: &Net, condition: ExprId) -> bool {
    if net.exprs[condition].kind == ExprKind::Literal(Value::Bool(true)) {
        return false;
    }
    // Most conditions are one name.
    if net.exprs[condition].kind.operands().next().is_none() {
        return matches!(net.exprs[condition].kind, ExprKind::Literal(_));
    }
    let mut seen = FxHashSet::default();
    let (mut comparisons, mut operands) = (0, 0);
    for e in below(&net.exprs, condition) {
        let named = match net.exprs[e].kind {
            ExprKind::Variable(v) => Some((0, v.index())),
            ExprKind::StepActive(s) => Some((1, s.index())),
            ExprKind::StepTime(s) => Some((2, s.index())),
            ExprKind::MacroActive(m) => Some((3, m.index())),
            ExprKind::GrafcetActive(g) => Some((4, g.index())),
            ExprKind::GrafcetFrozen(g) => Some((5, g.index())),
            ExprKind::Literal(Value::Bool(_)) => return true,
            ExprKind::Compare(..) => {
                comparisons += 1;
                None
            }
            ExprKind::Literal(_)
            | ExprKind::Not(_)
            | ExprKind::And(..)
            | ExprKind::Or(..)
            | ExprKind::Xor(..)
            | ExprKind::Rise(_)
            | ExprKind::Fall(_)
            | ExprKind::Delay { .. }
            | ExprKind::Arithmetic(..)
            | ExprKind::Negate(_)
            | ExprKind::Widen(_) => None,
        };
        if let Some(name) = named {
            operands += 1;
            if !seen.insert(name) {
                return true;
            }
        }
    }
    comparisons > 1 || operands == 0
}
