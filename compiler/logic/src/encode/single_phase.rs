//! Single-phase (Shalyto's methods 2 and 3): `N = S OR X AND NOT R`.
//!
//! R is the clearing of the step's own downstream transitions, so the step goes in the very micro-step in which its
//! successors come. S dominates: a step that is deactivated and activated at once stays active (IEC 60848, rule 5).

use super::task::SetReset;
use grafc_formula::{FormulaId, Pool};

pub(super) fn next(pool: &mut Pool, step: &SetReset) -> FormulaId {
    let kept = pool.not(step.reset);
    let stays = pool.and([step.active, kept]);
    pool.or([step.set, stays])
}
