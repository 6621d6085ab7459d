//! Formulas as expressions of JavaScript.
//!
//! Whole numbers wrap around at their width by a function of the name of their type. A time is a `BigInt` where it is
//! stored or computed with, since 64 bits of milliseconds are no `Number`; what a timer has measured and a constant are
//! numbers, and compare as such.

use super::places::Places;
use crate::formulas::{Arrangement, Formulas, Notation, Piece, Shape};
use crate::writer::Writer;
use ecow::{EcoString, eco_format};
use grafc_formula::{Arithmetic, Comparison, Formula, FormulaId, Pool, Type, Value};
use grafc_logic::scan::{Preset, Role};
use std::borrow::Cow;

/// How formulas of one program are spelt.
pub(super) struct Expressions<'p> {
    formulas: Formulas<JavaScript<'p>, JsLevel>,
}

struct JavaScript<'p> {
    places: &'p Places<'p>,
}

/// What parentheses depend on.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum JsLevel {
    Atom,
    /// With a sign or `!` before it.
    Prefix,
    Arithmetic,
    Comparison,
    Junction,
}

impl<'p> Expressions<'p> {
    /// Measures all formulas.
    pub fn new(places: &'p Places<'p>) -> Self {
        Expressions { formulas: Formulas::new(JavaScript { places }, places.program.pool.ids()) }
    }

    /// The columns that a formula takes on one line as the value of something.
    pub fn width(&self, id: FormulaId) -> usize {
        match self.formulas.notation.as_big(id) {
            Some(text) => text.len(),
            None => self.formulas.width(id),
        }
    }

    /// Writes a formula as the value of something, on the current line.
    pub fn flat(&self, out: &mut Writer, id: FormulaId) {
        match self.formulas.notation.as_big(id) {
            Some(text) => out.text(&text),
            None => self.formulas.flat(out, id),
        }
    }

    /// A formula as the value of something.
    pub fn text(&self, out: &Writer, id: FormulaId) -> String {
        let mut apart = out.apart();
        self.flat(&mut apart, id);
        apart.finish()
    }

    /// A time, or a number that a time is computed with.
    pub fn big(&self, id: FormulaId) -> EcoString {
        self.formulas.notation.big(id)
    }

    /// Writes a formula on lines of its own, `tail` behind the last.
    pub fn lines(&self, out: &mut Writer, id: FormulaId, tail: &str) {
        match self.formulas.notation.as_big(id) {
            Some(text) => out.line(&format!("{text}{tail}")),
            None => self.formulas.lines(out, id, tail),
        }
    }
}

/// How long a delay takes.
pub(super) fn preset(places: &Places, preset: Preset) -> EcoString {
    match preset.constant {
        Some(constant) => places.read(constant).clone(),
        None => eco_format!("{}", preset.ms),
    }
}

/// A constant; a time as a number.
pub(super) fn literal(value: Value, ty: Type) -> EcoString {
    match (value, ty) {
        (Value::Bool(b), _) => eco_format!("{b}"),
        (Value::Int(n) | Value::Time(n), _) => eco_format!("{n}"),
        // The shortest form that is read back as the same number; of a single, the same as a double is nearest to it.
        (Value::Real(x), Type::Real) => real(f64::from(x as f32)),
        (Value::Real(x), _) => real(x),
    }
}

fn real(x: f64) -> EcoString {
    if x.is_nan() {
        "NaN".into()
    } else if x.is_infinite() {
        (if x < 0.0 { "-Infinity" } else { "Infinity" }).into()
    } else {
        eco_format!("{x:?}")
    }
}

/// A constant where it is stored: a time as a `BigInt`.
pub(super) fn stored(value: Value, ty: Type) -> EcoString {
    let text = literal(value, ty);
    if ty == Type::Time { eco_format!("{text}n") } else { text }
}

/// The function that makes a result a value of its type.
fn wrapping(ty: Type) -> Option<&'static str> {
    match ty {
        Type::Int => Some("int("),
        Type::Dint => Some("dint("),
        Type::Uint => Some("uint("),
        Type::Udint => Some("udint("),
        Type::Real => Some("real("),
        Type::Time => Some("time("),
        Type::Bool | Type::Lreal => None,
    }
}

/// A result as a value of its type.
pub(super) fn wrapped(ty: Type, text: &str) -> EcoString {
    match wrapping(ty) {
        Some(function) => eco_format!("{function}{text})"),
        None => text.into(),
    }
}

impl Notation for JavaScript<'_> {
    type Level = JsLevel;

    fn needs_parentheses(&self, parent: JsLevel, place: usize, operand: JsLevel) -> bool {
        match (operand, parent) {
            (JsLevel::Atom, _) => false,
            (JsLevel::Prefix, JsLevel::Junction | JsLevel::Comparison) => false,
            (JsLevel::Prefix, JsLevel::Arithmetic) => place > 0,
            (JsLevel::Arithmetic, JsLevel::Comparison) | (JsLevel::Comparison, JsLevel::Junction) => false,
            (JsLevel::Prefix | JsLevel::Arithmetic | JsLevel::Comparison | JsLevel::Junction, _) => true,
        }
    }

    fn shape(&self, id: FormulaId) -> Shape<'_, JsLevel> {
        let pool = self.pool();
        let pair = |a: FormulaId, b: FormulaId| Cow::Owned(vec![a, b]);
        let atom = |text: EcoString| (JsLevel::Atom, Arrangement::Atom(text));
        let (level, arrangement) = match pool.get(id) {
            Formula::Constant(value) => {
                let text = literal(*value, pool.ty(id));
                (if text.starts_with('-') { JsLevel::Prefix } else { JsLevel::Atom }, Arrangement::Atom(text))
            }
            Formula::Variable(v) => (JsLevel::Atom, Arrangement::Name(self.places.read(*v))),
            Formula::TimerDone(timer) => {
                let total = preset(self.places, self.places.program.timers[*timer].given_preset());
                atom(eco_format!("hasRun({}, {total})", self.places.timer(*timer)))
            }
            Formula::TimerElapsed(timer) => atom(eco_format!("{}.elapsed", self.places.timer(*timer))),
            Formula::Not(a) => match pool.get(*a) {
                Formula::Xor([b, c]) => (JsLevel::Comparison, Arrangement::Infix("===", pair(*b, *c))),
                Formula::Compare(Comparison::Equal, [b, c]) => self.comparison(Comparison::NotEqual, *b, *c),
                _ => (JsLevel::Prefix, Arrangement::Prefix("!", *a)),
            },
            Formula::And(list) => (JsLevel::Junction, Arrangement::Infix("&&", Cow::Borrowed(pool.list(*list)))),
            Formula::Or(list) => (JsLevel::Junction, Arrangement::Infix("||", Cow::Borrowed(pool.list(*list)))),
            Formula::Xor([a, b]) => (JsLevel::Comparison, Arrangement::Infix("!==", pair(*a, *b))),
            Formula::Compare(op, [a, b]) => self.comparison(*op, *a, *b),
            Formula::Arithmetic(op, [a, b]) => self.arithmetic(*op, pool.ty(id), *a, *b),
            Formula::Negate(a) => match (pool.ty(id), wrapping(pool.ty(id))) {
                (Type::Time, _) => atom(eco_format!("time(-{})", self.big(*a))),
                (Type::Real | Type::Lreal, _) | (_, None) => (JsLevel::Prefix, Arrangement::Prefix("-", *a)),
                (_, Some(function)) => {
                    let head = Piece::Text(eco_format!("{function}-"));
                    // Of a negative constant the sign would be one of two.
                    let signed = pool.as_constant(*a).is_some();
                    let (open, close) = if signed { ("(", "))") } else { ("", ")") };
                    let pieces = vec![head, Piece::Text(open.into()), Piece::Enclosed(*a), Piece::Text(close.into())];
                    (JsLevel::Atom, Arrangement::Pieces(pieces))
                }
            },
            // Whatever fits in one type of number is the same in a wider one.
            Formula::Widen(a) if pool.ty(id) == Type::Time => atom(self.big(*a)),
            Formula::Widen(a) => (self.shape(*a).level, Arrangement::Pieces(vec![Piece::Enclosed(*a)])),
        };
        Shape { level, arrangement }
    }
}

impl JavaScript<'_> {
    fn pool(&self) -> &Pool {
        &self.places.program.pool
    }

    /// Whether a time is a number and no `BigInt`.
    fn is_number(&self, id: FormulaId) -> bool {
        match self.pool().get(id) {
            Formula::Constant(_) | Formula::TimerElapsed(_) => true,
            Formula::Variable(v) => self.places.program.variables[*v].role == Role::Constant,
            _ => false,
        }
    }

    /// What is a number where it stands, and has to be a `BigInt` where it is stored.
    fn as_big(&self, id: FormulaId) -> Option<EcoString> {
        (self.pool().ty(id) == Type::Time && self.is_number(id)).then(|| self.big(id))
    }

    /// An operand of times: a time, or a number that one is multiplied with or divided by.
    fn big(&self, id: FormulaId) -> EcoString {
        let pool = self.pool();
        match pool.get(id) {
            Formula::Constant(Value::Int(n) | Value::Time(n)) if *n < 0 => eco_format!("({n}n)"),
            Formula::Constant(Value::Int(n) | Value::Time(n)) => eco_format!("{n}n"),
            Formula::Variable(v) if pool.ty(id) == Type::Time && !self.is_number(id) => self.places.read(*v).clone(),
            Formula::Variable(v) => eco_format!("BigInt({})", self.places.read(*v)),
            Formula::TimerElapsed(timer) => eco_format!("BigInt({}.elapsed)", self.places.timer(*timer)),
            Formula::Widen(a) => self.big(*a),
            // Nothing else is an operand: what is computed has been stored.
            _ => EcoString::new(),
        }
    }

    fn comparison(&self, op: Comparison, a: FormulaId, b: FormulaId) -> (JsLevel, Arrangement<'_>) {
        let sign = match op {
            Comparison::Equal => "===",
            Comparison::NotEqual => "!==",
            Comparison::Less => "<",
            Comparison::LessEqual => "<=",
            Comparison::Greater => ">",
            Comparison::GreaterEqual => ">=",
        };
        let of_times = self.pool().ty(a) == Type::Time && !(self.is_number(a) && self.is_number(b));
        if of_times {
            let text = eco_format!("{} {sign} {}", self.big(a), self.big(b));
            return (JsLevel::Comparison, Arrangement::Atom(text));
        }
        (JsLevel::Comparison, Arrangement::Infix(sign, Cow::Owned(vec![a, b])))
    }

    fn arithmetic(&self, op: Arithmetic, ty: Type, a: FormulaId, b: FormulaId) -> (JsLevel, Arrangement<'_>) {
        let sign = match op {
            Arithmetic::Add => "+",
            Arithmetic::Subtract => "-",
            Arithmetic::Multiply => "*",
            Arithmetic::Divide => "/",
            Arithmetic::Modulo => "%",
        };
        let text = |text: &str| Piece::Text(text.into());
        match (op, ty) {
            (_, Type::Time) => {
                let text = eco_format!("time({} {sign} {})", self.big(a), self.big(b));
                (JsLevel::Atom, Arrangement::Atom(text))
            }
            // A product of 32 bits by 32 is exact in no number.
            (Arithmetic::Multiply, Type::Dint | Type::Udint) => {
                let (open, close) = if ty == Type::Udint { ("udint(Math.imul(", "))") } else { ("Math.imul(", ")") };
                let pieces = vec![text(open), Piece::Enclosed(a), text(", "), Piece::Enclosed(b), text(close)];
                (JsLevel::Atom, Arrangement::Pieces(pieces))
            }
            _ => match wrapping(ty) {
                None => (JsLevel::Arithmetic, Arrangement::Infix(sign, Cow::Owned(vec![a, b]))),
                Some(function) => {
                    let sign = eco_format!(" {sign} ");
                    // A sign behind an operator stands in parentheses.
                    let negative = self.shape(b).level == JsLevel::Prefix;
                    let (open, close) = if negative { ("(", "))") } else { ("", ")") };
                    let pieces = vec![
                        text(function),
                        Piece::Enclosed(a),
                        Piece::Text(sign),
                        text(open),
                        Piece::Enclosed(b),
                        text(close),
                    ];
                    (JsLevel::Atom, Arrangement::Pieces(pieces))
                }
            },
        }
    }
}
