//! What a target needs beside the program that saves the memory of a chart and gives it back.

use super::{Program, Statement, StepId, VarId};
use std::collections::BTreeSet;

/// How memory is given back.
#[derive(Clone, Debug, Default)]
pub struct Restoring {
    /// Gives the wires of the chart the values that they have in the situation that has been given back (R11). What these
    /// statements write need not be saved.
    pub statements: Vec<Statement>,
    /// Sets of steps of which at most one is active; a step is in one of them at most. Those that a state holds are left
    /// out, which cannot hold two. Sets that always have an active step once the chart has started come first.
    pub exclusive: Vec<Exclusive>,
}

/// Steps of which at most one is active.
#[derive(Clone, Debug)]
pub struct Exclusive {
    /// In order of declaration.
    pub steps: Vec<StepId>,
    /// Whether exactly one of them is, once the chart has started.
    pub always: bool,
}

impl Program {
    /// The variables that follow from the rest of the memory: what [`Restoring::statements`] write.
    pub fn derived(&self) -> BTreeSet<VarId> {
        let mut derived = BTreeSet::new();
        let mut open: Vec<&[Statement]> = self.restoring.iter().map(|r| r.statements.as_slice()).collect();
        while let Some(statements) = open.pop() {
            for statement in statements {
                if let Statement::Assign { target, .. } = statement
                    && self.variables[*target].role.is_kept()
                {
                    derived.insert(*target);
                }
                open.extend(statement.bodies());
            }
        }
        derived
    }
}
