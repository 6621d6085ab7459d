//! Words for statements, for targets that have to call something by them: labels of jumps.

use super::{Origin, Program, Statement, VarId};
use ecow::{EcoString, eco_format};

impl Program {
    /// What a statement is about, in a word made of the names of the chart: it does not change because another statement
    /// comes before it.
    pub fn word(&self, statement: &Statement) -> EcoString {
        let mut open = Some(statement);
        while let Some(now) = open {
            let word = match now {
                Statement::Heading(_) => EcoString::new(),
                Statement::Assign { target, origin, .. } => self.word_or(*origin, *target),
                Statement::Divide(division) => self.word_or(division.origin, division.target),
                Statement::CallTimer { timer, .. } => self.timers[*timer].name.as_str().into(),
                Statement::Case { of, .. } => self.variables[*of].name.clone(),
                Statement::If(_) => EcoString::new(),
            };
            if !word.is_empty() {
                return word;
            }
            open = now.bodies().flatten().find(|inner| !matches!(inner, Statement::Heading(_)));
        }
        EcoString::new()
    }

    /// A word for what a statement comes from, or for what it writes.
    fn word_or(&self, origin: Origin, target: VarId) -> EcoString {
        match origin {
            Origin::Transition(t) => self.elements.word(t, |s| self.label(s)),
            Origin::Step(s) => eco_format!("{}_{}", self.label(s), self.variables[target].name),
            Origin::Chart
            | Origin::Action(_)
            | Origin::Actions(_)
            | Origin::Order(_)
            | Origin::Orders(_)
            | Origin::Declaration(_) => self.variables[target].name.clone(),
        }
    }
}
