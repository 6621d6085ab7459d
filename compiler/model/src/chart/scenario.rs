//! Tests of a chart in words of time. They are no part of what it does, and no stage after this one reads them.

use super::{Expr, ExprId, Value, VariableId};
use crate::simulate::Probe;
use ecow::EcoString;
use grafc_diagnostics::Span;
use index_vec::IndexVec;

/// A test, line by line.
#[derive(Clone, Debug)]
pub struct Scenario {
    /// What it is called.
    pub name: EcoString,
    /// Its lines, in order.
    pub lines: Vec<ScenarioLine>,
    /// Its name.
    pub span: Span,
}

/// One line.
#[derive(Clone, Debug)]
pub struct ScenarioLine {
    /// When it is.
    pub when: ScenarioTime,
    /// What inputs are given then.
    pub given: Vec<ScenarioInput>,
    /// What is expected after that scan.
    pub expected: Vec<ScenarioExpectation>,
    /// The whole line.
    pub span: Span,
}

/// When a line is.
#[derive(Clone, Debug)]
pub enum ScenarioTime {
    /// So many milliseconds after the start.
    At(i64),
    /// So many after the line before.
    After(i64),
    /// As soon as this holds after a scan.
    Until(Condition, i64),
}

/// What an input is given.
#[derive(Clone, Copy, Debug)]
pub struct ScenarioInput {
    /// The input.
    pub variable: VariableId,
    /// Its value.
    pub value: Value,
    /// Whether it is 0 again in the next scan.
    pub is_pulse: bool,
}

/// What something is expected to be.
#[derive(Clone, Copy, Debug)]
pub struct ScenarioExpectation {
    /// A variable, or what conditions know.
    pub probe: Probe,
    /// Its value.
    pub value: Value,
    /// Where it is written.
    pub span: Span,
}

/// A condition on what is after a scan: it holds no edge and no delay. Its expressions are its own, not those of the chart.
#[derive(Clone, Debug)]
pub struct Condition {
    /// Its expressions, operands first.
    pub exprs: IndexVec<ExprId, Expr>,
    /// The whole of it.
    pub root: ExprId,
    /// Where it is written.
    pub span: Span,
}
