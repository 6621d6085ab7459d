//! What enclosures and forcing orders make of the next situation (R2, R3, R5).
//!
//! Grafcets are taken from the top of the hierarchy down, so that the next activity `N` of an enclosing or forcing step
//! is final when it is read. For a step i within e, on whose grafcet the orders w1, w2, … act, the first of which wins:
//!
//! ```text
//! frozen = an order's step is active, or the grafcet around is frozen                          in the old situation
//! f_w    = N of the order's step, and of no order before it
//! N_i    = N_e AND ( (f_w of the orders that force i)  OR  NOT (f_w of any order but {*}) AND (own OR link AND NOT X_e) )
//! ```
//!
//! A child that steps run is within all of them: `X_e` and `N_e` are the disjunctions of theirs.
//!
//! `own` is what clearings alone would make of the step; which factors and terms there are is known here, so that a step
//! on which nothing acts keeps the short formula.

use crate::analysis::components::Components;
use crate::encode::choose::raise;
use crate::encode::commanded;
use crate::lower::Lowering;
use crate::scan::{Flag, Origin, Role, Statement};
use grafc_formula::{FormulaId, Type};
use grafc_model::chart::{GrafcetId, StepId};
use grafc_net::Net;
use grafc_net::net::Forced;
use index_vec::IndexVec;
use rustc_hash::FxHashMap;

/// For each grafcet, whether it is frozen (R2), if it ever can be.
pub(crate) type Frozen = IndexVec<GrafcetId, Option<FormulaId>>;

/// Freezing in the old situation, with the statements that find it.
pub(crate) fn frozen(lowering: &mut Lowering) -> (Frozen, Vec<Statement>) {
    let net = &*lowering.net.clone();
    let mut statements = Vec::new();
    let mut frozen: Frozen = net.grafcets.iter().map(|_| None).collect();
    for g in &net.hierarchy {
        let grafcet = &net.grafcets[*g];
        let around = grafcet.frozen_with.and_then(|p| frozen[p]);
        let forcing: Vec<FormulaId> = grafcet.orders.iter().map(|order| lowering.active(order.step)).collect();
        let terms: Vec<FormulaId> = around.into_iter().chain(forcing).collect();
        if !terms.is_empty() {
            let value = lowering.pool.or(terms);
            let name = format!("frozen_{}", grafcet.name);
            frozen[*g] = Some(lowering.named(Origin::Orders(*g), &name, value, &mut statements));
        }
    }
    (frozen, statements)
}

/// Places whose next activity others read, or that more than clearings act on.
pub(crate) fn acted_on(net: &Net) -> IndexVec<StepId, bool> {
    let mut found: IndexVec<StepId, bool> = net.places.iter().map(|place| !place.within.is_empty()).collect();
    for place in &net.places {
        place.within.iter().for_each(|e| found[*e] = true);
    }
    for grafcet in &net.grafcets {
        let sets = grafcet.orders.iter().any(|order| matches!(order.forced, Forced::Steps(_)));
        if sets {
            grafcet.steps.iter().for_each(|s| found[*s] = true);
        }
        // A frozen grafcet can conflict with a forced one, so `{*}` counts here too.
        if sets || grafcet.orders.len() > 1 {
            grafcet.orders.iter().for_each(|order| found[order.step] = true);
        }
    }
    commanded::acted_on(net, &mut found);
    found
}

/// The next activity of what a grafcet is within: of one of these steps, if there are any.
pub(crate) fn around(
    lowering: &mut Lowering,
    g: GrafcetId,
    next: impl Fn(&mut Lowering, StepId) -> FormulaId,
) -> Option<FormulaId> {
    let net = &*lowering.net.clone();
    let steps: Vec<FormulaId> = net.within(g).iter().map(|e| next(lowering, *e)).collect();
    (!steps.is_empty()).then(|| lowering.pool.or(steps))
}

/// What clearings make of a step, and the link that activates it with the step around it (R5a).
pub(crate) fn linked(lowering: &mut Lowering, s: StepId, own: FormulaId) -> FormulaId {
    let net = &*lowering.net.clone();
    let place = &net.places[s];
    if place.within.is_empty() || !place.activated {
        return own;
    }
    let was = lowering.one_active(&place.within);
    let fresh = lowering.pool.not(was);
    lowering.pool.or([own, fresh])
}

/// The orders on one grafcet that set a situation.
pub(crate) struct InForce {
    /// Whether an order is the one in force, and the places that it forces.
    pub(crate) orders: Vec<(FormulaId, Vec<StepId>)>,
    /// For each place the orders that force it.
    forced_by: FxHashMap<StepId, Vec<FormulaId>>,
    /// Whether any of them is.
    pub(crate) any: FormulaId,
}

/// The orders in force on a grafcet in the next situation, and the flag where they disagree. None if no order sets a
/// situation.
pub(crate) fn orders(
    lowering: &mut Lowering,
    components: &Components,
    g: GrafcetId,
    within: Option<FormulaId>,
    next: &mut dyn FnMut(&mut Lowering, StepId) -> FormulaId,
    statements: &mut Vec<Statement>,
) -> Option<InForce> {
    let net = &*lowering.net.clone();
    let grafcet = &net.grafcets[g];
    let forcing: Vec<FormulaId> = grafcet.orders.iter().map(|order| next(lowering, order.step)).collect();
    let exclusive = exclude_each_other(components, net, g);
    if !exclusive {
        conflict(lowering, g, &forcing, within, statements);
    }
    let last = grafcet.orders.iter().rposition(|order| matches!(order.forced, Forced::Steps(_)));
    last?;
    let mut in_force = Vec::new();
    let before = (!exclusive && forcing.len() > 2)
        .then(|| lowering.symbols.fresh(Role::Temporary, format!("ordered_{}", grafcet.name), Type::Bool, None));
    for (index, (order, active)) in grafcet.orders.iter().zip(&forcing).enumerate() {
        let when = match (before, index) {
            _ if exclusive => *active,
            (_, 0) => *active,
            (None, _) => {
                let earlier = lowering.pool.not(forcing[0]);
                lowering.pool.and([*active, earlier])
            }
            (Some(before), _) => {
                let earlier = lowering.symbols.read(&mut lowering.pool, before);
                let none = lowering.pool.not(earlier);
                lowering.pool.and([*active, none])
            }
        };
        if let Forced::Steps(steps) = &order.forced {
            let name = format!("force_{}_by_{}", grafcet.name, net.places[order.step].label);
            let origin = lowering.order_origin(g, index);
            in_force.push((lowering.named(origin, &name, when, statements), steps.clone()));
        }
        // After the last order that sets a situation nothing asks any more.
        if let Some(target) = before.filter(|_| Some(index) < last) {
            let earlier = lowering.symbols.read(&mut lowering.pool, target);
            let value = if index == 0 { *active } else { lowering.pool.or([earlier, *active]) };
            statements.push(Statement::assign(Origin::Orders(g), target, value));
        }
    }
    let any = lowering.pool.or(in_force.iter().map(|(when, _)| *when).collect::<Vec<_>>());
    let any = lowering.named(Origin::Orders(g), &format!("forced_{}", grafcet.name), any, statements);
    let mut forced_by: FxHashMap<StepId, Vec<FormulaId>> = FxHashMap::default();
    for (when, steps) in &in_force {
        for s in steps {
            forced_by.entry(*s).or_default().push(*when);
        }
    }
    Some(InForce { orders: in_force, forced_by, any })
}

/// Whether the steps of all orders on a grafcet lie in one component, so that no two orders meet.
fn exclude_each_other(components: &Components, net: &Net, g: GrafcetId) -> bool {
    let mut steps: Vec<StepId> = net.grafcets[g].orders.iter().map(|order| order.step).collect();
    let count = steps.len();
    steps.sort_unstable();
    steps.dedup();
    let Some((first, others)) = steps.split_first().filter(|_| steps.len() == count) else { return count == 0 };
    others.is_empty() || components.of(*first).iter().any(|c| others.iter().all(|s| components.of(*s).contains(c)))
}

/// Two orders that would be obeyed ask for different situations (R2).
fn conflict(
    lowering: &mut Lowering,
    g: GrafcetId,
    forcing: &[FormulaId],
    within: Option<FormulaId>,
    statements: &mut Vec<Statement>,
) {
    let grafcet = &lowering.net.grafcets[g];
    let mut classes: Vec<(&Forced, Vec<FormulaId>)> = Vec::new();
    for (order, active) in grafcet.orders.iter().zip(forcing) {
        match classes.iter_mut().find(|(forced, _)| **forced == order.forced) {
            Some((_, list)) => list.push(*active),
            None => classes.push((&order.forced, vec![*active])),
        }
    }
    if classes.len() < 2 {
        return;
    }
    let asked: Vec<FormulaId> = classes.into_iter().map(|(_, list)| lowering.pool.or(list)).collect();
    let when = if let [a, b] = asked[..] {
        lowering.pool.and([a, b])
    } else {
        // One situation after the other: whether one was asked for before, and whether two were.
        let asked_before = lowering.symbols.fresh(Role::Temporary, format!("asked_{}", grafcet.name), Type::Bool, None);
        let two = lowering.symbols.fresh(Role::Temporary, format!("conflict_{}", grafcet.name), Type::Bool, None);
        let (before, both) =
            (lowering.symbols.read(&mut lowering.pool, asked_before), lowering.symbols.read(&mut lowering.pool, two));
        let last = asked.len() - 1;
        for (index, class) in asked.into_iter().enumerate() {
            let meets = lowering.pool.and([before, class]);
            match index {
                0 => {}
                1 => statements.push(Statement::assign(Origin::Orders(g), two, meets)),
                _ => {
                    let value = lowering.pool.or([both, meets]);
                    statements.push(Statement::assign(Origin::Orders(g), two, value));
                }
            }
            if index < last {
                let value = if index == 0 { class } else { lowering.pool.or([before, class]) };
                statements.push(Statement::assign(Origin::Orders(g), asked_before, value));
            }
        }
        both
    };
    let when = lowering.pool.and(within.into_iter().chain([when]));
    statements.extend(raise(lowering, Flag::ForceConflict, Origin::Orders(g), when));
}

/// The next activity of a step on which an enclosing step or orders act, from what clearings make of it.
pub(crate) fn settled(
    lowering: &mut Lowering,
    s: StepId,
    own: FormulaId,
    within: Option<FormulaId>,
    in_force: Option<&InForce>,
) -> FormulaId {
    let linked = linked(lowering, s, own);
    ordered(lowering, s, linked, within, in_force)
}

/// The same once links, and pulse orders, have acted.
pub(crate) fn ordered(
    lowering: &mut Lowering,
    s: StepId,
    mut value: FormulaId,
    within: Option<FormulaId>,
    in_force: Option<&InForce>,
) -> FormulaId {
    if let Some(in_force) = in_force {
        let forced = in_force.forced_by.get(&s).cloned().unwrap_or_default();
        let free = lowering.pool.not(in_force.any);
        let kept = lowering.pool.and([free, value]);
        value = lowering.pool.or(forced.into_iter().chain([kept]));
    }
    lowering.pool.and(within.into_iter().chain([value]))
}
