//! Delays, and durations of steps that are compared with a time: what measures each, and when it is over.

use super::actions::places;
use crate::lower::{LoweredDelay, Lowering};
use crate::scan::{ActionId, Origin, Preset, SeenDelay};
use crate::spell::in_signs;
use grafc_model::chart::{Comparison, ExprId, ExprKind, StepId, Value, VariableId, VariableKind};
use grafc_net::Net;
use rustc_hash::{FxHashMap, FxHashSet};

/// All of them as they are seen.
pub(super) fn seen(lowering: &Lowering) -> Vec<SeenDelay> {
    let net = &*lowering.net;
    let places = places(net);
    let targets = net.continuous.iter().map(|a| a.target).chain(net.stored.iter().map(|a| a.target));
    let mut first: FxHashMap<VariableId, ActionId> = FxHashMap::default();
    for (a, target) in targets.enumerate() {
        first.entry(target).or_insert(ActionId::from(a));
    }
    let mut seen: Vec<SeenDelay> = Vec::new();
    for LoweredDelay { expr, origin, timer, held } in &lowering.delays {
        let total = lowering.timers[*timer].given_preset();
        // Of all actions on a variable the first.
        let origin = match origin {
            Origin::Actions(v) => first.get(v).map_or(*origin, |a| Origin::Action(*a)),
            Origin::Chart
            | Origin::Step(_)
            | Origin::Transition(_)
            | Origin::Action(_)
            | Origin::Order(_)
            | Origin::Orders(_)
            | Origin::Declaration(_) => *origin,
        };
        let action = match origin {
            Origin::Action(a) => places.get(a.index()).copied(),
            Origin::Chart
            | Origin::Step(_)
            | Origin::Transition(_)
            | Origin::Actions(_)
            | Origin::Order(_)
            | Origin::Orders(_)
            | Origin::Declaration(_) => None,
        };
        seen.push(SeenDelay { origin, action, text: in_signs(net, *expr), timer: *timer, total, held: *held });
    }
    let mut known: FxHashSet<(StepId, i64)> = FxHashSet::default();
    for (id, expr) in net.exprs.iter_enumerated() {
        let ExprKind::Compare(op, a, b) = expr.kind else { continue };
        let Some((step, op, time)) = duration(net, op, a, b) else { continue };
        let Some(timer) = lowering.step_timers.get(&step) else { continue };
        // The instant from which on the comparison has another value.
        let ms = match op {
            Comparison::GreaterEqual | Comparison::Less | Comparison::Equal | Comparison::NotEqual => time,
            Comparison::Greater | Comparison::LessEqual => time.saturating_add(1),
        };
        if ms > 0 && known.insert((step, ms)) {
            let total = Preset { ms, constant: None };
            let text = in_signs(net, id);
            seen.push(SeenDelay { origin: Origin::Step(step), action: None, text, timer: *timer, total, held: None });
        }
    }
    seen
}

/// A comparison of the duration of a step with a constant.
fn duration(net: &Net, op: Comparison, a: ExprId, b: ExprId) -> Option<(StepId, Comparison, i64)> {
    let step = |e: ExprId| match net.exprs[e].kind {
        ExprKind::StepTime(s) => Some(s),
        _ => None,
    };
    let time = |e: ExprId| match net.exprs[e].kind {
        ExprKind::Literal(Value::Time(ms)) => Some(ms),
        ExprKind::Variable(v) if net.variables[v].kind == VariableKind::Constant => match net.variables[v].initial() {
            Value::Time(ms) => Some(ms),
            Value::Bool(_) | Value::Int(_) | Value::Real(_) => None,
        },
        _ => None,
    };
    let turned = match op {
        Comparison::Less => Comparison::Greater,
        Comparison::LessEqual => Comparison::GreaterEqual,
        Comparison::Greater => Comparison::Less,
        Comparison::GreaterEqual => Comparison::LessEqual,
        Comparison::Equal | Comparison::NotEqual => op,
    };
    match (step(a), step(b)) {
        (Some(s), None) => Some((s, op, time(b)?)),
        (None, Some(s)) => Some((s, turned, time(a)?)),
        (Some(_), Some(_)) | (None, None) => None,
    }
}
