//! The statements of a program.

use super::{Division, TimerId, VarId};
use grafc_formula::FormulaId;

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
    /// A quotient or a remainder by what may be 0.
    Divide(Division),
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

impl Statement {
    /// The statements within it, block by block.
    pub fn bodies(&self) -> impl Iterator<Item = &[Statement]> {
        let (arms, branches, otherwise): (&[Arm], &[_], &[Statement]) = match self {
            Statement::Heading(_) | Statement::Assign { .. } | Statement::Divide(_) | Statement::CallTimer { .. } => {
                (&[], &[], &[])
            }
            Statement::Case { of: _, arms } => (arms, &[], &[]),
            Statement::If { branches, otherwise } => (&[], branches, otherwise),
        };
        let arms = arms.iter().map(|arm| arm.body.as_slice());
        let branches = branches.iter().map(|(_, body)| body.as_slice());
        arms.chain(branches).chain([otherwise])
    }
}

/// Whether statements do nothing: compilers refuse an empty block.
pub fn is_empty(statements: &[Statement]) -> bool {
    statements.iter().all(|statement| matches!(statement, Statement::Heading(_)))
}
