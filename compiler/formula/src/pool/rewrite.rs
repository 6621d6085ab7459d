//! Formulas made of others: with parts replaced, or with what nobody needs left out.

use super::{Formula, FormulaId, Pool, TypedFormula, VarId};
use index_vec::IndexVec;
use rustc_hash::{FxHashMap, FxHashSet};

impl Pool {
    /// Every formula below `root`, operands before operators, `root` last.
    pub fn below(&self, root: FormulaId) -> Vec<FormulaId> {
        if self.is_leaf(root) {
            return vec![root];
        }
        let mut seen = FxHashSet::default();
        let mut stack = vec![root];
        while let Some(id) = stack.pop() {
            if seen.insert(id) {
                stack.extend(self.operands(id));
            }
        }
        let mut ids: Vec<FormulaId> = seen.into_iter().collect();
        ids.sort_unstable();
        ids
    }

    /// The formula with variables replaced.
    pub fn substitute(&mut self, root: FormulaId, by: &FxHashMap<VarId, FormulaId>) -> FormulaId {
        let reads = |pool: &Pool, id: FormulaId| match pool.get(id) {
            Formula::Variable(v) => by.get(v).copied(),
            _ => None,
        };
        let replaced = self.below(root).into_iter().filter_map(|id| Some((id, reads(self, id)?))).collect();
        self.replace(root, &replaced)
    }

    /// The formula with formulas in it replaced.
    pub fn replace(&mut self, root: FormulaId, by: &FxHashMap<FormulaId, FormulaId>) -> FormulaId {
        let mut new: FxHashMap<FormulaId, FormulaId> = FxHashMap::default();
        for id in self.below(root) {
            let replaced = match by.get(&id) {
                Some(replacement) => *replacement,
                None => self.rebuilt(id, &new),
            };
            new.insert(id, replaced);
        }
        new[&root]
    }

    /// Only the formulas below the roots, with the variables renumbered; and the new id of each, which means something
    /// for those that are kept.
    pub fn compacted(
        &self,
        roots: impl IntoIterator<Item = FormulaId>,
        variables: &IndexVec<VarId, VarId>,
    ) -> (Pool, IndexVec<FormulaId, FormulaId>) {
        let mut kept = vec![false; self.nodes.len()];
        let mut open: Vec<FormulaId> = roots.into_iter().collect();
        while let Some(id) = open.pop() {
            if !std::mem::replace(&mut kept[id.index()], true) {
                open.extend(self.operands(id));
            }
        }
        let mut pool = Pool::with_capacity(kept.iter().filter(|kept| **kept).count());
        let mut new: IndexVec<FormulaId, FormulaId> = self.ids().collect();
        for id in self.ids().filter(|id| kept[id.index()]) {
            let TypedFormula { formula, ty } = self.nodes[id.index()].clone();
            let formula = match formula {
                Formula::Variable(v) => Formula::Variable(variables[v]),
                Formula::Constant(_) | Formula::TimerDone(_) | Formula::TimerElapsed(_) => formula,
                Formula::Not(a) => Formula::Not(new[a]),
                Formula::And(list) => Formula::And(list.iter().map(|a| new[*a]).collect()),
                Formula::Or(list) => Formula::Or(list.iter().map(|a| new[*a]).collect()),
                Formula::Xor(a, b) => Formula::Xor(new[a], new[b]),
                Formula::Compare(op, a, b) => Formula::Compare(op, new[a], new[b]),
                Formula::Arithmetic(op, a, b) => Formula::Arithmetic(op, new[a], new[b]),
                Formula::Negate(a) => Formula::Negate(new[a]),
                Formula::Widen(a) => Formula::Widen(new[a]),
            };
            new[id] = pool.add(formula, ty);
        }
        (pool, new)
    }

    /// One formula on new operands, all of which are in `new`.
    pub fn rebuilt(&mut self, id: FormulaId, new: &FxHashMap<FormulaId, FormulaId>) -> FormulaId {
        match self.get(id).clone() {
            Formula::Variable(_) | Formula::Constant(_) | Formula::TimerDone(_) | Formula::TimerElapsed(_) => id,
            Formula::Not(a) => self.not(new[&a]),
            Formula::And(list) => self.and(list.iter().map(|o| new[o])),
            Formula::Or(list) => self.or(list.iter().map(|o| new[o])),
            Formula::Xor(a, b) => self.xor(new[&a], new[&b]),
            Formula::Compare(op, a, b) => self.compare(op, new[&a], new[&b]),
            Formula::Arithmetic(op, a, b) => self.arithmetic(op, self.ty(id), new[&a], new[&b]),
            Formula::Negate(a) => self.negate(new[&a]),
            Formula::Widen(a) => self.widen(self.ty(id), new[&a]),
        }
    }
}
