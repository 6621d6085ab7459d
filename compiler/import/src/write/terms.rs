//! What a chart computes: expressions whose names are resolved and whose types are known.
//!
//! They lie in one list, operands before what is made of them.

use grafc_diagnostics::Span;
use grafc_syntax::ast::Type;
use index_vec::{IndexVec, define_index_type};
use rustc_hash::FxHashMap;

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

/// A term.
pub struct Term {
    pub kind: TermKind,
    /// None of a whole number that adapts to what it meets.
    pub ty: Option<Type>,
    pub span: Span,
}

/// What a term is.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub enum TermKind {
    Bool(bool),
    Integer(i64),
    Real(String),
    Duration(u64),
    Variable(VarId),
    Active(StepId),
    Time(StepId),
    /// Whether a child program is active, and whether it is frozen: the place of its part.
    ChildActive(usize),
    ChildFrozen(usize),
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
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub enum Amount {
    Ms(u64),
    Constant(VarId),
}

/// All terms of a chart, each once.
#[derive(Default)]
pub struct Terms {
    pub terms: IndexVec<TermId, Term>,
    known: FxHashMap<(TermKind, Option<Type>), TermId>,
}

/// How many factors of a product are looked at.
const FACTORS: usize = 32;

impl Terms {
    /// Adds a term, if it is not there yet; then its place is that of the first.
    pub fn add(&mut self, kind: TermKind, ty: Option<Type>, span: Span) -> TermId {
        let terms = &mut self.terms;
        *self
            .known
            .entry((kind, ty))
            .or_insert_with_key(|(kind, ty)| terms.push(Term { kind: kind.clone(), ty: *ty, span }))
    }

    /// Adds a Boolean term.
    pub fn logic(&mut self, kind: TermKind, span: Span) -> TermId {
        self.add(kind, Some(Type::Bool), span)
    }

    /// A constant.
    pub fn constant(&mut self, value: bool, span: Span) -> TermId {
        self.logic(TermKind::Bool(value), span)
    }

    /// A condition, if it is not always true.
    pub fn unless_always(&self, condition: TermId) -> Option<TermId> {
        (!self.is(condition, true)).then_some(condition)
    }

    /// Whether it is a certain constant.
    pub fn is(&self, id: TermId, value: bool) -> bool {
        self.terms[id].kind == TermKind::Bool(value)
    }

    /// The negation; that of a sum is a product, whose factors can be compared with others.
    pub fn not(&mut self, id: TermId) -> TermId {
        let span = self.terms[id].span;
        let alternatives = self.alternatives(id);
        if alternatives.len() > 1 {
            let mut product = self.constant(true, span);
            for alternative in alternatives {
                let factor = self.negated(alternative);
                product = self.and(product, factor);
            }
            return product;
        }
        self.negated(id)
    }

    fn negated(&mut self, id: TermId) -> TermId {
        let span = self.terms[id].span;
        match self.terms[id].kind {
            TermKind::Bool(value) => self.constant(!value, span),
            TermKind::Not(inner) => inner,
            _ => self.logic(TermKind::Not(id), span),
        }
    }

    /// True if both are; what is said twice is left out, and what contradicts itself is false.
    pub fn and(&mut self, left: TermId, right: TermId) -> TermId {
        let span = self.terms[left].span;
        if self.is(left, true) || self.is(right, false) {
            return right;
        }
        if self.is(right, true) || self.is(left, false) {
            return left;
        }
        let before = self.factors(left);
        let mut product = left;
        for factor in self.factors(right) {
            if before.contains(&factor) {
                continue;
            }
            if before.iter().any(|&other| self.contradict(other, factor)) {
                return self.constant(false, span);
            }
            product = self.logic(TermKind::And(product, factor), span);
        }
        product
    }

    /// True if one is.
    pub fn or(&mut self, left: TermId, right: TermId) -> TermId {
        let span = self.terms[left].span;
        if self.is(left, false) || self.is(right, true) || left == right {
            return right;
        }
        if self.is(right, false) || self.is(left, true) {
            return left;
        }
        let (one, two) = (&self.terms[left].kind, &self.terms[right].kind);
        if *one == TermKind::Not(right) || *two == TermKind::Not(left) {
            return self.constant(true, span);
        }
        self.logic(TermKind::Or(left, right), span)
    }

    /// The factors of a product, in order; of a long one the rest is one factor.
    pub fn factors(&self, id: TermId) -> Vec<TermId> {
        let (mut stack, mut found) = (vec![id], Vec::new());
        while let Some(id) = stack.pop() {
            match self.terms[id].kind {
                TermKind::And(a, b) if found.len() + stack.len() < FACTORS => stack.extend([b, a]),
                _ => found.push(id),
            }
        }
        found
    }

    /// The terms of a sum, in order.
    fn alternatives(&self, id: TermId) -> Vec<TermId> {
        let (mut stack, mut found) = (vec![id], Vec::new());
        while let Some(id) = stack.pop() {
            match self.terms[id].kind {
                TermKind::Or(a, b) if found.len() + stack.len() < FACTORS => stack.extend([b, a]),
                _ => found.push(id),
            }
        }
        found
    }

    /// Whether two terms cannot both be true, as their form tells.
    pub fn contradict(&self, a: TermId, b: TermId) -> bool {
        let (one, two) = (&self.terms[a].kind, &self.terms[b].kind);
        if *one == TermKind::Not(b) || *two == TermKind::Not(a) {
            return true;
        }
        match (one, two) {
            (TermKind::Or(..), TermKind::Or(..)) => false,
            (TermKind::Or(..), _) => self.alternatives(a).iter().all(|&a| a != b && self.contradict(a, b)),
            (_, TermKind::Or(..)) => self.alternatives(b).iter().all(|&b| a != b && self.contradict(a, b)),
            (TermKind::Pair(p, x, m), TermKind::Pair(q, y, n)) if x == y => self.apart((p, *m), (q, *n)),
            _ => false,
        }
    }

    /// Whether something cannot compare with two others in these ways.
    fn apart(&self, (p, m): (&str, TermId), (q, n): (&str, TermId)) -> bool {
        let opposite = |p: &str, q: &str| {
            matches!((p, q), (" < ", " >= " | " > " | " = ") | (" > ", " <= " | " = ") | (" = ", " <> "))
        };
        if m == n && (opposite(p, q) || opposite(q, p)) {
            return true;
        }
        let ends = |sign: &str, limit: TermId| match (sign, &self.terms[limit].kind) {
            (" = ", TermKind::Integer(k)) => Some((*k, *k)),
            (" < ", TermKind::Integer(k)) => Some((i64::MIN, k.saturating_sub(1))),
            (" <= ", TermKind::Integer(k)) => Some((i64::MIN, *k)),
            (" > ", TermKind::Integer(k)) => Some((k.saturating_add(1), i64::MAX)),
            (" >= ", TermKind::Integer(k)) => Some((*k, i64::MAX)),
            _ => None,
        };
        match (ends(p, m), ends(q, n)) {
            (Some((from, to)), Some((other_from, other_to))) => to < other_from || other_to < from,
            _ => false,
        }
    }

    /// Whether two products cannot both be true: a factor contradicts one of the other, or all alternatives of a factor do.
    pub fn exclude(&self, a: TermId, b: TermId) -> bool {
        let (a, b) = (self.factors(a), self.factors(b));
        let some = |one: TermId, others: &[TermId]| others.iter().any(|&other| self.contradict(one, other));
        let falls = |one: TermId, others: &[TermId]| match self.terms[one].kind {
            TermKind::Or(..) => self.alternatives(one).iter().all(|&alternative| some(alternative, others)),
            TermKind::Not(inner) => self.factors(inner).iter().all(|factor| others.contains(factor)),
            _ => false,
        };
        a.iter().any(|&a| some(a, &b) || falls(a, &b)) || b.iter().any(|&b| falls(b, &a))
    }

    /// What is left of a guard where a condition holds; none if both cannot hold.
    pub fn under(&mut self, guard: TermId, here: TermId) -> Option<TermId> {
        if self.exclude(guard, here) {
            return None;
        }
        let known = self.factors(here);
        let mut left = self.constant(true, self.terms[guard].span);
        for factor in self.factors(guard) {
            if known.contains(&factor) {
                continue;
            }
            left = self.and(left, factor);
        }
        Some(left)
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
            | TermKind::Time(_)
            | TermKind::ChildActive(_)
            | TermKind::ChildFrozen(_) => Vec::new(),
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
