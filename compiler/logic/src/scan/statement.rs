//! The statements of a program.

use super::{Division, Heading, Origin, TimerId, Told, VarId};
use grafc_formula::FormulaId;

/// One statement.
#[derive(Clone, PartialEq, Debug)]
pub enum Statement {
    /// A heading for the reader.
    Heading(Heading),
    /// `target := value`.
    Assign {
        /// What is written.
        target: VarId,
        /// The value.
        value: FormulaId,
        /// Where it comes from.
        origin: Origin,
        /// How much of that is said beside it.
        told: Told,
    },
    /// A quotient or a remainder by what may be 0.
    Divide(Division),
    /// Brings a timer up to date with its input and the time of the call.
    CallTimer {
        /// The timer.
        timer: TimerId,
        /// Its input.
        input: FormulaId,
        /// Where it comes from.
        origin: Origin,
    },
    /// The arm of a variable's value.
    Case {
        /// The variable, a whole number.
        of: VarId,
        /// What is done at each value; no value twice, no body empty, at least one.
        arms: Vec<Arm>,
    },
    /// What is done in the first branch whose condition is true.
    If(Box<Choice>),
}

/// What is done where conditions are true.
#[derive(Clone, PartialEq, Debug)]
pub struct Choice {
    /// Conditions and what they guard; none is empty.
    pub branches: Vec<(FormulaId, Vec<Statement>)>,
    /// Otherwise: what a source transition on 1 stores where a later one may store something else, in an encoding
    /// that writes clearings out.
    pub otherwise: Vec<Statement>,
}

/// A program has several for each step.
const _: () = assert!(size_of::<Statement>() <= 32);

/// What is done at one value of a variable.
#[derive(Clone, PartialEq, Debug)]
pub struct Arm {
    /// The value.
    pub value: i64,
    /// Where it comes from: the step that the value stands for.
    pub origin: Origin,
    /// How much of that is said beside it.
    pub told: Told,
    /// What is done.
    pub body: Vec<Statement>,
}

impl Statement {
    /// `target := value`, with nothing beside it.
    pub fn assign(origin: Origin, target: VarId, value: FormulaId) -> Statement {
        Statement::Assign { target, value, origin, told: Told::Nothing }
    }

    /// What is done where a condition is true.
    pub fn when(condition: FormulaId, body: Vec<Statement>) -> Statement {
        Statement::choice(vec![(condition, body)], Vec::new())
    }

    /// What is done where the first of some conditions is true, and otherwise.
    pub fn choice(branches: Vec<(FormulaId, Vec<Statement>)>, otherwise: Vec<Statement>) -> Statement {
        Statement::If(Box::new(Choice { branches, otherwise }))
    }

    /// Where it comes from. A choice has no origin of its own: its arms have, and of its branches see [`origin_of`].
    pub fn origin(&self) -> Origin {
        match self {
            Statement::Heading(_) | Statement::Case { .. } | Statement::If(_) => Origin::Chart,
            Statement::Assign { origin, .. } | Statement::CallTimer { origin, .. } => *origin,
            Statement::Divide(division) => division.origin,
        }
    }

    /// Says the whole of its origin beside it, if that is a step or a transition.
    pub fn tell(&mut self) {
        if let Statement::Assign { told, origin: Origin::Step(_) | Origin::Transition(_), .. } = self {
            *told = Told::All;
        }
    }

    /// The statements within it, block by block.
    pub fn bodies(&self) -> impl Iterator<Item = &[Statement]> {
        let (arms, branches, otherwise): (&[Arm], &[_], &[Statement]) = match self {
            Statement::Heading(_) | Statement::Assign { .. } | Statement::Divide(_) | Statement::CallTimer { .. } => {
                (&[], &[], &[])
            }
            Statement::Case { of: _, arms } => (arms, &[], &[]),
            Statement::If(choice) => (&[], &choice.branches, &choice.otherwise),
        };
        let arms = arms.iter().map(|arm| arm.body.as_slice());
        let branches = branches.iter().map(|(_, body)| body.as_slice());
        arms.chain(branches).chain([otherwise])
    }
}

/// Where a branch comes from: whatever its first statement comes from. What stands under a heading is about several things.
pub fn origin_of(body: &[Statement]) -> Origin {
    body.first().map_or(Origin::Chart, Statement::origin)
}

/// Where the end of a choice comes from: from its branch, if there is only one.
pub fn origin_of_end(branches: &[(FormulaId, Vec<Statement>)], otherwise: &[Statement]) -> Origin {
    match branches {
        [(_, body)] if is_empty(otherwise) => origin_of(body),
        _ => Origin::Chart,
    }
}

/// Whether statements do nothing: compilers refuse an empty block.
pub fn is_empty(statements: &[Statement]) -> bool {
    statements.iter().all(|statement| matches!(statement, Statement::Heading(_)))
}
