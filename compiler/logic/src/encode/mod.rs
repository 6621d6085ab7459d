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

mod allocate;
mod bits;
mod by_grafcet;
mod choose;
pub(crate) mod claims;
pub(crate) mod clearings;
mod commanded;
pub(crate) mod controls;
pub(crate) mod each_scan;
pub(crate) mod first_call;
pub(crate) mod heading;
mod in_order;
pub(crate) mod input_event;
pub(crate) mod livelock;
pub(crate) mod momentary;
mod next_activity;
pub(crate) mod observe;
pub(crate) mod outputs;
mod pulses;
mod r_trigger;
pub(crate) mod restoring;
mod s_trigger;
mod sequent;
mod settle;
mod single_phase;
mod state_case;
pub(crate) mod stored;
mod switch;
pub(crate) mod task;
pub(crate) mod without_flag;

use crate::lower::{Context, Lowering};
use crate::options::Encoding;
use crate::scan::Statement;
use input_event::InputEvent;
use task::Task;

/// Adds the statements of a micro-step, all but those that compute conditions.
pub(crate) fn micro_step(
    lowering: &mut Lowering,
    cx: &mut Context,
    task: &Task,
    input_event: &mut InputEvent,
    out: &mut Vec<Statement>,
) {
    match task.encoding {
        Encoding::SinglePhase | Encoding::RTrigger | Encoding::STrigger | Encoding::Sequent => {
            bits::micro_step(lowering, cx, task, input_event, out);
        }
        Encoding::Switch => out.extend(switch::micro_step(lowering, cx, task, input_event)),
    }
}
