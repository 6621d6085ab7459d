//! What a clearing makes of states, and how the rest of the micro-step learns of it.

use super::Task;
use crate::lower::Lowering;
use crate::lower::situation::Holder;
use crate::scan::{Role, VarId};
use grafc_formula::Type;
use grafc_model::chart::{StepId, TransitionId};
use std::collections::BTreeMap;

/// Which transition of a set clears, where an action waits for it.
pub(super) struct Numbered {
    /// The variable of each set that has such a transition, 0 outside of a micro-step.
    pub variable: BTreeMap<usize, VarId>,
    /// The number of each such transition within its set.
    pub transitions: BTreeMap<TransitionId, i64>,
}

impl Numbered {
    pub fn new(lowering: &mut Lowering) -> Self {
        let net = &*lowering.net.clone();
        let mut numbered = Numbered { variable: BTreeMap::new(), transitions: BTreeMap::new() };
        for t in net.awaited_clearings() {
            let Some(set) = home(lowering, t) else { continue };
            numbered.transitions.insert(t, 0);
            numbered.variable.entry(set).or_insert_with(|| {
                let base = lowering.symbols.table[lowering.situation.sets[set].variable].name.clone();
                let base = base.strip_prefix("at_").unwrap_or(&base);
                let comment = Some("number of the transition that clears, else 0".into());
                lowering.symbols.fresh(Role::Memory, format!("clears_{base}"), Type::Dint, comment)
            });
        }
        let mut last: BTreeMap<usize, i64> = BTreeMap::new();
        for (t, number) in &mut numbered.transitions {
            let last = last.entry(home(lowering, *t).unwrap_or_default()).or_default();
            *last += 1;
            *number = *last;
        }
        numbered
    }
}

/// The set in whose arms a transition is looked at: that of the first step before it, if sets hold all steps around it.
pub(super) fn home(lowering: &Lowering, t: TransitionId) -> Option<usize> {
    let transition = &lowering.net.transitions[t];
    let set = |s: &StepId| match lowering.situation.holder(*s) {
        Holder::State { set, .. } => Some(set),
        Holder::Bit(_) => None,
    };
    let first = set(transition.pre.first()?)?;
    transition.pre.iter().chain(&transition.post).all(|s| set(s).is_some()).then_some(first)
}

/// The variable that says that something clears, and whether it is also what asks for another micro-step.
pub(super) struct Moved {
    pub variable: VarId,
    pub asks_again: bool,
}

impl Moved {
    pub fn new(lowering: &mut Lowering, task: &Task, numbered: &Numbered) -> Self {
        // A clearing that leads back to where it came from changes nothing, but its actions are done.
        let only_back = numbered.transitions.keys().any(|t| changes_of(lowering, *t).is_empty());
        let bits = lowering.net.places.indices().any(|s| lowering.situation.bit(s).is_some());
        match task.again.filter(|_| lowering.edges.is_empty() && !only_back && !bits) {
            Some(variable) => Moved { variable, asks_again: true },
            None => {
                let variable = lowering.symbols.fresh(Role::Temporary, "moved", Type::Bool, None);
                Moved { variable, asks_again: false }
            }
        }
    }
}

/// What a clearing makes of the states around it.
pub(super) fn changes_of(lowering: &Lowering, t: TransitionId) -> Vec<(usize, i64)> {
    let transition = &lowering.net.transitions[t];
    let mut left: BTreeMap<usize, i64> = BTreeMap::new();
    let mut come: BTreeMap<usize, i64> = BTreeMap::new();
    for s in &transition.pre {
        if let Holder::State { set, value } = lowering.situation.holder(*s) {
            left.insert(set, value);
        }
    }
    for s in &transition.post {
        if let Holder::State { set, value } = lowering.situation.holder(*s) {
            come.insert(set, value);
        }
    }
    let mut changes = Vec::new();
    for (set, from) in &left {
        let to = come.get(set).copied().unwrap_or(lowering.situation.sets[*set].idle);
        if to != *from {
            changes.push((*set, to));
        }
    }
    changes.extend(come.iter().filter(|(set, _)| !left.contains_key(set)).map(|(set, to)| (*set, *to)));
    changes
}
