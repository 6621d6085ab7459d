//! What may meet in one micro-step: transitions after one step, assignments to one variable, orders on one grafcet.
//!
//! Listed is what is not *proved* never to happen. A proof is that two steps share a component, that one forces the other
//! away, or that two conditions contradict each other. What is looked at is bounded by the size of the net: where very
//! many actions or transitions compete, only those that stand near each other in the text are compared.

pub(crate) mod assignments;
pub(crate) mod clearings;
mod neighbours;
mod orders;
pub(in crate::analysis) mod questions;
pub(crate) mod reentry;
mod triggers;
pub(in crate::analysis) mod witness;

use super::Analysis;
use assignments::Meeting;
use clearings::Clashes;
use orders::Disagreement;
use questions::Questions;
pub(crate) use witness::Case;

/// All that may meet.
#[derive(Clone)]
pub(crate) struct Together {
    /// Transitions after one step that may be cleared together, a step at a time.
    pub(crate) clearings: Vec<Clashes>,
    /// Assignments that compute a variable from itself and may be done at once, at most one pair a variable.
    pub(crate) races: Vec<Meeting>,
    /// Orders that force a grafcet into different situations and may be in force at once, at most one pair a grafcet.
    pub(crate) orders: Vec<Disagreement>,
    /// Assignments that may give a variable different values at once, at most one pair a variable.
    pub(crate) conflicts: Vec<Meeting>,
}

pub(super) fn find(analysis: &Analysis) -> Together {
    let mut asked = Questions::new(analysis);
    Together {
        clearings: clearings::find(&mut asked),
        races: assignments::races(analysis),
        orders: orders::find(analysis),
        conflicts: assignments::conflicts(&mut asked),
    }
}
