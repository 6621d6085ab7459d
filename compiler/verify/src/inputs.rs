//! Inputs that agree with the answers of a way.

use crate::atom::Atom;
use crate::goal::Answers;
use grafc_formula::{Type, Value, VarId};
use grafc_logic::scan::{Program, Role, Variable};

/// The inputs of a program, in order of declaration.
pub(crate) fn inputs(program: &Program) -> impl Iterator<Item = (VarId, &Variable)> {
    program.variables.iter_enumerated().filter(|(_, variable)| variable.role == Role::Input)
}

/// A value for each input that agrees with the answers of a reaction; what does not matter is as before. None if no value
/// was found.
pub(crate) fn agreeing(program: &Program, answers: &Answers, before: &[Value]) -> Option<Vec<Value>> {
    inputs(program).zip(before).map(|((v, variable), before)| of_input(v, variable.ty, answers, *before)).collect()
}

fn of_input(input: VarId, ty: Type, answers: &Answers, before: Value) -> Option<Value> {
    let fits = |value: &Value| {
        answers.iter().all(|(atom, answer)| match *atom {
            Atom::Holds(v) => v != input || (*value == Value::Bool(true)) == *answer,
            Atom::AtLeast(v, bound) => v != input || bound.is_reached(*value) == *answer,
            Atom::Ends(..) => true,
        })
    };
    if ty == Type::Bool {
        return [before, Value::Bool(false), Value::Bool(true)].into_iter().find(fits);
    }
    // The nearest that it may be lie at the bounds.
    let bounds = answers.iter().filter_map(|(atom, _)| match *atom {
        Atom::AtLeast(v, bound) if v == input => Some(bound),
        Atom::Holds(_) | Atom::AtLeast(..) | Atom::Ends(..) => None,
    });
    let near = bounds.flat_map(|bound| <[Value; 2]>::from(bound.sides(ty)));
    std::iter::once(before).chain(near).find(fits)
}
