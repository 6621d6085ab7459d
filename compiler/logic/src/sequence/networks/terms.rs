//! Boolean expressions that are made here, beside those of the chart.

use grafc_diagnostics::Span;
use grafc_model::chart::{Expr, ExprId, ExprKind, StepId, Type, Value};
use index_vec::IndexVec;
use rustc_hash::FxHashMap;

/// Makes expressions, each once.
#[derive(Default)]
pub(super) struct Terms {
    made: FxHashMap<Key, ExprId>,
}

#[derive(PartialEq, Eq, Hash)]
enum Key {
    Truth(bool),
    Active(StepId),
    Not(ExprId),
    And(ExprId, ExprId),
    Or(ExprId, ExprId),
}

pub(super) type Exprs = IndexVec<ExprId, Expr>;

impl Terms {
    fn make(&mut self, exprs: &mut Exprs, key: Key, kind: ExprKind) -> ExprId {
        *self.made.entry(key).or_insert_with(|| exprs.push(Expr { kind, ty: Type::Bool, span: Span::default() }))
    }

    pub(super) fn truth(&mut self, exprs: &mut Exprs, value: bool) -> ExprId {
        self.make(exprs, Key::Truth(value), ExprKind::Literal(Value::Bool(value)))
    }

    pub(super) fn active(&mut self, exprs: &mut Exprs, step: StepId) -> ExprId {
        self.make(exprs, Key::Active(step), ExprKind::StepActive(step))
    }

    pub(super) fn not(&mut self, exprs: &mut Exprs, a: ExprId) -> ExprId {
        match exprs[a].kind {
            ExprKind::Literal(Value::Bool(value)) => self.truth(exprs, !value),
            ExprKind::Not(inner) => inner,
            _ => self.make(exprs, Key::Not(a), ExprKind::Not(a)),
        }
    }

    /// A conjunction, each term once.
    pub(super) fn and(&mut self, exprs: &mut Exprs, terms: impl IntoIterator<Item = ExprId>) -> ExprId {
        self.join(exprs, terms, true, |a, b| (Key::And(a, b), ExprKind::And(a, b)))
    }

    /// A disjunction, each term once.
    pub(super) fn or(&mut self, exprs: &mut Exprs, terms: impl IntoIterator<Item = ExprId>) -> ExprId {
        self.join(exprs, terms, false, |a, b| (Key::Or(a, b), ExprKind::Or(a, b)))
    }

    /// Terms put together, where `neutral` is the value that changes nothing and the other one decides.
    fn join(
        &mut self,
        exprs: &mut Exprs,
        terms: impl IntoIterator<Item = ExprId>,
        neutral: bool,
        with: impl Fn(ExprId, ExprId) -> (Key, ExprKind),
    ) -> ExprId {
        let (mut joined, mut seen) = (None, Vec::new());
        for term in terms {
            match exprs[term].kind {
                ExprKind::Literal(Value::Bool(value)) if value == neutral => continue,
                ExprKind::Literal(_) => return term,
                _ if seen.contains(&term) => continue,
                _ => seen.push(term),
            }
            joined = Some(match joined {
                None => term,
                Some(joined) => {
                    let (key, kind) = with(joined, term);
                    self.make(exprs, key, kind)
                }
            });
        }
        joined.unwrap_or_else(|| self.truth(exprs, neutral))
    }
}
