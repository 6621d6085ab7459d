//! Causes of changes of values: expressions (X1-X6), wires, activities of macro-steps and grafcets.
//!
//! A Boolean operator is followed in its sense: a conjunction becomes true because an operand does. Two forms need
//! more care:
//!
//! - An *edge* (X4) is true in the micro-step in which its operand changes, and false again in the next. An expression
//!   that is false wherever all its edges are, as `a·↑b` is, is called an event: that it is true in a later micro-step
//!   than the first, not only that it has become so, needs one of these edges in this micro-step. Of a conjunction one
//!   event suffices as a cause.
//! - A *delay* (X5) in whose operand nothing changes keeps its value, since the time does not move. An on-delay of more
//!   than zero starts when its operand rises and cannot have run out; an off-delay of more than zero holds when its
//!   operand falls. So the first never lets a value rise within a reaction, nor the second let it fall.

use super::causes::{Causes, Change, Way};
use super::stable::Stable;
use grafc_model::chart::{Comparison, ExprId, ExprKind, GrafcetId, Mode, Value, VariableKind};
use grafc_net::Net;
use index_vec::IndexVec;

/// Whether an expression is an event.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) enum Occasion {
    /// Not an event: it may be true without an edge.
    Level,
    /// An event that may occur in any micro-step.
    Any,
    /// An event of inputs only, which occurs in the first micro-step or not at all.
    First,
}

/// Which expressions are events.
pub(super) fn occasions(net: &Net, stable: &Stable) -> IndexVec<ExprId, Occasion> {
    let mut occasions: IndexVec<ExprId, Occasion> = IndexVec::with_capacity(net.exprs.len());
    for expr in &net.exprs {
        occasions.push(match expr.kind {
            ExprKind::Rise(operand) | ExprKind::Fall(operand) => {
                if stable.is_fixed(operand) {
                    Occasion::First
                } else {
                    Occasion::Any
                }
            }
            ExprKind::And(a, b) => occasions[a].max(occasions[b]),
            ExprKind::Or(a, b) => occasions[a].min(occasions[b]),
            ExprKind::Literal(Value::Bool(false)) => Occasion::First,
            ExprKind::Literal(_)
            | ExprKind::Variable(_)
            | ExprKind::StepActive(_)
            | ExprKind::StepTime(_)
            | ExprKind::MacroActive(_)
            | ExprKind::GrafcetActive(_)
            | ExprKind::GrafcetFrozen(_)
            | ExprKind::Not(_)
            | ExprKind::Xor(..)
            | ExprKind::Delay { .. }
            | ExprKind::Compare(..)
            | ExprKind::Arithmetic(..)
            | ExprKind::Negate(_)
            | ExprKind::Widen(_) => Occasion::Level,
        });
    }
    occasions
}

/// Adds the causes of all changes of values.
pub(super) fn add(net: &Net, occasions: &IndexVec<ExprId, Occasion>, causes: &mut Causes) {
    for e in net.exprs.indices() {
        expression(net, occasions, e, causes);
    }
    for action in &net.continuous {
        let wire = |way| Change::Variable(action.target, way);
        causes.next(Change::Activated(action.step), wire(Way::Up));
        causes.next(Change::Deactivated(action.step), wire(Way::Down));
        if let Some(condition) = action.condition {
            Way::BOTH.into_iter().for_each(|way| causes.at_once(Change::Expr(condition, way), wire(way)));
        }
    }
    for (m, macro_step) in net.macro_steps.iter_enumerated() {
        for place in &macro_step.places {
            causes.next(Change::Activated(*place), Change::Macro(m, Way::Up));
            causes.next(Change::Deactivated(*place), Change::Macro(m, Way::Down));
        }
        for inner in &macro_step.inner {
            Way::BOTH.into_iter().for_each(|way| causes.at_once(Change::Macro(*inner, way), Change::Macro(m, way)));
        }
    }
    let mut read: IndexVec<GrafcetId, bool> = net.grafcets.iter().map(|_| false).collect();
    for expr in &net.exprs {
        if let ExprKind::GrafcetActive(g) = expr.kind {
            read[g] = true;
        }
    }
    for (s, place) in net.places.iter_enumerated().filter(|(_, place)| read[place.grafcet]) {
        causes.next(Change::Activated(s), Change::Grafcet(place.grafcet, Way::Up));
        causes.next(Change::Deactivated(s), Change::Grafcet(place.grafcet, Way::Down));
    }
}

fn expression(net: &Net, occasions: &IndexVec<ExprId, Occasion>, e: ExprId, causes: &mut Causes) {
    let to = |way| Change::Expr(e, way);
    let mut follow = |a: ExprId, way: Way, to: Change| causes.at_once(Change::Expr(a, way), to);
    match net.exprs[e].kind {
        ExprKind::Literal(_) => {}
        ExprKind::Variable(v) => match (net.variables[v].mode, net.variables[v].kind) {
            (Mode::Wire, _) => {
                Way::BOTH.into_iter().for_each(|way| causes.at_once(Change::Variable(v, way), to(way)));
            }
            (Mode::Stored, _) => {
                Way::BOTH.into_iter().for_each(|way| causes.next(Change::Variable(v, way), to(way)));
                if net.variables[v].momentary {
                    causes.start(to(Way::Down));
                }
            }
            (Mode::Given, VariableKind::Input) => Way::BOTH.into_iter().for_each(|way| causes.start(to(way))),
            (Mode::Given, VariableKind::Output | VariableKind::Internal | VariableKind::Constant) => {}
        },
        ExprKind::StepActive(s) => {
            causes.next(Change::Activated(s), to(Way::Up));
            causes.next(Change::Deactivated(s), to(Way::Down));
        }
        // X2: zero after the activation as before it; it is more at the deactivation only.
        ExprKind::StepTime(s) => {
            Way::BOTH.into_iter().for_each(|way| causes.start(to(way)));
            causes.next(Change::Deactivated(s), to(Way::Down));
        }
        ExprKind::MacroActive(m) => {
            Way::BOTH.into_iter().for_each(|way| causes.at_once(Change::Macro(m, way), to(way)));
        }
        // No bound is looked for where pulse orders act.
        ExprKind::GrafcetFrozen(_) => {}
        ExprKind::GrafcetActive(g) => {
            Way::BOTH.into_iter().for_each(|way| causes.at_once(Change::Grafcet(g, way), to(way)));
        }
        ExprKind::Not(a) => Way::BOTH.into_iter().for_each(|way| follow(a, way, to(way.other()))),
        ExprKind::And(a, b) => {
            for operand in [a, b] {
                follow(operand, Way::Down, to(Way::Down));
            }
            match occasions[e] {
                Occasion::Level => [a, b].into_iter().for_each(|operand| follow(operand, Way::Up, to(Way::Up))),
                Occasion::Any | Occasion::First => {
                    let event = if occasions[a] == occasions[e] { a } else { b };
                    follow(event, Way::Up, to(Way::Up));
                }
            }
        }
        ExprKind::Or(a, b) => {
            for operand in [a, b] {
                Way::BOTH.into_iter().for_each(|way| follow(operand, way, to(way)));
            }
        }
        ExprKind::Rise(a) => {
            causes.at_once(Change::Expr(a, Way::Up), to(Way::Up));
            causes.next(Change::Expr(a, Way::Up), to(Way::Down));
        }
        ExprKind::Fall(a) => {
            causes.at_once(Change::Expr(a, Way::Down), to(Way::Up));
            causes.next(Change::Expr(a, Way::Down), to(Way::Down));
        }
        ExprKind::Delay { on, operand, off } => {
            if on.ms <= 0 {
                follow(operand, Way::Up, to(Way::Up));
            }
            if off.ms <= 0 {
                follow(operand, Way::Down, to(Way::Down));
            }
            // It runs out as time passes.
            Way::BOTH.into_iter().for_each(|way| causes.start(to(way)));
        }
        ExprKind::Compare(Comparison::Less | Comparison::LessEqual, a, b) => {
            for way in Way::BOTH {
                follow(a, way, to(way.other()));
                follow(b, way, to(way));
            }
        }
        ExprKind::Compare(Comparison::Greater | Comparison::GreaterEqual, a, b) => {
            for way in Way::BOTH {
                follow(a, way, to(way));
                follow(b, way, to(way.other()));
            }
        }
        ExprKind::Compare(Comparison::Equal | Comparison::NotEqual, a, b)
        | ExprKind::Xor(a, b)
        | ExprKind::Arithmetic(_, a, b) => {
            for operand in [a, b] {
                for way in Way::BOTH {
                    Way::BOTH.into_iter().for_each(|effect| follow(operand, way, to(effect)));
                }
            }
        }
        ExprKind::Negate(a) | ExprKind::Widen(a) => {
            for way in Way::BOTH {
                Way::BOTH.into_iter().for_each(|effect| follow(a, way, to(effect)));
            }
        }
    }
}
