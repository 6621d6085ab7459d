//! What backends ask of a program as a whole.

use super::{Program, Role, Statement, TimerId, VarId, Variable, is_empty};
use grafc_formula::Formula;
use index_vec::IndexVec;
use rustc_hash::FxHashMap;

/// Which guarded divisions a program has.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Divided {
    /// For a quotient.
    pub quotient: bool,
    /// For a remainder.
    pub remainder: bool,
}

/// What is read of a timer.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Reads {
    /// Whether it has run out.
    pub end: bool,
    /// For how long it has run.
    pub elapsed: bool,
}

impl Program {
    /// The sections, in the order in which a call runs them; the last is what gives memory back, which no call runs.
    pub fn sections(&self) -> [&[Statement]; 5] {
        let restoring = self.restoring.as_ref().map_or(&[][..], |restoring| &restoring.statements);
        [&self.first, &self.before, &self.micro_step, &self.after, restoring]
    }

    /// All statements, a statement before those within it.
    pub fn statements(&self) -> impl Iterator<Item = &Statement> {
        let mut open: Vec<std::slice::Iter<Statement>> = self.sections().into_iter().rev().map(<[_]>::iter).collect();
        std::iter::from_fn(move || {
            loop {
                let Some(statement) = open.last_mut()?.next() else {
                    open.pop();
                    continue;
                };
                let at = open.len();
                open.extend(statement.bodies().map(<[_]>::iter));
                open[at..].reverse();
                return Some(statement);
            }
        })
    }

    /// What stands in `first`: what inputs ask for while they are true, as a reset does, with the values that a call keeps
    /// from the one before; and the initial reaction.
    pub fn asked_and_reaction(&self) -> (&[Statement], &[Statement]) {
        let asked = |statement: &Statement| match statement {
            Statement::If(choice) => match (choice.branches.as_slice(), choice.otherwise.is_empty()) {
                ([(when, _)], true) => match self.pool.get(*when) {
                    Formula::Variable(v) => self.variables[*v].role == Role::Input,
                    _ => false,
                },
                _ => false,
            },
            // Memory where they are saved as well.
            Statement::Assign { target, .. } => {
                matches!(self.variables[*target].role, Role::Temporary | Role::Memory)
            }
            Statement::Heading(_) | Statement::Divide(_) | Statement::CallTimer { .. } | Statement::Case { .. } => {
                false
            }
        };
        self.first.split_at(self.first.iter().take_while(|statement| asked(statement)).count())
    }

    /// The variables of a role, in order.
    pub fn of_role(&self, role: Role) -> impl Iterator<Item = (VarId, &Variable)> {
        self.variables.iter_enumerated().filter(move |(_, variable)| variable.role == role)
    }

    /// For each variable that takes its values from a state, the place of that among the states: the state itself, and its
    /// copies.
    pub fn state_of(&self) -> FxHashMap<VarId, usize> {
        let states = self.states.iter().enumerate();
        states.flat_map(|(place, state)| state.variables().map(move |v| (v, place))).collect()
    }

    /// What is read of each timer.
    pub fn reads_of_timers(&self) -> IndexVec<TimerId, Reads> {
        let mut reads: IndexVec<TimerId, Reads> = self.timers.iter().map(|_| Reads::default()).collect();
        for id in self.pool.ids() {
            if let Formula::TimerDone(timer) = self.pool.get(id) {
                reads[*timer].end = true;
            } else if let Formula::TimerElapsed(timer) = self.pool.get(id) {
                reads[*timer].elapsed = true;
            }
        }
        reads
    }

    /// Which guarded divisions there are.
    pub fn divided(&self) -> Divided {
        let mut divided = Divided::default();
        for statement in self.statements() {
            if let Statement::Divide(division) = statement {
                divided.quotient |= !division.modulo;
                divided.remainder |= division.modulo;
            }
        }
        divided
    }

    /// A variable to write where a call does nothing at all, since no compiler takes an empty body; none if a call does
    /// something, or if there are only constants.
    pub fn idle_variable(&self) -> Option<VarId> {
        if self.repeat.is_some() || !self.sections().into_iter().all(is_empty) {
            return None;
        }
        self.variables.iter_enumerated().find(|(_, v)| v.role != Role::Constant).map(|(id, _)| id)
    }
}
