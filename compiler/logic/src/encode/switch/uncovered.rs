//! Steps that no set covers: bits, with the formulas of the single-phase encoding.

use super::next_in_set;
use crate::encode::clearings::Clearings;
use crate::encode::next_activity::next_activity;
use crate::encode::pulses::Pulses;
use crate::encode::settle::{self, InForce};
use crate::lower::Lowering;
use crate::options::Encoding;
use crate::scan::{Origin, Statement, Told};
use grafc_formula::FormulaId;
use grafc_model::chart::{GrafcetId, StepId};
use index_vec::IndexVec;
use rustc_hash::FxHashMap;

/// The next activity of a step, covered or not, once enclosures and orders above it are settled.
pub(super) fn next(lowering: &mut Lowering, clearings: &Clearings, s: StepId) -> FormulaId {
    match clearings.next[s] {
        Some(next) => next,
        None => next_in_set(lowering, s),
    }
}

/// What transitions make of a bit; none where they leave it as it is.
fn by_transitions(lowering: &mut Lowering, clearings: &Clearings, s: StepId) -> Option<FormulaId> {
    let place = clearings.set_and_reset(lowering, s, false)?;
    Some(next_activity(Encoding::Switch, &mut lowering.pool, &place))
}

/// What enclosures and orders make of the bits of a grafcet (R5). Pulse orders act on bits alone.
pub(super) fn settle(
    lowering: &mut Lowering,
    clearings: &mut Clearings,
    acted_on: &IndexVec<StepId, bool>,
    g: GrafcetId,
    (around, in_force): (Option<FormulaId>, Option<&InForce>),
    pulses: Option<&mut Pulses>,
) -> Vec<Statement> {
    let net = &*lowering.net.clone();
    let mut out = Vec::new();
    let is_bit = |s: &StepId| acted_on[*s] && lowering.situation.bit(*s).is_some();
    let bits: Vec<StepId> = net.grafcets[g].steps.iter().copied().filter(is_bit).collect();
    let mut linked: FxHashMap<StepId, FormulaId> = FxHashMap::default();
    for s in &bits {
        let own = by_transitions(lowering, clearings, *s).unwrap_or_else(|| lowering.active(*s));
        linked.insert(*s, settle::linked(lowering, *s, own));
    }
    if let Some(pulses) = pulses {
        pulses.act(lowering, clearings, g, (around, in_force), &mut linked, &mut out);
    }
    for s in bits {
        let value = settle::ordered(lowering, s, linked[&s], around, in_force);
        let name = format!("next_{}", net.places[s].label);
        clearings.next[s] = Some(lowering.named(Origin::Step(s), &name, value, &mut out));
    }
    out
}

/// The next value of each bit becomes its value.
pub(super) fn commit(lowering: &mut Lowering, clearings: &Clearings, told: Told) -> Vec<Statement> {
    let mut out = Vec::new();
    for s in lowering.net.places.indices() {
        let Some(target) = lowering.situation.bit(s) else { continue };
        let next = clearings.next[s].or_else(|| by_transitions(lowering, clearings, s));
        if let Some(value) = next.filter(|value| *value != lowering.active(s)) {
            out.push(Statement::Assign { target, value, origin: Origin::Step(s), told });
        }
    }
    out
}

/// Whether pulse orders change a bit, or what they remember, as the terms of a disjunction.
pub(super) fn commanded(lowering: &mut Lowering, clearings: &Clearings, pulses: Option<&Pulses>) -> Vec<FormulaId> {
    let Some(pulses) = pulses else { return Vec::new() };
    let net = &*lowering.net.clone();
    let commanded = net.commanded();
    let mut terms = Vec::new();
    for s in net.places.indices().filter(|s| commanded[net.places[*s].grafcet]) {
        if let Some(next) = clearings.next[s] {
            terms.push(lowering.pool.xor(next, lowering.active(s)));
        }
    }
    terms.extend(pulses.changes.iter().copied());
    terms
}
