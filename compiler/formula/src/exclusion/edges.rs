//! What is known of the variables in conditions: which hold edges, and of what.

use crate::{FormulaId, VarId};
use rustc_hash::FxHashMap;

/// One operand of edges and the variables that are kept of it (X4).
#[derive(Clone, Debug)]
pub struct EdgeOperand {
    /// Its value now.
    pub now: FormulaId,
    /// Its value in the context before.
    pub old: VarId,
    /// True at a rising edge, if the chart asks.
    pub rise: Option<VarId>,
    /// True at a falling edge, if the chart asks.
    pub fall: Option<VarId>,
}

/// The edge that a variable holds (X4).
#[derive(Clone, Copy, Debug)]
pub(super) struct Edge {
    /// The operand now.
    pub(super) now: FormulaId,
    /// The operand in the context before.
    pub(super) old: VarId,
    pub(super) rising: bool,
}

/// What is known of the variables in conditions.
#[derive(Clone, Debug, Default)]
pub struct EdgeFacts {
    edges: FxHashMap<VarId, Edge>,
}

impl EdgeFacts {
    /// Of these operands; of all other variables nothing is known.
    pub fn new<'a>(edges: impl IntoIterator<Item = &'a EdgeOperand>) -> Self {
        let mut table = FxHashMap::default();
        for edge in edges {
            for (variable, rising) in [(edge.rise, true), (edge.fall, false)] {
                table.extend(variable.map(|v| (v, Edge { now: edge.now, old: edge.old, rising })));
            }
        }
        EdgeFacts { edges: table }
    }

    pub(super) fn edge(&self, variable: VarId) -> Option<&Edge> {
        self.edges.get(&variable)
    }
}
