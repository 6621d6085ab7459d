//! What is claimed of the chart, for those who prove it or watch it: each condition in a variable of the role `Observed`,
//! which the program writes in each call and never reads.
//!
//! Of an assumption it is written before the evolution, from the inputs of the call and those of the call before, of all
//! others at the end of the call, from the state reached. Nothing else of a program hangs on it.

use super::VarId;
use ecow::EcoString;
use grafc_diagnostics::Span;
pub use grafc_model::chart::ClaimKind;

/// Which claims of the chart a program computes.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Default)]
pub enum Claimed {
    /// None, as generated code on a controller.
    #[default]
    Nothing,
    /// All of them.
    All,
}

/// A claim that a program computes.
#[derive(Clone, Debug)]
pub struct SeenClaim {
    /// Its place among all claims of the chart, in the order of the text.
    pub place: usize,
    /// What is done with it.
    pub kind: ClaimKind,
    /// What it is called: its text or, without one, its body.
    pub name: EcoString,
    /// What is claimed.
    pub body: SeenBody,
    /// The whole item.
    pub span: Span,
}

/// What is claimed: variables that say what is true after a call.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SeenBody {
    /// A condition: on the inputs of the call, or on the state reached.
    Condition(VarId),
    /// From every state reached from one with the first without meeting the second, the second can be reached.
    Leads(VarId, VarId),
}

impl SeenClaim {
    /// What says after a call whether what is claimed of it is true; none where it takes more than a call to say.
    pub fn condition(&self) -> Option<VarId> {
        match self.body {
            SeenBody::Condition(holds) => Some(holds),
            SeenBody::Leads(..) => None,
        }
    }

    /// Whether it is false that is a fault: of an assumption or an assertion, while a state that is wanted or final needs
    /// to be reached but once.
    pub fn must_always_hold(&self) -> bool {
        match self.kind {
            ClaimKind::Assume | ClaimKind::Assert => true,
            ClaimKind::Reach | ClaimKind::Final => false,
        }
    }

    /// All variables that it names.
    pub fn variables(&mut self) -> impl Iterator<Item = &mut VarId> {
        let (first, second) = match &mut self.body {
            SeenBody::Condition(holds) => (holds, None),
            SeenBody::Leads(from, to) => (from, Some(to)),
        };
        std::iter::once(first).chain(second)
    }
}
