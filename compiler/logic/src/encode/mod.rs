//! Encodings: how the situation is held and the next one found (Shalyto, chapter 12). One file each.
//!
//! | encoding | the next activity of a step | file |
//! | --- | --- | --- |
//! | single-phase | `S OR X AND NOT R`, R its own clearing | `single_phase` |
//! | r-trigger | `NOT R AND (S OR X)`, R an active successor | `r_trigger` |
//! | s-trigger | `S OR NOT R AND X`, the same R | `s_trigger` |
//! | sequent | `IF` a transition clears `THEN` resets, sets | `sequent` |
//! | switch | one number a set of steps, `CASE` | `switch` |
//!
//! The first four hold a bit a step and share the order of a micro-step, in `bits`.

mod bits;
mod in_order;
mod r_trigger;
mod s_trigger;
mod sequent;
mod single_phase;
pub(crate) mod switch;

use crate::formula::{FormulaId, Pool};
use crate::input_event::InputEvent;
use crate::lower::{Context, Lowering};
use crate::outputs::Followers;
use crate::scan::{Statement, VarId};
use crate::tokens::Components;
use grafc_model::chart::TransitionId;
use index_vec::IndexVec;
use rustc_hash::FxHashMap;

/// The encodings.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Encoding {
    /// A bit a step, set-dominant: `S OR X AND NOT R`.
    #[default]
    SinglePhase,
    /// A bit a step, reset by a successor that is active, reset-dominant: `NOT R AND (S OR X)`.
    RTrigger,
    /// A bit a step, reset by a successor that is active, set-dominant: `S OR NOT R AND X`.
    STrigger,
    /// A bit a step, `IF` a transition clears.
    Sequent,
    /// A multi-valued variable for each set of steps that exclude each other, bits for the rest.
    Switch,
}

/// What an encoding is given.
pub(crate) struct Task<'a> {
    /// The encoding.
    pub(crate) encoding: Encoding,
    /// Whether formulas are shortened by what has been proved.
    pub(crate) simplify: bool,
    /// The condition of each transition.
    pub(crate) conditions: &'a IndexVec<TransitionId, FormulaId>,
    /// The expression of each stored action on an event, by the number of the action.
    pub(crate) events: &'a FxHashMap<usize, FormulaId>,
    /// Sets of steps that exclude each other, as far as that may be used.
    pub(crate) components: &'a Components,
    /// Outputs that follow a state.
    pub(crate) followers: Option<&'a Followers>,
    /// Tells that another micro-step is needed, if there may be one.
    pub(crate) again: Option<VarId>,
}

/// What decides on the next activity of one step.
pub(crate) struct Place {
    /// Its activity.
    pub(crate) active: FormulaId,
    /// Whether a transition before it clears.
    pub(crate) set: FormulaId,
    /// What resets it: a transition after it that clears or, where steps overlap, a successor that is active.
    pub(crate) reset: FormulaId,
}

impl Encoding {
    /// All of them, in the order of the textbook.
    pub const ALL: [Encoding; 5] =
        [Encoding::SinglePhase, Encoding::RTrigger, Encoding::STrigger, Encoding::Sequent, Encoding::Switch];

    /// The name, as options and reports spell it.
    pub fn name(self) -> &'static str {
        match self {
            Encoding::SinglePhase => "single-phase",
            Encoding::RTrigger => "r-trigger",
            Encoding::STrigger => "s-trigger",
            Encoding::Sequent => "sequent",
            Encoding::Switch => "switch",
        }
    }

    /// Whether a step and its successor are active together for one micro-step at each hand-over.
    pub fn overlaps(self) -> bool {
        match self {
            Encoding::RTrigger | Encoding::STrigger => true,
            Encoding::SinglePhase | Encoding::Sequent | Encoding::Switch => false,
        }
    }

    /// The next activity of a step.
    fn next(self, pool: &mut Pool, place: &Place) -> FormulaId {
        match self {
            Encoding::SinglePhase | Encoding::Sequent | Encoding::Switch => single_phase::next(pool, place),
            Encoding::RTrigger => r_trigger::next(pool, place),
            Encoding::STrigger => s_trigger::next(pool, place),
        }
    }
}

/// The statements of a micro-step, all but those that compute conditions.
pub(crate) fn micro_step(
    lowering: &mut Lowering,
    cx: &mut Context,
    task: &Task,
    input_event: &mut InputEvent,
) -> Vec<Statement> {
    match task.encoding {
        Encoding::SinglePhase | Encoding::RTrigger | Encoding::STrigger | Encoding::Sequent => {
            bits::micro_step(lowering, cx, task, input_event)
        }
        Encoding::Switch => switch::micro_step(lowering, cx, task, input_event),
    }
}
