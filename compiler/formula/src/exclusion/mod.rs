//! Conditions that exclude each other.
//!
//! Two conditions of one micro-step exclude each other if their conjunction has no model. Most pairs are decided by a
//! look at their factors; the others by a binary decision diagram, of bounded size, over
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
mod proof;
mod scale;

pub use edges::{EdgeFacts, EdgeOperand};

use crate::{Comparison, Formula, FormulaId, Pool, Value, VarId};
use proof::{Proof, below};
use rustc_hash::FxHashSet;

/// More factors than this are not compared one by one.
const FACTORS: usize = 32;

impl EdgeFacts {
    /// Whether two conditions are never true in one micro-step.
    pub fn exclude(&self, pool: &Pool, a: FormulaId, b: FormulaId) -> bool {
        self.in_plain_sight(pool, a, b) || self.share(pool, a, b) && Proof::new(self, pool, None).refuted(a, b)
    }

    /// Whether `a`, true in some micro-step, and `b`, true in a later one of the same reaction, exclude each other, where
    /// only the variables that are `stable` keep their values. An edge of a stable operand is over by then.
    pub fn exclude_later(&self, pool: &Pool, a: FormulaId, b: FormulaId, stable: &dyn Fn(VarId) -> bool) -> bool {
        Proof::new(self, pool, Some(stable)).refuted(a, b)
    }

    /// Whether a factor of one condition contradicts a factor of the other.
    fn in_plain_sight(&self, pool: &Pool, a: FormulaId, b: FormulaId) -> bool {
        if [a, b].iter().any(|c| pool.as_truth(*c) == Some(false)) {
            return true;
        }
        let (a, b) = (self.literals(pool, &a), self.literals(pool, &b));
        a.iter().any(|x| b.iter().any(|y| contradict(pool, *x, *y)))
    }

    /// The first factors of a condition, each with whether it is asserted or denied, and what its edges imply.
    fn literals(&self, pool: &Pool, condition: &FormulaId) -> Vec<(FormulaId, bool)> {
        let mut literals = Vec::new();
        for factor in pool.factors(condition).iter().copied().take(FACTORS) {
            if let Formula::Not(inner) = pool.get(factor) {
                literals.push((*inner, false));
                continue;
            }
            literals.push((factor, true));
            if let Formula::Variable(v) = pool.get(factor) {
                literals.extend(self.edge(*v).map(|edge| (edge.now, edge.rising)));
            }
        }
        literals
    }

    /// Whether some variable or timer has a say in both conditions. Conditions without a common one are true together
    /// if each can be true. Too large a condition counts as sharing none: nothing will be proved of it.
    fn share(&self, pool: &Pool, a: FormulaId, b: FormulaId) -> bool {
        let (Some(a), Some(b)) = (below(pool, a), below(pool, b)) else { return false };
        let leaf = |f: FormulaId| match pool.get(f) {
            Formula::Variable(v) => Some(self.edge(*v).map_or(f, |edge| edge.now)),
            _ => (pool.is_leaf(f) && pool.as_constant(f).is_none()).then_some(f),
        };
        let read: FxHashSet<FormulaId> = a.into_iter().filter_map(leaf).collect();
        b.into_iter().filter_map(leaf).any(|f| read.contains(&f))
    }
}

fn contradict(pool: &Pool, (a, asserted_a): (FormulaId, bool), (b, asserted_b): (FormulaId, bool)) -> bool {
    if a == b {
        return asserted_a != asserted_b;
    }
    match (pool.get(a), pool.get(b)) {
        (Formula::Compare(p, a1, a2), Formula::Compare(q, b1, b2)) => {
            asserted_a
                && asserted_b
                && (disjoint_values(pool, (*p, *a1, *a2), (*q, *b1, *b2)) || (a1, a2) == (b1, b2) && disjoint(*p, *q))
        }
        _ => false,
    }
}

/// `C = 3` and `C = 4`.
fn disjoint_values(
    pool: &Pool,
    (p, a1, a2): (Comparison, FormulaId, FormulaId),
    (q, b1, b2): (Comparison, FormulaId, FormulaId),
) -> bool {
    let literal = |f| matches!(pool.get(f), Formula::Constant(Value::Int(_) | Value::Time(_)));
    (p, q) == (Comparison::Equal, Comparison::Equal) && a1 == b1 && a2 != b2 && literal(a2) && literal(b2)
}

/// Whether two comparisons of the same operands cannot both hold. A real that is no number satisfies none but `<>`.
fn disjoint(p: Comparison, q: Comparison) -> bool {
    use Comparison::*;
    matches!(
        (p, q),
        (Equal, NotEqual | Less | Greater)
            | (NotEqual | Less | Greater, Equal)
            | (Less, Greater | GreaterEqual)
            | (Greater, Less | LessEqual)
            | (LessEqual, Greater)
            | (GreaterEqual, Less)
    )
}
