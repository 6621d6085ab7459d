//! The scan program of a flat net, put together section by section.

use crate::allocate::{self, Place, Tokens, Trigger, Triggers};
use crate::encode::Encoding;
use crate::events::{Clearings, StepEvents};
use crate::formula::{Formula, FormulaId, Type};
use crate::input_event::InputEvent;
use crate::lower::{Context, Lowering, Moment};
use crate::scan::{Flag, Program, Repeat, Role, Statement, VarId};
use crate::tokens::Components;
use crate::{limits, tokens};
use grafc_diagnostics::Diagnostics;
use grafc_model::chart::{Event, Mode, StepId, TransitionId, VariableKind};
use grafc_model::reaction::{Evolution, Profile};
use grafc_net::Net;
use index_vec::IndexVec;
use rustc_hash::FxHashMap;

/// The scan program of a net under one encoding, or errors where the net holds what cannot be lowered.
pub fn compile(net: &Net, profile: Profile, encoding: Encoding) -> (Option<Program>, Diagnostics) {
    let diagnostics = limits::check(net);
    if diagnostics.has_errors() {
        return (None, diagnostics);
    }
    let mut lowering = Lowering::new(net);
    let mut cx = Context::new(Moment::MicroStep);
    let loops = profile.evolution == Evolution::Stable;

    // Every condition has to be known before the first statement: the operands of all edges are compared at once.
    let conditions: IndexVec<TransitionId, FormulaId> =
        net.transitions.iter().map(|t| lowering.expr(&mut cx, t.condition)).collect();
    let mut events: FxHashMap<usize, FormulaId> = FxHashMap::default();
    for (index, action) in net.stored.iter().enumerate() {
        if let Event::Event(_, e) = action.event {
            events.insert(index, lowering.expr(&mut cx, e));
        }
        lowering.prepare(&mut cx, action.value, true);
    }
    for action in &net.continuous {
        if let Some(condition) = action.condition {
            lowering.prepare(&mut cx, condition, false);
        }
    }
    let components = tokens::analyse(net, &lowering.pool, &lowering.edges, &conditions);
    let repeat = loops.then(|| {
        let again = lowering.symbols.fresh(Role::Temporary, "again", Type::Bool, None);
        let bound = profile.bound_for(net.places.len(), net.transitions.len()).clamp(1, i32::MAX as u32);
        let wide_enough = if bound <= i16::MAX as u32 { Type::Int } else { Type::Dint };
        let count = lowering.symbols.fresh(Role::Temporary, "micro_steps", wide_enough, None);
        lowering.symbols.flag(Flag::Livelock);
        Repeat { again, count, bound }
    });
    let again = repeat.map(|r| r.again);

    let mut step = Section::default();
    step.add("conditions", std::mem::take(&mut cx.statements));
    let mut input_event = InputEvent::default();
    let edges = edge_section(&mut lowering, again);
    let (clearings, clearing_statements) = Clearings::new(&mut lowering, &conditions);
    let stored = stored_section(&mut lowering, &mut cx, &clearings, &components, &events, &mut input_event, again);
    let situation = situation_section(&mut lowering, &clearings, encoding);
    step.add("memory of edges", edges);
    step.add("transitions that clear", clearing_statements);
    if let Some(again) = again {
        step.statements.extend(again_statement(&mut lowering, &clearings, &components, &conditions, again));
    }
    step.add("stored actions", stored);
    step.add("situation", situation);
    // Timers of durations are known only now that every moment that reads them has been lowered.
    let after = output_section(&mut lowering);
    step.statements.extend(step_timer_statements(&mut lowering));
    step.statements.extend(input_event.over(&mut lowering));

    let first = first_section(&mut lowering, profile, &input_event);
    let mut before = Section::default();
    before.statements.extend(step_timer_statements(&mut lowering));
    before.statements.extend(input_event.found(&mut lowering));

    let program = Program {
        name: net.name.clone(),
        comment: net.comment.clone(),
        variables: lowering.symbols.table,
        timers: lowering.timers,
        pool: lowering.pool,
        first,
        before: before.statements,
        micro_step: step.statements,
        repeat,
        after,
    };
    debug_assert_eq!(crate::scan::verify(&program), Ok(()), "the program as compiled");
    (Some(program), diagnostics)
}

/// Statements with a heading before each group.
#[derive(Default)]
struct Section {
    statements: Vec<Statement>,
}

impl Section {
    fn add(&mut self, heading: &str, statements: Vec<Statement>) {
        if !statements.is_empty() {
            self.statements.push(Statement::Heading(heading.to_owned()));
            self.statements.extend(statements);
        }
    }
}

/// Whether an edge operand has changed, before the memory forgets it: `again` begins with that.
fn edge_section(lowering: &mut Lowering, again: Option<VarId>) -> Vec<Statement> {
    let mut statements = Vec::new();
    if let Some(target) = again.filter(|_| !lowering.edges.is_empty()) {
        let value = lowering.edges_changed();
        statements.push(Statement::Assign { target, value, remark: None });
    }
    statements.extend(lowering.remember_operands());
    statements
}

/// Another micro-step is needed if the situation changes (R8).
fn again_statement(
    lowering: &mut Lowering,
    clearings: &Clearings,
    components: &Components,
    conditions: &IndexVec<TransitionId, FormulaId>,
    again: VarId,
) -> Option<Statement> {
    let mut terms = clearings.changes(lowering, components, conditions);
    if !lowering.edges.is_empty() {
        let edges = lowering.symbols.read(&mut lowering.pool, again);
        terms.insert(0, edges);
    }
    let value = lowering.pool.or(terms);
    let unchanged = matches!(lowering.pool.get(value), Formula::Variable(v) if *v == again);
    (!unchanged).then_some(Statement::Assign { target: again, value, remark: None })
}

/// The stored actions of a micro-step, in the order of R7: event, deactivation, clearing, activation.
fn stored_section(
    lowering: &mut Lowering,
    cx: &mut Context,
    clearings: &Clearings,
    components: &Components,
    events: &FxHashMap<usize, FormulaId>,
    input_event: &mut InputEvent,
    again: Option<VarId>,
) -> Vec<Statement> {
    let net = lowering.net;
    let step_events = StepEvents::new(lowering, clearings, components);
    let mut statements = Vec::new();
    let no_edges = without_edges(lowering, !events.is_empty(), &mut statements);
    let mut triggers = Triggers::new();
    for kind in 0..4 {
        for (index, action) in net.stored.iter().enumerate() {
            let value = action.value;
            let trigger = match (kind, action.event) {
                (0, Event::Event(s, _)) => {
                    let (when, levels) = event(lowering, s, events[&index], &no_edges, input_event, &mut statements);
                    Trigger { when, value, place: Place::At(s), repeats: !levels }
                }
                (1, Event::Deactivation(s)) => {
                    Trigger { when: step_events.deactivated(s), value, place: Place::At(s), repeats: true }
                }
                (2, Event::Clearing(t)) => {
                    let when = lowering.symbols.read(&mut lowering.pool, clearings.variable[t]);
                    let transition = &net.transitions[t];
                    // A clearing moves a token that it does not lead back.
                    let moves = |s: &StepId| components.covers(*s) && !transition.post.contains(s);
                    Trigger { when, value, place: Place::Through(t), repeats: transition.pre.iter().any(moves) }
                }
                (3, Event::Activation(s)) => {
                    Trigger { when: step_events.activated(s), value, place: Place::To(s), repeats: true }
                }
                _ => continue,
            };
            triggers.entry(action.target).or_default().push(trigger);
        }
    }
    statements.extend(step_events.statements);
    statements.extend(allocate::statements(lowering, cx, &triggers, Some(Tokens { components, clearings }), again));
    statements
}

/// What to read for each variable where all edges are taken as false.
fn without_edges(
    lowering: &mut Lowering,
    wanted: bool,
    statements: &mut Vec<Statement>,
) -> FxHashMap<VarId, FormulaId> {
    let mut by = FxHashMap::default();
    if !wanted {
        return by;
    }
    let no = lowering.pool.truth(false);
    by.extend(lowering.edges.iter().flat_map(|e| [e.rise, e.fall]).flatten().map(|v| (v, no)));
    for (part, formula) in lowering.parts.clone() {
        let level = lowering.pool.substitute(formula, &by);
        if level != formula {
            let target = lowering.symbols.fresh(Role::Temporary, "level", Type::Bool, None);
            statements.push(Statement::Assign { target, value: level, remark: None });
            by.insert(part, lowering.symbols.read(&mut lowering.pool, target));
        }
    }
    by
}

/// When an action on event is done: its step is active, the expression true, and either an edge made it true or an
/// input has just changed (R7, kind E). Also says whether the second way is possible.
fn event(
    lowering: &mut Lowering,
    step: StepId,
    expr: FormulaId,
    no_edges: &FxHashMap<VarId, FormulaId>,
    input_event: &mut InputEvent,
    statements: &mut Vec<Statement>,
) -> (FormulaId, bool) {
    let active = lowering.active(step);
    let level = lowering.pool.substitute(expr, no_edges);
    let levels = lowering.pool.as_truth(level) != Some(false);
    let mut when = lowering.pool.and([active, expr]);
    if levels {
        let changed = input_event.changed(lowering);
        let by_edge = lowering.pool.not(level);
        let caused = lowering.pool.or([by_edge, changed]);
        when = lowering.pool.and([when, caused]);
    }
    // Written variables must not be read again once the first of them has its new value.
    let reads_written = lowering.pool.below(when).into_iter().any(|f| match lowering.pool.get(f) {
        Formula::Variable(v) => matches!(lowering.symbols.table[*v].role, Role::Output | Role::Internal),
        _ => false,
    });
    if reads_written {
        let name = format!("event_{}", lowering.net.places[step].label);
        let target = lowering.symbols.fresh(Role::Temporary, name, Type::Bool, None);
        statements.push(Statement::Assign { target, value: when, remark: None });
        when = lowering.symbols.read(&mut lowering.pool, target);
    }
    (when, levels)
}

/// The new activity of each step. In place: clearings were latched, and a step reads no activity but its own.
fn situation_section(lowering: &mut Lowering, clearings: &Clearings, encoding: Encoding) -> Vec<Statement> {
    let mut statements = Vec::new();
    for s in lowering.net.places.indices() {
        if let Some(place) = clearings.place(lowering, s) {
            let value = encoding.next(&mut lowering.pool, &place);
            let target = lowering.symbols.step(s);
            statements.push(Statement::Assign { target, value, remark: None });
        }
    }
    statements
}

/// Brings the timers of step durations up to date with the situation.
fn step_timer_statements(lowering: &mut Lowering) -> Vec<Statement> {
    let timers: Vec<_> = lowering.step_timers.iter().map(|(s, t)| (*s, *t)).collect();
    timers.into_iter().map(|(s, timer)| Statement::CallTimer { timer, input: lowering.active(s) }).collect()
}

/// The outputs of continuous actions, from the situation reached, and the internal variables that they read (R11).
fn output_section(lowering: &mut Lowering) -> Vec<Statement> {
    let net = lowering.net;
    let mut cx = Context::new(Moment::After);
    for (v, variable) in net.variables.iter_enumerated() {
        if variable.mode == Mode::Wire && variable.kind == VariableKind::Output {
            lowering.wire(&mut cx, v);
        }
    }
    let mut section = Section::default();
    section.add("outputs", cx.statements);
    section.statements
}

/// The initial reaction up to its first micro-step (R10), guarded from later calls.
fn first_section(lowering: &mut Lowering, profile: Profile, input_event: &InputEvent) -> Vec<Statement> {
    let net = lowering.net;
    let mut cx = Context::new(Moment::First);
    let yes = lowering.pool.truth(true);
    let mut body = Vec::new();
    for (s, place) in net.places.iter_enumerated() {
        if place.initial {
            body.push(Statement::Assign { target: lowering.symbols.step(s), value: yes, remark: None });
        }
    }
    for (v, variable) in net.variables.iter_enumerated() {
        let kept = matches!(variable.kind, VariableKind::Output | VariableKind::Internal);
        if kept && variable.mode != Mode::Wire && variable.initial != crate::symbols::zero(variable.ty) {
            let value = lowering.pool.constant(variable.initial, variable.ty);
            body.push(Statement::Assign { target: lowering.symbols.declared(v), value, remark: None });
        }
    }
    if profile.initial_actions {
        let mut triggers = Triggers::new();
        for action in &net.stored {
            match action.event {
                Event::Activation(s) if net.places[s].initial => {
                    let trigger = Trigger { when: yes, value: action.value, place: Place::To(s), repeats: true };
                    triggers.entry(action.target).or_default().push(trigger);
                }
                Event::Event(..) | Event::Deactivation(_) | Event::Clearing(_) | Event::Activation(_) => {}
            }
        }
        for trigger in triggers.values().flatten() {
            lowering.prepare(&mut cx, trigger.value, true);
        }
        let allocations = allocate::statements(lowering, &mut cx, &triggers, None, None);
        body.append(&mut cx.statements);
        body.extend(allocations);
    }
    // What was defined for the actions no longer holds: edge operands see the variables that the actions have left.
    let mut cx = Context::new(Moment::First);
    for index in 0..lowering.edges.len() {
        let (operand, old) = (lowering.edges[index].operand, lowering.edges[index].old);
        let value = lowering.expr(&mut cx, operand);
        body.append(&mut cx.statements);
        body.push(Statement::Assign { target: old, value, remark: None });
    }
    body.extend(input_event.start(lowering));
    if body.is_empty() {
        return body;
    }
    let started =
        lowering.symbols.fresh(Role::Memory, "started", Type::Bool, Some("false until the first call".into()));
    let is_started = lowering.symbols.read(&mut lowering.pool, started);
    let at_first = lowering.pool.not(is_started);
    body.insert(0, Statement::Assign { target: started, value: yes, remark: None });
    vec![Statement::If { branches: vec![(at_first, body)], otherwise: Vec::new() }]
}
