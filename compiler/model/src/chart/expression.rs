//! The pool of expressions: conditions and arithmetic, typed.

use super::{ExprId, GrafcetId, MacroId, StepId, Type, Value, VariableId};
use grafc_diagnostics::Span;
use index_vec::IndexVec;

/// An expression, its type and its place.
#[derive(Clone, Copy, Debug)]
pub struct Expr {
    /// What it is.
    pub kind: ExprKind,
    /// Its type.
    pub ty: Type,
    /// Its place.
    pub span: Span,
}

/// The forms of expression. All children have smaller ids.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum ExprKind {
    /// A literal of type `ty`.
    Literal(Value),
    /// A declared variable, constants included.
    Variable(VariableId),
    /// `Xn`
    StepActive(StepId),
    /// `Tn`: time since its activation, 0 while inactive (X2).
    StepTime(StepId),
    /// `XMn`
    MacroActive(MacroId),
    /// `XGn`
    GrafcetActive(GrafcetId),
    /// `FGn`: it is frozen by a pulse order (R15).
    GrafcetFrozen(GrafcetId),
    /// Boolean.
    Not(ExprId),
    /// Boolean.
    And(ExprId, ExprId),
    /// Boolean.
    Or(ExprId, ExprId),
    /// Boolean.
    Xor(ExprId, ExprId),
    /// `↑e` (X4); `e` holds no edge.
    Rise(ExprId),
    /// `↓e` (X4); `e` holds no edge.
    Fall(ExprId),
    /// `on/e/off` (X5); `e` holds no edge.
    Delay {
        /// On-delay; zero if not given.
        on: DelayTime,
        /// The operand; Boolean.
        operand: ExprId,
        /// Off-delay; zero if not given.
        off: DelayTime,
    },
    /// Both sides have the same type.
    Compare(Comparison, ExprId, ExprId),
    /// Sides and result have the type of the node, except that `time * n`, `n * time` and `time / n` take a whole
    /// number. Wraps around at the width of the type; division by zero gives 0 and raises DIV0.
    Arithmetic(Arithmetic, ExprId, ExprId),
    /// `-e`; wraps around.
    Negate(ExprId),
    /// A conversion without loss to the type of the node: `int` to `dint`, `uint` to `real`, …
    Widen(ExprId),
}

impl ExprKind {
    /// The same in a pool in which its operands stand so many places further on.
    pub fn moved(self, by: usize) -> ExprKind {
        let m = |id: ExprId| ExprId::new(id.index() + by);
        match self {
            ExprKind::Literal(_)
            | ExprKind::Variable(_)
            | ExprKind::StepActive(_)
            | ExprKind::StepTime(_)
            | ExprKind::MacroActive(_)
            | ExprKind::GrafcetActive(_)
            | ExprKind::GrafcetFrozen(_) => self,
            ExprKind::Not(a) => ExprKind::Not(m(a)),
            ExprKind::And(a, b) => ExprKind::And(m(a), m(b)),
            ExprKind::Or(a, b) => ExprKind::Or(m(a), m(b)),
            ExprKind::Xor(a, b) => ExprKind::Xor(m(a), m(b)),
            ExprKind::Rise(a) => ExprKind::Rise(m(a)),
            ExprKind::Fall(a) => ExprKind::Fall(m(a)),
            ExprKind::Delay { on, operand, off } => ExprKind::Delay { on, operand: m(operand), off },
            ExprKind::Compare(op, a, b) => ExprKind::Compare(op, m(a), m(b)),
            ExprKind::Arithmetic(op, a, b) => ExprKind::Arithmetic(op, m(a), m(b)),
            ExprKind::Negate(a) => ExprKind::Negate(m(a)),
            ExprKind::Widen(a) => ExprKind::Widen(m(a)),
        }
    }

    /// The operands, from left to right.
    pub fn operands(&self) -> impl DoubleEndedIterator<Item = ExprId> + use<> {
        let (first, second) = match *self {
            ExprKind::Literal(_)
            | ExprKind::Variable(_)
            | ExprKind::StepActive(_)
            | ExprKind::StepTime(_)
            | ExprKind::MacroActive(_)
            | ExprKind::GrafcetActive(_)
            | ExprKind::GrafcetFrozen(_) => (None, None),
            ExprKind::Not(a) | ExprKind::Rise(a) | ExprKind::Fall(a) | ExprKind::Negate(a) | ExprKind::Widen(a) => {
                (Some(a), None)
            }
            ExprKind::Delay { operand, .. } => (Some(operand), None),
            ExprKind::And(a, b)
            | ExprKind::Or(a, b)
            | ExprKind::Xor(a, b)
            | ExprKind::Compare(_, a, b)
            | ExprKind::Arithmetic(_, a, b) => (Some(a), Some(b)),
        };
        first.into_iter().chain(second)
    }
}

/// An expression and all below it, in order of the text. What is used in several places comes once for each.
pub fn below(exprs: &IndexVec<ExprId, Expr>, root: ExprId) -> impl Iterator<Item = ExprId> {
    // Most expressions are a name, for which nothing is put aside.
    let mut next = Some(root);
    let mut open = Vec::new();
    std::iter::from_fn(move || {
        let id = next?;
        let mut operands = exprs[id].kind.operands();
        next = operands.next();
        open.extend(operands.rev());
        next = next.or_else(|| open.pop());
        Some(id)
    })
}

/// A delay: milliseconds, and the constant that gave them, if one did.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct DelayTime {
    /// Milliseconds, at least 0.
    pub ms: i64,
    /// The time constant.
    pub constant: Option<VariableId>,
}

/// Comparisons.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Comparison {
    /// `=`
    Equal,
    /// `<>`
    NotEqual,
    /// `<`
    Less,
    /// `<=`
    LessEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterEqual,
}

impl Comparison {
    /// How it is written in a chart, and in ST.
    pub fn sign(self) -> &'static str {
        match self {
            Comparison::Equal => "=",
            Comparison::NotEqual => "<>",
            Comparison::Less => "<",
            Comparison::LessEqual => "<=",
            Comparison::Greater => ">",
            Comparison::GreaterEqual => ">=",
        }
    }

    /// What holds between two values in the other order.
    pub fn mirrored(self) -> Comparison {
        match self {
            Comparison::Equal => Comparison::Equal,
            Comparison::NotEqual => Comparison::NotEqual,
            Comparison::Less => Comparison::Greater,
            Comparison::LessEqual => Comparison::GreaterEqual,
            Comparison::Greater => Comparison::Less,
            Comparison::GreaterEqual => Comparison::LessEqual,
        }
    }

    /// What holds where this does not, between values that are in an order: no real that is no number is among them.
    pub fn opposite(self) -> Comparison {
        match self {
            Comparison::Equal => Comparison::NotEqual,
            Comparison::NotEqual => Comparison::Equal,
            Comparison::Less => Comparison::GreaterEqual,
            Comparison::LessEqual => Comparison::Greater,
            Comparison::Greater => Comparison::LessEqual,
            Comparison::GreaterEqual => Comparison::Less,
        }
    }
}

/// Arithmetic operators.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Arithmetic {
    /// `+`
    Add,
    /// `-`
    Subtract,
    /// `*`
    Multiply,
    /// `/`, towards zero for integers
    Divide,
    /// `mod`, with the sign of the dividend
    Modulo,
}

impl Arithmetic {
    /// How it is written in a chart.
    pub fn sign(self) -> &'static str {
        match self {
            Arithmetic::Add => "+",
            Arithmetic::Subtract => "-",
            Arithmetic::Multiply => "*",
            Arithmetic::Divide => "/",
            Arithmetic::Modulo => "mod",
        }
    }
}
