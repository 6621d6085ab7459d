//! What formulas read and statements write: two statements may change places, and a value may be kept, as long as neither
//! meets the other.

use crate::scan::{Division, Statement, TimerId, VarId};
use grafc_formula::{Formula, FormulaId, Pool};
use rustc_hash::FxHashSet;

/// What has a value that statements change.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Cell {
    Variable(VarId),
    Timer(TimerId),
}

/// What a formula reads.
pub(super) fn read_by(pool: &Pool, root: FormulaId) -> FxHashSet<Cell> {
    let mut read = FxHashSet::default();
    for id in pool.below(root) {
        match pool.get(id) {
            Formula::Variable(v) => {
                read.insert(Cell::Variable(*v));
            }
            Formula::TimerDone(t) | Formula::TimerElapsed(t) => {
                read.insert(Cell::Timer(*t));
            }
            Formula::Constant(_)
            | Formula::Not(_)
            | Formula::And(_)
            | Formula::Or(_)
            | Formula::Xor(..)
            | Formula::Compare(..)
            | Formula::Arithmetic(..)
            | Formula::Negate(_)
            | Formula::Widen(_) => {}
        }
    }
    read
}

/// What a statement writes, and those within it. Statements nest no deeper than lowering nests them.
pub(super) fn each_written(statement: &Statement, of: &mut dyn FnMut(Cell)) {
    match statement {
        Statement::Heading(_) => {}
        Statement::Assign { target, .. } => of(Cell::Variable(*target)),
        Statement::Divide(Division { target, flag, .. }) => {
            of(Cell::Variable(*target));
            of(Cell::Variable(*flag));
        }
        Statement::CallTimer { timer, .. } => of(Cell::Timer(*timer)),
        Statement::Case { .. } | Statement::If(_) => {
            statement.bodies().flatten().for_each(|inner| each_written(inner, of));
        }
    }
}
