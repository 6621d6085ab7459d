//! What expressions have been lowered to at one moment.

use grafc_formula::FormulaId;
use grafc_model::chart::ExprId;
use index_vec::IndexVec;
use std::ops::Index;

/// The formula of each expression that has been lowered. Nearly all are, so there is a place for each up to the last.
#[derive(Clone, Default)]
pub(super) struct LoweredExprs(IndexVec<ExprId, Option<FormulaId>>);

impl LoweredExprs {
    /// The formula of an expression, once it is lowered.
    pub(super) fn get(&self, e: ExprId) -> Option<FormulaId> {
        self.0.get(e).copied().flatten()
    }

    /// An expression has been lowered.
    pub(super) fn insert(&mut self, e: ExprId, formula: FormulaId) {
        if self.0.len() <= e.index() {
            self.0.resize(e.index() + 1, None);
        }
        self.0[e] = Some(formula);
    }

    /// All that have been.
    pub(super) fn iter(&self) -> impl Iterator<Item = (ExprId, FormulaId)> + '_ {
        self.0.iter_enumerated().filter_map(|(e, formula)| Some((e, (*formula)?)))
    }
}

impl Index<ExprId> for LoweredExprs {
    type Output = FormulaId;

    /// # Panics
    /// If it has not been lowered: whoever asks has seen to that.
    fn index(&self, e: ExprId) -> &FormulaId {
        self.0[e].as_ref().expect("an operand is lowered before what it is an operand of")
    }
}
