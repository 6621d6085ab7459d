//! Inputs that agree with the answers of a way.

use crate::atom::{Atom, Bound, Question, is_whole};
use crate::clocks::constant;
use crate::goal::Answers;
use grafc_formula::{Formula, FormulaId, Type, Value, VarId};
use grafc_logic::scan::{Program, Role, Statement, Variable};
use grafc_model::chart::Bits;
use std::collections::{BTreeMap, BTreeSet};

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
    if let Some(value) = of_bits(input, ty, answers) {
        return Some(value);
    }
    let fits = |value: &Value| {
        answers.iter().all(|(atom, answer)| match *atom {
            Atom::Holds(v) => v != input || (*value == Value::Bool(true)) == *answer,
            Atom::AtLeast(v, bound) => v != input || bound.is_reached(*value) == *answer,
            Atom::Bit(..) | Atom::Ends(..) => true,
        })
    };
    if ty == Type::Bool {
        return [before, Value::Bool(false), Value::Bool(true)].into_iter().find(fits);
    }
    // The nearest that it may be lie at the bounds.
    let bounds = answers.iter().filter_map(|(atom, _)| match *atom {
        Atom::AtLeast(v, bound) if v == input => Some(bound),
        Atom::Holds(_) | Atom::AtLeast(..) | Atom::Bit(..) | Atom::Ends(..) => None,
    });
    let near = bounds.flat_map(|bound| <[Value; 2]>::from(bound.sides(ty)));
    std::iter::once(before).chain(near).find(fits)
}

/// The value that an input has by the bits that were asked of it, if any were.
fn of_bits(input: VarId, ty: Type, answers: &Answers) -> Option<Value> {
    let bits = answers.iter().filter_map(|(atom, answer)| match *atom {
        Atom::Bit(v, bit) if v == input => Some((bit, *answer)),
        Atom::Bit(..) | Atom::Holds(_) | Atom::AtLeast(..) | Atom::Ends(..) => None,
    });
    let words = bits.map(|(bit, answer)| u64::from(answer) << bit);
    words.reduce(|a, b| a | b).map(|word| Bits::of_word(word).value(ty))
}

/// The inputs that are whole numbers and not only compared with what is known: they are taken bit by bit.
pub(crate) fn computed(program: &Program) -> BTreeSet<VarId> {
    let mut found = BTreeSet::new();
    let mut used = |formula: FormulaId| found.extend(given(program, formula));
    for id in program.pool.ids() {
        match *program.pool.get(id) {
            Formula::Compare(_, [a, b]) => {
                if constant(program, a).is_none() && constant(program, b).is_none() {
                    used(a);
                    used(b);
                }
            }
            Formula::Arithmetic(_, [a, b]) => {
                used(a);
                used(b);
            }
            Formula::Negate(a) => used(a),
            Formula::Constant(_)
            | Formula::Variable(_)
            | Formula::TimerDone(_)
            | Formula::TimerElapsed(_)
            | Formula::Not(_)
            | Formula::And(_)
            | Formula::Or(_)
            | Formula::Xor(..)
            | Formula::Widen(_) => {}
        }
    }
    for statement in program.statements() {
        match statement {
            Statement::Assign { value, .. } => used(*value),
            Statement::Divide(division) => {
                used(division.dividend);
                used(division.divisor);
            }
            Statement::Heading(_) | Statement::CallTimer { .. } | Statement::Case { .. } | Statement::If(_) => {}
        }
    }
    found.retain(|v| program.variables[*v].ty != Type::Bool && is_whole(program.variables[*v].ty));
    found
}

/// Where the values of numbers are parted that are given and only compared with what is known.
pub(crate) fn bounds(program: &Program) -> BTreeMap<VarId, BTreeSet<Bound>> {
    let computed = computed(program);
    let mut bounds: BTreeMap<VarId, BTreeSet<Bound>> = BTreeMap::new();
    for id in program.pool.ids() {
        let Formula::Compare(op, [a, b]) = *program.pool.get(id) else { continue };
        for (side, other, op) in [(a, b, op), (b, a, op.mirrored())] {
            let (Some(v), Some(value)) = (given(program, side), constant(program, other)) else { continue };
            let ty = program.variables[v].ty;
            if ty != Type::Bool && !computed.contains(&v) && !matches!(value, Value::Real(x) if x.is_nan()) {
                let Question { from, to, .. } = Question::new(op, ty, value);
                bounds.entry(v).or_default().extend(from.into_iter().chain(to));
            }
        }
    }
    bounds
}

/// The input that a formula is, perhaps as another type.
pub(crate) fn given(program: &Program, mut formula: FormulaId) -> Option<VarId> {
    while let Formula::Widen(inner) = program.pool.get(formula) {
        formula = *inner;
    }
    match program.pool.get(formula) {
        Formula::Variable(v) => (program.variables[*v].role == Role::Input).then_some(*v),
        Formula::TimerDone(_)
        | Formula::TimerElapsed(_)
        | Formula::Constant(_)
        | Formula::Not(_)
        | Formula::And(_)
        | Formula::Or(_)
        | Formula::Xor(..)
        | Formula::Compare(..)
        | Formula::Arithmetic(..)
        | Formula::Negate(_)
        | Formula::Widen(_) => None,
    }
}
