//! The stored actions of a micro-step and what triggers them, in the order of R7: event, deactivation, clearing,
//! activation. `allocate` describes how they are carried out.

use crate::encode::allocate::{self, Position, Tokens, Trigger, Triggers};
use crate::encode::clearings::{Clearings, StepEvents};
use crate::encode::each_scan;
use crate::encode::input_event::InputEvent;
use crate::encode::task::Task;
use crate::lower::{Context, Lowering};
use crate::scan::{ActionId, Origin, Role, Statement, VarId};
use ecow::eco_format;
use grafc_formula::{FormulaId, Type};
use grafc_model::chart::{Event, StepId};
use rustc_hash::FxHashMap;

/// All stored actions of a micro-step.
pub(crate) fn actions(
    lowering: &mut Lowering,
    cx: &mut Context,
    task: &Task,
    clearings: &Clearings,
    step_events: StepEvents,
    input_event: &mut InputEvent,
) -> Vec<Statement> {
    let net = &*lowering.net.clone();
    let mut statements = Vec::new();
    let no_edges = without_edges(lowering, !task.events.is_empty(), &mut statements);
    let mut triggers = Triggers::new();
    for kind in 0..4 {
        for (index, action) in net.stored.iter().enumerate() {
            let value = action.value;
            let origin = Origin::Action(ActionId::from(net.continuous.len() + index));
            let trigger = match (kind, action.event) {
                (0, Event::Event(s, _)) => {
                    let (when, levels) =
                        event(lowering, (s, origin), task.events[&index], &no_edges, input_event, &mut statements);
                    Trigger { when, value, origin, position: Position::At(s), repeats: !levels }
                }
                (1, Event::Deactivation(s)) => Trigger {
                    when: step_events.deactivated(s),
                    value,
                    origin,
                    position: Position::At(s),
                    repeats: true,
                },
                (2, Event::Clearing(t)) => {
                    let transition = &net.transitions[t];
                    // A clearing moves a token that it does not lead back.
                    let repeats = transition.left().into_iter().any(|s| task.components.covers(s));
                    Trigger { when: clearings.cleared[t], value, origin, position: Position::Through(t), repeats }
                }
                (3, Event::Activation(s)) => {
                    Trigger { when: step_events.activated(s), value, origin, position: Position::To(s), repeats: true }
                }
                _ => continue,
            };
            triggers.entry(action.target).or_default().push(trigger);
        }
    }
    statements.extend(step_events.statements);
    let tokens = Tokens { components: task.components, arcs: task.arcs };
    let each_scan = each_scan::triggers(lowering, task, clearings, &mut statements);
    statements.extend(allocate::statements(lowering, cx, &triggers, Some(tokens), task.again));
    statements.extend(each_scan::statements(lowering, cx, &each_scan, tokens, task.again));
    statements
}

/// What to read for each variable where all edges are taken as false.
pub(super) fn without_edges(
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
            let name = eco_format!("level_of_{}", lowering.symbols.table[part].name);
            let target = lowering.symbols.fresh(Role::Temporary, name, Type::Bool, None);
            statements.push(Statement::assign(Origin::Chart, target, level));
            by.insert(part, lowering.symbols.read(&mut lowering.pool, target));
        }
    }
    by
}

/// When an action on event is done: its step is active, the expression true, and either an edge made it true or an
/// input has just changed (R7, kind E). Also says whether the second way is possible.
pub(super) fn event(
    lowering: &mut Lowering,
    (step, origin): (StepId, Origin),
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
    if lowering.reads_written(when) {
        let name = format!("event_{}", lowering.net.places[step].label);
        let target = lowering.symbols.fresh(Role::Temporary, name, Type::Bool, None);
        statements.push(Statement::assign(origin, target, when));
        when = lowering.symbols.read(&mut lowering.pool, target);
    }
    (when, levels)
}
