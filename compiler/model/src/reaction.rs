//! What goes into a reaction and what comes out: shared by everything that runs a chart.

use crate::chart::{StepId, Value};

/// How a chart evolves when it is called.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Evolution {
    /// Micro-steps until the situation is stable (R9).
    #[default]
    Stable,
    /// Exactly one micro-step a call, as SFC does (R14).
    Scan,
}

/// What outputs of continuous actions do in a call that LIVELOCK ended; those of stored actions keep their values.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum LivelockOutputs {
    /// As the situation says that was reached (R11).
    #[default]
    Computed,
    /// As after the call before.
    Hold,
    /// False.
    Off,
}

/// Choices that change what a chart means.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Profile {
    /// How it evolves.
    pub evolution: Evolution,
    /// Whether initial steps do their actions on activation at the start (R10).
    pub initial_actions: bool,
    /// The bound K on micro-steps (R9); `None` is max(200, steps + transitions + 1).
    pub bound: Option<u32>,
    /// What outputs do where that is hit.
    pub livelock_outputs: LivelockOutputs,
}

impl Default for Profile {
    fn default() -> Self {
        Profile {
            evolution: Evolution::Stable,
            initial_actions: true,
            bound: None,
            livelock_outputs: LivelockOutputs::Computed,
        }
    }
}

impl Profile {
    /// The largest bound: what 31 bits hold.
    pub const LARGEST_BOUND: u32 = i32::MAX as u32;

    /// The bound K for a chart of this size; macro-steps do not count.
    pub fn bound_for(&self, steps: usize, transitions: usize) -> u32 {
        self.bound.unwrap_or((steps + transitions + 1).max(200) as u32)
    }
}

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
