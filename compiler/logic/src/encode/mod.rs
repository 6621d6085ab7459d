//! Encodings: how the next activity of a step is written (Shalyto, chapter 12). One file each.

mod single_phase;

use crate::formula::{FormulaId, Pool};

/// The encodings.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Encoding {
    /// A bit a step, set-dominant: `S OR X AND NOT R`.
    #[default]
    SinglePhase,
}

/// What decides on the next activity of one step.
pub(crate) struct Place {
    /// Its activity.
    pub(crate) active: FormulaId,
    /// Whether a transition before it clears.
    pub(crate) set: FormulaId,
    /// Whether a transition after it clears.
    pub(crate) reset: FormulaId,
}

impl Encoding {
    /// The next activity of a step.
    pub(crate) fn next(self, pool: &mut Pool, place: &Place) -> FormulaId {
        match self {
            Encoding::SinglePhase => single_phase::next(pool, place),
        }
    }
}
