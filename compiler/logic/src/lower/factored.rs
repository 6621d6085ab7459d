//! What several steps set, with what their conditions have in common written once: `X1 · c + X2 · c` is `(X1 + X2) · c`.

use grafc_formula::{FormulaId, Pool};
use indexmap::IndexMap;
use rustc_hash::{FxBuildHasher, FxHashSet};

/// The disjunction of terms, each the activity of a step and perhaps a condition.
pub(super) fn factored(pool: &mut Pool, terms: Vec<(FormulaId, Option<FormulaId>)>) -> FormulaId {
    let always = pool.truth(true);
    if let [(step, condition)] = terms[..] {
        return pool.and([step, condition.unwrap_or(always)]);
    }
    let mut steps: IndexMap<FormulaId, Vec<FormulaId>, FxBuildHasher> = IndexMap::default();
    for (step, condition) in terms {
        steps.entry(condition.unwrap_or(always)).or_default().push(step);
    }
    let mut conditions = steps.keys();
    let mut common: Vec<FormulaId> = conditions.next().map_or_else(Vec::new, |c| pool.factors(c).to_vec());
    for condition in conditions {
        let factors: FxHashSet<FormulaId> = pool.factors(condition).iter().copied().collect();
        common.retain(|f| factors.contains(f));
    }
    let taken: FxHashSet<FormulaId> = common.iter().copied().collect();
    let mut sum = Vec::with_capacity(steps.len());
    for (condition, steps) in steps {
        let rest: Vec<FormulaId> = pool.factors(&condition).iter().copied().filter(|f| !taken.contains(f)).collect();
        let any = pool.or(steps);
        sum.push(pool.and(std::iter::once(any).chain(rest)));
    }
    let sum = pool.or(sum);
    pool.and(std::iter::once(sum).chain(common))
}

#[cfg(test)]
mod tests {
    use super::*;
    use grafc_formula::{Formula, Type, VarId};

    #[test]
    fn what_is_common_is_written_once() {
        let mut pool = Pool::default();
        let [x1, x2, x3, a, b, c] = [0, 1, 2, 3, 4, 5].map(|n| pool.variable(VarId::from_usize(n), Type::Bool));
        let any = pool.or([x1, x2]);
        // x1 · a + x2 · a
        let expected = pool.and([any, a]);
        assert_eq!(factored(&mut pool, vec![(x1, Some(a)), (x2, Some(a))]), expected);
        // x1 · a + x2 · b + x3: nothing is common to all.
        let (xa, xb) = (pool.and([x1, a]), pool.and([x2, b]));
        let expected = pool.or([xa, xb, x3]);
        assert_eq!(factored(&mut pool, vec![(x1, Some(a)), (x2, Some(b)), (x3, None)]), expected);
        // x1 · (a · c) + x2 · (c · b) is (x1 · a + x2 · b) · c.
        let (ac, cb) = (pool.and([a, c]), pool.and([c, b]));
        let sum = pool.or([xa, xb]);
        let expected = pool.and([sum, c]);
        assert_eq!(factored(&mut pool, vec![(x1, Some(ac)), (x2, Some(cb))]), expected);
        // x1 · a + x2 · b + x3 · a: the same condition once.
        let pair = pool.or([x1, x3]);
        let xa = pool.and([pair, a]);
        let expected = pool.or([xa, xb]);
        assert_eq!(factored(&mut pool, vec![(x1, Some(a)), (x2, Some(b)), (x3, Some(a))]), expected);
        // One step alone, and none.
        assert_eq!(factored(&mut pool, vec![(x1, None)]), x1);
        assert!(matches!(
            pool.get(factored(&mut Pool::default(), Vec::new())),
            Formula::Constant(_) | Formula::Variable(_)
        ));
    }
}
