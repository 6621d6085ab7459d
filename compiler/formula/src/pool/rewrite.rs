//! Formulas made of others: with parts replaced, or with what nobody needs left out.

use super::{Candidate, Formula, FormulaId, Pool, SHORT, VarId};
use index_vec::IndexVec;
use rustc_hash::{FxHashMap, FxHashSet};

impl Pool {
    /// Every formula below `root`, operands before operators, `root` last.
    pub fn below(&self, root: FormulaId) -> Vec<FormulaId> {
        let mut ids = vec![root];
        let mut at = 0;
        // Most formulas are short, and need no table.
        while at < ids.len() && ids.len() + self.operands(ids[at]).size_hint().0 <= SHORT {
            for operand in self.operands(ids[at]) {
                if !ids.contains(&operand) {
                    ids.push(operand);
                }
            }
            at += 1;
        }
        if at < ids.len() {
            let mut seen: FxHashSet<FormulaId> = ids.iter().copied().collect();
            while let Some(id) = ids.get(at).copied() {
                ids.extend(self.operands(id).filter(|operand| seen.insert(*operand)));
                at += 1;
            }
        }
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
        let mut kept = vec![false; self.formulas.len()];
        let mut open: Vec<FormulaId> = roots.into_iter().collect();
        while let Some(id) = open.pop() {
            if !std::mem::replace(&mut kept[id.index()], true) {
                open.extend(self.operands(id));
            }
        }
        let (mut formulas, mut operands) = (0, 0);
        for id in self.ids().filter(|id| kept[id.index()]) {
            formulas += 1;
            if let Formula::And(list) | Formula::Or(list) = self.get(id) {
                operands += self.list(*list).len();
            }
        }
        let mut pool = Pool::with_capacity(formulas, operands);
        let mut new: IndexVec<FormulaId, FormulaId> = self.ids().collect();
        let mut on_new: Vec<FormulaId> = Vec::new();
        for id in self.ids().filter(|id| kept[id.index()]) {
            on_new.clear();
            let formula = match *self.get(id) {
                Formula::Variable(v) => Formula::Variable(variables[v]),
                formula @ (Formula::Constant(_) | Formula::TimerDone(_) | Formula::TimerElapsed(_)) => formula,
                formula @ (Formula::And(list) | Formula::Or(list)) => {
                    on_new.extend(self.list(list).iter().map(|a| new[*a]));
                    formula
                }
                Formula::Not(a) => Formula::Not(new[a]),
                Formula::Xor([a, b]) => Formula::Xor([new[a], new[b]]),
                Formula::Compare(op, [a, b]) => Formula::Compare(op, [new[a], new[b]]),
                Formula::Arithmetic(op, [a, b]) => Formula::Arithmetic(op, [new[a], new[b]]),
                Formula::Negate(a) => Formula::Negate(new[a]),
                Formula::Widen(a) => Formula::Widen(new[a]),
            };
            new[id] = pool.add_candidate(&Candidate { formula, ty: self.ty(id), list: &on_new });
        }
        (pool, new)
    }

    /// One formula on new operands, all of which are in `new`.
    pub fn rebuilt(&mut self, id: FormulaId, new: &FxHashMap<FormulaId, FormulaId>) -> FormulaId {
        match *self.get(id) {
            Formula::Variable(_) | Formula::Constant(_) | Formula::TimerDone(_) | Formula::TimerElapsed(_) => id,
            Formula::Not(a) => self.not(new[&a]),
            Formula::And(list) => {
                let operands: Vec<FormulaId> = self.list(list).iter().map(|o| new[o]).collect();
                self.and(operands)
            }
            Formula::Or(list) => {
                let operands: Vec<FormulaId> = self.list(list).iter().map(|o| new[o]).collect();
                self.or(operands)
            }
            Formula::Xor([a, b]) => self.xor(new[&a], new[&b]),
            Formula::Compare(op, [a, b]) => self.compare(op, new[&a], new[&b]),
            Formula::Arithmetic(op, [a, b]) => self.arithmetic(op, self.ty(id), new[&a], new[&b]),
            Formula::Negate(a) => self.negate(new[&a]),
            Formula::Widen(a) => self.widen(self.ty(id), new[&a]),
        }
    }
}
