//! What the facts of a net say, each from its meaning and not from the pass that establishes it; and that no pass has
//! filled in what belongs to a later one.

use super::tables::ascending;
use crate::net::{Fact, Forced, Net};
use grafc_model::chart::{GrafcetId, StepId, TransitionId};
use index_vec::IndexVec;

pub(super) fn verify(net: &Net) -> Result<(), String> {
    for fact in &net.facts {
        match fact {
            Fact::NoMacroSteps => no_macro_steps(net)?,
            Fact::RankedOrders => ranked_orders(net)?,
            Fact::SettledStart => settled_start(net)?,
            Fact::ClosedFreezing => closed_freezing(net)?,
            Fact::NoEnclosures => no_enclosures(net)?,
            Fact::NestedChildren => nested_children(net)?,
            Fact::NoTwoStepRings => no_two_step_rings(net)?,
        }
    }
    let lacks = |fact| !net.facts.contains(&fact);
    if lacks(Fact::RankedOrders) && net.grafcets.iter().any(|g| !g.orders.is_empty()) {
        return Err("some orders are ranked".into());
    }
    if lacks(Fact::SettledStart) && net.conflict_at_start {
        return Err("a conflict at the start is known before the start".into());
    }
    if lacks(Fact::ClosedFreezing) && net.grafcets.iter().any(|g| g.frozen_with.is_some()) {
        return Err("some freezing is closed".into());
    }
    let mut within = net.places.iter().map(|s| &s.within).chain(net.transitions.iter().map(|t| &t.within));
    if lacks(Fact::NoEnclosures) && within.any(|around| !around.is_empty()) {
        return Err("some enclosure is flat".into());
    }
    let is_nested = |g: GrafcetId| net.grafcets[g].child && !net.within(g).is_empty();
    if lacks(Fact::NestedChildren) && net.grafcets.indices().any(is_nested) {
        return Err("some child is nested".into());
    }
    Ok(())
}

fn no_macro_steps(net: &Net) -> Result<(), String> {
    match net.macro_steps.iter().find(|m| !m.entered_by.is_empty() || !m.left_by.is_empty()) {
        None => Ok(()),
        Some(m) => Err(format!("macro-step {} still has arcs", m.label)),
    }
}

fn ranked_orders(net: &Net) -> Result<(), String> {
    if !net.orders.is_empty() {
        return Err("an order is not ranked".into());
    }
    for (g, grafcet) in net.grafcets.iter_enumerated() {
        let levels: Vec<u32> = grafcet.orders.iter().map(|o| net.grafcets[net.places[o.step].grafcet].level).collect();
        if levels.windows(2).any(|pair| pair[0] > pair[1]) {
            return Err(format!("a higher order on {g} comes after a lower one"));
        }
        for order in &grafcet.orders {
            match &order.forced {
                Forced::Steps(steps) => ascending("the places of an order", steps)?,
                Forced::Current => {}
            }
        }
    }
    Ok(())
}

/// What a grafcet is within, at any stage. One without places and transitions does not say once it is flat.
fn around(net: &Net, g: GrafcetId) -> &[StepId] {
    net.grafcets[g].enclosing_step.as_ref().map_or_else(|| net.within(g), std::slice::from_ref)
}

fn settled_start(net: &Net) -> Result<(), String> {
    let mut conflict = false;
    for (g, grafcet) in net.grafcets.iter_enumerated() {
        let active: Vec<StepId> = grafcet.steps.iter().copied().filter(|s| net.places[*s].initial).collect();
        if let Some(s) = active.iter().find(|s| net.places[**s].auxiliary) {
            return Err(format!("{s} is initial, but no step"));
        }
        let around = around(net, g);
        if let Some(e) = around.first().filter(|_| !around.iter().any(|e| net.places[*e].initial)) {
            if let Some(s) = active.first() {
                return Err(format!("{s} is initial within {e}, which is not"));
            }
            continue;
        }
        let in_force: Vec<&Forced> =
            grafcet.orders.iter().filter(|order| net.places[order.step].initial).map(|order| &order.forced).collect();
        if let Some(Forced::Steps(steps)) = in_force.first()
            && active != *steps
        {
            return Err(format!("{g} starts in another situation than it is forced to"));
        }
        conflict |= in_force.windows(2).any(|pair| pair[0] != pair[1]);
    }
    // Pulse orders may disagree as well.
    if conflict == net.conflict_at_start || net.has_commands() {
        Ok(())
    } else {
        Err("the conflict at the start is wrong".into())
    }
}

fn closed_freezing(net: &Net) -> Result<(), String> {
    let mut expected: IndexVec<GrafcetId, Option<GrafcetId>> = net.grafcets.iter().map(|_| None).collect();
    for g in &net.hierarchy {
        let grafcet = &net.grafcets[*g];
        // An order that freezes what runs a child leaves the child alone.
        if let Some(e) = around(net, *g).first().filter(|_| !grafcet.child) {
            let around = net.places[*e].grafcet;
            expected[*g] = if net.grafcets[around].orders.is_empty() { expected[around] } else { Some(around) };
        }
        if grafcet.frozen_with != expected[*g] && !grafcet.steps.is_empty() {
            return Err(format!("{g} is frozen with {:?} instead of {:?}", grafcet.frozen_with, expected[*g]));
        }
    }
    Ok(())
}

fn no_enclosures(net: &Net) -> Result<(), String> {
    if let Some(grafcet) = net.grafcets.iter().find(|grafcet| grafcet.enclosing_step.is_some()) {
        return Err(format!("{} still has an enclosing step", grafcet.name));
    }
    let mut seen: IndexVec<GrafcetId, bool> = net.grafcets.iter().map(|_| false).collect();
    for g in &net.hierarchy {
        let grafcet = &net.grafcets[*g];
        let within = net.within(*g);
        if let Some(s) = grafcet.steps.iter().find(|s| net.places[**s].within[..] != *within) {
            return Err(format!("{s} and its neighbours are not within the same place"));
        }
        ascending("the places around a grafcet", within)?;
        if let Some(e) = within.iter().find(|e| !seen[net.places[**e].grafcet]) {
            return Err(format!("{g} comes before the grafcet of {e}, which it is within"));
        }
        if within.iter().any(|e| net.places[*e].grafcet != net.places[within[0]].grafcet) {
            return Err(format!("{g} is within places of several grafcets"));
        }
        seen[*g] = true;
    }
    for (id, t) in net.transitions.iter_enumerated() {
        if let Some(s) = t.pre.iter().chain(&t.post).find(|s| net.places[**s].within != t.within) {
            return Err(format!("{id} and {s} are not within the same place"));
        }
    }
    Ok(())
}

fn nested_children(net: &Net) -> Result<(), String> {
    let is_nested = |g: &GrafcetId| net.grafcets[*g].child && !net.within(*g).is_empty();
    match net.commands().find(|(_, commanded)| is_nested(commanded)) {
        None => Ok(()),
        Some((by, g)) => Err(format!("{g} is nested, and {by} commands it")),
    }
}

fn no_two_step_rings(net: &Net) -> Result<(), String> {
    // The places that a transition takes the token of for good, and those that it newly gives one to.
    let mut takes: IndexVec<TransitionId, Vec<StepId>> = IndexVec::with_capacity(net.transitions.len());
    let mut gives = takes.clone();
    let mut taken_by: IndexVec<StepId, Vec<TransitionId>> = net.places.iter().map(|_| Vec::new()).collect();
    let mut given_by = taken_by.clone();
    for (id, t) in net.transitions.iter_enumerated() {
        takes.push(without(&t.pre, &t.post));
        gives.push(without(&t.post, &t.pre));
        takes[id].iter().for_each(|s| taken_by[*s].push(id));
        gives[id].iter().for_each(|s| given_by[*s].push(id));
    }
    let mut follows: IndexVec<StepId, Option<StepId>> = net.places.iter().map(|_| None).collect();
    for s in net.places.indices() {
        taken_by[s].iter().flat_map(|t| &gives[*t]).for_each(|after| follows[*after] = Some(s));
        if let Some(before) = given_by[s].iter().flat_map(|t| &takes[*t]).find(|before| follows[**before] == Some(s)) {
            return Err(format!("{s} and {before} hand over to each other"));
        }
    }
    Ok(())
}

fn without(steps: &[StepId], others: &[StepId]) -> Vec<StepId> {
    let mut others = others.to_vec();
    others.sort_unstable();
    steps.iter().copied().filter(|s| others.binary_search(s).is_err()).collect()
}
