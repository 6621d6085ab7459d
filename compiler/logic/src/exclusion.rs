//! Conditions that exclude each other in plain sight.

use crate::formula::{Comparison, Formula, FormulaId, Pool, Value};
use crate::lower::EdgeOperand;
use crate::scan::VarId;
use rustc_hash::FxHashMap;

/// What the variables of edges imply: `rise_a` that `a` is true, `fall_a` that it is false.
pub(crate) struct EdgeFacts {
    implied: FxHashMap<VarId, (FormulaId, bool)>,
}

impl EdgeFacts {
    pub(crate) fn new(edges: &[EdgeOperand]) -> Self {
        let mut implied = FxHashMap::default();
        for edge in edges {
            implied.extend(edge.rise.map(|v| (v, (edge.now, true))));
            implied.extend(edge.fall.map(|v| (v, (edge.now, false))));
        }
        EdgeFacts { implied }
    }

    /// Whether a factor of one condition contradicts a factor of the other.
    pub(crate) fn exclude(&self, pool: &Pool, a: FormulaId, b: FormulaId) -> bool {
        let (a, b) = (self.literals(pool, a), self.literals(pool, b));
        a.iter().any(|x| b.iter().any(|y| contradict(pool, *x, *y)))
    }

    /// The factors of a condition, each with whether it is asserted or denied, and what its edges imply.
    fn literals(&self, pool: &Pool, condition: FormulaId) -> Vec<(FormulaId, bool)> {
        let factors = pool.factors(&condition);
        let mut literals = Vec::with_capacity(factors.len());
        for factor in factors.iter().copied() {
            if let Formula::Not(inner) = pool.get(factor) {
                literals.push((*inner, false));
                continue;
            }
            literals.push((factor, true));
            if let Formula::Variable(v) = pool.get(factor) {
                literals.extend(self.implied.get(v));
            }
        }
        literals
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
