//! In which order variables are written: what reads a variable comes before it.

use super::Triggers;
use crate::lower::Lowering;
use crate::scan::Origin;
use grafc_formula::FormulaId;
use grafc_model::chart::{ExprId, ExprKind, Mode, VariableId};
use rustc_hash::FxHashMap;
use std::collections::BTreeSet;

/// A variable in the order of writing.
pub(super) struct Turn {
    pub(super) variable: VariableId,
    /// Whether it is copied before it is written, because others have yet to read it.
    pub(super) copied: bool,
    /// A variable that is written later although the chart has it before this one: it is read here.
    pub(super) before: Option<VariableId>,
}

/// The place of a variable's first action in the chart, and the variable.
type Ranked = (usize, VariableId);

/// The order of writing: that of the chart as far as no variable is written before all have read it, and variables that are
/// written under the same guards one after the other.
pub(super) fn order(lowering: &Lowering, triggers: &Triggers) -> Vec<Turn> {
    let rank = |v: &VariableId| -> Ranked {
        let of = |origin: Origin| match origin {
            Origin::Action(a) => a.index(),
            Origin::Chart
            | Origin::Step(_)
            | Origin::Transition(_)
            | Origin::Actions(_)
            | Origin::Order(_)
            | Origin::Orders(_)
            | Origin::Declaration(_) => usize::MAX,
        };
        (triggers[v].iter().map(|t| of(t.origin)).min().unwrap_or(usize::MAX), *v)
    };
    // For each variable those that must be written before it, because they read it, and the reverse.
    let mut readers: FxHashMap<VariableId, BTreeSet<VariableId>> = FxHashMap::default();
    let mut reads: FxHashMap<VariableId, BTreeSet<VariableId>> = FxHashMap::default();
    for (writer, list) in triggers {
        for trigger in list {
            for read in stored_reads(lowering, trigger.value) {
                if read != *writer && triggers.contains_key(&read) {
                    readers.entry(read).or_default().insert(*writer);
                    reads.entry(*writer).or_default().insert(read);
                }
            }
        }
    }
    let guards: FxHashMap<VariableId, Vec<FormulaId>> =
        triggers.iter().map(|(v, list)| (*v, list.iter().map(|t| t.when).collect())).collect();
    let mut waiting: BTreeSet<Ranked> = triggers.keys().map(rank).collect();
    let mut ready = Ready { guards: &guards, all: BTreeSet::new(), under: FxHashMap::default() };
    waiting.iter().filter(|(_, v)| !readers.contains_key(v)).for_each(|ranked| ready.insert(*ranked));
    let mut order: Vec<Turn> = Vec::with_capacity(waiting.len());
    while let Some(first) = waiting.first().copied() {
        let last = order.last().map(|turn| turn.variable);
        let (ranked, copied) = match ready.next(last) {
            Some(ranked) => (ranked, false),
            None => (first, true),
        };
        waiting.remove(&ranked);
        let variable = ranked.1;
        let read = reads.remove(&variable).unwrap_or_default();
        let before = read.iter().copied().find(|v| rank(v) < ranked && waiting.contains(&rank(v)));
        order.push(Turn { variable, copied, before });
        for read in read {
            if let Some(left) = readers.get_mut(&read) {
                left.remove(&variable);
                if left.is_empty() && waiting.contains(&rank(&read)) {
                    ready.insert(rank(&read));
                }
            }
        }
    }
    order
}

/// Variables that nothing has yet to read.
struct Ready<'g> {
    guards: &'g FxHashMap<VariableId, Vec<FormulaId>>,
    all: BTreeSet<Ranked>,
    /// The same, by the guards under which they are written.
    under: FxHashMap<&'g [FormulaId], BTreeSet<Ranked>>,
}

impl Ready<'_> {
    fn insert(&mut self, ranked: Ranked) {
        self.all.insert(ranked);
        self.under.entry(&self.guards[&ranked.1]).or_default().insert(ranked);
    }

    /// The next one, under the same guards as the last if there is one.
    fn next(&mut self, last: Option<VariableId>) -> Option<Ranked> {
        let same = last.and_then(|v| self.under.get(self.guards[&v].as_slice())?.first().copied());
        let ranked = same.or_else(|| self.all.first().copied())?;
        self.all.remove(&ranked);
        if let Some(set) = self.under.get_mut(self.guards[&ranked.1].as_slice()) {
            set.remove(&ranked);
        }
        Some(ranked)
    }
}

/// The stored variables that a right side reads at the moment of writing; wires, edges and delays were fixed before.
fn stored_reads(lowering: &Lowering, root: ExprId) -> Vec<VariableId> {
    let net = &*lowering.net.clone();
    let mut found = Vec::new();
    let mut stack = vec![root];
    while let Some(e) = stack.pop() {
        match &net.exprs[e].kind {
            ExprKind::Variable(v) => {
                if net.variables[*v].mode == Mode::Stored {
                    found.push(*v);
                }
            }
            ExprKind::Rise(_) | ExprKind::Fall(_) | ExprKind::Delay { .. } => {}
            ExprKind::Literal(_)
            | ExprKind::StepActive(_)
            | ExprKind::StepTime(_)
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
            | ExprKind::Widen(_) => stack.extend(net.exprs[e].kind.operands()),
        }
    }
    found
}
