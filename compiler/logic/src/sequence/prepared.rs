//! What is found before a sequential function chart is called, as far as it has been collected (see `prepare`).

use crate::scan::{Statement, Timer, TimerId, VarId};
use grafc_formula::FormulaId;
use grafc_model::chart::StepId;
use index_vec::IndexVec;
use rustc_hash::{FxHashMap, FxHashSet};

/// The statements so far.
#[derive(Default)]
pub(super) struct Prepared {
    /// What the chart is given, in order.
    pub given: Vec<VarId>,
    /// What keeps its value from call to call.
    pub memory: Vec<VarId>,
    /// The markers of steps that are read.
    pub shown: Vec<VarId>,
    pub is_shown: FxHashSet<VarId>,
    pub timers: IndexVec<TimerId, Timer>,
    /// In the first call, before all others.
    pub first: Vec<Statement>,
    /// In each call.
    pub before: Vec<Statement>,
    /// In each call, behind those: edge operands are kept as they are before the chart goes on.
    pub last: Vec<Statement>,
    /// In each call, behind the chart.
    pub after: Vec<Statement>,
    /// The activity of steps as it was.
    pub active: FxHashMap<StepId, VarId>,
    pub old: FxHashMap<FormulaId, VarId>,
    pub edges: FxHashMap<(FormulaId, bool), VarId>,
    pub delays: FxHashMap<(FormulaId, i64, i64), VarId>,
}
