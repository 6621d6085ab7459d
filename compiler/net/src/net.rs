//! The Petri net: places, transitions with what comes before and after, and side tables.
//!
//! Meaning: a place is a step of IEC 60848 (Boolean: its token is its activity), a transition is a transition. Step
//! `s3` of the chart is place `s3`; grafcets, variables, expressions and transitions keep their ids as well. Conditions
//! stay in the chart's pool of expressions: an expression that names the activity of a macro-step or of a grafcet means
//! the disjunction of the places that the side table lists.
//!
//! Invariants, which [`crate::verify()`] checks:
//! - every id lies in its table;
//! - `pre` and `post` of a transition hold no place twice, and only places of the transition's grafcet;
//! - an operand of an expression comes before the expression;
//! - a transition is in `entered_by` (`left_by`) of a macro-step at most once;
//! - what a [`Fact`] that was reached says.

use grafc_diagnostics::Span;
use grafc_model::chart::{
    Continuous, Expr, ExprId, Grafcet, GrafcetId, MacroId, Order, StepId, Stored, TransitionId, Variable, VariableId,
};
use index_vec::IndexVec;

/// What a pass has brought about, for good.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Fact {
    /// No arc leads into or out of a macro-step: `entered_by` and `left_by` are empty.
    NoMacroSteps,
}

/// A chart as a Petri net.
#[derive(Clone, Debug)]
pub struct Net {
    /// The chart's name.
    pub name: String,
    /// The chart's attached comment.
    pub comment: Option<String>,
    /// Declared variables.
    pub variables: IndexVec<VariableId, Variable>,
    /// Places: the steps of the chart.
    pub places: IndexVec<StepId, Place>,
    /// Transitions.
    pub transitions: IndexVec<TransitionId, Transition>,
    /// Partial grafcets.
    pub grafcets: IndexVec<GrafcetId, Grafcet>,
    /// Grafcets from the top of the hierarchy down.
    pub hierarchy: Vec<GrafcetId>,
    /// Macro-steps: their arcs until they are expanded, and for good the places that their activity means.
    pub macro_steps: IndexVec<MacroId, MacroStep>,
    /// Continuous actions.
    pub continuous: Vec<Continuous>,
    /// Stored actions.
    pub stored: Vec<Stored>,
    /// Forcing orders.
    pub orders: Vec<Order>,
    /// Conditions and values.
    pub exprs: IndexVec<ExprId, Expr>,
    /// What the passes so far have brought about.
    pub facts: Vec<Fact>,
}

/// A place: one step.
#[derive(Clone, Debug)]
pub struct Place {
    /// The step's label.
    pub label: String,
    /// The attached comment.
    pub comment: Option<String>,
    /// The grafcet that it belongs to.
    pub grafcet: GrafcetId,
    /// In the initial situation.
    pub initial: bool,
    /// Bears an activation link.
    pub activated: bool,
    /// The label in the chart.
    pub span: Span,
}

/// A transition.
#[derive(Clone, Debug)]
pub struct Transition {
    /// The designation.
    pub designation: Option<String>,
    /// The attached comment.
    pub comment: Option<String>,
    /// The grafcet that it belongs to.
    pub grafcet: GrafcetId,
    /// The immediately preceding places.
    pub pre: Vec<StepId>,
    /// The immediately succeeding places.
    pub post: Vec<StepId>,
    /// The transition-condition.
    pub condition: ExprId,
    /// The item in the chart.
    pub span: Span,
}

/// A macro-step.
#[derive(Clone, Debug)]
pub struct MacroStep {
    /// The label.
    pub label: String,
    /// Where arcs into it lead.
    pub entry: StepId,
    /// Where arcs out of it start.
    pub exit: StepId,
    /// The steps that its expansion holds directly. Its activity is the disjunction of theirs and of that of `inner`.
    pub places: Vec<StepId>,
    /// The macro-steps that its expansion holds directly.
    pub inner: Vec<MacroId>,
    /// Transitions with an arc into it.
    pub entered_by: Vec<TransitionId>,
    /// Transitions with an arc out of it.
    pub left_by: Vec<TransitionId>,
}
