//! Words for formulas that get a variable of their own.

use crate::scan::{Timer, TimerId, VarId, Variable};
use ecow::EcoString;
use grafc_formula::{Formula, FormulaId, Pool, Value};
use index_vec::IndexVec;

/// So many variables are named, if they are not too long.
const NAMED: usize = 3;
const LONG: usize = 18;

/// `all_a_b_c`, `any_XM2_XM3`: what a formula is of the variables that it reads, from left to right.
pub(super) fn formula_word(
    pool: &Pool,
    variables: &IndexVec<VarId, Variable>,
    timers: &IndexVec<TimerId, Timer>,
    root: FormulaId,
) -> EcoString {
    let mut word = EcoString::from(match pool.get(root) {
        Formula::And(_) => "all",
        Formula::Or(_) => "any",
        Formula::Not(_) => "not",
        Formula::Constant(_)
        | Formula::Variable(_)
        | Formula::TimerDone(_)
        | Formula::TimerElapsed(_)
        | Formula::Xor(..)
        | Formula::Compare(..)
        | Formula::Arithmetic(..)
        | Formula::Negate(_)
        | Formula::Widen(_) => "is",
    });
    let mut named = 0;
    let mut open = vec![root];
    while let Some(id) = open.pop() {
        let part: EcoString = match pool.get(id) {
            Formula::Variable(v) => variables[*v].name.clone(),
            Formula::TimerDone(t) | Formula::TimerElapsed(t) => timers[*t].name.as_str().into(),
            Formula::Constant(Value::Int(n)) => ecow::eco_format!("{n}"),
            Formula::Constant(_) => continue,
            Formula::Not(_)
            | Formula::And(_)
            | Formula::Or(_)
            | Formula::Xor(..)
            | Formula::Compare(..)
            | Formula::Arithmetic(..)
            | Formula::Negate(_)
            | Formula::Widen(_) => {
                open.extend(pool.operands(id).rev());
                continue;
            }
        };
        word.push('_');
        if named == NAMED || word.len() > LONG {
            word.push_str("more");
            break;
        }
        named += 1;
        word.push_str(&part);
    }
    word
}
