//! Expressions: from the syntax tree to the typed pool.
//!
//! An expression is resolved in four loops over its nodes: [`flatten`] lists them, parents first; [`infer`] says, children
//! first, what each is by itself; [`demand`] says, parents first, what its place asks of it, since literals adapt to
//! the type they meet; and [`emit`] writes the pool, children first. A faulty node is reported once and then agrees
//! with everything.

mod delays;
mod demand;
mod emit;
mod flatten;
mod infer;
mod names;
#[cfg(test)]
mod tests;

use super::fold::Constants;
use super::scope::{Reference, Scope};
use crate::chart::{DelayTime, Expr, ExprId, Type, Variable, VariableId};
use crate::symbols::{Role, Symbols};
use flatten::FlatExpr;
use grafc_diagnostics::{Diagnostic, Diagnostics, Span};
use grafc_syntax::ast;
use index_vec::IndexVec;
pub use names::note_names;

/// What expressions are resolved against.
#[derive(Clone, Copy)]
pub struct Context<'c, 'a> {
    /// The expressions as written.
    pub tree: &'a ast::Exprs,
    /// What names mean.
    pub scope: &'c Scope<'a>,
    /// Kinds and types of the variables.
    pub variables: &'c IndexVec<VariableId, Variable>,
    /// The values of the constants that are known so far.
    pub constants: &'c Constants,
    /// The label of the step whose activity a time in the expression would be counted from, for messages.
    pub step: Option<&'c str>,
}

/// What the place of an expression asks of it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Need {
    /// It is a condition, or an operand of one.
    Condition,
    /// It has, or widens to, this type.
    Value(Type),
}

/// What an expression is by itself.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum OwnKind {
    /// It makes no sense; that has been reported.
    Faulty,
    /// It has a type.
    Known(Type),
    /// It consists of whole literals and adapts to any type of numbers.
    Whole,
    /// It consists of literals, not all whole, and adapts to `real` and `lreal`.
    Fraction,
}

impl Context<'_, '_> {
    /// Resolves the expression `root` into `pool`; none if something in it is wrong, and has been reported.
    pub fn resolve(
        &self,
        root: ast::ExprId,
        need: Need,
        pool: &mut IndexVec<ExprId, Expr>,
        scratch: &mut Scratch,
        symbols: &mut Symbols,
        diagnostics: &mut Diagnostics,
    ) -> Option<ExprId> {
        scratch.nodes.clear();
        let mut work = Work { context: self, nodes: &mut scratch.nodes, symbols, diagnostics };
        work.flatten(root, &mut scratch.open);
        work.infer();
        work.demand(need);
        let faultless = !work.nodes.iter().any(|node| node.faulty);
        faultless.then(|| work.emit(pool, &mut scratch.places))
    }
}

/// Lists that one expression after another is resolved in: most are short, and there are many.
#[derive(Default)]
pub struct Scratch {
    nodes: Vec<FlatExpr>,
    open: Vec<(ast::ExprId, Option<(usize, usize)>)>,
    places: Vec<Option<ExprId>>,
}

/// One expression under way.
struct Work<'w, 'c, 'a> {
    context: &'w Context<'c, 'a>,
    /// Its nodes, parents first.
    nodes: &'w mut Vec<FlatExpr>,
    symbols: &'w mut Symbols,
    diagnostics: &'w mut Diagnostics,
}

impl<'a> Work<'_, '_, 'a> {
    /// The node as written.
    fn written(&self, node: usize) -> &'a ast::Expr {
        &self.context.tree[self.nodes[node].ast]
    }

    /// Reports a fault of a node.
    fn report(&mut self, node: usize, diagnostic: Diagnostic) {
        self.nodes[node].faulty = true;
        self.nodes[node].kind = OwnKind::Faulty;
        self.diagnostics.push(diagnostic);
    }

    /// Notes that a name is read.
    fn read(&mut self, span: Span, reference: Reference) {
        let (entity, form) = reference.entity();
        self.symbols.used(span, entity, form, Role::Read);
    }

    /// The node itself, out of its parentheses.
    fn bare(&self, mut node: usize) -> usize {
        while let ast::ExprKind::Paren(_) = self.written(node).kind {
            node = self.nodes[node].children[0];
        }
        node
    }

    /// How messages call a node: by its name, if it has one.
    fn spell(&self, node: usize) -> String {
        match &self.written(self.bare(node)).kind {
            ast::ExprKind::Name(name) => format!("`{name}`"),
            ast::ExprKind::Integer(number) => format!("`{number}`"),
            ast::ExprKind::Real(number) => format!("`{number}`"),
            ast::ExprKind::Bool(value) => format!("`{value}`"),
            ast::ExprKind::Duration(_)
            | ast::ExprKind::Paren(_)
            | ast::ExprKind::Predicate(_)
            | ast::ExprKind::Not(_)
            | ast::ExprKind::Negate(_)
            | ast::ExprKind::Rise(_)
            | ast::ExprKind::Fall(_)
            | ast::ExprKind::Binary(..)
            | ast::ExprKind::Delay(_)
            | ast::ExprKind::Error => "this".to_owned(),
        }
    }
}

/// What else is known of a node.
#[derive(Clone, Copy, Debug)]
enum Detail {
    /// Nothing.
    None,
    /// What its name stands for.
    Reference(Reference),
    /// The times of a delay; its operand is the only child.
    Delay {
        /// On-delay.
        on: DelayTime,
        /// Off-delay.
        off: DelayTime,
    },
    /// The type in which the sides of a comparison meet.
    Sides(Type),
}
