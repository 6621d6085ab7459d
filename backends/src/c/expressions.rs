//! Formulas as expressions of C.
//!
//! What computes with whole numbers is a function, which wraps around by unsigned arithmetic: the operators of C may not
//! overflow, and promote small types. Comparisons that a type decides alone are decided here, since compilers complain of
//! them.

use super::literals::{literal, range, type_name, word};
use super::places::Places;
use crate::formulas::{Arrangement, Formulas, Notation, Piece, Shape};
use crate::writer::Writer;
use ecow::{EcoString, eco_format};
use grafc_formula::{Arithmetic, Comparison, Formula, FormulaId, Pool, Type, Value};
use grafc_logic::scan::{Guard, Role, Statement, VarId, Variable};
use rustc_hash::FxHashSet;
use std::borrow::Cow;

/// How formulas of one program are spelt.
pub(super) struct Expressions<'p> {
    formulas: Formulas<C<'p>, CLevel>,
    /// The variables that are read.
    read: FxHashSet<VarId>,
}

struct C<'p> {
    places: &'p Places<'p>,
}

/// What parentheses depend on.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum CLevel {
    Atom,
    /// With a sign, `!` or a type before it.
    Prefix,
    Arithmetic,
    Comparison,
    Junction,
}

impl<'p> Expressions<'p> {
    /// Measures all formulas: of the scan, or of what gives memory back.
    pub fn new(places: &'p Places<'p>, restoring: bool) -> Self {
        let formulas = Formulas::new(C { places }, places.program.pool.ids());
        let read = read(&formulas.notation, restoring);
        Expressions { formulas, read }
    }

    /// Whether a variable is read: what a comparison asks that its types decide is not.
    pub fn is_read(&self, v: VarId) -> bool {
        self.read.contains(&v)
    }

    /// The columns that a formula takes on one line as the value of something.
    pub fn width(&self, id: FormulaId) -> usize {
        self.formulas.width(id)
    }

    /// Writes a formula as the value of something, on the current line.
    pub fn flat(&self, out: &mut Writer, id: FormulaId) {
        self.formulas.flat(out, id);
    }

    /// A formula as the value of something.
    pub fn text(&self, out: &Writer, id: FormulaId) -> String {
        let mut apart = out.apart();
        self.flat(&mut apart, id);
        apart.finish()
    }

    /// Writes a formula on lines of its own, `tail` behind the last.
    pub fn lines(&self, out: &mut Writer, id: FormulaId, tail: &str) {
        self.formulas.lines(out, id, tail);
    }
}

/// The variables that statements read: those of the scan, or those that give memory back.
fn read(c: &C, restoring: bool) -> FxHashSet<VarId> {
    let program = c.places.program;
    let counted = program.repeat.and_then(|repeat| repeat.limit).map(|limit| limit.count);
    let mut found: FxHashSet<VarId> = program.repeat.iter().map(|repeat| repeat.again).chain(counted).collect();
    let mut open: Vec<FormulaId> = Vec::new();
    let [first, before, micro_step, after, back] = program.sections();
    let mut blocks = if restoring { vec![back] } else { vec![first, before, micro_step, after] };
    while let Some(block) = blocks.pop() {
        for statement in block {
            blocks.extend(statement.bodies());
            match statement {
                Statement::Heading(_) => {}
                Statement::Assign { value, .. } => open.push(*value),
                // By the constant 0 nothing is divided.
                Statement::Divide(division) if program.guard(division) == Guard::Never => {}
                Statement::Divide(division) => open.extend([division.dividend, division.divisor]),
                Statement::CallTimer { input, .. } => open.push(*input),
                Statement::Case { of, .. } => {
                    found.insert(*of);
                }
                Statement::If(choice) => open.extend(choice.branches.iter().map(|(when, _)| *when)),
            }
        }
    }
    let mut seen = vec![false; program.pool.len()];
    while let Some(id) = open.pop() {
        if std::mem::replace(&mut seen[id.index()], true) {
            continue;
        }
        match program.pool.get(id) {
            Formula::Variable(v) => {
                found.insert(*v);
            }
            Formula::Compare(op, [a, b]) if c.decided(*op, *a, *b).is_some() => {}
            _ => open.extend(program.pool.operands(id)),
        }
    }
    found
}

impl Notation for C<'_> {
    type Level = CLevel;

    fn needs_parentheses(&self, parent: CLevel, place: usize, operand: CLevel) -> bool {
        match (operand, parent) {
            (CLevel::Atom, _) => false,
            (CLevel::Prefix, CLevel::Junction) => false,
            (CLevel::Prefix, CLevel::Arithmetic) => place > 0,
            (CLevel::Arithmetic, CLevel::Comparison) | (CLevel::Comparison, CLevel::Junction) => false,
            (CLevel::Prefix | CLevel::Arithmetic | CLevel::Comparison | CLevel::Junction, _) => true,
        }
    }

    fn shape(&self, id: FormulaId) -> Shape<'_, CLevel> {
        let pool = self.pool();
        let pair = |a: FormulaId, b: FormulaId| Cow::Owned(vec![a, b]);
        let atom = |text: EcoString| (CLevel::Atom, Arrangement::Atom(text));
        let (level, arrangement) = match pool.get(id) {
            Formula::Constant(value) => atom(literal(*value, pool.ty(id))),
            Formula::Variable(v) => (CLevel::Atom, Arrangement::Name(self.places.read(*v))),
            Formula::TimerDone(timer) => {
                let total = self.places.preset(self.places.program.timers[*timer].given_preset());
                atom(eco_format!("delay_has_run(&{}, {total})", self.places.timer(*timer)))
            }
            Formula::TimerElapsed(timer) => atom(eco_format!("{}.elapsed", self.places.timer(*timer))),
            Formula::Not(a) => match pool.get(*a) {
                Formula::Xor([b, c]) => (CLevel::Comparison, Arrangement::Infix("==", pair(*b, *c))),
                Formula::Compare(Comparison::Equal, [b, c]) => self.comparison(Comparison::NotEqual, *b, *c),
                _ => (CLevel::Prefix, Arrangement::Prefix("!", *a)),
            },
            Formula::And(list) => (CLevel::Junction, Arrangement::Infix("&&", Cow::Borrowed(pool.list(*list)))),
            Formula::Or(list) => (CLevel::Junction, Arrangement::Infix("||", Cow::Borrowed(pool.list(*list)))),
            Formula::Xor([a, b]) => (CLevel::Comparison, Arrangement::Infix("!=", pair(*a, *b))),
            Formula::Compare(op, [a, b]) => self.comparison(*op, *a, *b),
            Formula::Arithmetic(op, [a, b]) => self.arithmetic(*op, pool.ty(id), *a, *b),
            Formula::Negate(a) => match pool.ty(id) {
                Type::Real | Type::Lreal => (CLevel::Prefix, Arrangement::Prefix("-", *a)),
                ty @ (Type::Bool | Type::Int | Type::Dint | Type::Uint | Type::Udint | Type::Time) => {
                    let head = Piece::Text(eco_format!("neg_{}(", word(ty)));
                    (CLevel::Atom, Arrangement::Pieces(vec![head, Piece::Enclosed(*a), Piece::Text(")".into())]))
                }
            },
            Formula::Widen(a) => {
                let head = Piece::Text(eco_format!("({})", type_name(pool.ty(id))));
                (CLevel::Prefix, Arrangement::Pieces(vec![head, Piece::Operand(1, *a)]))
            }
        };
        Shape { level, arrangement }
    }
}

impl C<'_> {
    fn pool(&self) -> &Pool {
        &self.places.program.pool
    }

    fn comparison(&self, op: Comparison, a: FormulaId, b: FormulaId) -> (CLevel, Arrangement<'_>) {
        if let Some(decided) = self.decided(op, a, b) {
            return (CLevel::Atom, Arrangement::Atom(eco_format!("{decided}")));
        }
        let sign = match op {
            Comparison::Equal => "==",
            Comparison::NotEqual => "!=",
            Comparison::Less => "<",
            Comparison::LessEqual => "<=",
            Comparison::Greater => ">",
            Comparison::GreaterEqual => ">=",
        };
        for (of, with) in [(a, b), (b, a)] {
            if let (Formula::Variable(v), Some(value)) = (self.pool().get(of), self.pool().as_constant(with))
                && self.places.state(*v).is_some()
            {
                let text = eco_format!("{} {sign} {}", self.places.read(*v), self.places.value(*v, value));
                return (CLevel::Comparison, Arrangement::Atom(text));
            }
        }
        (CLevel::Comparison, Arrangement::Infix(sign, Cow::Owned(vec![a, b])))
    }

    /// What the range of a type says of a comparison with a constant at one of its ends; and of a number with itself, which a
    /// real need not be equal to.
    fn decided(&self, op: Comparison, a: FormulaId, b: FormulaId) -> Option<bool> {
        let pool = self.pool();
        if a == b && !matches!(pool.ty(a), Type::Real | Type::Lreal) {
            return Some(matches!(op, Comparison::Equal | Comparison::LessEqual | Comparison::GreaterEqual));
        }
        let (least, greatest) = range(pool.ty(a))?;
        // A constant of the chart is a macro, so that compilers see its value.
        let declared = |id: FormulaId| match pool.get(id) {
            Formula::Variable(v) => Some(&self.places.program.variables[*v]).filter(|v| v.role == Role::Constant),
            _ => None,
        };
        let value = |id: FormulaId| pool.as_constant(id).or_else(|| declared(id).map(Variable::initial));
        let number = |id: FormulaId| match value(id) {
            Some(Value::Int(n) | Value::Time(n)) => Some(n),
            Some(Value::Bool(_) | Value::Real(_)) | None => None,
        };
        // As if the constant stood at the right.
        let of = |op: Comparison, n: i64| match op {
            Comparison::GreaterEqual if n == least => Some(true),
            Comparison::Less if n == least => Some(false),
            Comparison::LessEqual if n == greatest => Some(true),
            Comparison::Greater if n == greatest => Some(false),
            Comparison::Equal
            | Comparison::NotEqual
            | Comparison::Less
            | Comparison::LessEqual
            | Comparison::Greater
            | Comparison::GreaterEqual => None,
        };
        number(b).and_then(|n| of(op, n)).or_else(|| number(a).and_then(|n| of(op.mirrored(), n)))
    }

    fn arithmetic(&self, op: Arithmetic, ty: Type, a: FormulaId, b: FormulaId) -> (CLevel, Arrangement<'_>) {
        if matches!(ty, Type::Real | Type::Lreal) {
            return (CLevel::Arithmetic, Arrangement::Infix(sign(op), Cow::Owned(vec![a, b])));
        }
        let pieces = vec![
            Piece::Text(eco_format!("{}(", function(op, ty))),
            Piece::Enclosed(a),
            Piece::Text(", ".into()),
            Piece::Enclosed(b),
            Piece::Text(")".into()),
        ];
        (CLevel::Atom, Arrangement::Pieces(pieces))
    }
}

/// The function that does an operation on whole numbers.
pub(super) fn function(op: Arithmetic, ty: Type) -> EcoString {
    let name = match op {
        Arithmetic::Add => "add",
        Arithmetic::Subtract => "sub",
        Arithmetic::Multiply => "mul",
        Arithmetic::Divide => "div",
        Arithmetic::Modulo => "rem",
    };
    eco_format!("{name}_{}", word(ty))
}

/// The operator of an operation on reals; there is no remainder of them.
pub(super) fn sign(op: Arithmetic) -> &'static str {
    match op {
        Arithmetic::Add => "+",
        Arithmetic::Subtract => "-",
        Arithmetic::Multiply => "*",
        Arithmetic::Divide => "/",
        Arithmetic::Modulo => "%",
    }
}
