//! Conditions that exclude each other.
//!
//! Two conditions of one micro-step exclude each other if their conjunction has no model. Most pairs are decided by their
//! factors: one contradicts another, or cannot hold where the plain ones do. The others are decided by binary decision
//! diagrams, of bounded size, one for those factors that have to do with each other, over
//!
//! | atom | what is known of it |
//! | --- | --- |
//! | Boolean variable, activity of a step, output of a timer | nothing |
//! | edge of a variable (X4) | `rise = now AND NOT old`, `fall = NOT now AND old` |
//! | comparison with a constant, or of two operands | where its operand can lie, see `scale` |
//!
//! What is not proved counts as not excluded. The work on a pair is bounded, so that the work on all pairs is linear.
//!
//! Conditions of two micro-steps of one reaction are compared by what stays the same in a reaction (R9): each of the
//! other atoms counts twice, once for either micro-step.

mod edges;
mod factors;
mod proof;
mod scale;

pub use edges::{EdgeFacts, EdgeOperand};

use crate::{Formula, FormulaId, Pool, VarId};
use proof::Proof;
use rustc_hash::FxHashSet;

impl EdgeFacts {
    /// Whether two conditions are never true in one micro-step.
    pub fn exclude(&self, pool: &Pool, a: FormulaId, b: FormulaId) -> bool {
        self.exclude_plainly(pool, a, b) || self.share(pool, a, b) && self.groups_refuted(pool, &[a, b])
    }

    /// Whether that is seen without a decision diagram: conditions of any length are compared.
    pub fn exclude_plainly(&self, pool: &Pool, a: FormulaId, b: FormulaId) -> bool {
        factors::contradict(self, pool, a, b)
    }

    /// Whether `a`, true in some micro-step, and `b`, true in a later one of the same reaction, exclude each other, where
    /// only the variables that are `stable` keep their values. An edge of a stable operand is over by then.
    pub fn exclude_later(&self, pool: &Pool, a: FormulaId, b: FormulaId, stable: &dyn Fn(VarId) -> bool) -> bool {
        Proof::new(self, pool, Some(stable)).refuted(a, b)
    }

    /// For which values of the `kept` variables conditions of one micro-step can all hold, as a list of cases; an empty
    /// one if they never do. None if that takes too much work.
    pub fn cases(&self, pool: &Pool, conditions: &[FormulaId], kept: &dyn Fn(VarId) -> bool) -> Option<Vec<Case>> {
        let mut asked = Vec::new();
        for group in factors::groups(self, pool, conditions) {
            if group.factors.iter().any(|factor| self.variables(pool, *factor).any(kept)) {
                asked.extend(group.factors);
            } else if conditions.len() > 1 && Proof::new(self, pool, None).all_refuted(&group.factors) {
                return Some(Vec::new());
            }
        }
        Proof::new(self, pool, None).cases(&asked, kept)
    }

    /// The variables that a condition reads, itself or as operands of edges.
    pub fn variables<'p>(&'p self, pool: &'p Pool, condition: FormulaId) -> impl Iterator<Item = VarId> + 'p {
        factors::read(self, pool, condition).filter_map(|f| match pool.get(f) {
            Formula::Variable(v) => Some(*v),
            _ => None,
        })
    }

    /// Whether factors that have to do with each other contradict each other.
    fn groups_refuted(&self, pool: &Pool, conditions: &[FormulaId]) -> bool {
        let groups = factors::groups(self, pool, conditions);
        groups.iter().any(|group| Proof::new(self, pool, None).all_refuted(&group.factors))
    }

    /// Whether some variable or timer has a say in both conditions. Conditions without a common one are true together
    /// if each can be true.
    fn share(&self, pool: &Pool, a: FormulaId, b: FormulaId) -> bool {
        let read: FxHashSet<FormulaId> = factors::read(self, pool, a).collect();
        factors::read(self, pool, b).any(|f| read.contains(&f))
    }
}

/// Values of variables.
pub type Case = Vec<(VarId, bool)>;
