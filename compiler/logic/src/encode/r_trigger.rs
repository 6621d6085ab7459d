//! R-trigger (Shalyto's method 1, table 12.1): `N = NOT R AND (S OR X)`, where R is the activity of a successor.
//!
//! A step is reset only once a successor is seen to be active, so both are active for one micro-step. R dominates: in a
//! ring of two steps the token would be lost, which is why such rings get a step more beforehand.

use super::task::SetReset;
use grafc_formula::{FormulaId, Pool};

pub(super) fn next(pool: &mut Pool, step: &SetReset) -> FormulaId {
    let free = pool.not(step.reset);
    let wanted = pool.or([step.set, step.active]);
    pool.and([free, wanted])
}
