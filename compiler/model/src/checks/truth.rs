//! What is known of conditions before the chart runs.

use crate::chart::{Expr, ExprId, ExprKind, Value, Variable, VariableId, VariableKind};
use index_vec::IndexVec;

/// What is known of a condition.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Truth {
    /// It never holds.
    Never,
    /// It always holds.
    Always,
    /// It may hold, or nothing is known.
    Sometimes,
}

/// What edges are taken for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Edges {
    /// They come and go.
    Sometimes,
    /// No event occurs: what holds then is the level in a condition (R7).
    Never,
}

/// What is known of each expression; of those that are no conditions nothing.
pub fn truths(
    exprs: &IndexVec<ExprId, Expr>,
    variables: &IndexVec<VariableId, Variable>,
    edges: Edges,
) -> IndexVec<ExprId, Truth> {
    let mut truths = IndexVec::with_capacity(exprs.len());
    for expr in exprs {
        truths.push(truth(variables, expr, edges, &truths));
    }
    truths
}

fn truth(
    variables: &IndexVec<VariableId, Variable>,
    expr: &Expr,
    edges: Edges,
    below: &IndexVec<ExprId, Truth>,
) -> Truth {
    use Truth::{Always, Never, Sometimes};
    let certain = |value| if value { Always } else { Never };
    match expr.kind {
        ExprKind::Literal(Value::Bool(value)) => certain(value),
        ExprKind::Literal(Value::Int(_) | Value::Real(_) | Value::Time(_)) => Sometimes,
        ExprKind::Variable(id) => match (variables[id].kind, variables[id].initial()) {
            (VariableKind::Constant, Value::Bool(value)) => certain(value),
            (VariableKind::Constant, Value::Int(_) | Value::Real(_) | Value::Time(_)) => Sometimes,
            (VariableKind::Input | VariableKind::Output | VariableKind::Internal, _) => Sometimes,
        },
        ExprKind::Not(a) => match below[a] {
            Never => Always,
            Always => Never,
            Sometimes => Sometimes,
        },
        ExprKind::And(a, b) => match (below[a], below[b]) {
            (Never, _) | (_, Never) => Never,
            (Always, other) | (other, Always) => other,
            (Sometimes, Sometimes) => Sometimes,
        },
        ExprKind::Or(a, b) => match (below[a], below[b]) {
            (Always, _) | (_, Always) => Always,
            (Never, other) | (other, Never) => other,
            (Sometimes, Sometimes) => Sometimes,
        },
        ExprKind::Xor(a, b) => match (below[a], below[b]) {
            (Sometimes, _) | (_, Sometimes) => Sometimes,
            (a, b) => certain(a != b),
        },
        ExprKind::Rise(_) | ExprKind::Fall(_) => match edges {
            Edges::Sometimes => Sometimes,
            Edges::Never => Never,
        },
        ExprKind::StepActive(_)
        | ExprKind::StepTime(_)
        | ExprKind::MacroActive(_)
        | ExprKind::GrafcetActive(_)
        | ExprKind::GrafcetFrozen(_)
        | ExprKind::Delay { .. }
        | ExprKind::Compare(..)
        | ExprKind::Arithmetic(..)
        | ExprKind::Negate(_)
        | ExprKind::Widen(_) => Sometimes,
    }
}
