//! Frozen grafcets, orders in force and what they force, in the situation reached (R2, R15).

use crate::encode::settle;
use crate::lower::Lowering;
use crate::scan::{Heading, Observing, Origin, Role, Statement, VarId};
use ecow::eco_format;
use grafc_diagnostics::Span;
use grafc_formula::{FormulaId, Type};
use grafc_model::chart::StepId;
use grafc_net::net::Forced;
use rustc_hash::FxHashMap;
use std::collections::BTreeMap;

/// The statements; the variables are those of the time before, if there was one.
pub(super) fn statements(lowering: &mut Lowering, observing: &mut Observing) -> Vec<Statement> {
    let net = &*lowering.net.clone();
    let known = std::mem::take(observing);
    let mut shown = Shown { known: known.frozen.iter().map(|(_, v)| *v).collect(), out: Vec::new() };
    let (frozen, statements) = settle::frozen(lowering);
    shown.out.extend(statements);
    let mut list = Vec::new();
    for (g, by_order) in frozen.iter_enumerated() {
        // Pulse orders freeze as well (R15).
        let by_pulse = lowering.frozen_bits.frozen[g].map(|bit| lowering.symbols.read(&mut lowering.pool, bit));
        if by_order.is_none() && by_pulse.is_none() {
            continue;
        }
        let value = lowering.pool.or(by_order.iter().copied().chain(by_pulse));
        let name = eco_format!("is_frozen_{}", net.grafcets[g].name);
        list.push((g, shown.set(lowering, &name, Origin::Orders(g), value)));
    }
    let places = orders_by_text(lowering);
    shown.known = known.orders.iter().map(|(_, v)| *v).collect();
    let mut orders = Vec::new();
    // What holds or forces each step.
    let mut holding: BTreeMap<StepId, Vec<FormulaId>> = BTreeMap::new();
    for (g, grafcet) in net.grafcets.iter_enumerated() {
        // Whether an order before has its step active.
        let mut before: Option<FormulaId> = None;
        let last = grafcet.orders.len().saturating_sub(1);
        let mut holds = Vec::new();
        for (rank, order) in grafcet.orders.iter().enumerate() {
            let (origin, active) = (lowering.order_origin(g, rank), lowering.active(order.step));
            let free = before.map(|before| lowering.pool.not(before));
            let value = lowering.pool.and([Some(active), free].into_iter().flatten());
            let name = eco_format!("in_force_{}_by_{}", grafcet.name, net.places[order.step].label);
            let variable = shown.set(lowering, &name, origin, value);
            orders.push((places[&order.span], variable));
            let in_force = lowering.symbols.read(&mut lowering.pool, variable);
            match &order.forced {
                Forced::Steps(steps) => steps.iter().for_each(|s| holding.entry(*s).or_default().push(in_force)),
                Forced::Current => holds.push(in_force),
            }
            if rank < last {
                let value = lowering.pool.or([before, Some(active)].into_iter().flatten());
                let name = format!("ordered_{}", grafcet.name);
                before = Some(lowering.named(Origin::Orders(g), &name, value, &mut shown.out));
            }
        }
        if !holds.is_empty() {
            let any = lowering.pool.or(holds);
            let name = format!("held_{}", grafcet.name);
            let any = lowering.named(Origin::Orders(g), &name, any, &mut shown.out);
            grafcet.steps.iter().for_each(|s| holding.entry(*s).or_default().push(any));
        }
    }
    shown.known = known.forced.iter().map(|(_, v)| *v).collect();
    let mut forced = Vec::new();
    for (s, by) in holding {
        let any = lowering.pool.or(by);
        let value = lowering.pool.and([lowering.active(s), any]);
        let name = eco_format!("is_forced_{}", net.places[s].label);
        forced.push((s, shown.set(lowering, &name, Origin::Step(s), value)));
    }
    *observing = Observing { frozen: list, orders, forced, ..known };
    let mut out = shown.out;
    if !out.is_empty() {
        out.insert(0, Statement::Heading(Heading::WhatIsSeenOfTheSituation));
    }
    out
}

/// Variables that show something, each set again where it is known already.
struct Shown {
    known: std::collections::VecDeque<VarId>,
    out: Vec<Statement>,
}

impl Shown {
    fn set(&mut self, lowering: &mut Lowering, name: &str, origin: Origin, value: FormulaId) -> VarId {
        let known = self.known.pop_front();
        let target = known.unwrap_or_else(|| lowering.symbols.fresh(Role::Observed, name, Type::Bool, None));
        self.out.push(Statement::assign(origin, target, value));
        target
    }
}

/// The place of each order among all as the chart writes them.
fn orders_by_text(lowering: &Lowering) -> FxHashMap<Span, usize> {
    let orders = lowering.net.grafcets.iter().flat_map(|grafcet| &grafcet.orders);
    super::actions::by_text(orders.map(|order| order.span))
}
