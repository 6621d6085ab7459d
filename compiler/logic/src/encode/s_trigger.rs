//! S-trigger: `N = S OR NOT R AND X`, where R is the activity of a successor.
//!
//! The set-dominant sister of the R-trigger: the same overlap of one micro-step, and a step that its predecessor still
//! sets stays whatever its successors do.

use super::single_phase;
use super::task::SetReset;
use grafc_formula::{FormulaId, Pool};

pub(super) fn next(pool: &mut Pool, step: &SetReset) -> FormulaId {
    // Only R differs from the single-phase form.
    single_phase::next(pool, step)
}
