//! What a chart computes: expressions whose names are resolved and whose types are known.
//!
//! They lie in one list, operands before what is made of them.

use grafc_diagnostics::Span;
use index_vec::{IndexVec, define_index_type};

define_index_type! {
    /// A term.
    pub struct TermId = u32;
}

define_index_type! {
    /// A variable of the chart.
    pub struct VarId = u32;
}

define_index_type! {
    /// A step of the chart.
    pub struct StepId = u32;
}

/// The type of a term.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Ty {
    Bool,
    Int,
    Dint,
    Uint,
    Udint,
    Real,
    Lreal,
    Time,
}

impl Ty {
    /// How it is written.
    pub fn word(self) -> &'static str {
        match self {
            Ty::Bool => "bool",
            Ty::Int => "int",
            Ty::Dint => "dint",
            Ty::Uint => "uint",
            Ty::Udint => "udint",
            Ty::Real => "real",
            Ty::Lreal => "lreal",
            Ty::Time => "time",
        }
    }

    /// Whether it is a whole number.
    pub fn is_whole(self) -> bool {
        matches!(self, Ty::Int | Ty::Dint | Ty::Uint | Ty::Udint)
    }

    /// Whether all its values are values of another type.
    pub fn widens_to(self, other: Ty) -> bool {
        use Ty::{Bool, Dint, Int, Lreal, Real, Time, Udint, Uint};
        self == other
            || match self {
                Int => matches!(other, Dint | Real | Lreal),
                Uint => matches!(other, Udint | Dint | Real | Lreal),
                Dint | Udint => other == Lreal,
                Real => other == Lreal,
                Bool | Lreal | Time => false,
            }
    }
}

/// A term.
pub struct Term {
    pub kind: TermKind,
    /// None of a whole number that adapts to what it meets.
    pub ty: Option<Ty>,
    pub span: Span,
}

/// What a term is.
#[derive(Clone, PartialEq, Debug)]
pub enum TermKind {
    Bool(bool),
    Integer(i64),
    Real(String),
    Duration(u64),
    Variable(VarId),
    Active(StepId),
    Time(StepId),
    Not(TermId),
    Negate(TermId),
    Or(TermId, TermId),
    Xor(TermId, TermId),
    And(TermId, TermId),
    /// A comparison or arithmetic: its sign.
    Pair(&'static str, TermId, TermId),
    Rise(TermId),
    Fall(TermId),
    /// `2s/x`, `x/2s`: the delays as they are written.
    Delay {
        on: Option<Amount>,
        operand: TermId,
        off: Option<Amount>,
    },
}

/// The time of a delay.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Amount {
    Ms(u64),
    Constant(VarId),
}

/// All terms of a chart.
#[derive(Default)]
pub struct Terms {
    pub terms: IndexVec<TermId, Term>,
}

impl Terms {
    /// Adds a term.
    pub fn add(&mut self, kind: TermKind, ty: Option<Ty>, span: Span) -> TermId {
        self.terms.push(Term { kind, ty, span })
    }

    /// Adds a Boolean term.
    pub fn logic(&mut self, kind: TermKind, span: Span) -> TermId {
        self.add(kind, Some(Ty::Bool), span)
    }

    /// A constant.
    pub fn constant(&mut self, value: bool, span: Span) -> TermId {
        self.logic(TermKind::Bool(value), span)
    }

    /// Whether it is a certain constant.
    pub fn is(&self, id: TermId, value: bool) -> bool {
        self.terms[id].kind == TermKind::Bool(value)
    }

    /// The negation.
    pub fn not(&mut self, id: TermId) -> TermId {
        let span = self.terms[id].span;
        match self.terms[id].kind {
            TermKind::Bool(value) => self.constant(!value, span),
            TermKind::Not(inner) => inner,
            _ => self.logic(TermKind::Not(id), span),
        }
    }

    /// True if both are.
    pub fn and(&mut self, left: TermId, right: TermId) -> TermId {
        if self.is(left, true) || self.is(right, false) || left == right {
            right
        } else if self.is(right, true) || self.is(left, false) {
            left
        } else {
            let span = self.terms[left].span;
            self.logic(TermKind::And(left, right), span)
        }
    }

    /// True if one is.
    pub fn or(&mut self, left: TermId, right: TermId) -> TermId {
        if self.is(left, false) || self.is(right, true) || left == right {
            right
        } else if self.is(right, false) || self.is(left, true) {
            left
        } else {
            let span = self.terms[left].span;
            self.logic(TermKind::Or(left, right), span)
        }
    }

    /// True if one of them is.
    pub fn any(&mut self, terms: impl IntoIterator<Item = TermId>, span: Span) -> TermId {
        let terms: Vec<TermId> = terms.into_iter().collect();
        terms.into_iter().reduce(|left, right| self.or(left, right)).unwrap_or_else(|| self.constant(false, span))
    }

    /// The operands of a term, in order.
    pub fn operands(&self, id: TermId) -> Vec<TermId> {
        match &self.terms[id].kind {
            TermKind::Not(a) | TermKind::Negate(a) | TermKind::Rise(a) | TermKind::Fall(a) => vec![*a],
            TermKind::Delay { operand, .. } => vec![*operand],
            TermKind::Or(a, b) | TermKind::Xor(a, b) | TermKind::And(a, b) | TermKind::Pair(_, a, b) => vec![*a, *b],
            TermKind::Bool(_)
            | TermKind::Integer(_)
            | TermKind::Real(_)
            | TermKind::Duration(_)
            | TermKind::Variable(_)
            | TermKind::Active(_)
            | TermKind::Time(_) => Vec::new(),
        }
    }

    /// Calls `found` with each part of a term, up to a number of parts; whether all were seen.
    pub fn parts(&self, id: TermId, most: usize, mut found: impl FnMut(&Term)) -> bool {
        let mut stack = vec![id];
        let mut seen = 0;
        while let Some(id) = stack.pop() {
            seen += 1;
            if seen > most {
                return false;
            }
            found(&self.terms[id]);
            stack.extend(self.operands(id));
        }
        true
    }
}
