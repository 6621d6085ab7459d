//! Decomposition into interacting transition graphs (Shalyto, 12.3): each set of steps that exclude each other is one
//! number, and a micro-step looks at the arm of the active step only, enclosures inside the arm of the step that encloses
//! them. A child that several steps run is one machine beside the one that runs it: while it is idle, none of its arms is
//! gone into, so that nothing has to be asked before it.
//!
//! ```text
//! CASE at OF  3: IF condition THEN next := 4 …             transitions: read the old situation, write the next one
//! IF moved THEN                                            only where something clears:
//!   enclosures and orders (R5), from the top down          on the next situation
//!   stored actions (R7), outputs that follow a state       from both
//!   at := next                                             from the bottom up
//! ```
//!
//! Where nothing else hangs on a clearing, its transition writes the states themselves, see `in_place`. A small chart costs
//! little in any case; there `compact` takes the fewest lines.
//!
//! Pulse orders act on grafcets whose steps are bits, between enclosures and forcing orders.
//!
//! Outside of a micro-step `next` equals the state, so nothing has to be copied where nothing moves. Steps that no set
//! covers stay bits, with the formulas of the single-phase encoding; a transition that touches one is latched like there.

mod commit;
mod compact;
mod hierarchy;
mod in_place;
mod moves;
mod transitions;
mod uncovered;

use super::bits;
use super::task::Task;
use crate::encode::by_grafcet::headed;
use crate::encode::clearings::{Clearings, StepEvents};
use crate::encode::each_scan;
use crate::encode::heading::heading;
use crate::encode::input_event::InputEvent;
use crate::encode::outputs::Followers;
use crate::encode::pulses::Pulses;
use crate::encode::settle;
use crate::encode::stored;
use crate::lower::cover::is_forced;
use crate::lower::situation::{Holder, equals};
use crate::lower::{Context, Lowering};
use crate::scan::{Heading, Origin, Part, Statement, VarId};
use grafc_formula::{FormulaId, Value};
use grafc_model::chart::{GrafcetId, StepId, TransitionId};
use grafc_net::Net;
use index_vec::IndexVec;
use moves::{Moved, Numbered};
use rustc_hash::FxHashMap;

/// How sets lie in grafcets and grafcets in steps.
struct Layout {
    sets_of: IndexVec<GrafcetId, Vec<usize>>,
    /// The grafcets that a step alone encloses, if they have sets.
    inside: FxHashMap<StepId, Vec<GrafcetId>>,
    /// The grafcets that several steps of a grafcet run, if they have sets.
    shared: IndexVec<GrafcetId, Vec<GrafcetId>>,
    /// Grafcets on which an order sets a situation.
    forced: IndexVec<GrafcetId, bool>,
}

impl Layout {
    fn new(lowering: &Lowering) -> Self {
        let net = &*lowering.net.clone();
        let mut layout = Layout {
            sets_of: net.grafcets.iter().map(|_| Vec::new()).collect(),
            inside: FxHashMap::default(),
            shared: net.grafcets.iter().map(|_| Vec::new()).collect(),
            forced: net.grafcets.indices().map(|g| is_forced(net, g)).collect(),
        };
        for (index, set) in lowering.situation.sets.iter().enumerate() {
            layout.sets_of[set.grafcet].push(index);
        }
        for g in net.grafcets.indices().filter(|g| !layout.sets_of[*g].is_empty()) {
            match net.within(g) {
                [] => {}
                [e] => layout.inside.entry(*e).or_default().push(g),
                [e, ..] => layout.shared[net.places[*e].grafcet].push(g),
            }
        }
        layout
    }

    /// The sets inside a step.
    fn enclosed(&self, e: StepId) -> impl Iterator<Item = usize> + '_ {
        let grafcets = self.inside.get(&e).map_or(&[][..], Vec::as_slice);
        grafcets.iter().flat_map(|g| self.sets_of[*g].iter().copied())
    }
}

/// The state-held step that encloses a grafcet alone, so that the grafcet lies in its arm.
fn encloser(lowering: &Lowering, g: GrafcetId) -> Option<StepId> {
    match lowering.net.within(g) {
        [e] if lowering.situation.bit(*e).is_none() => Some(*e),
        _ => None,
    }
}

/// What is told of a grafcet that begins and ends with what it is within.
fn origin_around(net: &Net, g: GrafcetId) -> Origin {
    match net.within(g) {
        [e] => Origin::Step(*e),
        _ => Origin::Orders(g),
    }
}

struct Switch<'t> {
    task: &'t Task<'t>,
    layout: Layout,
    numbered: Numbered,
    moved: Moved,
    cleared: IndexVec<TransitionId, FormulaId>,
}

pub(super) fn micro_step(
    lowering: &mut Lowering,
    cx: &mut Context,
    task: &Task,
    input_event: &mut InputEvent,
) -> Vec<Statement> {
    let net = &*lowering.net.clone();
    let layout = Layout::new(lowering);
    let mut out = Vec::new();
    heading(&mut out, Heading::MemoryOfEdges, bits::edges(lowering, task.again));
    if lowering.situation.in_place {
        out.extend(in_place::in_place(lowering, task));
        return out;
    }
    if lowering.situation.is_small {
        out.extend(compact::micro_step(lowering, cx, task, input_event));
        return out;
    }
    let (frozen, freezing) = settle::frozen(lowering);
    let numbered = Numbered::new(lowering);
    let moved = Moved::new(lowering, task, &numbered);

    let mut switch = Switch { task, layout, numbered, moved, cleared: IndexVec::new() };
    let transitions = switch.transitions(lowering, &frozen);
    heading(&mut out, Heading::FrozenGrafcets, freezing);
    headed(&mut out, lowering, Part::Transitions, transitions);

    // What follows happens only where something clears, unless an action on an event or each scan has to be done in any
    // case.
    let mut inner = Vec::new();
    let mut clearings = Clearings::with(task.arcs, net, std::mem::take(&mut switch.cleared));
    let mut settled = Vec::new();
    let mut pulses = net.has_commands().then(|| Pulses::new(lowering, task, input_event, &mut settled));
    settled.extend(switch.settle(lowering, &mut clearings, pulses.as_mut()));
    heading(&mut inner, Heading::EnclosuresAndOrders, settled);
    inner.extend(switch.tell_changed_bits(lowering, &clearings, pulses.as_ref()));
    let step_events = StepEvents::new(lowering, &clearings, task.components);
    let actions = stored::actions(lowering, cx, task, &clearings, step_events, input_event);
    heading(&mut inner, Heading::StoredActions, actions);
    heading(&mut inner, Heading::OutputsOfTheSteps, switch.follow(lowering));
    heading(&mut inner, Heading::Situation, switch.commit(lowering, &clearings));
    inner.extend(pulses.into_iter().flat_map(|pulses| pulses.remembered));
    // Orders that disagree raise a flag, and raise it again where an input has lowered it.
    let conflicts = net.controls.clear_flags.is_some() && net.grafcets.iter().any(|grafcet| grafcet.orders.len() > 1);
    if !task.events.is_empty() || !task.pulses.is_empty() || conflicts || each_scan::any(net) {
        out.extend(inner);
    } else if !inner.is_empty() {
        let when = lowering.symbols.read(&mut lowering.pool, switch.moved.variable);
        out.push(Statement::Heading(Heading::WhatTheClearingsBringAbout));
        out.push(Statement::when(when, inner));
    }
    out
}

/// The states at the start, before the first call has done anything.
pub(crate) fn start(lowering: &mut Lowering, followers: &Followers) -> Vec<Statement> {
    let net = &*lowering.net.clone();
    let mut out = Vec::new();
    for set in lowering.situation.sets.clone() {
        let initial = set.steps.iter().copied().find(|s| net.places[*s].initial);
        let value = initial.map_or(set.idle, |s| value_of(lowering, s));
        let origin = initial.map_or(Origin::Chart, Origin::Step);
        // Before the first call all variables are 0.
        if value != 0 {
            out.push(assign_number(lowering, origin, set.variable, value));
        }
        if set.next != set.variable && !lowering.situation.is_small {
            out.push(assign_number(lowering, origin, set.next, value));
        }
        for s in set.steps.iter().filter(|s| net.places[**s].initial) {
            out.extend(entered(lowering, followers, *s));
        }
    }
    out
}

/// The outputs that become true with a step.
fn entered(lowering: &mut Lowering, followers: &Followers, s: StepId) -> Vec<Statement> {
    let value = lowering.pool.truth(true);
    let wires = followers.on_step(&lowering.net, s).into_iter().filter(|(_, conditions)| conditions.is_empty());
    let assign = |(v, _)| Statement::assign(followers.origin(&lowering.net, s, v), lowering.symbols.declared(v), value);
    wires.map(assign).collect()
}

fn value_of(lowering: &Lowering, s: StepId) -> i64 {
    match lowering.situation.holder(s) {
        Holder::State { value, .. } => value,
        Holder::Bit(_) => 0,
    }
}

fn next_in_set(lowering: &mut Lowering, s: StepId) -> FormulaId {
    match lowering.situation.holder(s) {
        Holder::State { set, value } => {
            equals(&lowering.symbols, &mut lowering.pool, lowering.situation.sets[set].next, value)
        }
        Holder::Bit(_) => lowering.active(s),
    }
}

/// `next <> at`.
fn differs(lowering: &mut Lowering, a: VarId, b: VarId) -> FormulaId {
    let (a, b) = (lowering.symbols.read(&mut lowering.pool, a), lowering.symbols.read(&mut lowering.pool, b));
    lowering.pool.differs(b, a)
}

fn assign_number(lowering: &mut Lowering, origin: Origin, target: VarId, value: i64) -> Statement {
    let ty = lowering.symbols.table[target].ty;
    Statement::assign(origin, target, lowering.pool.constant(Value::Int(value), ty))
}

fn assign_truth(lowering: &mut Lowering, origin: Origin, target: VarId, value: bool) -> Statement {
    Statement::assign(origin, target, lowering.pool.truth(value))
}

fn copy(lowering: &mut Lowering, origin: Origin, target: VarId, from: VarId) -> Statement {
    let value = lowering.symbols.read(&mut lowering.pool, from);
    Statement::assign(origin, target, value)
}
