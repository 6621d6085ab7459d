//! The initial reaction up to its first micro-step (R10).

use super::allocate::{self, Position, Trigger, Triggers};
use super::input_event::InputEvent;
use super::outputs::Followers;
use super::switch;
use crate::lower::{Context, Lowering, Moment};
use crate::scan::{ActionId, Flag, Origin, Role, Statement, Told, VarId};
use grafc_formula::Type;
use grafc_model::chart::{Event, Mode, VariableKind};
use grafc_model::reaction::Profile;

/// The initial reaction up to its first micro-step (R10), guarded from later calls by the mark of the first one.
pub(crate) fn first_call(
    lowering: &mut Lowering,
    profile: Profile,
    followers: Option<&Followers>,
    input_event: &InputEvent,
) -> (Vec<Statement>, Option<VarId>) {
    let net = &*lowering.net.clone();
    let mut cx = Context::new(Moment::First);
    let yes = lowering.pool.truth(true);
    let (mut body, mut retained) = (Vec::new(), Vec::new());
    for (s, place) in net.places.iter_enumerated() {
        if let Some(target) = lowering.situation.bit(s).filter(|_| place.initial) {
            body.push(Statement::Assign { target, value: yes, origin: Origin::Step(s), told: Told::Comment });
        }
    }
    for (s, place) in net.places.iter_enumerated() {
        if let Some(target) = lowering.frozen_bits.saved[s].filter(|_| place.saved) {
            body.push(Statement::assign(Origin::Step(s), target, yes));
        }
    }
    for (g, grafcet) in net.grafcets.iter_enumerated() {
        if let Some(target) = lowering.frozen_bits.frozen[g].filter(|_| grafcet.starts_frozen) {
            body.push(Statement::assign(Origin::Orders(g), target, yes));
        }
    }
    if let Some(followers) = followers {
        body.extend(switch::start(lowering, followers));
    }
    if net.conflict_at_start {
        let target = lowering.symbols.flag(Flag::ForceConflict);
        body.push(Statement::assign(Origin::Chart, target, yes));
    }
    for (v, variable) in net.variables.iter_enumerated() {
        let kept = matches!(variable.kind, VariableKind::Output | VariableKind::Internal);
        if kept && variable.mode != Mode::Wire && variable.initial() != grafc_formula::number::zero(variable.ty) {
            let value = lowering.pool.constant(variable.initial(), variable.ty);
            let statement = Statement::assign(Origin::Declaration(v), lowering.symbols.declared(v), value);
            if variable.retain { retained.push(statement) } else { body.push(statement) }
        }
    }
    body.extend(at_first_of_all(lowering, retained));
    if profile.initial_actions {
        let mut triggers = Triggers::new();
        for (index, action) in net.stored.iter().enumerate() {
            match action.event {
                Event::Activation(s) if net.places[s].initial => {
                    let origin = Origin::Action(ActionId::from(net.continuous.len() + index));
                    let (value, position) = (action.value, Position::To(s));
                    let trigger = Trigger { when: yes, value, origin, position, repeats: true };
                    triggers.entry(action.target).or_default().push(trigger);
                }
                Event::Event(..)
                | Event::Deactivation(_)
                | Event::Clearing(_)
                | Event::Activation(_)
                | Event::EachScan(..) => {}
            }
        }
        for trigger in triggers.values().flatten() {
            cx.origin = trigger.origin;
            lowering.prepare(&mut cx, trigger.value, true);
        }
        let allocations = allocate::statements(lowering, &mut cx, &triggers, None, None);
        body.append(&mut cx.statements);
        body.extend(allocations);
    }
    // What was defined for the actions no longer holds: edge operands see the variables that the actions have left.
    let mut cx = Context::new(Moment::First);
    for index in 0..lowering.edges.len() {
        let (operand, old) = (lowering.edge_operands[index], lowering.edges[index].old);
        let origin = lowering.edge_origins[index];
        cx.origin = origin;
        let value = lowering.expr(&mut cx, operand);
        body.append(&mut cx.statements);
        body.push(Statement::assign(origin, old, value));
    }
    body.extend(input_event.start(lowering));
    if body.is_empty() {
        return (body, None);
    }
    let started =
        lowering.symbols.fresh(Role::Memory, "started", Type::Bool, Some("false until the first call".into()));
    let is_started = lowering.symbols.read(&mut lowering.pool, started);
    let at_first = lowering.pool.not(is_started);
    body.insert(0, Statement::assign(Origin::Chart, started, yes));
    (vec![Statement::when(at_first, body)], Some(started))
}

/// What the first call of all gives to variables that are retained, guarded from the first calls after restarts by a mark
/// that is retained as they are.
fn at_first_of_all(lowering: &mut Lowering, mut body: Vec<Statement>) -> Option<Statement> {
    if body.is_empty() {
        return None;
    }
    let about = "whether what is retained has had its initial value";
    let mark = lowering.symbols.fresh(Role::Memory, "retained", Type::Bool, Some(about.into()));
    lowering.symbols.table[mark].retain = true;
    let is_set = lowering.symbols.read(&mut lowering.pool, mark);
    let (at_first, yes) = (lowering.pool.not(is_set), lowering.pool.truth(true));
    body.push(Statement::assign(Origin::Chart, mark, yes));
    Some(Statement::when(at_first, body))
}
