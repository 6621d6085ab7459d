//! Choices of which it is known beforehand that a branch is never taken, or always.

use crate::lower::Lowering;
use crate::scan::{Flag, Origin, Statement};
use grafc_formula::FormulaId;
use rustc_hash::FxHashSet;

/// An IF with these branches, less those that are never taken and what follows one that always is: a source transition
/// on 1 whose clearing is not named, as in the r- and s-trigger, is done otherwise.
pub(crate) fn choose(lowering: &Lowering, branches: Vec<(FormulaId, Vec<Statement>)>) -> Vec<Statement> {
    let mut kept = Vec::with_capacity(branches.len());
    let mut otherwise = Vec::new();
    let mut asked = FxHashSet::default();
    for (when, body) in branches {
        // What has been asked before is not true any more.
        if !asked.insert(when) {
            continue;
        }
        match lowering.pool.as_truth(when) {
            Some(false) => {}
            Some(true) => {
                otherwise = body;
                break;
            }
            None => kept.push((when, body)),
        }
    }
    if kept.is_empty() { otherwise } else { vec![Statement::choice(kept, otherwise)] }
}

/// Raises a flag where something holds.
pub(crate) fn raise(lowering: &mut Lowering, flag: Flag, origin: Origin, when: FormulaId) -> Vec<Statement> {
    if lowering.pool.as_truth(when) == Some(false) {
        return Vec::new();
    }
    let target = lowering.symbols.flag(flag);
    let value = lowering.pool.truth(true);
    choose(lowering, vec![(when, vec![Statement::assign(origin, target, value)])])
}
