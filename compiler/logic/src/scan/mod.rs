//! The scan program: what one call of the generated code does, statement by statement.
//!
//! Everything that a backend would have to decide has been decided here: the order of statements, every temporary,
//! guards of divisions, the stability loop. A backend chooses spelling and names, never meaning. What more than one backend
//! asks of a program is answered here, too:
//!
//! | file | what |
//! | --- | --- |
//! | `variable` | what a variable is for, which of them keep their values, what holds a step, how long a timer runs |
//! | `statement` | the statements |
//! | `origin`, `elements` | where in the chart a statement comes from, and what is said of that beside it |
//! | `words` | what a statement is called where it needs a label |
//! | `division` | which divisors a division looks at first, and what comes out then |
//! | `restoring` | what gives saved memory back |
//! | `observing`, `claims` | what is shown of micro-steps, and what is claimed |
//! | `fingerprint` | a number that tells programs apart |
//! | `facts` | sections, loops over all statements, what is read of timers, which state a variable takes its values from |
//! | `verify` | the check of the invariants |
//! | `worst` | the longest call |
//! | `dump`, `evaluate`, `measure` | the program as text, run, counted |
//!
//! One call runs
//! 1. `first`: the initial reaction up to its first micro-step (R10), inside an `If` that guards it from later calls;
//! 2. `before`, once: timers of step durations are brought up to date, input events are found (R7, kind E);
//! 3. `micro_step`: once (`repeat` is none), or until `again` is false or, if there is a limit, so many micro-steps are
//!    done, which raises LIVELOCK (R1-R9);
//! 4. `after`, once: outputs (R11).
//!
//! Invariants: a statement reads only variables that hold a value; operands come before operators in the pool; the
//! value of every `Assign` has the type of its target, and storing it wraps around; a state and its copies take no
//! values but those of the state.

#[cfg(test)]
pub(crate) mod by_hand;
mod claims;
mod division;
mod dump;
mod elements;
pub mod evaluate;
mod facts;
mod fingerprint;
mod measure;
mod observing;
mod origin;
mod restoring;
mod statement;
#[cfg(test)]
mod tests;
mod variable;
mod verify;
mod words;
mod worst;

pub use claims::{ClaimKind, Claimed, SeenBody, SeenClaim};
pub use division::{ByMinusOne, Division, Guard};
pub use dump::{dump, equations};
pub use elements::{Action, Elements, Grafcet, Order, Origins, Transition, When};
pub use facts::{Divided, Reads};
pub use fingerprint::Fingerprint;
pub use grafc_formula::{TimerId, VarId};
pub use grafc_model::chart::{GrafcetId, Note, StepId, TransitionId, VariableId};
pub use measure::{Measure, measure};
pub use observing::{Observed, Observing, SeenDelay, SeenTransition};
pub use origin::{ActionId, Heading, OrderId, Origin, Part, Told};
pub use restoring::{Exclusive, Restoring};
pub use statement::{Arm, Choice, Statement, is_empty, origin_of, origin_of_end};
pub use variable::{Flag, Held, Preset, Role, State, Step, Timer, Variable};
pub use verify::verify;
pub use worst::WorstCase;

use grafc_formula::Pool;
use index_vec::IndexVec;

/// The statements of one scan.
#[derive(Clone, Debug)]
pub struct Program {
    /// The chart's name.
    pub name: String,
    /// The chart's attached comment.
    pub comment: Option<Note>,
    /// Variables; inputs, outputs, internal variables, constants and steps in order of declaration.
    pub variables: IndexVec<VarId, Variable>,
    /// Timers.
    pub timers: IndexVec<TimerId, Timer>,
    /// All formulas.
    pub pool: Pool,
    /// The steps of the chart, in order of declaration.
    pub steps: IndexVec<StepId, Step>,
    /// The multi-valued variables that hold several steps each.
    pub states: Vec<State>,
    /// Its transitions, actions and orders, which statements say that they come from.
    pub elements: Elements,
    /// The initial reaction; these statements hold their own guard.
    pub first: Vec<Statement>,
    /// The mark of the first call, which the guard asks for: false until then. None if there is no initial reaction.
    pub started: Option<VarId>,
    /// Once a call, before the evolution.
    pub before: Vec<Statement>,
    /// One micro-step.
    pub micro_step: Vec<Statement>,
    /// Whether another micro-step is needed, and at most how many; none if a call is one micro-step.
    pub repeat: Option<Repeat>,
    /// At most so many micro-steps a call.
    pub most: u32,
    /// Once a call, after the evolution.
    pub after: Vec<Statement>,
    /// What gives saved memory back, for a target that saves it.
    pub restoring: Option<Restoring>,
    /// What it shows of its micro-steps, for a target that lets somebody look on.
    pub observing: Option<Observing>,
    /// What is claimed of the chart, in the order of the text; empty unless somebody asked.
    pub claims: Vec<SeenClaim>,
    /// The output that tells the first assertion that was false, if it is asked for: 0 while there is none. Who lowers the
    /// flags lowers it as well.
    pub assertion: Option<VarId>,
}

/// The stability loop (R9).
#[derive(Clone, Copy, Debug)]
pub struct Repeat {
    /// True after a micro-step that needs another.
    pub again: VarId,
    /// Ends an evolution that finds no stable situation; none where it is proved that each does.
    pub limit: Option<Limit>,
}

/// The bound on micro-steps.
#[derive(Clone, Copy, Debug)]
pub struct Limit {
    /// Counts the micro-steps of the call; its type holds the bound.
    pub count: VarId,
    /// At most so many micro-steps: at least one, and at most what 31 bits hold.
    pub bound: u32,
    /// The flag to raise when it is hit: LIVELOCK.
    pub flag: VarId,
}
