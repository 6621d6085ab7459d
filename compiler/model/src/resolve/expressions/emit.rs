//! Writes a faultless expression into the pool, children first.

use super::demand::Literal;
use super::{Detail, Need, OwnKind, Work};
use crate::chart::{Arithmetic, Comparison, Expr, ExprId, ExprKind, Type, Value};
use crate::resolve::scope::{Label, Reference};
use crate::resolve::types;
use grafc_syntax::ast::{self, BinaryOp};
use index_vec::IndexVec;

impl Work<'_, '_, '_> {
    /// Gives back the place of the whole expression.
    pub(super) fn emit(&self, pool: &mut IndexVec<ExprId, Expr>, places: &mut Vec<Option<ExprId>>) -> ExprId {
        places.clear();
        places.resize(self.nodes.len(), None);
        for node in (0..self.nodes.len()).rev() {
            if self.nodes[node].signed {
                continue; // its sign brings it along
            }
            let written = self.written(node);
            let child = |slot: usize| places[self.nodes[node].children[slot]].expect("children are emitted first");
            if let ast::ExprKind::Paren(_) = written.kind {
                places[node] = Some(child(0));
                continue;
            }
            let own = self.own_type(node);
            let mut push = |kind, ty| pool.push(Expr { kind, ty, span: written.span });
            let place = match self.form(node, own, &child) {
                Form::Own(kind) => push(kind, own),
                Form::Same(id) => id,
                Form::Equivalence(left, right) => {
                    let differ = push(ExprKind::Xor(left, right), Type::Bool);
                    push(ExprKind::Not(differ), Type::Bool)
                }
            };
            places[node] = Some(match self.nodes[node].need {
                Some(Need::Value(ty)) if ty != own => push(ExprKind::Widen(place), ty),
                Some(Need::Value(_) | Need::Condition) | None => place,
            });
        }
        places[0].expect("the root is emitted last")
    }

    /// The type in which a node computes, before it is widened.
    fn own_type(&self, node: usize) -> Type {
        match (self.nodes[node].kind, self.nodes[node].need) {
            (OwnKind::Known(ty), _) => ty,
            (OwnKind::Whole | OwnKind::Fraction | OwnKind::Faulty, Some(Need::Value(ty))) => ty,
            (OwnKind::Whole | OwnKind::Fraction | OwnKind::Faulty, Some(Need::Condition) | None) => Type::Bool,
        }
    }

    fn form(&self, node: usize, own: Type, child: &dyn Fn(usize) -> ExprId) -> Form {
        if let Some(literal) = self.literal(node) {
            return Form::Own(ExprKind::Literal(literal_value(literal, own)));
        }
        let detail = self.nodes[node].detail;
        Form::Own(match &self.written(node).kind {
            ast::ExprKind::Name(_) => match detail {
                Detail::Reference(Reference::Variable(id)) => ExprKind::Variable(id),
                Detail::Reference(Reference::Activity(Label::Step(step))) => ExprKind::StepActive(step),
                Detail::Reference(Reference::Activity(Label::Macro(macro_step))) => ExprKind::MacroActive(macro_step),
                Detail::Reference(Reference::Activity(Label::Grafcet(grafcet))) => ExprKind::GrafcetActive(grafcet),
                Detail::Reference(Reference::Frozen(grafcet)) => ExprKind::GrafcetFrozen(grafcet),
                Detail::Reference(Reference::Duration(step)) => ExprKind::StepTime(step),
                Detail::None | Detail::Delay { .. } | Detail::Sides(_) => unreachable!("a faultless name is resolved"),
            },
            ast::ExprKind::Integer(_) | ast::ExprKind::Real(_) | ast::ExprKind::Error => {
                unreachable!("a literal, or a fault")
            }
            ast::ExprKind::Duration(ms) => ExprKind::Literal(Value::Time(*ms)),
            ast::ExprKind::Bool(value) => ExprKind::Literal(Value::Bool(*value)),
            ast::ExprKind::Paren(_) | ast::ExprKind::Predicate(_) => return Form::Same(child(0)),
            ast::ExprKind::Not(_) => ExprKind::Not(child(0)),
            ast::ExprKind::Negate(_) => ExprKind::Negate(child(0)),
            ast::ExprKind::Rise(_) => ExprKind::Rise(child(0)),
            ast::ExprKind::Fall(_) => ExprKind::Fall(child(0)),
            ast::ExprKind::Delay(_) => match detail {
                Detail::Delay { on, off } => ExprKind::Delay { on, operand: child(0), off },
                Detail::None | Detail::Reference(_) | Detail::Sides(_) => {
                    unreachable!("a faultless delay has its times")
                }
            },
            ast::ExprKind::Binary(op, ..) => {
                let (left, right) = (child(0), child(1));
                let of_conditions = matches!(detail, Detail::Sides(Type::Bool));
                match op {
                    BinaryOp::And => ExprKind::And(left, right),
                    BinaryOp::Or => ExprKind::Or(left, right),
                    BinaryOp::Xor => ExprKind::Xor(left, right),
                    BinaryOp::Equal if of_conditions => return Form::Equivalence(left, right),
                    BinaryOp::NotEqual if of_conditions => ExprKind::Xor(left, right),
                    BinaryOp::Equal => ExprKind::Compare(Comparison::Equal, left, right),
                    BinaryOp::NotEqual => ExprKind::Compare(Comparison::NotEqual, left, right),
                    BinaryOp::Less => ExprKind::Compare(Comparison::Less, left, right),
                    BinaryOp::LessEqual => ExprKind::Compare(Comparison::LessEqual, left, right),
                    BinaryOp::Greater => ExprKind::Compare(Comparison::Greater, left, right),
                    BinaryOp::GreaterEqual => ExprKind::Compare(Comparison::GreaterEqual, left, right),
                    BinaryOp::Add => ExprKind::Arithmetic(Arithmetic::Add, left, right),
                    BinaryOp::Subtract => ExprKind::Arithmetic(Arithmetic::Subtract, left, right),
                    BinaryOp::Multiply => ExprKind::Arithmetic(Arithmetic::Multiply, left, right),
                    BinaryOp::Divide => ExprKind::Arithmetic(Arithmetic::Divide, left, right),
                    BinaryOp::Modulo => ExprKind::Arithmetic(Arithmetic::Modulo, left, right),
                }
            }
        })
    }
}

/// How a node stands in the pool.
enum Form {
    /// As an expression of its own.
    Own(ExprKind),
    /// As what it holds.
    Same(ExprId),
    /// `a = b` of conditions, which the pool writes as `not (a xor b)`.
    Equivalence(ExprId, ExprId),
}

/// A literal as a value of a type that holds it.
fn literal_value(literal: Literal, ty: Type) -> Value {
    match (literal, ty) {
        (Literal::Whole(value), Type::Bool) => Value::Bool(value == 1),
        (Literal::Whole(value), Type::Real | Type::Lreal) => Value::Real(types::real(ty, value as f64).unwrap_or(0.0)),
        (Literal::Whole(value), Type::Int | Type::Dint | Type::Uint | Type::Udint | Type::Time) => {
            Value::Int(value as i64)
        }
        (Literal::Fraction(value), _) => Value::Real(types::real(ty, value).unwrap_or(0.0)),
    }
}
