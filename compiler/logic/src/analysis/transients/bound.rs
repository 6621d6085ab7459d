//! A bound on micro-steps that no reaction hits that comes to rest (R9), where one is known.
//!
//! Where it is proved that every reaction ends, the longest gives it. Else the situations do, where nothing else decides on
//! how a reaction goes on: no condition and no order depends on what stored actions write, on edges of what changes within
//! a reaction, on delays of it, or on how long a step has lasted. Then a situation that comes again comes for ever, and one that comes to rest
//! goes through each at most once. The first micro-step stands apart, since edges of inputs are seen in it alone.

use crate::analysis::Analysis;
use grafc_model::chart::{ExprId, ExprKind, Mode};
use index_vec::IndexVec;
use rustc_hash::FxHashSet;

impl Analysis {
    /// One micro-step more than the longest evolution takes that repeats no state; none if that is not known.
    pub fn known_bound(&self) -> Option<u32> {
        if let Some(longest) = self.transients().longest {
            return Some(longest.max(1));
        }
        if !self.goes_by_situations() {
            return None;
        }
        // One for the edges of inputs, and one that finds nothing, or the first situation again.
        let bound = self.situations()?.checked_add(2)?;
        u32::try_from(bound).ok().filter(|bound| *bound <= i32::MAX as u32)
    }

    /// Whether the situation alone decides on the next one, after the first micro-step.
    fn goes_by_situations(&self) -> bool {
        let net = self.net();
        let mut moves: IndexVec<ExprId, bool> = IndexVec::with_capacity(net.exprs.len());
        for expr in &net.exprs {
            let below = expr.kind.operands().any(|operand| moves[operand]);
            moves.push(match expr.kind {
                ExprKind::StepActive(_) | ExprKind::StepTime(_) => true,
                ExprKind::MacroActive(_) | ExprKind::GrafcetActive(_) | ExprKind::GrafcetFrozen(_) => true,
                ExprKind::Variable(v) => matches!(net.variables[v].mode, Mode::Wire | Mode::Stored),
                ExprKind::Literal(_)
                | ExprKind::Not(_)
                | ExprKind::And(..)
                | ExprKind::Or(..)
                | ExprKind::Xor(..)
                | ExprKind::Rise(_)
                | ExprKind::Fall(_)
                | ExprKind::Delay { .. }
                | ExprKind::Compare(..)
                | ExprKind::Arithmetic(..)
                | ExprKind::Negate(_)
                | ExprKind::Widen(_) => below,
            });
        }
        net.stored.is_empty()
            && net.exprs.iter().all(|expr| match expr.kind {
                ExprKind::Rise(a) | ExprKind::Fall(a) => !moves[a],
                ExprKind::Delay { operand, .. } => !moves[operand],
                // Within a reaction a step that is activated again has lasted less long.
                ExprKind::StepTime(_) => false,
                ExprKind::Literal(_)
                | ExprKind::Variable(_)
                | ExprKind::StepActive(_)
                | ExprKind::MacroActive(_)
                | ExprKind::GrafcetActive(_)
                | ExprKind::GrafcetFrozen(_)
                | ExprKind::Not(_)
                | ExprKind::And(..)
                | ExprKind::Or(..)
                | ExprKind::Xor(..)
                | ExprKind::Compare(..)
                | ExprKind::Arithmetic(..)
                | ExprKind::Negate(_)
                | ExprKind::Widen(_) => true,
            })
    }

    /// At most so many situations: of each set of steps that exclude each other one or none is active, and of every other
    /// step it is free whether it is.
    fn situations(&self) -> Option<u64> {
        let mut covered: FxHashSet<_> = FxHashSet::default();
        let mut count: u64 = 1;
        for part in self.reachable.parts() {
            let Some(found) = part.count() else { continue };
            count = count.checked_mul(found)?;
            covered.extend(part.steps.iter().copied());
        }
        for set in &self.cover.sets {
            let free = set.steps.iter().filter(|s| !covered.contains(*s)).count() as u64;
            if free > 0 {
                count = count.checked_mul(free + u64::from(!set.always_marked || free < set.steps.len() as u64))?;
            }
        }
        for s in self.net().places.indices() {
            if self.cover.of_step[s].is_none() && !covered.contains(&s) {
                count = count.checked_mul(2)?;
            }
        }
        Some(count)
    }
}
