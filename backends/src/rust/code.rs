//! What the functions of a scan are made of, and what a function has to be given.

use grafc_formula::FormulaId;
use grafc_logic::scan::{Arm, Statement, VarId};

/// What a function needs to be given.
#[derive(Clone, Copy, Default)]
pub(super) struct Needs {
    pub inputs: bool,
    pub now: bool,
    /// The values that functions share.
    pub values: bool,
    /// The names of steps.
    pub steps: bool,
}

impl Needs {
    /// What is needed of something for the inputs, something for the time and something for the values.
    pub fn of<T>(self, [inputs, now, values]: [T; 3]) -> impl Iterator<Item = T> {
        let all = [(self.inputs, inputs), (self.now, now), (self.values, values)];
        all.into_iter().filter_map(|(needed, one)| needed.then_some(one))
    }

    /// And what something else needs, except the names of steps: each function names those that it uses.
    pub fn and(&mut self, other: Needs) {
        self.inputs |= other.inputs;
        self.now |= other.now;
        self.values |= other.values;
    }
}

/// Branches and what else.
pub(super) struct Choice<'p> {
    pub branches: Vec<(FormulaId, Vec<Code<'p>>)>,
    pub otherwise: Vec<Code<'p>>,
}

/// A statement, or what is left of one whose parts are elsewhere. There are many, so they are small.
pub(super) enum Code<'p> {
    /// As it stands.
    Plain(&'p Statement),
    /// The stability loop, with the function of its micro-step.
    Loop(usize),
    /// Whether another micro-step is needed, which the function of a micro-step tells.
    Again(VarId),
    /// The call of a function.
    Call(usize),
    /// Parts of an `If`.
    If(Box<Choice<'p>>),
    /// Arms of a state.
    Arms(VarId, Box<[(&'p Arm, Vec<Code<'p>>)]>),
    /// By the value of a state, the function that a table has for it.
    Table(VarId, usize),
}
