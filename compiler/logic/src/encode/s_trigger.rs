//! S-trigger: `N = S OR NOT R AND X`, where R is the activity of a successor.
//!
//! The set-dominant sister of the R-trigger: the same overlap of one micro-step, and a step that its predecessor still
//! sets stays whatever its successors do.

use super::{Place, single_phase};
use crate::formula::{FormulaId, Pool};

pub(super) fn next(pool: &mut Pool, place: &Place) -> FormulaId {
    // Only R differs from the single-phase form.
    single_phase::next(pool, place)
}
