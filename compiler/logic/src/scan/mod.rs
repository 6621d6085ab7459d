//! The scan program: what one call of the generated code does, statement by statement.
//!
//! Everything that a backend would have to decide has been decided here: the order of statements, every temporary,
//! guards of divisions, the stability loop. A backend chooses spelling and names, never meaning.
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
mod dump;
pub mod evaluate;
mod measure;
mod verify;

pub use dump::{dump, equations};
pub use measure::{Measure, measure};
pub use verify::verify;

use grafc_diagnostics::Span;
use grafc_formula::{FormulaId, Pool, Type, Value};
pub use grafc_formula::{TimerId, VarId};
pub use grafc_model::chart::StepId;
use index_vec::IndexVec;

/// The statements of one scan.
#[derive(Clone, Debug)]
pub struct Program {
    /// The chart's name.
    pub name: String,
    /// The chart's attached comment.
    pub comment: Option<String>,
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
    /// The initial reaction; these statements hold their own guard.
    pub first: Vec<Statement>,
    /// Once a call, before the evolution.
    pub before: Vec<Statement>,
    /// One micro-step.
    pub micro_step: Vec<Statement>,
    /// Whether another micro-step is needed, and at most how many; none if a call is one micro-step.
    pub repeat: Option<Repeat>,
    /// Once a call, after the evolution.
    pub after: Vec<Statement>,
}

/// A step of the chart.
#[derive(Clone, Debug)]
pub struct Step {
    /// The label.
    pub label: String,
    /// The attached comment.
    pub comment: Option<String>,
    /// Whether the step is active: a variable of its own, or a comparison of the state that holds it.
    pub active: FormulaId,
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
    /// At most so many micro-steps; at least one.
    pub bound: u32,
}

/// A variable that says which one of several steps is active.
#[derive(Clone, Debug)]
pub struct State {
    /// The variable; a whole number.
    pub variable: VarId,
    /// Its value while none of the steps is active; none if one of them always is, from the first call on.
    pub idle: Option<i64>,
    /// Its value for each step, in order of declaration.
    pub values: Vec<(StepId, i64)>,
    /// Further variables that hold one of these values: what it will be, what it was.
    pub copies: Vec<VarId>,
}

/// A variable of the program.
#[derive(Clone, Debug)]
pub struct Variable {
    /// What it is for.
    pub role: Role,
    /// The name to give it: the chart's own, or one derived from the chart's (`clr_5`, `old_TD`). Not yet fit for a
    /// target and not yet unique: that is the namer's work.
    pub name: String,
    /// The type.
    pub ty: Type,
    /// The value before the first call.
    pub initial: Value,
    /// The attached comment of the chart, or a few words on what a variable of ours is for.
    pub comment: Option<String>,
    /// The address in the PLC.
    pub address: Option<String>,
    /// Where in the chart it comes from.
    pub span: Option<Span>,
}

/// What a variable is for, and how long its value lives.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Role {
    /// Given before each call.
    Input,
    /// Published after each call; keeps its value.
    Output,
    /// An internal variable of the chart; keeps its value.
    Internal,
    /// A constant of the chart.
    Constant,
    /// The activity of a step; keeps its value.
    Step,
    /// Which of several steps is active; keeps its value.
    State,
    /// A run-time flag; starts false, keeps its value, readable from outside.
    Flag(Flag),
    /// Memory of ours that keeps its value from call to call: edge operands, off-delays, the mark of the first call.
    Memory,
    /// A value that lives within one call.
    Temporary,
}

/// The run-time flags.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Flag {
    /// The bound on micro-steps was hit.
    Livelock,
    /// Two stored actions gave one variable different values in one micro-step.
    AllocConflict,
    /// Two orders of one grafcet asked for different situations.
    ForceConflict,
    /// Something was divided by zero.
    Div0,
}

/// A timer: an on-delay in the sense of TON, with the time of one call fixed throughout the call.
#[derive(Clone, Debug)]
pub struct Timer {
    /// The name to give it.
    pub name: String,
    /// How long its input must be true; none if only the elapsed time is read.
    pub preset: Option<Preset>,
    /// A few words on what it measures.
    pub comment: Option<String>,
}

/// The preset of a timer.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Preset {
    /// Milliseconds, more than 0.
    pub ms: i64,
    /// The constant that gives it.
    pub constant: Option<VarId>,
}

/// One statement.
#[derive(Clone, PartialEq, Debug)]
pub enum Statement {
    /// A heading for the reader.
    Heading(String),
    /// `target := value`, with a remark for the reader.
    Assign {
        /// What is written.
        target: VarId,
        /// The value.
        value: FormulaId,
        /// What the reader should know: a transition as the chart draws it, an attached comment.
        remark: Option<String>,
    },
    /// `target := dividend / divisor`, or 0 and the flag DIV0 if the divisor is 0.
    Divide {
        /// What is written.
        target: VarId,
        /// `true` for the remainder.
        modulo: bool,
        /// A formula without operators.
        dividend: FormulaId,
        /// A formula without operators; of constants only 0, since others divide inside a formula.
        divisor: FormulaId,
        /// The flag to raise.
        flag: VarId,
    },
    /// Brings a timer up to date with its input and the time of the call.
    CallTimer {
        /// The timer.
        timer: TimerId,
        /// Its input.
        input: FormulaId,
    },
    /// The arm of a variable's value.
    Case {
        /// The variable, a whole number.
        of: VarId,
        /// What is done at each value; no value twice, no body empty, at least one.
        arms: Vec<Arm>,
    },
    /// The first branch whose condition is true.
    If {
        /// Conditions and what they guard; none is empty.
        branches: Vec<(FormulaId, Vec<Statement>)>,
        /// Otherwise: what a source transition on 1 stores where a later one may store something else, in an encoding
        /// that writes clearings out.
        otherwise: Vec<Statement>,
    },
}

/// What is done at one value of a variable.
#[derive(Clone, PartialEq, Debug)]
pub struct Arm {
    /// The value.
    pub value: i64,
    /// What the reader should know: the step that the value stands for.
    pub remark: Option<String>,
    /// What is done.
    pub body: Vec<Statement>,
}
