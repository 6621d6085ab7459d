//! Lists the nodes of an expression, parents first.

use super::{Detail, Need, OwnKind, Work};
use grafc_syntax::ast;

/// A node of an expression under way.
pub(super) struct FlatExpr {
    /// The node as written.
    pub(super) ast: ast::ExprId,
    /// The places of its operands in the list, as many as its form has.
    pub(super) children: [usize; 2],
    /// What it is by itself.
    pub(super) kind: OwnKind,
    /// What its place asks of it; nothing if its parent is faulty.
    pub(super) need: Option<Need>,
    /// What else is known of it.
    pub(super) detail: Detail,
    /// Whether a fault of it has been reported.
    pub(super) faulty: bool,
    /// Whether it is the literal behind a minus sign, and one number with it.
    pub(super) signed: bool,
}

impl Work<'_, '_, '_> {
    /// Fills the list of nodes. The times of a delay do not become nodes: they are read on the way.
    pub(super) fn flatten(&mut self, root: ast::ExprId, open: &mut Vec<(ast::ExprId, Option<(usize, usize)>)>) {
        open.push((root, None));
        while let Some((id, parent)) = open.pop() {
            let place = self.nodes.len();
            let mut signed = false;
            if let Some((parent, slot)) = parent {
                let parent: &mut FlatExpr = &mut self.nodes[parent];
                parent.children[slot] = place;
                signed = matches!(self.context.tree[parent.ast].kind, ast::ExprKind::Negate(_))
                    && matches!(self.context.tree[id].kind, ast::ExprKind::Integer(_) | ast::ExprKind::Real(_));
            }
            self.nodes.push(FlatExpr {
                ast: id,
                children: [usize::MAX; 2],
                kind: OwnKind::Faulty,
                need: None,
                detail: Detail::None,
                faulty: false,
                signed,
            });
            match &self.context.tree[id].kind {
                ast::ExprKind::Name(_)
                | ast::ExprKind::Integer(_)
                | ast::ExprKind::Real(_)
                | ast::ExprKind::Duration(_)
                | ast::ExprKind::Bool(_)
                | ast::ExprKind::Error => {}
                ast::ExprKind::Paren(inner)
                | ast::ExprKind::Predicate(inner)
                | ast::ExprKind::Not(inner)
                | ast::ExprKind::Negate(inner)
                | ast::ExprKind::Rise(inner)
                | ast::ExprKind::Fall(inner) => open.push((*inner, Some((place, 0)))),
                ast::ExprKind::Binary(_, left, right) => {
                    open.push((*right, Some((place, 1))));
                    open.push((*left, Some((place, 0))));
                }
                ast::ExprKind::Delay(parts) => {
                    if let Some(operand) = self.read_delay(place, parts) {
                        open.push((operand, Some((place, 0))));
                    }
                }
            }
        }
    }
}
