//! Expressions and statements of Structured Text, in which the other languages are read as well.
//!
//! Expressions lie in one list, operands before what is made of them, so that nobody walks them by recursion; statements
//! lie in a flat list as well, an `IF` being a mark where it begins and one where it ends. What could not be read is in
//! its place, so that what stands around it keeps its meaning.

use grafc_diagnostics::Span;
use index_vec::{IndexVec, define_index_type};

define_index_type! {
    /// An expression.
    pub struct ExprId = u32;
}

/// All expressions of a file.
#[derive(Default)]
pub struct Code {
    pub exprs: IndexVec<ExprId, Expr>,
}

/// An expression and where it stands.
pub struct Expr {
    pub kind: ExprKind,
    pub span: Span,
}

/// What an expression is.
#[derive(Clone, PartialEq, Debug)]
pub enum ExprKind {
    Bool(bool),
    /// A whole number, as it is written in decimal.
    Integer(i64),
    /// A number with a fraction, as it is written.
    Real(String),
    /// A duration in milliseconds.
    Duration(u64),
    /// A variable, a step's flag, a member: `Valve.Motor.on`, indexes in brackets.
    Path(String),
    Not(ExprId),
    Negate(ExprId),
    Binary(Operator, ExprId, ExprId),
    Call(String, Vec<Argument>),
    /// Whether something has just become true, or false.
    Edge(Direction, ExprId),
    /// What no chart can say: why.
    Unknown(String),
}

/// The direction of an edge.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Direction {
    Rise,
    Fall,
}

/// An operator with two operands.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Operator {
    Or,
    Xor,
    And,
    Equal,
    NotEqual,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    Add,
    Subtract,
    Multiply,
    Divide,
    Modulo,
}

impl Operator {
    /// Whether it compares.
    pub fn compares(self) -> bool {
        use Operator::{Equal, Greater, GreaterEqual, Less, LessEqual, NotEqual};
        matches!(self, Equal | NotEqual | Less | LessEqual | Greater | GreaterEqual)
    }

    /// Whether its operands and its value are Boolean.
    pub fn is_logic(self) -> bool {
        matches!(self, Operator::Or | Operator::Xor | Operator::And)
    }
}

/// An argument of a call.
#[derive(Clone, PartialEq, Debug)]
pub struct Argument {
    pub name: Option<String>,
    pub value: ExprId,
    /// `name => value`.
    pub gives: bool,
}

/// A statement, or the mark of one that holds others.
#[derive(Clone, Debug)]
pub struct Statement {
    pub kind: StatementKind,
    pub span: Span,
}

/// What a statement is.
#[derive(Clone, Debug)]
pub enum StatementKind {
    Assign {
        target: String,
        value: ExprId,
    },
    Call(String, Vec<Argument>),
    /// Up to the mark of its `END_IF`.
    If(ExprId),
    Elsif(ExprId),
    Else,
    EndIf,
    /// Up to the mark of its `END_CASE`; then come the branches.
    Case(ExprId),
    /// The branch of some values, each from and to.
    Label(Vec<(ExprId, ExprId)>),
    EndCase,
    /// Why it is left out, and its text.
    Lost {
        why: String,
        text: String,
    },
}

impl Code {
    /// Adds an expression.
    pub fn add(&mut self, kind: ExprKind, span: Span) -> ExprId {
        self.exprs.push(Expr { kind, span })
    }

    /// Adds one of two operands.
    pub fn binary(&mut self, operator: Operator, left: ExprId, right: ExprId) -> ExprId {
        let span = self.exprs[left].span.to(self.exprs[right].span);
        self.add(ExprKind::Binary(operator, left, right), span)
    }

    /// Adds a negation; that of a negation is what was negated.
    pub fn not(&mut self, operand: ExprId) -> ExprId {
        match self.exprs[operand].kind {
            ExprKind::Not(inner) => inner,
            ExprKind::Bool(value) => self.add(ExprKind::Bool(!value), self.exprs[operand].span),
            _ => self.add(ExprKind::Not(operand), self.exprs[operand].span),
        }
    }

    /// Adds what is true if both are; a constant is left out.
    pub fn and(&mut self, left: ExprId, right: ExprId) -> ExprId {
        match (&self.exprs[left].kind, &self.exprs[right].kind) {
            (ExprKind::Bool(true), _) | (_, ExprKind::Bool(false)) => right,
            (_, ExprKind::Bool(true)) | (ExprKind::Bool(false), _) => left,
            _ => self.binary(Operator::And, left, right),
        }
    }

    /// Adds what is true if one of both is; a constant is left out.
    pub fn or(&mut self, left: ExprId, right: ExprId) -> ExprId {
        match (&self.exprs[left].kind, &self.exprs[right].kind) {
            (ExprKind::Bool(false), _) | (_, ExprKind::Bool(true)) => right,
            (_, ExprKind::Bool(false)) | (ExprKind::Bool(true), _) => left,
            _ => self.binary(Operator::Or, left, right),
        }
    }

    /// The operands of an expression, in order.
    pub fn operands(&self, id: ExprId) -> Vec<ExprId> {
        match &self.exprs[id].kind {
            ExprKind::Not(a) | ExprKind::Negate(a) | ExprKind::Edge(_, a) => vec![*a],
            ExprKind::Binary(_, a, b) => vec![*a, *b],
            ExprKind::Call(_, arguments) => arguments.iter().map(|argument| argument.value).collect(),
            ExprKind::Bool(_)
            | ExprKind::Integer(_)
            | ExprKind::Real(_)
            | ExprKind::Duration(_)
            | ExprKind::Path(_)
            | ExprKind::Unknown(_) => Vec::new(),
        }
    }
}
