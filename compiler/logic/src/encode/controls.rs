//! Inputs that act on the chart as a whole: one that lowers the flags, and one that starts the chart anew.
//!
//! Both are looked at before all else of a call. A reset gives what is kept the value that it had before the first call, and
//! stops the timers; the initial reaction follows, since its mark is lowered like the rest.

use crate::scan::{Heading, Origin, Program, Role, Statement, VarId};
use grafc_formula::{Type, Value};
use grafc_model::chart::{Controls, VariableId};
use rustc_hash::FxHashSet;

/// Puts them before the initial reaction of a program that is made but for this.
pub(crate) fn add(program: &mut Program, controls: Controls) {
    let mut first = Vec::new();
    if let Some(input) = controls.clear_flags {
        let flags = program.variables.iter_enumerated().filter(|(_, v)| matches!(v.role, Role::Flag(_)));
        let flags: Vec<VarId> = flags.map(|(id, _)| id).collect();
        let no = program.pool.truth(false);
        let mut lowered: Vec<Statement> =
            flags.into_iter().map(|flag| Statement::assign(Origin::Chart, flag, no)).collect();
        if let Some(target) = program.assertion {
            let none = program.pool.constant(Value::Int(0), program.variables[target].ty);
            lowered.push(Statement::assign(Origin::declaration(target), target, none));
        }
        first.extend(while_true(program, input, Heading::FlagsAreLowered, lowered));
    }
    if let Some(input) = controls.reset {
        let anew = anew(program, controls.keeps_retained);
        first.extend(while_true(program, input, Heading::StartsAnew, anew));
    }
    program.first.splice(0..0, first);
}

fn while_true(
    program: &mut Program,
    input: VariableId,
    heading: Heading,
    mut body: Vec<Statement>,
) -> Option<Statement> {
    if body.is_empty() {
        return None;
    }
    body.insert(0, Statement::Heading(heading));
    // Those of the chart come first in the table, in its order.
    let when = program.pool.variable(VarId::from(input.index()), Type::Bool);
    Some(Statement::when(when, body))
}

/// All that is kept, as before the first call.
fn anew(program: &mut Program, keeps_retained: bool) -> Vec<Statement> {
    let states = program.state_of();
    let values: FxHashSet<(usize, i64)> = program
        .states
        .iter()
        .enumerate()
        .flat_map(|(place, state)| {
            let all = state.idle.into_iter().chain(state.values.iter().map(|(_, value)| *value));
            all.map(move |value| (place, value))
        })
        .collect();
    let mut body = Vec::new();
    for id in program.variables.indices() {
        let variable = &program.variables[id];
        if !variable.role.is_kept() || variable.retain && keeps_retained {
            continue;
        }
        // A state that 0 is no value of gets another in the initial reaction, before anything reads it.
        if let (Some(state), Value::Int(n)) = (states.get(&id), variable.initial())
            && !values.contains(&(*state, n))
        {
            continue;
        }
        let (initial, ty) = (variable.initial(), variable.ty);
        let value = program.pool.constant(initial, ty);
        body.push(Statement::assign(Origin::Chart, id, value));
    }
    let no = program.pool.truth(false);
    let stops = |timer| Statement::CallTimer { timer, input: no, origin: Origin::Chart };
    body.extend(program.timers.indices().map(stops));
    body
}
