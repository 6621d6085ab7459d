//! Says of each node what it is by itself, children first.

use super::{Detail, OwnKind, Work};
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

    fn kind(&mut self, node: usize) -> OwnKind {
        let context = self.context;
        let written = &context.tree[self.nodes[node].ast];
        let [first, second] = self.nodes[node].children;
        match &written.kind {
            ExprKind::Name(name) => match context.scope.reference(name) {
                Some(reference) => {
                    self.nodes[node].detail = Detail::Reference(reference);
                    self.read(written.span, reference);
                    if matches!(reference, Reference::Variable(id) if !context.scope.is_typed(id)) {
                        self.nodes[node].faulty = true;
                        return OwnKind::Faulty;
                    }
                    OwnKind::Known(match reference {
                        Reference::Variable(id) => context.variables[id].ty,
                        Reference::Activity(_) | Reference::Frozen(_) => Type::Bool,
                        Reference::Duration(_) => Type::Time,
                    })
                }
                None => {
                    self.symbols.missed(written.span, Wanted::Value);
                    self.report(node, context.scope.unknown_name(name, written.span));
                    OwnKind::Faulty
                }
            },
            ExprKind::Integer(_) => OwnKind::Whole,
            ExprKind::Real(_) => OwnKind::Fraction,
            ExprKind::Duration(_) => OwnKind::Known(Type::Time),
            ExprKind::Paren(_) => self.nodes[first].kind,
            ExprKind::Bool(_)
            | ExprKind::Predicate(_)
            | ExprKind::Not(_)
            | ExprKind::Rise(_)
            | ExprKind::Fall(_)
            | ExprKind::Delay(_)
            | ExprKind::Binary(BinaryOp::And | BinaryOp::Or | BinaryOp::Xor, ..) => OwnKind::Known(Type::Bool),
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
                OwnKind::Faulty
            }
        }
    }

    fn negation(&mut self, node: usize, operand: usize) -> OwnKind {
        let kind = self.nodes[operand].kind;
        match kind {
            OwnKind::Known(ty @ (Type::Bool | Type::Uint | Type::Udint)) => {
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
                        diagnostic.help("declare it with a type that has a sign, `int` or `dint`")
                    },
                );
                OwnKind::Faulty
            }
            OwnKind::Known(Type::Int | Type::Dint | Type::Real | Type::Lreal | Type::Time)
            | OwnKind::Whole
            | OwnKind::Fraction
            | OwnKind::Faulty => kind,
        }
    }

    fn comparison(&mut self, node: usize, op: BinaryOp, left: usize, right: usize) -> OwnKind {
        let orders = !matches!(op, BinaryOp::Equal | BinaryOp::NotEqual);
        let sides = match (self.nodes[left].kind, self.nodes[right].kind) {
            (OwnKind::Faulty, _) | (_, OwnKind::Faulty) => return OwnKind::Known(Type::Bool),
            (OwnKind::Known(Type::Bool), OwnKind::Known(Type::Bool) | OwnKind::Whole)
            | (OwnKind::Whole, OwnKind::Known(Type::Bool))
                if !orders =>
            {
                Some(Type::Bool)
            }
            (OwnKind::Known(Type::Bool), _) | (_, OwnKind::Known(Type::Bool)) => None,
            (OwnKind::Known(Type::Time), OwnKind::Known(Type::Time)) => Some(Type::Time),
            (a, b) => meet(a, b).map(|kind| match kind {
                OwnKind::Known(ty) => ty,
                OwnKind::Whole | OwnKind::Faulty => Type::Dint,
                OwnKind::Fraction => Type::Lreal,
            }),
        };
        match sides {
            Some(ty) => self.nodes[node].detail = Detail::Sides(ty),
            None => self.report_mismatch(node, op, left, right),
        }
        OwnKind::Known(Type::Bool)
    }

    fn arithmetic(&mut self, node: usize, op: BinaryOp, left: usize, right: usize) -> OwnKind {
        use BinaryOp::{Add, Divide, Multiply, Subtract};
        let time = OwnKind::Known(Type::Time);
        let (a, b) = (self.nodes[left].kind, self.nodes[right].kind);
        if a == OwnKind::Faulty || b == OwnKind::Faulty {
            return OwnKind::Faulty;
        }
        if (a, b) == (time, time) && matches!(op, Add | Subtract)
            || a == time && counts(b) && matches!(op, Multiply | Divide)
            || b == time && counts(a) && op == Multiply
        {
            return time;
        }
        let met = meet(a, b).filter(|&kind| match kind {
            OwnKind::Known(ty) => {
                // Two whole numbers that only meet as reals would divide otherwise than either does.
                let both_whole = counts(a) && counts(b);
                types::is_number(ty) && (ty.is_whole() || op != BinaryOp::Modulo && !both_whole)
            }
            OwnKind::Fraction => op != BinaryOp::Modulo,
            OwnKind::Whole | OwnKind::Faulty => true,
        });
        met.unwrap_or_else(|| {
            self.report_mismatch(node, op, left, right);
            OwnKind::Faulty
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
        let time = OwnKind::Known(Type::Time);
        let fraction_meets_whole = [(a, b), (b, a)].into_iter().any(|(x, y)| x == OwnKind::Fraction && counts(y));
        let is_number = |kind| matches!(kind, OwnKind::Whole | OwnKind::Fraction);
        self.report(
            node,
            if (a == time || b == time) && (is_number(a) || is_number(b)) {
                let number = if is_number(a) { left } else { right };
                match op {
                    // Two times would not go together either.
                    BinaryOp::Multiply | BinaryOp::Divide | BinaryOp::Modulo => diagnostic
                        .note(OF_TIMES)
                        .help("a time is multiplied by a whole number and divided by one: `… / …`"),
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
            } else if op == BinaryOp::Divide && [(a, b), (b, a)].contains(&(time, OwnKind::Known(Type::Bool))) {
                diagnostic.note("in brackets `/` divides, and a comparison holds no delay").help(
                    "put the delay outside, as in `[n > 3] and 5s/X1`, or compare the time of the step: `[T1 >= 5s]`",
                )
            } else if a == time || b == time {
                diagnostic.note(OF_TIMES).help("give both the same type, `time` or a type of numbers")
            } else if a == OwnKind::Known(Type::Bool) || b == OwnKind::Known(Type::Bool) {
                diagnostic
                    .note("conditions are joined by `and`, `or`, `xor`, and compared by `=` and `<>` only")
                    .help("compare numbers with numbers and conditions with conditions, and join the two by `and`")
            } else if fraction_meets_whole {
                diagnostic
                    .note("a whole number is not compared or joined with a fraction")
                    .help("declare the variable as `real`, or write a whole number")
            } else {
                // All numbers have a common type, `lreal` at the latest; only the remainder is of whole numbers.
                diagnostic
                    .note("what is left of a division is asked of whole numbers")
                    .help("declare both as whole numbers, such as `dint`")
            },
        );
    }
}

const OF_TIMES: &str = "times are added, subtracted and compared with times, multiplied and divided by whole numbers";

/// Whether it is a whole number.
fn counts(kind: OwnKind) -> bool {
    match kind {
        OwnKind::Known(ty) => ty.is_whole(),
        OwnKind::Whole => true,
        OwnKind::Fraction | OwnKind::Faulty => false,
    }
}

/// What two kinds of numbers become together.
fn meet(a: OwnKind, b: OwnKind) -> Option<OwnKind> {
    match (a, b) {
        (OwnKind::Faulty, _) | (_, OwnKind::Faulty) => Some(OwnKind::Faulty),
        (OwnKind::Whole, OwnKind::Whole) => Some(OwnKind::Whole),
        (OwnKind::Fraction, OwnKind::Whole | OwnKind::Fraction) | (OwnKind::Whole, OwnKind::Fraction) => {
            Some(OwnKind::Fraction)
        }
        (OwnKind::Whole, OwnKind::Known(ty)) | (OwnKind::Known(ty), OwnKind::Whole) => {
            types::is_number(ty).then_some(OwnKind::Known(ty))
        }
        (OwnKind::Fraction, OwnKind::Known(ty)) | (OwnKind::Known(ty), OwnKind::Fraction) => {
            matches!(ty, Type::Real | Type::Lreal).then_some(OwnKind::Known(ty))
        }
        (OwnKind::Known(a), OwnKind::Known(b)) => {
            types::join(a, b).filter(|&ty| types::is_number(ty)).map(OwnKind::Known)
        }
    }
}

/// What messages call a kind.
fn describe(kind: OwnKind) -> String {
    match kind {
        OwnKind::Known(ty) => format!("`{}`", types::name(ty)),
        OwnKind::Whole => "a whole number".to_owned(),
        OwnKind::Fraction => "a fraction".to_owned(),
        OwnKind::Faulty => "something faulty".to_owned(),
    }
}
