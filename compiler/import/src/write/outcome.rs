//! What bodies of statements have done so far, and what of them is lost.

use super::maker::Command;
use super::resolve::{Environment, Loss};
use super::terms::{TermId, VarId};
use grafc_diagnostics::Span;

/// What bodies do.
#[derive(Default)]
pub struct Effects {
    /// The variables, in the order of their first assignments.
    pub order: Vec<VarId>,
    pub environment: Environment,
    /// Orders to child programs.
    pub given: Vec<Order>,
    pub lost: Vec<Lost>,
}

/// An order to a child program, under a condition.
pub struct Order {
    pub command: Command,
    pub child: usize,
    pub guard: TermId,
    pub span: Span,
}

/// What a chart does not do.
pub struct Lost {
    pub span: Span,
    pub why: String,
    pub text: String,
}

impl Effects {
    /// Notes what is lost.
    pub fn lose(&mut self, span: Span, why: &str, text: String) {
        self.lost.push(Lost { span, why: why.to_string(), text });
    }

    /// Notes a part of a statement that cannot be said.
    pub fn lose_loss(&mut self, loss: Loss, what: &str) {
        self.lost.push(Lost {
            span: loss.span,
            why: format!("{what} cannot be said: {}", loss.why),
            text: String::new(),
        });
    }
}
