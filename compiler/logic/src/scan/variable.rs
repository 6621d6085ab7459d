//! Variables, steps, states and timers of a program: what each is for.

use super::{StepId, VarId};
use ecow::{EcoString, eco_format};
use grafc_diagnostics::Span;
use grafc_formula::number::zero;
use grafc_formula::{FormulaId, Type, Value};
use grafc_model::chart::{self, Bits, Note, VariableKind};
use grafc_net::net::Place;

/// A step of the chart.
#[derive(Clone, Debug)]
pub struct Step {
    /// The label.
    pub label: EcoString,
    /// The attached comment.
    pub comment: Option<Note>,
    /// What holds its activity.
    pub held: Held,
    /// The label in the chart.
    pub span: Span,
    /// Whether the step is active, as a formula: what holds it, read.
    pub active: FormulaId,
}

/// What holds the activity of a step.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Held {
    /// A variable of its own, which is true while the step is active.
    Bit(VarId),
    /// A state, by its place among the states of the program, while it has this value.
    State(usize, i64),
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

impl State {
    /// The variables that take its values: the state itself, and its copies.
    pub fn variables(&self) -> impl Iterator<Item = VarId> {
        std::iter::once(self.variable).chain(self.copies.iter().copied())
    }
}

/// A variable of the program.
#[derive(Clone, Debug)]
pub struct Variable {
    /// What it is for.
    pub role: Role,
    /// The name to give it: the chart's own, or one derived from the chart's (`clr_5`, `old_TD`). Not yet fit for a
    /// target and not yet unique: that is the namer's work.
    pub name: EcoString,
    /// The type.
    pub ty: Type,
    /// The [value before the first call](Variable::initial).
    pub start: Bits,
    /// Whether a restart of the controller leaves it as it is.
    pub retain: bool,
    /// The attached comment of the chart, or a few words on what a variable of ours is for.
    pub comment: Option<Note>,
    /// The address in the PLC.
    pub address: Option<Note>,
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
    /// What is shown of the last micro-step to somebody who looks on; the program reads it for nothing else.
    Observed,
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

impl Flag {
    /// What a target calls it whose names are words: a field, a property.
    pub fn name(self) -> &'static str {
        match self {
            Flag::Livelock => "livelock",
            Flag::AllocConflict => "alloc_conflict",
            Flag::ForceConflict => "force_conflict",
            Flag::Div0 => "div0",
        }
    }
}

impl Role {
    /// Whether a variable of this role keeps its value from call to call: what a restart puts back to the initial value, and
    /// what is saved where power may fail.
    pub fn is_kept(self) -> bool {
        match self {
            Role::Output | Role::Internal | Role::Step | Role::State | Role::Flag(_) | Role::Memory => true,
            Role::Input | Role::Constant | Role::Temporary | Role::Observed => false,
        }
    }
}

impl Variable {
    /// A variable of ours: it starts with the zero of its type.
    pub fn new(role: Role, name: impl Into<EcoString>, ty: Type) -> Variable {
        Variable {
            role,
            name: name.into(),
            ty,
            start: Bits::of(zero(ty), ty),
            retain: false,
            comment: None,
            address: None,
            span: None,
        }
    }

    /// A variable that the chart declares, with the value that it declares.
    pub fn declared(declared: &chart::Variable) -> Variable {
        let role = match declared.kind {
            VariableKind::Input => Role::Input,
            VariableKind::Output => Role::Output,
            VariableKind::Internal => Role::Internal,
            VariableKind::Constant => Role::Constant,
        };
        Variable {
            role,
            name: declared.name.clone(),
            ty: declared.ty,
            start: declared.start,
            retain: declared.retain,
            comment: declared.comment.clone(),
            address: declared.address.clone(),
            span: Some(declared.span),
        }
    }

    /// The activity of a step.
    pub fn of_step(place: &Place) -> Variable {
        Variable {
            comment: place.comment.clone(),
            span: Some(place.span),
            ..Variable::new(Role::Step, eco_format!("X{}", place.label), Type::Bool)
        }
    }

    /// The value before the first call.
    pub fn initial(&self) -> Value {
        self.start.value(self.ty)
    }

    /// Gives it another initial value of its type.
    pub fn set_initial(&mut self, initial: Value) {
        self.start = Bits::of(initial, self.ty);
    }

    /// Whether it is shown to the outside after each call: outputs, flags, and what has an address.
    pub fn is_published(&self) -> bool {
        match self.role {
            Role::Output | Role::Flag(_) => true,
            Role::Internal => self.address.is_some(),
            Role::Input
            | Role::Constant
            | Role::Step
            | Role::State
            | Role::Memory
            | Role::Temporary
            | Role::Observed => false,
        }
    }
}

/// A timer: an on-delay in the sense of TON, with the time of one call fixed throughout the call.
#[derive(Clone, Debug)]
pub struct Timer {
    /// The name to give it.
    pub name: String,
    /// How long its input must be true; none if only the elapsed time is read.
    pub preset: Option<Preset>,
    /// A few words on what it measures.
    pub comment: Option<Note>,
}

impl Timer {
    /// The preset to give to it: where only the elapsed time is read, one that it does not reach.
    pub fn given_preset(&self) -> Preset {
        self.preset.unwrap_or(Preset::LONGEST)
    }
}

/// The preset of a timer.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Preset {
    /// Milliseconds, more than 0.
    pub ms: i64,
    /// The constant that gives it.
    pub constant: Option<VarId>,
}

impl Preset {
    /// The longest time that every target takes: 32 bits of milliseconds, some 24 days.
    pub const LONGEST: Preset = Preset { ms: i32::MAX as i64, constant: None };
}
