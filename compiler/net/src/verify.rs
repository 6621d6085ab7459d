//! Checks the invariants that [`crate::net`] lists. A violation is a fault of grafc, never of the chart.

use crate::net::{Fact, Net};
use grafc_model::chart::{Event, ExprKind, Situation, StepId};
use index_vec::IndexVec;

/// Says which invariant of the net does not hold, if one does not.
pub fn verify(net: &Net) -> Result<(), String> {
    arcs(net)?;
    expressions(net)?;
    side_tables(net)?;
    for fact in &net.facts {
        match fact {
            Fact::NoMacroSteps => no_macro_steps(net)?,
        }
    }
    Ok(())
}

fn in_table<T>(what: &str, index: usize, table: &[T]) -> Result<(), String> {
    if index < table.len() { Ok(()) } else { Err(format!("{what} {index} is not in a table of {}", table.len())) }
}

fn arcs(net: &Net) -> Result<(), String> {
    // The last transition side that used a place, to find repetitions in one pass.
    let mut used: IndexVec<StepId, usize> = net.places.iter().map(|_| usize::MAX).collect();
    for (t, transition) in net.transitions.iter_enumerated() {
        for (side, places) in [&transition.pre, &transition.post].into_iter().enumerate() {
            let mark = t.index() * 2 + side;
            for place in places {
                in_table("place", place.index(), net.places.as_raw_slice())?;
                if net.places[*place].grafcet != transition.grafcet {
                    return Err(format!("an arc of {t} crosses the frame of {}", transition.grafcet));
                }
                if std::mem::replace(&mut used[*place], mark) == mark {
                    return Err(format!("{t} has {place} twice on one side"));
                }
            }
        }
        in_table("expression", transition.condition.index(), net.exprs.as_raw_slice())?;
    }
    Ok(())
}

fn expressions(net: &Net) -> Result<(), String> {
    for (id, expr) in net.exprs.iter_enumerated() {
        if let Some(operand) = expr.kind.operands().find(|operand| *operand >= id) {
            return Err(format!("operand {operand} does not come before {id}"));
        }
        match &expr.kind {
            ExprKind::Variable(v) => in_table("variable", v.index(), net.variables.as_raw_slice())?,
            ExprKind::StepActive(s) | ExprKind::StepTime(s) => {
                in_table("place", s.index(), net.places.as_raw_slice())?;
            }
            ExprKind::MacroActive(m) => in_table("macro-step", m.index(), net.macro_steps.as_raw_slice())?,
            ExprKind::GrafcetActive(g) => in_table("grafcet", g.index(), net.grafcets.as_raw_slice())?,
            ExprKind::Literal(_)
            | ExprKind::Not(_)
            | ExprKind::And(..)
            | ExprKind::Or(..)
            | ExprKind::Xor(..)
            | ExprKind::Rise(_)
            | ExprKind::Fall(_)
            | ExprKind::Delay { .. }
            | ExprKind::Compare(..)
            | ExprKind::Arithmetic(..)
            | ExprKind::Negate(_)
            | ExprKind::Widen(_) => {}
        }
    }
    Ok(())
}

fn side_tables(net: &Net) -> Result<(), String> {
    for action in &net.continuous {
        in_table("place", action.step.index(), net.places.as_raw_slice())?;
        in_table("variable", action.target.index(), net.variables.as_raw_slice())?;
    }
    for action in &net.stored {
        in_table("variable", action.target.index(), net.variables.as_raw_slice())?;
        in_table("expression", action.value.index(), net.exprs.as_raw_slice())?;
        match action.event {
            Event::Event(s, e) => {
                in_table("place", s.index(), net.places.as_raw_slice())?;
                in_table("expression", e.index(), net.exprs.as_raw_slice())?;
            }
            Event::Activation(s) | Event::Deactivation(s) => {
                in_table("place", s.index(), net.places.as_raw_slice())?;
            }
            Event::Clearing(t) => in_table("transition", t.index(), net.transitions.as_raw_slice())?,
        }
    }
    for order in &net.orders {
        in_table("place", order.step.index(), net.places.as_raw_slice())?;
        in_table("grafcet", order.grafcet.index(), net.grafcets.as_raw_slice())?;
        if let Situation::Steps(steps) = &order.situation {
            for s in steps {
                in_table("place", s.index(), net.places.as_raw_slice())?;
                if net.places[*s].grafcet != order.grafcet {
                    return Err(format!("an order forces {s} outside of {}", order.grafcet));
                }
            }
        }
    }
    for m in &net.macro_steps {
        in_table("place", m.entry.index(), net.places.as_raw_slice())?;
        in_table("place", m.exit.index(), net.places.as_raw_slice())?;
    }
    Ok(())
}

fn no_macro_steps(net: &Net) -> Result<(), String> {
    match net.macro_steps.iter().find(|m| !m.entered_by.is_empty() || !m.left_by.is_empty()) {
        None => Ok(()),
        Some(m) => Err(format!("macro-step {} still has arcs", m.label)),
    }
}
