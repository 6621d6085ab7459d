//! Says of each node what its place asks of it, parents first, and reports where it cannot give that.

use super::{Detail, Need, OwnKind, Work};
use crate::chart::Type;
use crate::fixes::{name_instead, with_unit};
use crate::resolve::scope::Reference;
use crate::resolve::types;
use grafc_diagnostics::{Code, Diagnostic, Fix, Span};
use grafc_syntax::ast::{BinaryOp, ExprKind};
use grafc_syntax::spelling;

impl Work<'_, '_, '_> {
    /// Gives every node its need.
    pub(super) fn demand(&mut self, root: Need) {
        self.nodes[0].need = Some(root);
        for node in 0..self.nodes.len() {
            if let Some(need) = self.nodes[node].need {
                self.check(node, need);
            }
            self.pass_on(node);
        }
    }

    /// Tells the operands of a node what it needs of them.
    fn pass_on(&mut self, node: usize) {
        let [first, second] = self.nodes[node].children;
        let number = self.number_type(node);
        match &self.context.tree[self.nodes[node].ast].kind {
            ExprKind::Name(_)
            | ExprKind::Integer(_)
            | ExprKind::Real(_)
            | ExprKind::Duration(_)
            | ExprKind::Bool(_)
            | ExprKind::Error => {}
            ExprKind::Paren(_) => self.nodes[first].need = self.nodes[node].need,
            ExprKind::Predicate(_) | ExprKind::Not(_) | ExprKind::Rise(_) | ExprKind::Fall(_) => {
                self.nodes[first].need = Some(Need::Condition);
            }
            ExprKind::Delay(_) => {
                if first != usize::MAX {
                    self.nodes[first].need = Some(Need::Condition);
                }
            }
            ExprKind::Binary(BinaryOp::And | BinaryOp::Or | BinaryOp::Xor, ..) => {
                self.nodes[first].need = Some(Need::Condition);
                self.nodes[second].need = Some(Need::Condition);
            }
            ExprKind::Negate(_) => self.nodes[first].need = number,
            ExprKind::Binary(
                BinaryOp::Equal
                | BinaryOp::NotEqual
                | BinaryOp::Less
                | BinaryOp::LessEqual
                | BinaryOp::Greater
                | BinaryOp::GreaterEqual,
                ..,
            ) => {
                let sides = match self.nodes[node].detail {
                    Detail::Sides(ty) => Some(Need::Value(ty)),
                    Detail::None | Detail::Reference(_) | Detail::Delay { .. } => None,
                };
                self.nodes[first].need = sides;
                self.nodes[second].need = sides;
            }
            ExprKind::Binary(
                BinaryOp::Add | BinaryOp::Subtract | BinaryOp::Multiply | BinaryOp::Divide | BinaryOp::Modulo,
                ..,
            ) => {
                self.nodes[first].need = self.operand_need(first, number);
                self.nodes[second].need = self.operand_need(second, number);
            }
        }
    }

    /// The type in which a node of arithmetic computes: its own, or if it has none the type it is to adapt to.
    fn number_type(&self, node: usize) -> Option<Need> {
        match (self.nodes[node].kind, self.nodes[node].need) {
            (OwnKind::Faulty, _) => None,
            (OwnKind::Known(ty), _) => Some(Need::Value(ty)),
            (OwnKind::Whole | OwnKind::Fraction, Some(Need::Value(ty))) if types::is_number(ty) => {
                Some(Need::Value(ty))
            }
            (OwnKind::Whole | OwnKind::Fraction, _) => None,
        }
    }

    /// An operand computes in the type of its node; beside a time, a count keeps its own.
    fn operand_need(&self, operand: usize, number: Option<Need>) -> Option<Need> {
        match (self.nodes[operand].kind, number) {
            (OwnKind::Known(ty), Some(Need::Value(Type::Time))) => Some(Need::Value(ty)),
            (OwnKind::Whole, Some(Need::Value(Type::Time))) => Some(Need::Value(Type::Dint)),
            (OwnKind::Known(_) | OwnKind::Whole | OwnKind::Fraction | OwnKind::Faulty, _) => number,
        }
    }

    /// Reports a node that cannot give what it is asked for.
    fn check(&mut self, node: usize, need: Need) {
        let written = &self.context.tree[self.nodes[node].ast];
        if let ExprKind::Paren(_) = written.kind {
            return; // what it holds is asked instead
        }
        match (self.nodes[node].kind, need) {
            (OwnKind::Faulty, _) => {}
            (OwnKind::Known(ty), Need::Condition) => {
                if ty != Type::Bool {
                    self.report(node, self.not_a_condition(node, ty));
                }
            }
            (OwnKind::Known(from), Need::Value(to)) => {
                if !from.widens_to(to) {
                    let message = format!("{} is `{}`, not `{}`", self.spell(node), types::name(from), types::name(to));
                    let diagnostic = Diagnostic::new(Code::E0205, written.span, message);
                    let diagnostic = match types::is_number(from) && types::is_number(to) {
                        true => diagnostic.note(format!(
                            "`{}` does not convert to `{}` without loss",
                            types::name(from),
                            types::name(to)
                        )),
                        false => diagnostic,
                    };
                    let help = match (from, to) {
                        (Type::Bool, _) => {
                            "a condition has no number: say by conditions when which value is assigned".to_owned()
                        }
                        (_, Type::Bool) => format!("make a condition of it: `[{} …]`", self.spelled(node)),
                        _ => format!(
                            "declare one of the two as the other: `{}` or `{}`",
                            types::name(from),
                            types::name(to)
                        ),
                    };
                    self.report(node, diagnostic.help(help));
                }
            }
            (OwnKind::Whole | OwnKind::Fraction, Need::Condition) => {
                if !matches!(written.kind, ExprKind::Integer(0 | 1)) {
                    self.report(node, self.number_as_condition(node));
                }
            }
            (OwnKind::Whole, Need::Value(Type::Bool)) if matches!(written.kind, ExprKind::Integer(0 | 1)) => {}
            (kind @ (OwnKind::Whole | OwnKind::Fraction), Need::Value(to)) => {
                let adapts = to.is_whole() && kind == OwnKind::Whole || matches!(to, Type::Real | Type::Lreal);
                if !adapts {
                    let diagnostic = Diagnostic::new(
                        Code::E0205,
                        written.span,
                        format!("{} is a number, not `{}`", self.spell(node), types::name(to)),
                    );
                    self.report(
                        node,
                        match to {
                            Type::Time => self.with_unit(diagnostic, node),
                            Type::Bool => diagnostic
                                .note("only the numbers `0` and `1` are Boolean constants")
                                .help("write `1` for true, or declare the variable with a type of numbers"),
                            Type::Int | Type::Dint | Type::Uint | Type::Udint => diagnostic
                                .note("a fraction has no place in a whole number")
                                .help("round it, or declare the variable as `real`"),
                            Type::Real | Type::Lreal => diagnostic,
                        },
                    );
                } else if let Some(diagnostic) = self.out_of_range(node, to) {
                    self.report(node, diagnostic);
                }
            }
        }
    }

    /// The error on a literal that its type cannot hold. `-32768` is one number, not 32768 negated.
    fn out_of_range(&self, node: usize, ty: Type) -> Option<Diagnostic> {
        let fits = match self.literal(node)? {
            Literal::Whole(value) => {
                ty.whole_range().is_none_or(|(least, most)| (i128::from(least)..=i128::from(most)).contains(&value))
            }
            Literal::Fraction(value) => types::real(ty, value).is_some(),
        };
        (!fits).then(|| {
            let span = self.written(node).span;
            let diagnostic =
                Diagnostic::new(Code::E0210, span, format!("the number does not fit `{}`", types::name(ty)));
            match ty.whole_range() {
                Some((least, most)) => diagnostic.note(format!("`{}` goes from {least} to {most}", types::name(ty))),
                None => diagnostic,
            }
            .help(types::larger(ty))
        })
    }

    /// The literal that a node is, sign and all. The number behind a sign has no range of its own.
    pub(super) fn literal(&self, node: usize) -> Option<Literal> {
        if self.nodes[node].signed {
            return None;
        }
        let (number, sign) = match self.written(node).kind {
            ExprKind::Negate(_) => (self.nodes[node].children[0], -1),
            _ => (node, 1),
        };
        if let ExprKind::Integer(value) = self.written(number).kind {
            return Some(Literal::Whole(sign * i128::from(value)));
        }
        if let ExprKind::Real(value) = self.written(number).kind {
            return Some(Literal::Fraction(sign as f64 * value));
        }
        None
    }

    fn not_a_condition(&self, node: usize, ty: Type) -> Diagnostic {
        let written = self.written(node);
        let message = format!("{} is `{}`, not a condition", self.spell(node), types::name(ty));
        let diagnostic = Diagnostic::new(Code::E0206, written.span, message);
        if let ExprKind::Duration(_) = written.kind {
            return self.counted_from_a_step(diagnostic, written.span);
        }
        match (&written.kind, self.nodes[node].detail) {
            (ExprKind::Name(name), Detail::Reference(Reference::Duration(_))) => {
                diagnostic.help(format!("compare it in brackets, as in `[{name} >= 3s]`"))
            }
            (ExprKind::Name(name), _) => {
                let example = if ty == Type::Time { "3s" } else { "3" };
                diagnostic.help(format!("compare it in brackets, as in `[{} = {example}]`", spelling::written(name)))
            }
            _ => diagnostic
                .note("a number becomes a condition by a comparison in brackets")
                .help("compare it in brackets: `[…]`"),
        }
    }

    /// A duration alone: it is counted from the activation of the step that the condition belongs to.
    fn counted_from_a_step(&self, diagnostic: Diagnostic, span: Span) -> Diagnostic {
        let step = self.context.step.unwrap_or("…");
        let activity = spelling::written(&format!("X{step}"));
        let diagnostic = diagnostic.help(format!("a time is counted from something: `…/{activity}`"));
        match self.context.step {
            Some(_) => diagnostic
                .fix(Fix::maybe(format!("count it from `{activity}`")).replace(span.behind(), format!("/{activity}"))),
            None => diagnostic,
        }
    }

    /// A name as it is written.
    fn spelled(&self, node: usize) -> String {
        match &self.written(self.bare(node)).kind {
            ExprKind::Name(name) => spelling::written(name),
            ExprKind::Integer(_)
            | ExprKind::Real(_)
            | ExprKind::Duration(_)
            | ExprKind::Bool(_)
            | ExprKind::Paren(_)
            | ExprKind::Predicate(_)
            | ExprKind::Not(_)
            | ExprKind::Negate(_)
            | ExprKind::Rise(_)
            | ExprKind::Fall(_)
            | ExprKind::Binary(..)
            | ExprKind::Delay(_)
            | ExprKind::Error => "…".to_owned(),
        }
    }

    /// Offers a unit for a node that is a plain number.
    pub(super) fn with_unit(&self, diagnostic: Diagnostic, node: usize) -> Diagnostic {
        let node = self.bare(node);
        match self.written(node).kind {
            ExprKind::Integer(_) | ExprKind::Real(_) => {
                let number = self.spell(node).replace('`', "");
                diagnostic.help(format!("a time has a unit: `{number}s`")).fix(with_unit(self.written(node).span))
            }
            ExprKind::Name(_)
            | ExprKind::Duration(_)
            | ExprKind::Bool(_)
            | ExprKind::Paren(_)
            | ExprKind::Predicate(_)
            | ExprKind::Not(_)
            | ExprKind::Negate(_)
            | ExprKind::Rise(_)
            | ExprKind::Fall(_)
            | ExprKind::Binary(..)
            | ExprKind::Delay(_)
            | ExprKind::Error => diagnostic.help("a time has a unit, as in `3s`"),
        }
    }

    fn number_as_condition(&self, node: usize) -> Diagnostic {
        let written = self.written(node);
        let message = format!("{} is a number, not a condition", self.spell(node));
        let diagnostic = Diagnostic::new(Code::E0206, written.span, message);
        match &written.kind {
            ExprKind::Integer(number) if self.context.scope.node(&number.to_string()).is_some() => diagnostic
                .help(format!("the activity of step `{number}` is written `X{number}`"))
                .fix(name_instead(written.span, &format!("X{number}"))),
            _ => diagnostic
                .note("only the numbers `0` and `1` are Boolean constants")
                .help("write a condition, or compare the number with something in brackets: `[…]`"),
        }
    }
}

/// A literal number.
pub(super) enum Literal {
    /// `3`, `-3`
    Whole(i128),
    /// `8.5`, `-8.5`
    Fraction(f64),
}
