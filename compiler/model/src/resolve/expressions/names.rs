//! The names in an expression that is not resolved, because of what is wrong around it.

use crate::resolve::scope::Scope;
use crate::symbols::{Role, Symbols, Wanted};
use grafc_syntax::ast::{ExprId, ExprKind, Exprs};

/// Notes what the names in an expression refer to; nothing is said of it otherwise.
pub fn note_names(tree: &Exprs, scope: &Scope, root: ExprId, symbols: &mut Symbols) {
    let mut open = vec![root];
    while let Some(id) = open.pop() {
        match &tree[id].kind {
            ExprKind::Name(name) => match scope.reference(name) {
                Some(reference) => {
                    let (entity, form) = reference.entity();
                    symbols.used(tree[id].span, entity, form, Role::Read);
                }
                None => symbols.missed(tree[id].span, Wanted::Value),
            },
            ExprKind::Integer(_) | ExprKind::Real(_) | ExprKind::Duration(_) | ExprKind::Bool(_) | ExprKind::Error => {}
            ExprKind::Paren(a)
            | ExprKind::Predicate(a)
            | ExprKind::Not(a)
            | ExprKind::Negate(a)
            | ExprKind::Rise(a)
            | ExprKind::Fall(a) => open.push(*a),
            ExprKind::Binary(_, a, b) => open.extend([*b, *a]),
            ExprKind::Delay(parts) => open.extend(parts),
        }
    }
}
