//! Formulas as expressions: parentheses wherever two operators meet, long ones a term a line.

use crate::formulas::{Arrangement, Formulas, Notation, Piece, Shape};
use crate::iec::literals::{literal, type_name};
use crate::iec::names::Names;
use crate::writer::Writer;
use ecow::eco_format;
use grafc_formula::{Arithmetic, Comparison, Formula, FormulaId, Type, Value};
use grafc_logic::scan::Program;
use std::borrow::Cow;

/// How formulas of one program are spelt.
pub(super) struct Expressions<'p> {
    formulas: Formulas<StructuredText<'p>, StLevel>,
}

struct StructuredText<'p> {
    program: &'p Program,
    names: &'p Names,
    /// Whether a formula is made of comparisons and negations alone.
    bare: Vec<bool>,
}

/// What parentheses depend on.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum StLevel {
    Atom,
    /// A constant with a sign.
    Signed,
    Not,
    Arithmetic,
    Comparison,
    Junction,
}

impl<'p> Expressions<'p> {
    /// Measures all formulas.
    pub fn new(program: &'p Program, names: &'p Names) -> Self {
        let mut notation = StructuredText { program, names, bare: Vec::new() };
        for id in program.pool.ids() {
            let bare = notation.is_bare(id);
            notation.bare.push(bare);
        }
        Expressions { formulas: Formulas::new(notation, program.pool.ids()) }
    }

    /// The columns that a formula takes on one line.
    pub fn width(&self, id: FormulaId) -> usize {
        self.formulas.width(id)
    }

    /// The columns that a formula takes as a value.
    pub fn value_width(&self, id: FormulaId) -> usize {
        self.width(id).saturating_add(if self.level(id) == StLevel::Comparison { 2 } else { 0 })
    }

    /// Writes a formula as the value of something on the current line: `a := (b = c)` is easier on the eye than
    /// `a := b = c`.
    pub fn value(&self, out: &mut Writer, id: FormulaId) {
        let wrap = self.level(id) == StLevel::Comparison;
        out.text(if wrap { "(" } else { "" });
        self.flat(out, id);
        out.text(if wrap { ")" } else { "" });
    }

    /// Writes a formula on the current line.
    pub fn flat(&self, out: &mut Writer, id: FormulaId) {
        self.formulas.flat(out, id);
    }

    fn level(&self, id: FormulaId) -> StLevel {
        self.formulas.level(id)
    }

    /// Writes a formula on lines of its own, `tail` behind the last.
    pub fn lines(&self, out: &mut Writer, id: FormulaId, tail: &str) {
        self.formulas.lines(out, id, tail);
    }
}

impl Notation for StructuredText<'_> {
    type Level = StLevel;
    /// Some compilers recurse along a chain of terms.
    const LONGEST_CHAIN: usize = 200;

    fn needs_parentheses(&self, parent: StLevel, place: usize, operand: StLevel) -> bool {
        match (operand, parent) {
            (StLevel::Atom, _) => false,
            (StLevel::Signed, StLevel::Arithmetic) => place > 0,
            (StLevel::Signed, _) => false,
            (StLevel::Not, parent) => !matches!(parent, StLevel::Junction),
            (StLevel::Arithmetic, StLevel::Comparison) => false,
            (StLevel::Arithmetic | StLevel::Comparison | StLevel::Junction, _) => true,
        }
    }

    fn shape(&self, id: FormulaId) -> Shape<'_, StLevel> {
        let pool = &self.program.pool;
        let pair = |a: FormulaId, b: FormulaId| Cow::Owned(vec![a, b]);
        let (level, arrangement) = match pool.get(id) {
            Formula::Constant(value) => {
                let text = literal(*value, pool.ty(id));
                (if text.starts_with('-') { StLevel::Signed } else { StLevel::Atom }, Arrangement::Atom(text))
            }
            Formula::Variable(variable) => (StLevel::Atom, Arrangement::Name(&self.names.variables[*variable])),
            Formula::TimerDone(timer) => {
                (StLevel::Atom, Arrangement::Atom(eco_format!("{}.Q", self.names.timers[*timer])))
            }
            Formula::TimerElapsed(timer) => {
                (StLevel::Atom, Arrangement::Atom(eco_format!("{}.ET", self.names.timers[*timer])))
            }
            Formula::Not(a) => match pool.get(*a) {
                Formula::Xor([b, c]) => (StLevel::Comparison, Arrangement::Infix("=", pair(*b, *c))),
                Formula::And(list) if self.bare[a.index()] => {
                    (StLevel::Junction, self.negated(" OR ", pool.list(*list)))
                }
                Formula::Or(list) if self.bare[a.index()] => {
                    (StLevel::Junction, self.negated(" AND ", pool.list(*list)))
                }
                Formula::Compare(Comparison::Equal, [b, c]) => {
                    (StLevel::Comparison, Arrangement::Infix("<>", pair(*b, *c)))
                }
                _ => (StLevel::Not, Arrangement::Prefix("NOT ", *a)),
            },
            Formula::And(list) => (StLevel::Junction, Arrangement::Infix("AND", Cow::Borrowed(pool.list(*list)))),
            Formula::Or(list) => (StLevel::Junction, Arrangement::Infix("OR", Cow::Borrowed(pool.list(*list)))),
            Formula::Xor([a, b]) if self.is_plain(*a) && self.is_plain(*b) => {
                (StLevel::Comparison, Arrangement::Infix("<>", pair(*a, *b)))
            }
            Formula::Xor([a, b]) => (StLevel::Junction, Arrangement::Infix("XOR", pair(*a, *b))),
            Formula::Compare(op, [a, b]) => (StLevel::Comparison, Arrangement::Infix(op.sign(), pair(*a, *b))),
            // `TIME * n` is taken everywhere, `n * TIME` is not.
            Formula::Arithmetic(Arithmetic::Multiply, [a, b])
                if pool.ty(*b) == Type::Time && pool.ty(*a) != Type::Time =>
            {
                (StLevel::Arithmetic, Arrangement::Infix("*", pair(*b, *a)))
            }
            Formula::Arithmetic(op, [a, b]) => (StLevel::Arithmetic, Arrangement::Infix(operator(*op), pair(*a, *b))),
            Formula::Negate(a) => (StLevel::Arithmetic, Arrangement::Prefix(negation(pool.ty(id)), *a)),
            Formula::Widen(a) => {
                let function = eco_format!("{}_TO_{}(", type_name(pool.ty(*a)), type_name(pool.ty(id)));
                let pieces = vec![Piece::Text(function), Piece::Enclosed(*a), Piece::Text(")".into())];
                (StLevel::Atom, Arrangement::Pieces(pieces))
            }
        };
        Shape { level, arrangement }
    }
}

impl StructuredText<'_> {
    /// Whether a formula is made of comparisons and negations alone. A conjunction of these is a number in the C++ that
    /// STruC++ writes, and a `NOT` of it does not compile.
    fn is_bare(&self, id: FormulaId) -> bool {
        let pool = &self.program.pool;
        match pool.get(id) {
            Formula::Compare(..) => true,
            Formula::Not(a) => !matches!(pool.get(*a), Formula::And(_) | Formula::Or(_)) || self.bare[a.index()],
            Formula::And(list) | Formula::Or(list) => pool.list(*list).iter().all(|a| self.bare[a.index()]),
            Formula::Xor([a, b]) => {
                self.is_plain(*a) && self.is_plain(*b) || self.bare[a.index()] && self.bare[b.index()]
            }
            Formula::Constant(_)
            | Formula::Variable(_)
            | Formula::TimerDone(_)
            | Formula::TimerElapsed(_)
            | Formula::Arithmetic(..)
            | Formula::Negate(_)
            | Formula::Widen(_) => false,
        }
    }

    /// The negations of operands with a word between them, each `NOT` as deep as it goes.
    fn negated(&self, word: &'static str, operands: &[FormulaId]) -> Arrangement<'static> {
        let mut pieces = Vec::new();
        self.negate(&mut pieces, word, operands);
        Arrangement::Pieces(pieces)
    }

    fn negate(&self, pieces: &mut Vec<Piece>, word: &'static str, operands: &[FormulaId]) {
        let text = |text: &'static str| Piece::Text(text.into());
        for (place, operand) in operands.iter().enumerate() {
            if place > 0 {
                pieces.push(text(word));
            }
            let pool = &self.program.pool;
            match pool.get(*operand) {
                Formula::Not(a) => pieces.push(Piece::Operand(0, *a)),
                Formula::And(list) => self.negate_within(pieces, " OR ", pool.list(*list)),
                Formula::Or(list) => self.negate_within(pieces, " AND ", pool.list(*list)),
                Formula::Xor([a, b]) => {
                    let both = [text("(("), Piece::Enclosed(*a), text(") = ("), Piece::Enclosed(*b), text("))")];
                    pieces.extend(both);
                }
                _ => pieces.extend([text("NOT ("), Piece::Enclosed(*operand), text(")")]),
            }
        }
    }

    fn negate_within(&self, pieces: &mut Vec<Piece>, word: &'static str, operands: &[FormulaId]) {
        pieces.push(Piece::Text("(".into()));
        self.negate(pieces, word, operands);
        pieces.push(Piece::Text(")".into()));
    }

    /// Whether a formula is a single word.
    fn is_plain(&self, id: FormulaId) -> bool {
        match self.program.pool.as_constant(id) {
            Some(value) => matches!(value, Value::Bool(_)),
            None => self.program.pool.is_leaf(id),
        }
    }
}

/// Words are in capitals in ST.
fn operator(op: Arithmetic) -> &'static str {
    if op == Arithmetic::Modulo { "MOD" } else { op.sign() }
}

/// A minus sign where the type has one.
fn negation(ty: Type) -> &'static str {
    match ty {
        Type::Time => "T#0ms - ",
        Type::Uint | Type::Udint => "0 - ",
        Type::Bool | Type::Int | Type::Dint | Type::Real | Type::Lreal => "-",
    }
}
