//! The next activity of a step, as the encoding writes it.

use super::task::SetReset;
use super::{r_trigger, s_trigger, single_phase};
use crate::options::Encoding;
use grafc_formula::{FormulaId, Pool};

/// The next activity of a step.
pub(super) fn next_activity(encoding: Encoding, pool: &mut Pool, step: &SetReset) -> FormulaId {
    match encoding {
        Encoding::SinglePhase | Encoding::Sequent | Encoding::Switch => single_phase::next(pool, step),
        Encoding::RTrigger => r_trigger::next(pool, step),
        Encoding::STrigger => s_trigger::next(pool, step),
    }
}
