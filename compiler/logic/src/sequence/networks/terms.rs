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

    pub(super) fn and(&mut self, exprs: &mut Exprs, terms: impl IntoIterator<Item = ExprId>) -> ExprId {
        let (mut all, mut seen) = (None, Vec::new());
        for term in terms {
            match exprs[term].kind {
                ExprKind::Literal(Value::Bool(true)) => continue,
                ExprKind::Literal(_) => return term,
                _ if seen.contains(&term) => continue,
                _ => seen.push(term),
            }
            all = Some(match all {
                None => term,
                Some(all) => self.make(exprs, Key::And(all, term), ExprKind::And(all, term)),
            });
        }
        all.unwrap_or_else(|| self.truth(exprs, true))
    }

    pub(super) fn or(&mut self, exprs: &mut Exprs, terms: impl IntoIterator<Item = ExprId>) -> ExprId {
        let (mut any, mut seen) = (None, Vec::new());
        for term in terms {
            match exprs[term].kind {
                ExprKind::Literal(Value::Bool(false)) => continue,
                ExprKind::Literal(_) => return term,
                _ if seen.contains(&term) => continue,
                _ => seen.push(term),
            }
            any = Some(match any {
                None => term,
                Some(any) => self.make(exprs, Key::Or(any, term), ExprKind::Or(any, term)),
            });
        }
        any.unwrap_or_else(|| self.truth(exprs, false))
    }
}
