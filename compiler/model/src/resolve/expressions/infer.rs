//! Says of each node what it is by itself, children first.

use super::{Detail, Kind, Work};
use crate::chart::Type;
use crate::resolve::scope::Reference;
use crate::resolve::types;
use crate::symbols::Wanted;
use grafc_diagnostics::{Code, Diagnostic, Fix, Span};
use grafc_syntax::ast::{BinaryOp, ExprKind};

impl Work<'_, '_, '_> {
    /// Gives every node its kind.
    pub(super) fn infer(&mut self) {
        for node in (0..self.nodes.len()).rev() {
            let kind = self.kind(node);
            if !self.nodes[node].faulty {
                self.nodes[node].kind = kind;
            }
        }
    }

    fn kind(&mut self, node: usize) -> Kind {
        let context = self.context;
        let written = &context.tree[self.nodes[node].ast];
        let [first, second] = self.nodes[node].children;
        match &written.kind {
            ExprKind::Name(name) => match context.scope.reference(name) {
                Some(reference) => {
                    self.nodes[node].detail = Detail::Reference(reference);
                    self.read(written.span, reference);
                    Kind::Known(match reference {
                        Reference::Variable(id) => context.variables[id].ty,
                        Reference::Activity(_) => Type::Bool,
                        Reference::Duration(_) => Type::Time,
                    })
                }
                None => {
                    self.symbols.missed(written.span, Wanted::Value);
                    self.report(node, context.scope.unknown_name(name, written.span));
                    Kind::Faulty
                }
            },
            ExprKind::Integer(_) => Kind::Whole,
            ExprKind::Real(_) => Kind::Fraction,
            ExprKind::Duration(_) => Kind::Known(Type::Time),
            ExprKind::Paren(_) => self.nodes[first].kind,
            ExprKind::Bool(_)
            | ExprKind::Predicate(_)
            | ExprKind::Not(_)
            | ExprKind::Rise(_)
            | ExprKind::Fall(_)
            | ExprKind::Delay(_)
            | ExprKind::Binary(BinaryOp::And | BinaryOp::Or | BinaryOp::Xor, ..) => Kind::Known(Type::Bool),
            ExprKind::Negate(_) => self.negation(node, first),
            ExprKind::Binary(
                op @ (BinaryOp::Equal
                | BinaryOp::NotEqual
                | BinaryOp::Less
                | BinaryOp::LessEqual
                | BinaryOp::Greater
                | BinaryOp::GreaterEqual),
                ..,
            ) => self.comparison(node, *op, first, second),
            ExprKind::Binary(
                op @ (BinaryOp::Add | BinaryOp::Subtract | BinaryOp::Multiply | BinaryOp::Divide | BinaryOp::Modulo),
                ..,
            ) => self.arithmetic(node, *op, first, second),
            ExprKind::Error => {
                self.nodes[node].faulty = true;
                Kind::Faulty
            }
        }
    }

    fn negation(&mut self, node: usize, operand: usize) -> Kind {
        let kind = self.nodes[operand].kind;
        match kind {
            Kind::Known(ty @ (Type::Bool | Type::Uint | Type::Udint)) => {
                let message = format!("{} is `{}`, which has no negative values", self.spell(operand), types::name(ty));
                let span = self.written(node).span;
                let diagnostic = Diagnostic::new(Code::E0205, span, message);
                self.report(
                    node,
                    if ty == Type::Bool {
                        let sign = Span { end: self.written(operand).span.start, ..span };
                        diagnostic
                            .help("the opposite of a condition is `not`")
                            .fix(Fix::certain("write `not`").replace(sign, "not "))
                    } else {
                        diagnostic
                    },
                );
                Kind::Faulty
            }
            Kind::Known(Type::Int | Type::Dint | Type::Real | Type::Lreal | Type::Time)
            | Kind::Whole
            | Kind::Fraction
            | Kind::Faulty => kind,
        }
    }

    fn comparison(&mut self, node: usize, op: BinaryOp, left: usize, right: usize) -> Kind {
        let orders = !matches!(op, BinaryOp::Equal | BinaryOp::NotEqual);
        let sides = match (self.nodes[left].kind, self.nodes[right].kind) {
            (Kind::Faulty, _) | (_, Kind::Faulty) => return Kind::Known(Type::Bool),
            (Kind::Known(Type::Bool), Kind::Known(Type::Bool) | Kind::Whole)
            | (Kind::Whole, Kind::Known(Type::Bool))
                if !orders =>
            {
                Some(Type::Bool)
            }
            (Kind::Known(Type::Bool), _) | (_, Kind::Known(Type::Bool)) => None,
            (Kind::Known(Type::Time), Kind::Known(Type::Time)) => Some(Type::Time),
            (a, b) => meet(a, b).map(|kind| match kind {
                Kind::Known(ty) => ty,
                Kind::Whole | Kind::Faulty => Type::Dint,
                Kind::Fraction => Type::Lreal,
            }),
        };
        match sides {
            Some(ty) => self.nodes[node].detail = Detail::Sides(ty),
            None => self.report_mismatch(node, op, left, right),
        }
        Kind::Known(Type::Bool)
    }

    fn arithmetic(&mut self, node: usize, op: BinaryOp, left: usize, right: usize) -> Kind {
        use BinaryOp::{Add, Divide, Multiply, Subtract};
        let time = Kind::Known(Type::Time);
        let (a, b) = (self.nodes[left].kind, self.nodes[right].kind);
        if a == Kind::Faulty || b == Kind::Faulty {
            return Kind::Faulty;
        }
        if (a, b) == (time, time) && matches!(op, Add | Subtract)
            || a == time && counts(b) && matches!(op, Multiply | Divide)
            || b == time && counts(a) && op == Multiply
        {
            return time;
        }
        let met = meet(a, b).filter(|&kind| match kind {
            Kind::Known(ty) => {
                // Two whole numbers that only meet as reals would divide otherwise than either does.
                let both_whole = counts(a) && counts(b);
                types::is_number(ty) && (types::is_whole(ty) || op != BinaryOp::Modulo && !both_whole)
            }
            Kind::Fraction => op != BinaryOp::Modulo,
            Kind::Whole | Kind::Faulty => true,
        });
        met.unwrap_or_else(|| {
            self.report_mismatch(node, op, left, right);
            Kind::Faulty
        })
    }

    fn report_mismatch(&mut self, node: usize, op: BinaryOp, left: usize, right: usize) {
        let (a, b) = (self.nodes[left].kind, self.nodes[right].kind);
        let sign = types::operator(op);
        let message = if describe(a) == describe(b) {
            format!("`{sign}` does not take {}", describe(a))
        } else {
            format!("`{sign}` does not take {} and {} together", describe(a), describe(b))
        };
        let mut diagnostic = Diagnostic::new(Code::E0205, self.written(node).span, message);
        for (side, kind) in [(left, a), (right, b)] {
            diagnostic = diagnostic.also(self.written(side).span, format!("this is {}", describe(kind)));
        }
        let time = Kind::Known(Type::Time);
        let fraction_meets_whole = [(a, b), (b, a)].into_iter().any(|(x, y)| x == Kind::Fraction && counts(y));
        self.report(
            node,
            if (a == time || b == time) && [a, b].contains(&Kind::Whole) {
                let number = if a == Kind::Whole { left } else { right };
                let diagnostic = diagnostic.help("a time has a unit, as in `3s` or `500ms`");
                match op {
                    // Two times would not go together either.
                    BinaryOp::Multiply | BinaryOp::Divide | BinaryOp::Modulo => diagnostic,
                    BinaryOp::Add
                    | BinaryOp::Subtract
                    | BinaryOp::Equal
                    | BinaryOp::NotEqual
                    | BinaryOp::Less
                    | BinaryOp::LessEqual
                    | BinaryOp::Greater
                    | BinaryOp::GreaterEqual
                    | BinaryOp::And
                    | BinaryOp::Or
                    | BinaryOp::Xor => self.with_unit(diagnostic, number),
                }
            } else if a == time || b == time {
                diagnostic.note(
                    "times are added, subtracted and compared with times, multiplied and divided by whole numbers",
                )
            } else if a == Kind::Known(Type::Bool) || b == Kind::Known(Type::Bool) {
                diagnostic.note("conditions are joined by `and`, `or`, `xor`, and compared by `=` and `<>` only")
            } else if fraction_meets_whole {
                diagnostic
                    .note("a whole number is not compared or joined with a fraction: declare the variable as `real`")
            } else {
                diagnostic.note("numbers of different types meet only where one converts to the other without loss")
            },
        );
    }
}

/// Whether it is a whole number.
fn counts(kind: Kind) -> bool {
    match kind {
        Kind::Known(ty) => types::is_whole(ty),
        Kind::Whole => true,
        Kind::Fraction | Kind::Faulty => false,
    }
}

/// What two kinds of numbers become together.
fn meet(a: Kind, b: Kind) -> Option<Kind> {
    match (a, b) {
        (Kind::Faulty, _) | (_, Kind::Faulty) => Some(Kind::Faulty),
        (Kind::Whole, Kind::Whole) => Some(Kind::Whole),
        (Kind::Fraction, Kind::Whole | Kind::Fraction) | (Kind::Whole, Kind::Fraction) => Some(Kind::Fraction),
        (Kind::Whole, Kind::Known(ty)) | (Kind::Known(ty), Kind::Whole) => {
            types::is_number(ty).then_some(Kind::Known(ty))
        }
        (Kind::Fraction, Kind::Known(ty)) | (Kind::Known(ty), Kind::Fraction) => {
            matches!(ty, Type::Real | Type::Lreal).then_some(Kind::Known(ty))
        }
        (Kind::Known(a), Kind::Known(b)) => types::join(a, b).filter(|&ty| types::is_number(ty)).map(Kind::Known),
    }
}

/// What messages call a kind.
fn describe(kind: Kind) -> String {
    match kind {
        Kind::Known(ty) => format!("`{}`", types::name(ty)),
        Kind::Whole => "a whole number".to_owned(),
        Kind::Fraction => "a fraction".to_owned(),
        Kind::Faulty => "something faulty".to_owned(),
    }
}
