//! Ids lie in their tables, lists are in order, and nothing belongs to two grafcets.

use crate::net::{Forced, Net};
use grafc_model::chart::{Event, ExprKind, GrafcetId, Situation, StepId};
use index_vec::{Idx, IndexSlice, IndexVec};

pub(super) fn verify(net: &Net) -> Result<(), String> {
    hierarchy(net)?;
    places(net)?;
    arcs(net)?;
    expressions(net)?;
    actions(net)?;
    orders(net)?;
    macro_steps(net)
}

fn in_table<I: Idx, T>(what: &str, id: I, table: &IndexSlice<I, [T]>) -> Result<(), String> {
    if id.index() < table.len() {
        Ok(())
    } else {
        Err(format!("{what} {} is not in a table of {}", id.index(), table.len()))
    }
}

/// Each grafcet once, after the ones that enclose, force or freeze it.
fn hierarchy(net: &Net) -> Result<(), String> {
    let mut seen: IndexVec<GrafcetId, bool> = net.grafcets.iter().map(|_| false).collect();
    for g in &net.hierarchy {
        in_table("grafcet", *g, &net.grafcets)?;
        let grafcet = &net.grafcets[*g];
        for s in grafcet.enclosing_step.iter().chain(grafcet.orders.iter().map(|order| &order.step)) {
            in_table("place", *s, &net.places)?;
            in_table("grafcet", net.places[*s].grafcet, &net.grafcets)?;
            if !seen[net.places[*s].grafcet] {
                return Err(format!("{g} comes before the grafcet of {s}, which acts on it"));
            }
        }
        if let Some(around) = grafcet.frozen_with {
            in_table("grafcet", around, &net.grafcets)?;
            if !seen[around] {
                return Err(format!("{g} comes before {around}, which freezes it"));
            }
        }
        if std::mem::replace(&mut seen[*g], true) {
            return Err(format!("{g} is twice in the hierarchy"));
        }
    }
    if net.hierarchy.len() == net.grafcets.len() {
        Ok(())
    } else {
        Err("a grafcet has no place in the hierarchy".into())
    }
}

/// Each place is listed by its grafcet, and by no other.
fn places(net: &Net) -> Result<(), String> {
    let mut listed = 0;
    for (g, grafcet) in net.grafcets.iter_enumerated() {
        for s in &grafcet.steps {
            in_table("place", *s, &net.places)?;
            if net.places[*s].grafcet != g {
                return Err(format!("{g} lists {s} of {}", net.places[*s].grafcet));
            }
        }
        ascending("the places of a grafcet", &grafcet.steps)?;
        listed += grafcet.steps.len();
    }
    if listed != net.places.len() {
        return Err("a place is not listed by its grafcet".into());
    }
    net.places.iter().flat_map(|place| &place.within).try_for_each(|e| in_table("place", *e, &net.places))
}

pub(super) fn ascending(what: &str, steps: &[StepId]) -> Result<(), String> {
    match steps.windows(2).find(|pair| pair[0] >= pair[1]) {
        None => Ok(()),
        Some(pair) => Err(format!("{what} are out of order: {} before {}", pair[0], pair[1])),
    }
}

fn arcs(net: &Net) -> Result<(), String> {
    // The last transition side that used a place, to find repetitions in one pass.
    let mut used: IndexVec<StepId, usize> = net.places.iter().map(|_| usize::MAX).collect();
    for (t, transition) in net.transitions.iter_enumerated() {
        in_table("grafcet", transition.grafcet, &net.grafcets)?;
        for (side, places) in [&transition.pre, &transition.post].into_iter().enumerate() {
            let mark = t.index() * 2 + side;
            for place in places {
                in_table("place", *place, &net.places)?;
                if net.places[*place].grafcet != transition.grafcet {
                    return Err(format!("an arc of {t} crosses the frame of {}", transition.grafcet));
                }
                if std::mem::replace(&mut used[*place], mark) == mark {
                    return Err(format!("{t} has {place} twice on one side"));
                }
            }
        }
        transition.within.iter().try_for_each(|e| in_table("place", *e, &net.places))?;
        in_table("expression", transition.condition, &net.exprs)?;
    }
    Ok(())
}

fn expressions(net: &Net) -> Result<(), String> {
    for (id, expr) in net.exprs.iter_enumerated() {
        if let Some(operand) = expr.kind.operands().find(|operand| *operand >= id) {
            return Err(format!("operand {operand} does not come before {id}"));
        }
        match &expr.kind {
            ExprKind::Variable(v) => in_table("variable", *v, &net.variables)?,
            ExprKind::StepActive(s) | ExprKind::StepTime(s) => in_table("place", *s, &net.places)?,
            ExprKind::MacroActive(m) => in_table("macro-step", *m, &net.macro_steps)?,
            ExprKind::GrafcetActive(g) | ExprKind::GrafcetFrozen(g) => in_table("grafcet", *g, &net.grafcets)?,
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

fn actions(net: &Net) -> Result<(), String> {
    for action in &net.continuous {
        in_table("place", action.step, &net.places)?;
        in_table("variable", action.target, &net.variables)?;
        if let Some(condition) = action.condition {
            in_table("expression", condition, &net.exprs)?;
        }
    }
    for action in &net.stored {
        in_table("variable", action.target, &net.variables)?;
        in_table("expression", action.value, &net.exprs)?;
        match action.event {
            Event::Event(s, e) => {
                in_table("place", s, &net.places)?;
                in_table("expression", e, &net.exprs)?;
            }
            Event::Activation(s) | Event::Deactivation(s) => in_table("place", s, &net.places)?,
            Event::EachScan(s, condition) => {
                in_table("place", s, &net.places)?;
                condition.iter().try_for_each(|e| in_table("expression", *e, &net.exprs))?;
            }
            Event::Clearing(t) => in_table("transition", t, &net.transitions)?,
        }
    }
    Ok(())
}

/// Orders as the chart has them, and ranked ones.
fn orders(net: &Net) -> Result<(), String> {
    for order in &net.orders {
        in_table("place", order.step, &net.places)?;
        in_table("grafcet", order.grafcet, &net.grafcets)?;
        match &order.situation {
            Situation::Steps(steps) => forced_places(net, order.grafcet, steps)?,
            Situation::Current | Situation::Initial => {}
        }
    }
    for (g, grafcet) in net.grafcets.iter_enumerated() {
        for order in &grafcet.orders {
            in_table("place", order.step, &net.places)?;
            match &order.forced {
                Forced::Steps(steps) => forced_places(net, g, steps)?,
                Forced::Current => {}
            }
        }
    }
    Ok(())
}

fn forced_places(net: &Net, g: GrafcetId, steps: &[StepId]) -> Result<(), String> {
    for s in steps {
        in_table("place", *s, &net.places)?;
        if net.places[*s].grafcet != g {
            return Err(format!("an order forces {s} outside of {g}"));
        }
    }
    Ok(())
}

fn macro_steps(net: &Net) -> Result<(), String> {
    for (id, m) in net.macro_steps.iter_enumerated() {
        for s in [m.entry, m.exit].iter().chain(&m.places) {
            in_table("place", *s, &net.places)?;
        }
        for inner in &m.inner {
            in_table("macro-step", *inner, &net.macro_steps)?;
        }
        for list in [&m.entered_by, &m.left_by] {
            list.iter().try_for_each(|t| in_table("transition", *t, &net.transitions))?;
            let mut sorted = list.clone();
            sorted.sort_unstable();
            if sorted.windows(2).any(|pair| pair[0] == pair[1]) {
                return Err(format!("a transition is twice at an end of {id}"));
            }
        }
    }
    Ok(())
}
