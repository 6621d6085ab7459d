//! Where edges stand within expressions.

use crate::chart::{Expr, ExprId, ExprKind};
use index_vec::IndexVec;

/// For each expression the first edge in it that no other edge and no delay holds.
pub fn first_edges(exprs: &IndexVec<ExprId, Expr>) -> IndexVec<ExprId, Option<ExprId>> {
    let mut edges: IndexVec<ExprId, Option<ExprId>> = IndexVec::with_capacity(exprs.len());
    for (id, expr) in exprs.iter_enumerated() {
        edges.push(match expr.kind {
            ExprKind::Rise(_) | ExprKind::Fall(_) => Some(id),
            ExprKind::Delay { .. } => None, // E0415
            ExprKind::Literal(_)
            | ExprKind::Variable(_)
            | ExprKind::StepActive(_)
            | ExprKind::StepTime(_)
            | ExprKind::MacroActive(_)
            | ExprKind::GrafcetActive(_)
            | ExprKind::GrafcetFrozen(_)
            | ExprKind::Not(_)
            | ExprKind::And(..)
            | ExprKind::Or(..)
            | ExprKind::Xor(..)
            | ExprKind::Compare(..)
            | ExprKind::Arithmetic(..)
            | ExprKind::Negate(_)
            | ExprKind::Widen(_) => expr.kind.operands().find_map(|operand| edges[operand]),
        });
    }
    edges
}
