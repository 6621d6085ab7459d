//! Which actions act: continuous ones that assign in the outputs that are published (R11), stored ones that are done in a
//! micro-step (R7).

use crate::encode::input_event::InputEvent;
use crate::encode::stored;
use crate::encode::task::Task;
use crate::encode::without_flag::without_flag;
use crate::lower::{Context, Lowering};
use crate::scan::{ActionId, Heading, Observing, Origin, Role, Statement, VarId};
use ecow::eco_format;
use grafc_diagnostics::Span;
use grafc_formula::{FormulaId, Type};
use grafc_model::chart::{Event, Mode, StepId, VariableId, VariableKind};
use grafc_model::reaction::Profile;
use grafc_net::Net;
use rustc_hash::FxHashMap;
use std::collections::BTreeMap;

/// Of each span its place among all, in the order of the text.
pub(super) fn by_text(spans: impl Iterator<Item = Span>) -> FxHashMap<Span, usize> {
    let mut spans: Vec<Span> = spans.collect();
    spans.sort_unstable_by_key(|span| (span.start, span.end));
    spans.dedup();
    spans.into_iter().enumerate().map(|(place, span)| (span, place)).collect()
}

/// The places of all actions, the continuous ones first, then the stored ones.
pub(super) fn places(net: &Net) -> Vec<usize> {
    let spans = || net.continuous.iter().map(|action| action.span).chain(net.stored.iter().map(|action| action.span));
    let places = by_text(spans());
    spans().map(|span| places[&span]).collect()
}

/// Stored actions, done in a micro-step.
#[derive(Default)]
pub(super) struct Done {
    /// For each stored action what says that it is done, as far as that is known before the micro-step.
    early: Vec<Option<FormulaId>>,
    /// Whether a step was active before the micro-step.
    was: BTreeMap<StepId, VarId>,
    /// True from the initial reaction to the end of the first micro-step.
    began: Option<VarId>,
}

impl Done {
    /// Before the micro-step: events and clearings, and what was active.
    pub(super) fn before(
        &mut self,
        lowering: &mut Lowering,
        task: &Task,
        observing: &mut Observing,
        input_event: &mut InputEvent,
    ) -> Vec<Statement> {
        let net = &*lowering.net.clone();
        let mut out = Vec::new();
        let no_edges = stored::without_edges(lowering, !task.events.is_empty(), &mut out);
        for (index, action) in net.stored.iter().enumerate() {
            let origin = Origin::Action(ActionId::from(net.continuous.len() + index));
            let early = match action.event {
                Event::Event(s, _) => {
                    let expr = task.events[&index];
                    let (when, _) = stored::event(lowering, (s, origin), expr, &no_edges, input_event, &mut out);
                    let name = eco_format!("event_of_{}", net.places[s].label);
                    let target = lowering.symbols.fresh(Role::Temporary, name, Type::Bool, None);
                    out.push(Statement::assign(origin, target, when));
                    Some(lowering.symbols.read(&mut lowering.pool, target))
                }
                Event::Clearing(t) => {
                    let cleared = observing.transitions[t.index()].cleared;
                    Some(lowering.symbols.read(&mut lowering.pool, cleared))
                }
                Event::EachScan(_, None) => None,
                Event::EachScan(s, Some(_)) => {
                    let name = eco_format!("scan_of_{}", net.places[s].label);
                    let target = lowering.symbols.fresh(Role::Temporary, name, Type::Bool, None);
                    out.push(Statement::assign(origin, target, task.events[&index]));
                    Some(lowering.symbols.read(&mut lowering.pool, target))
                }
                Event::Deactivation(s) | Event::Activation(s) => {
                    self.was.entry(s).or_insert_with(|| {
                        let name = eco_format!("was_{}", net.places[s].label);
                        let target = lowering.symbols.fresh(Role::Temporary, name, Type::Bool, None);
                        out.push(Statement::assign(Origin::Step(s), target, lowering.active(s)));
                        target
                    });
                    None
                }
            };
            self.early.push(early);
        }
        out
    }

    /// After it: those on deactivation and activation as well, and at the start those of initial steps.
    pub(super) fn after(&mut self, lowering: &mut Lowering, acting: &mut Acting, profile: Profile) -> Vec<Statement> {
        let net = &*lowering.net.clone();
        let places = places(net);
        let mut out = Vec::new();
        for (index, action) in net.stored.iter().enumerate() {
            let mut now_and_before = |s: StepId| {
                let (now, was) = (lowering.active(s), self.was[&s]);
                (now, lowering.symbols.read(&mut lowering.pool, was))
            };
            let value = match (action.event, self.early[index]) {
                (Event::Event(..) | Event::Clearing(_), early) => early.unwrap_or_else(|| lowering.pool.truth(false)),
                (Event::EachScan(s, _), early) => {
                    let active = lowering.active(s);
                    lowering.pool.and([Some(active), early].into_iter().flatten())
                }
                (Event::Deactivation(s), _) => {
                    let (now, was) = now_and_before(s);
                    let gone = lowering.pool.not(now);
                    lowering.pool.and([was, gone])
                }
                (Event::Activation(s), _) => {
                    let (now, was) = now_and_before(s);
                    let new = lowering.pool.not(was);
                    let activated = lowering.pool.and([now, new]);
                    if net.places[s].initial && profile.initial_actions {
                        let began = *self.began.get_or_insert_with(|| {
                            let about = "true in the first micro-step";
                            lowering.symbols.fresh(Role::Observed, "began", Type::Bool, Some(about.into()))
                        });
                        let began = lowering.symbols.read(&mut lowering.pool, began);
                        lowering.pool.or([activated, began])
                    } else {
                        activated
                    }
                }
            };
            let place = net.continuous.len() + index;
            let target = acting.variable(lowering, places[place], action.target);
            out.push(Statement::assign(Origin::Action(ActionId::from(place)), target, value));
        }
        if let Some(began) = self.began {
            out.push(Statement::assign(Origin::Chart, began, lowering.pool.truth(false)));
        }
        if !out.is_empty() {
            out.insert(0, Statement::Heading(Heading::WhatIsSeenOfActions));
        }
        out
    }

    /// The initial reaction is the beginning.
    pub(super) fn at_start(&self, lowering: &mut Lowering) -> Option<Statement> {
        let began = self.began?;
        Some(Statement::assign(Origin::Chart, began, lowering.pool.truth(true)))
    }
}

/// The variables of actions by their places, each made where it is first set.
#[derive(Default)]
pub(super) struct Acting {
    pub(super) by_place: BTreeMap<usize, VarId>,
}

impl Acting {
    fn variable(&mut self, lowering: &mut Lowering, place: usize, target: VariableId) -> VarId {
        *self.by_place.entry(place).or_insert_with(|| {
            let name = eco_format!("acts_{}", lowering.net.variables[target].name);
            lowering.symbols.fresh(Role::Observed, name, Type::Bool, None)
        })
    }

    /// Those of continuous actions on outputs, and where each comes from.
    pub(super) fn on_outputs(&self, net: &Net) -> Vec<(VarId, Origin)> {
        let places = places(net);
        let mut origins: BTreeMap<usize, Origin> = BTreeMap::new();
        for (index, action) in net.continuous.iter().enumerate() {
            if net.variables[action.target].kind == VariableKind::Output {
                origins.entry(places[index]).or_insert(Origin::Action(ActionId::from(index)));
            }
        }
        origins.into_iter().filter_map(|(place, origin)| Some((*self.by_place.get(&place)?, origin))).collect()
    }
}

/// Continuous actions and internal wires at a moment after the evolution. What is computed for this alone raises no flag.
pub(super) fn continuous(lowering: &mut Lowering, mut cx: Context, acting: &mut Acting) -> Vec<Statement> {
    let net = &*lowering.net.clone();
    let places = places(net);
    for (v, variable) in net.variables.iter_enumerated() {
        if variable.mode == Mode::Wire && variable.kind == VariableKind::Internal {
            cx.origin = lowering.wire_origin(v);
            lowering.wire(&mut cx, v);
        }
    }
    for (index, action) in net.continuous.iter().enumerate() {
        let origin = Origin::Action(ActionId::from(index));
        cx.origin = origin;
        let condition = action.condition.map(|condition| lowering.expr(&mut cx, condition));
        let active = lowering.active(action.step);
        let value = lowering.pool.and([Some(active), condition].into_iter().flatten());
        let target = acting.variable(lowering, places[index], action.target);
        cx.statements.push(Statement::assign(origin, target, value));
    }
    let mut out = without_flag(lowering, cx.statements);
    if !out.is_empty() {
        out.insert(0, Statement::Heading(Heading::WhatIsSeenOfActions));
    }
    out
}
