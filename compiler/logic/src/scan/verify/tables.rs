//! What the tables of a program say, and what its statements have to fit.

use crate::scan::{Choice, Flag, Held, Limit, Origin, Program, Repeat, Role, SeenBody, Statement, Step, Told, VarId};
use grafc_formula::{Comparison, Formula, Type, Value};

/// Checks steps, timers, the initial reaction, what is shown, and the stability loop.
pub(super) fn verify(program: &Program) -> Result<(), String> {
    for step in &program.steps {
        holds(program, step)?;
    }
    for timer in &program.timers {
        if timer.preset.is_some_and(|preset| preset.ms <= 0) {
            return Err(format!("the timer `{}` has a preset that is over at once", timer.name));
        }
    }
    come_from_something(program)?;
    starts(program)?;
    shown(program)?;
    program.repeat.map_or(Ok(()), |repeat| ends(program, repeat))
}

/// Statements come from elements that there are, and only of steps and transitions is something said beside them.
fn come_from_something(program: &Program) -> Result<(), String> {
    let said = |origin: Origin, told: Told| {
        let unsaid = match told {
            Told::Nothing => true,
            Told::Comment => matches!(origin, Origin::Step(_)),
            Told::Name | Told::All | Told::Steps | Told::Before(_) => false,
        };
        let is_told = unsaid || program.remark(origin, told).is_some();
        if program.has(origin) && is_told {
            Ok(())
        } else {
            Err(format!("a statement comes from {origin:?}, {told:?}"))
        }
    };
    for statement in program.statements() {
        match statement {
            Statement::Assign { origin, told, .. } => said(*origin, *told)?,
            Statement::Case { arms, .. } => arms.iter().try_for_each(|arm| said(arm.origin, arm.told))?,
            Statement::Heading(_) | Statement::Divide(_) | Statement::CallTimer { .. } | Statement::If(_) => {
                said(statement.origin(), Told::Nothing)?;
            }
        }
    }
    Ok(())
}

/// What holds a step is what its formula reads.
fn holds(program: &Program, step: &Step) -> Result<(), String> {
    let pool = &program.pool;
    let read = |variable: VarId, id| *pool.get(id) == Formula::Variable(variable);
    let fits = match (step.held, pool.get(step.active)) {
        (Held::Bit(v), Formula::Variable(read)) => v == *read && program.variables[v].role == Role::Step,
        (Held::State(place, value), Formula::Compare(Comparison::Equal, [a, b])) => {
            let state = program.states.get(place);
            state.is_some_and(|state| read(state.variable, *a) && state.values.iter().any(|(_, n)| *n == value))
                && pool.as_constant(*b) == Some(Value::Int(value))
        }
        (Held::Bit(_) | Held::State(..), _) => false,
    };
    if fits {
        Ok(())
    } else {
        Err(format!("step {} is held by {:?} and read by {}", step.label, step.held, step.active))
    }
}

/// The initial reaction is guarded by the mark of the first call, and sets it. Before it stands only what inputs ask for.
fn starts(program: &Program) -> Result<(), String> {
    let (_, reaction) = program.asked_and_reaction();
    let Some(started) = program.started else {
        return if reaction.is_empty() { Ok(()) } else { Err("nothing guards the initial reaction".to_owned()) };
    };
    let is_mark = |id| *program.pool.get(id) == Formula::Variable(started);
    let guarded = reaction.iter().all(|statement| match statement {
        Statement::If(choice) => {
            let Choice { branches, otherwise } = &**choice;
            let [(when, body)] = branches.as_slice() else { return false };
            let sets = |statement: &Statement| match statement {
                Statement::Assign { target, value, .. } => {
                    *target == started && program.pool.as_truth(*value) == Some(true)
                }
                _ => false,
            };
            let at_first = matches!(program.pool.get(*when), Formula::Not(mark) if is_mark(*mark));
            otherwise.is_empty() && at_first && body.iter().any(sets)
        }
        _ => false,
    });
    let kept = program.variables[started].role == Role::Memory && program.variables[started].ty == Type::Bool;
    if guarded && kept && reaction.len() == 1 {
        return Ok(());
    }
    Err(format!("{started} does not guard the initial reaction"))
}

/// What is shown stands in variables that are there for nothing else.
fn shown(program: &Program) -> Result<(), String> {
    let is_none = |v: &VarId| program.variables.get(*v).is_none_or(|v| v.role != Role::Observed || v.ty != Type::Bool);
    let claimed = program.claims.iter().flat_map(|claim| match claim.body {
        SeenBody::Condition(v) => [Some(v), None],
        SeenBody::Leads(from, to) => [Some(from), Some(to)],
    });
    if let Some(v) = claimed.flatten().find(is_none) {
        return Err(format!("{v} says whether a claim is true, and is no variable for that"));
    }
    let Some(observing) = &program.observing else { return Ok(()) };
    let transitions = observing
        .transitions
        .iter()
        .flat_map(|seen| [Some(seen.enabled), Some(seen.cleared), seen.satisfied].into_iter().flatten());
    let situation = observing.frozen.iter().map(|(_, v)| *v).chain(observing.forced.iter().map(|(_, v)| *v));
    let numbered = observing.orders.iter().chain(&observing.actions).map(|(_, v)| *v);
    let mut all = observing.wanted.into_iter().chain(transitions).chain(situation).chain(numbered);
    match all.find(is_none) {
        Some(v) => Err(format!("{v} shows something, and is no variable for that")),
        None => Ok(()),
    }
}

/// The stability loop asks a bit, and counts to its bound in a variable that holds it.
fn ends(program: &Program, repeat: Repeat) -> Result<(), String> {
    let ty = |v: VarId| program.variables[v].ty;
    if ty(repeat.again) != Type::Bool {
        return Err(format!("{} cannot ask for another micro-step", repeat.again));
    }
    let Some(Limit { count, bound, flag }) = repeat.limit else { return Ok(()) };
    let most = match ty(count) {
        Type::Int => i16::MAX as u32,
        Type::Uint => u32::from(u16::MAX),
        Type::Dint | Type::Udint => i32::MAX as u32,
        Type::Bool | Type::Real | Type::Lreal | Type::Time => 0,
    };
    if bound == 0 || bound > most {
        return Err(format!("{count} cannot count to {bound}"));
    }
    if program.variables[flag].role != Role::Flag(Flag::Livelock) {
        return Err(format!("{flag} is raised where no situation is stable"));
    }
    Ok(())
}
