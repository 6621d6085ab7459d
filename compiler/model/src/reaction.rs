//! What goes into a reaction and what comes out: shared by everything that runs a chart.

use crate::chart::{StepId, Value};
pub use crate::profile::{Asked, Evolution, LivelockOutputs, Profile};

/// The run-time flags; once raised they stay.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Flags {
    /// The bound on micro-steps was hit.
    pub livelock: bool,
    /// Two stored actions gave one variable different values in one micro-step.
    pub alloc_conflict: bool,
    /// Two orders of one grafcet asked for different situations.
    pub force_conflict: bool,
    /// Something was divided by zero.
    pub div0: bool,
}

impl Flags {
    /// The names of the raised flags, in the order of the fields.
    pub fn names(self) -> impl Iterator<Item = &'static str> {
        [
            (self.livelock, "LIVELOCK"),
            (self.alloc_conflict, "ALLOC_CONFLICT"),
            (self.force_conflict, "FORCE_CONFLICT"),
            (self.div0, "DIV0"),
        ]
        .into_iter()
        .filter_map(|(raised, name)| raised.then_some(name))
    }
}

/// What a call is given.
#[derive(Clone, PartialEq, Debug)]
pub struct Stimulus {
    /// The time in milliseconds; never less than at the call before.
    pub t_ms: i64,
    /// Whether the controller has restarted: what is retained is kept, all the rest is as before the first call.
    pub restart: bool,
    /// A value for each input, in order of declaration.
    pub inputs: Vec<Value>,
}

/// What a call gives back.
#[derive(Clone, PartialEq, Debug)]
pub struct Response {
    /// A value for each output, in order of declaration.
    pub outputs: Vec<Value>,
    /// The active steps, in order of declaration.
    pub situation: Vec<StepId>,
    /// The flags raised so far.
    pub flags: Flags,
}
