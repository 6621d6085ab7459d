//! Terms as conditions and as arithmetic.
//!
//! Our language has two kinds of expression: conditions, and arithmetic in brackets and behind `:=`. A comparison in a
//! condition opens brackets. Parentheses are written where the grammar needs them; `and` and `or` mean the same however
//! they are grouped, so nested ones of one kind become one row. The walk has its own stack.

use super::Writer;
use crate::agrafe::model::{TermId, TermKind};

/// How tightly a term must hold together where it stands.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Binding {
    Or,
    And,
    /// Where a comparison stands in arithmetic; in a condition the brackets hold it together.
    Comparison,
    Sum,
    /// Right of a minus.
    Product,
    /// Behind `not`.
    Unary,
    /// Behind `↑`.
    Operand,
    /// Beside the slash of a delay.
    Delay,
}

/// Where a term stands.
#[derive(Clone, Copy, PartialEq, Eq)]
enum TermUse {
    Condition,
    Arithmetic,
}

enum Task {
    Term(TermId, TermUse, Binding),
    Text(&'static str),
}

impl Writer<'_> {
    /// Writes a term as a condition.
    pub fn condition(&mut self, term: TermId, level: Binding) {
        self.term(term, TermUse::Condition, level);
    }

    /// Writes a term as the right side of an assignment.
    pub fn value(&mut self, term: TermId) {
        self.term(term, TermUse::Arithmetic, Binding::Or);
    }

    fn term(&mut self, term: TermId, kind: TermUse, level: Binding) {
        let mut tasks = vec![Task::Term(term, kind, level)];
        while let Some(task) = tasks.pop() {
            if self.text.is_full() {
                return;
            }
            match task {
                Task::Text(text) => self.text.push(text),
                Task::Term(term, kind, level) => self.part(term, kind, level, &mut tasks),
            }
        }
    }

    /// Writes what stands before the operands, and leaves the rest as tasks, the last first.
    fn part(&mut self, term: TermId, kind: TermUse, level: Binding, tasks: &mut Vec<Task>) {
        let model = self.model;
        let operands = &model.terms[term].operands;
        let mut pair = |writer: &mut Self, own: Binding, sign: &'static str, left: Binding, right: Binding| {
            let close = writer.open(own < level);
            tasks.extend(close.map(Task::Text));
            for (place, &operand) in operands.iter().enumerate().rev() {
                tasks.push(Task::Term(operand, kind, if place == 0 { left } else { right }));
                if place > 0 {
                    tasks.push(Task::Text(sign));
                }
            }
        };
        match model.terms[term].kind {
            // Of one that refers to nothing an error tells, and nothing is written.
            TermKind::Variable(variable) => variable.into_iter().for_each(|id| self.variable(id, level)),
            TermKind::Boolean(value) => self.constant(value, kind, level),
            TermKind::Integer(value) => self.text.push(&value.to_string()),
            TermKind::Or => pair(self, Binding::Or, " or ", Binding::Or, Binding::Or),
            TermKind::And => pair(self, Binding::And, " and ", Binding::And, Binding::And),
            TermKind::Add => pair(self, Binding::Sum, " + ", Binding::Sum, Binding::Product),
            TermKind::Subtract => pair(self, Binding::Sum, " - ", Binding::Sum, Binding::Product),
            TermKind::Equal => self.comparison(term, " = ", kind, level, tasks),
            TermKind::Greater => self.comparison(term, " > ", kind, level, tasks),
            TermKind::Less => self.comparison(term, " < ", kind, level, tasks),
            TermKind::Not => {
                let close = self.open(Binding::Unary < level);
                self.text.push("not ");
                tasks.extend(close.map(Task::Text));
                tasks.extend(operands.iter().map(|&operand| Task::Term(operand, kind, Binding::Unary)));
            }
            TermKind::Rise | TermKind::Fall => {
                let close = self.open(Binding::Unary < level);
                self.text.push(if model.terms[term].kind == TermKind::Rise { "↑" } else { "↓" });
                tasks.extend(close.map(Task::Text));
                tasks.extend(operands.iter().map(|&operand| Task::Term(operand, kind, Binding::Operand)));
            }
        }
    }

    /// A parenthesis if there must be one; what closes it.
    fn open(&mut self, needed: bool) -> Option<&'static str> {
        if needed {
            self.text.push("(");
        }
        needed.then_some(")")
    }

    /// A comparison: in brackets in a condition.
    fn comparison(&mut self, term: TermId, sign: &'static str, kind: TermUse, level: Binding, tasks: &mut Vec<Task>) {
        let close = match kind {
            TermUse::Condition if level == Binding::Delay => {
                self.text.push("([");
                Some("])")
            }
            TermUse::Condition => {
                self.text.push("[");
                Some("]")
            }
            TermUse::Arithmetic => self.open(Binding::Comparison < level),
        };
        tasks.extend(close.map(Task::Text));
        for (place, &operand) in self.model.terms[term].operands.iter().enumerate().rev() {
            tasks.push(Task::Term(operand, TermUse::Arithmetic, Binding::Sum));
            if place > 0 {
                tasks.push(Task::Text(sign));
            }
        }
    }

    /// A Boolean constant; the standard writes `1`, and in arithmetic that would be a number.
    fn constant(&mut self, value: bool, kind: TermUse, level: Binding) {
        let close = self.open(level >= Binding::Operand);
        self.text.push(match (kind, value) {
            (TermUse::Condition, true) => "1",
            (TermUse::Condition, false) => "0",
            (TermUse::Arithmetic, true) => "true",
            (TermUse::Arithmetic, false) => "false",
        });
        self.text.push(close.unwrap_or_default());
    }
}
