//! Habits of other languages, and the cure for each.
//!
//! Who comes from Structured Text, from C, from a textbook or from another tongue writes what is right there. Where the
//! grammar stops at such a thing, a row of `TABLE` says what it is called here, and mostly changes it. What shows in a
//! single word or sign, whatever stands around it, is in [`words`] and in the lexer; what shows only when names are
//! known, `N fill` or `x1`, is found where names are resolved.

mod actions;
mod conditions;
mod declarations;
mod items;
mod slip;
mod table;
#[cfg(test)]
mod tests;
mod transitions;
pub mod words;

pub(crate) use declarations::{in_letters_of_iec, named};
pub(crate) use items::opening;
pub(crate) use slip::{Cure, Slip, Spot};

/// What others write, and its cure.
pub(crate) struct Habit {
    /// An item as they write it, in which nothing else is wrong.
    #[cfg_attr(not(test), allow(dead_code, reason = "each row is its own test"))]
    pub(crate) wrong: &'static str,
    /// The same after the cure.
    #[cfg_attr(not(test), allow(dead_code, reason = "each row is its own test"))]
    pub(crate) right: &'static str,
    cure: fn(&Slip<'_>) -> Option<Cure>,
}

/// The help for a mistake, if there is one.
pub(crate) fn cure(slip: &Slip<'_>) -> Option<Cure> {
    table::TABLE.iter().find_map(|habit| (habit.cure)(slip))
}
