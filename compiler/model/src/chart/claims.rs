//! What is said of a chart and changes nothing in it: assumptions on its inputs, and claims about its states.
//!
//! Their conditions lie in a pool of their own, so that nobody who asks what a chart does meets them.

use super::{Expr, ExprId, Note};
use ecow::EcoString;
use grafc_diagnostics::Span;
pub use grafc_syntax::ast::ClaimKind;
use index_vec::IndexVec;

/// All claims of a chart, in the order of the text.
#[derive(Clone, Debug, Default)]
pub struct Claims {
    /// The claims.
    pub list: Vec<Claim>,
    /// Their conditions; children before parents. None holds a delay, and only those of assumptions hold edges.
    pub exprs: IndexVec<ExprId, Expr>,
}

/// One claim.
#[derive(Clone, Debug)]
pub struct Claim {
    /// What is done with it.
    pub kind: ClaimKind,
    /// What the author calls it.
    pub text: Option<Note>,
    /// Its body as written, on one line.
    pub written: EcoString,
    /// What is claimed.
    pub body: ClaimBody,
    /// Its expressions in [`Claims::exprs`]: from the first, up to and without the second.
    pub pool: (ExprId, ExprId),
    /// Its keyword.
    pub keyword: Span,
    /// The whole item.
    pub span: Span,
}

/// What is claimed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ClaimBody {
    /// A condition: of the inputs of a reaction, or of a state. `at most one of …` and `after …` have become one.
    Condition(ExprId),
    /// From every state reached from one with the first activity without meeting the second, the second can be reached.
    Leads(ExprId, ExprId),
}

impl Claim {
    /// What messages call it: its text or, without one, its body.
    pub fn name(&self) -> &str {
        self.text.as_deref().unwrap_or(&self.written)
    }

    /// All its expressions, children before parents.
    pub fn nodes(&self) -> impl DoubleEndedIterator<Item = ExprId> + use<> {
        (self.pool.0.index()..self.pool.1.index()).map(ExprId::new)
    }

    /// The condition, if it is one.
    pub fn condition(&self) -> Option<ExprId> {
        match self.body {
            ClaimBody::Condition(condition) => Some(condition),
            ClaimBody::Leads(..) => None,
        }
    }
}

impl Claims {
    /// The claims with this keyword.
    pub fn of(&self, kind: ClaimKind) -> impl Iterator<Item = &Claim> {
        self.list.iter().filter(move |claim| claim.kind == kind)
    }

    /// The assertions that are about a state alone, each with its number, from 1 on: what a run can break.
    pub fn assertions(&self) -> impl Iterator<Item = (usize, &Claim, ExprId)> {
        let about_states = self.of(ClaimKind::Assert).filter_map(|claim| Some((claim, claim.condition()?)));
        about_states.enumerate().map(|(place, (claim, condition))| (place + 1, claim, condition))
    }
}
