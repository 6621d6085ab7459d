//! Formulas as expressions of Rust, laid out as rustfmt does it.

use super::literals::{literal, type_name};
use super::places::Places;
use crate::formulas::{Arrangement, Formulas, Notation, Piece, Shape};
use crate::writer::Writer;
use ecow::{EcoString, eco_format};
use grafc_formula::{Arithmetic, Comparison, Formula, FormulaId, Type, Value};
use grafc_logic::scan::Program;
use std::borrow::Cow;

/// rustfmt makes lines no longer.
pub(super) const WIDTH: usize = 100;
/// The arguments of a call, and a chain of methods, are broken when they are longer.
pub(super) const SMALL: usize = 60;

/// How formulas of one program are spelt.
pub(super) struct Expressions<'p> {
    formulas: Formulas<Rust<'p>, RustLevel>,
}

struct Rust<'p> {
    program: &'p Program,
    places: &'p Places<'p>,
}

/// What parentheses depend on.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum RustLevel {
    Atom,
    /// With a sign or `!` before it.
    Prefix,
    Arithmetic,
    Comparison,
    Junction,
}

impl<'p> Expressions<'p> {
    /// Measures all formulas.
    pub fn new(program: &'p Program, places: &'p Places<'p>) -> Self {
        Expressions { formulas: Formulas::new(Rust { program, places }, program.pool.ids()) }
    }

    /// The columns that a formula takes on one line.
    pub fn width(&self, id: FormulaId) -> usize {
        self.formulas.width(id)
    }

    /// Writes a formula on the current line.
    pub fn flat(&self, out: &mut Writer, id: FormulaId) {
        self.formulas.flat(out, id);
    }

    /// Writes `head = formula;`, broken as rustfmt breaks it: before its operators, or behind the sign, if it then has room
    /// in one line or at least takes fewer.
    pub fn statement(&self, out: &mut Writer, head: &str, id: FormulaId) {
        if (out.indent() + head.len() + 4).saturating_add(self.width(id)) <= WIDTH {
            out.start();
            out.text(head);
            out.text(" = ");
            self.flat(out, id);
            out.text(";");
            return out.end();
        }
        let mut beside = out.apart();
        self.broken(&mut beside, id, out.indent() + head.len() + 3, 1, true);
        let beside = beside.finish();
        out.enter();
        let mut below = out.apart();
        self.broken(&mut below, id, out.indent(), 1, true);
        let below = below.finish();
        out.leave();
        let lines = |text: &str| text.bytes().filter(|byte| *byte == b'\n').count();
        if lines(&below) == 0 || lines(&beside) > lines(&below) + 1 {
            out.open(&format!("{head} ="));
            out.start();
            out.text(&below);
            out.text(";");
            out.end();
            return out.leave();
        }
        out.start();
        out.text(&format!("{head} = {beside};"));
        out.end();
    }

    /// Writes `head condition {`, the brace on a line of its own if the condition takes several.
    pub fn condition(&self, out: &mut Writer, head: &str, id: FormulaId) {
        out.start();
        out.text(head);
        out.text(" ");
        if (out.indent() + head.len() + 3).saturating_add(self.width(id)) <= WIDTH {
            self.flat(out, id);
            out.text(" {");
            out.end();
            return;
        }
        self.broken(out, id, out.indent() + head.len() + 1, 2, true);
        out.end();
        out.line("{");
    }

    /// Writes a formula from a column on, a term a line if it would not fit with `tail` more columns.
    /// The lines are one level `deeper`, except where the formula is the first term of another that is broken.
    fn broken(&self, out: &mut Writer, id: FormulaId, column: usize, tail: usize, deeper: bool) {
        let fits = (column + tail).saturating_add(self.width(id)) <= WIDTH;
        let shape = self.formulas.notation.shape(id);
        match &shape.arrangement {
            Arrangement::Infix(operator, operands) if !fits => {
                if deeper {
                    out.enter();
                }
                for (place, operand) in operands.iter().enumerate() {
                    let mut at = column;
                    if place > 0 {
                        out.end();
                        out.start();
                        out.text(operator);
                        out.text(" ");
                        at = out.indent() + operator.len() + 1;
                    }
                    let wrap = self.formulas.needs_parentheses(shape.level, place, *operand);
                    out.text(if wrap { "(" } else { "" });
                    let (at, tail) = if wrap { (at + 1, tail + 1) } else { (at, tail) };
                    self.broken(out, *operand, at, tail, place > 0);
                    out.text(if wrap { ")" } else { "" });
                }
                if deeper {
                    out.leave();
                }
            }
            Arrangement::Prefix(word, operand) if !fits => {
                out.text(word);
                let wrap = self.formulas.needs_parentheses(shape.level, 1, *operand);
                out.text(if wrap { "(" } else { "" });
                let at = column + word.len() + usize::from(wrap);
                self.broken(out, *operand, at, tail + usize::from(wrap), deeper);
                out.text(if wrap { ")" } else { "" });
            }
            Arrangement::Atom(_)
            | Arrangement::Name(_)
            | Arrangement::Prefix(..)
            | Arrangement::Pieces(_)
            | Arrangement::Infix(..) => self.flat(out, id),
        }
    }
}

impl Notation for Rust<'_> {
    type Level = RustLevel;

    fn needs_parentheses(&self, parent: RustLevel, place: usize, operand: RustLevel) -> bool {
        match (operand, parent) {
            (RustLevel::Atom, _) => false,
            (RustLevel::Prefix, RustLevel::Junction | RustLevel::Comparison | RustLevel::Prefix) => false,
            (RustLevel::Prefix, RustLevel::Arithmetic) => place > 0,
            (RustLevel::Arithmetic, RustLevel::Comparison) | (RustLevel::Comparison, RustLevel::Junction) => false,
            (RustLevel::Prefix | RustLevel::Arithmetic | RustLevel::Comparison | RustLevel::Junction, _) => true,
        }
    }

    fn shape(&self, id: FormulaId) -> Shape<'_, RustLevel> {
        let pool = &self.program.pool;
        let pair = |a: FormulaId, b: FormulaId| Cow::Owned(vec![a, b]);
        let atom = |text: EcoString| (RustLevel::Atom, Arrangement::Atom(text));
        let (level, arrangement) = match pool.get(id) {
            Formula::Constant(value) => {
                let text = literal(*value, pool.ty(id));
                let level = if text.starts_with('-') { RustLevel::Prefix } else { RustLevel::Atom };
                (level, Arrangement::Atom(text))
            }
            Formula::Variable(variable) => atom(self.places.read(*variable)),
            Formula::TimerDone(timer) => {
                atom(eco_format!("{}.has_run({})", self.places.timer(*timer), self.places.preset(*timer)))
            }
            Formula::TimerElapsed(timer) => atom(eco_format!("{}.elapsed()", self.places.timer(*timer))),
            Formula::Not(a) => match pool.get(*a) {
                Formula::Xor([b, c]) if self.program.pool.is_leaf(*b) && self.program.pool.is_leaf(*c) => {
                    (RustLevel::Comparison, Arrangement::Infix("==", pair(*b, *c)))
                }
                Formula::Compare(Comparison::Equal, [b, c]) => self.comparison(Comparison::NotEqual, *b, *c),
                _ => (RustLevel::Prefix, Arrangement::Prefix("!", *a)),
            },
            Formula::And(list) => (RustLevel::Junction, Arrangement::Infix("&&", Cow::Borrowed(pool.list(*list)))),
            Formula::Or(list) => (RustLevel::Junction, Arrangement::Infix("||", Cow::Borrowed(pool.list(*list)))),
            Formula::Xor([a, b]) => (RustLevel::Comparison, Arrangement::Infix("!=", pair(*a, *b))),
            Formula::Compare(op, [a, b]) => self.comparison(*op, *a, *b),
            Formula::Arithmetic(Arithmetic::Multiply, [a, b])
                if pool.ty(*b) == Type::Time && pool.ty(*a) != Type::Time =>
            {
                self.arithmetic(Arithmetic::Multiply, pool.ty(id), *b, *a)
            }
            Formula::Arithmetic(op, [a, b]) => self.arithmetic(*op, pool.ty(id), *a, *b),
            Formula::Negate(a) => match pool.ty(id) {
                Type::Real | Type::Lreal => (RustLevel::Prefix, Arrangement::Prefix("-", *a)),
                Type::Bool | Type::Int | Type::Dint | Type::Uint | Type::Udint | Type::Time => {
                    let pieces = vec![Piece::Operand(0, *a), Piece::Text(".wrapping_neg()".into())];
                    (RustLevel::Atom, Arrangement::Pieces(pieces))
                }
            },
            Formula::Widen(a) => {
                let function = eco_format!("{}::from(", type_name(pool.ty(id)));
                let pieces = vec![Piece::Text(function), Piece::Enclosed(*a), Piece::Text(")".into())];
                (RustLevel::Atom, Arrangement::Pieces(pieces))
            }
        };
        Shape { level, arrangement }
    }
}

impl Rust<'_> {
    /// A state is compared with a variant of its enum.
    fn comparison(&self, op: Comparison, a: FormulaId, b: FormulaId) -> (RustLevel, Arrangement<'_>) {
        let pool = &self.program.pool;
        let sign = match op {
            Comparison::Equal => "==",
            Comparison::NotEqual => "!=",
            Comparison::Less => "<",
            Comparison::LessEqual => "<=",
            Comparison::Greater => ">",
            Comparison::GreaterEqual => ">=",
        };
        if a == b
            && matches!(pool.ty(a), Type::Real | Type::Lreal)
            && matches!(op, Comparison::Equal | Comparison::NotEqual)
        {
            // Only what is no number differs from itself.
            let not = if op == Comparison::Equal { "!" } else { "" };
            let level = if op == Comparison::Equal { RustLevel::Prefix } else { RustLevel::Atom };
            let pieces = vec![Piece::Text(not.into()), Piece::Operand(0, a), Piece::Text(".is_nan()".into())];
            return (level, Arrangement::Pieces(pieces));
        }
        if let (Formula::Variable(v), Formula::Constant(Value::Int(n))) = (pool.get(a), pool.get(b))
            && let Some(variant) = self.places.variant(*v, *n)
        {
            let text = eco_format!(" {sign} {variant}");
            return (RustLevel::Comparison, Arrangement::Pieces(vec![Piece::Enclosed(a), Piece::Text(text)]));
        }
        (RustLevel::Comparison, Arrangement::Infix(sign, Cow::Owned(vec![a, b])))
    }

    /// Whole numbers and times wrap around at their width.
    fn arithmetic(&self, op: Arithmetic, ty: Type, a: FormulaId, b: FormulaId) -> (RustLevel, Arrangement<'_>) {
        let pool = &self.program.pool;
        let (sign, method) = match op {
            Arithmetic::Add => ("+", "wrapping_add"),
            Arithmetic::Subtract => ("-", "wrapping_sub"),
            Arithmetic::Multiply => ("*", "wrapping_mul"),
            // By constants alone that are neither 0 nor -1.
            Arithmetic::Divide => ("/", ""),
            Arithmetic::Modulo => ("%", ""),
        };
        if matches!(ty, Type::Real | Type::Lreal) || method.is_empty() {
            return (RustLevel::Arithmetic, Arrangement::Infix(sign, Cow::Owned(vec![a, b])));
        }
        let converted = ty == Type::Time && pool.ty(b) != Type::Time && pool.as_constant(b).is_none();
        let (open, close) = if converted { ("i64::from(", "))") } else { ("", ")") };
        let text = Piece::Text;
        // A constant has no type of its own, and a long chain would be broken.
        let width = |id: FormulaId| self.places.width_of_operand(self.program, id);
        let chain = width(a) + method.len() + 3 + open.len() + width(b) + close.len();
        let pieces = if pool.as_constant(a).is_some() || chain > SMALL {
            let head = text(eco_format!("{}::{method}(", type_name(ty)));
            vec![head, Piece::Enclosed(a), text(eco_format!(", {open}")), Piece::Enclosed(b), text(close.into())]
        } else {
            let middle = text(eco_format!(".{method}({open}"));
            vec![Piece::Operand(0, a), middle, Piece::Enclosed(b), text(close.into())]
        };
        (RustLevel::Atom, Arrangement::Pieces(pieces))
    }
}
