//! Assignments to one variable that may be done in one micro-step (R7).

use super::neighbours;
use super::questions::Questions;
use super::triggers::{meet, ways};
use crate::analysis::Analysis;
use grafc_model::chart::{Event, ExprKind, Stored, VariableId, below};
use grafc_net::Net;
use std::collections::BTreeMap;

/// Two assignments to a variable, as places in the net's list of stored actions.
#[derive(Clone, Copy)]
pub(crate) struct Meeting {
    pub(crate) variable: VariableId,
    pub(crate) first: usize,
    pub(crate) second: usize,
}

/// The stored actions by what they write.
fn writers(net: &Net) -> BTreeMap<VariableId, Vec<usize>> {
    let mut writers: BTreeMap<VariableId, Vec<usize>> = BTreeMap::new();
    for (index, action) in net.stored.iter().enumerate() {
        writers.entry(action.target).or_default().push(index);
    }
    writers
}

/// Whether two actions could stand against each other: what is done each scan is done after all others, and sees them.
fn are_of_one_class(net: &Net, a: usize, b: usize) -> bool {
    let is_each_scan = |action: usize| matches!(net.stored[action].event, Event::EachScan(..));
    is_each_scan(a) == is_each_scan(b)
}

/// Two that compute the variable from itself: one of them is lost.
pub(super) fn races(analysis: &Analysis) -> Vec<Meeting> {
    let net = &analysis.net;
    let mut found = Vec::new();
    for (variable, actions) in writers(net) {
        let counting: Vec<usize> = actions.into_iter().filter(|a| counts(net, &net.stored[*a])).collect();
        let ways: Vec<_> = counting.iter().map(|action| ways(analysis, *action)).collect();
        let pair = neighbours::first(counting.len(), |a, b| {
            are_of_one_class(net, counting[a], counting[b]) && meet(analysis, &ways[a], &ways[b])
        });
        found.extend(pair.map(|(a, b)| Meeting { variable, first: counting[a], second: counting[b] }));
    }
    found
}

/// Two that give it different values, other than those that `races` tells of.
pub(super) fn conflicts(asked: &mut Questions) -> Vec<Meeting> {
    let analysis = asked.analysis;
    let net = &analysis.net;
    let mut found = Vec::new();
    for (variable, actions) in writers(net) {
        if actions.len() < 2 {
            continue;
        }
        let values: Vec<_> = actions.iter().map(|a| asked.value(net.stored[*a].value)).collect();
        let counting: Vec<bool> = actions.iter().map(|a| counts(net, &net.stored[*a])).collect();
        let ways: Vec<_> = actions.iter().map(|a| ways(analysis, *a)).collect();
        let pair = neighbours::first(actions.len(), |a, b| {
            values[a] != values[b]
                && !(counting[a] && counting[b])
                && are_of_one_class(net, actions[a], actions[b])
                && meet(analysis, &ways[a], &ways[b])
        });
        found.extend(pair.map(|(a, b)| Meeting { variable, first: actions[a], second: actions[b] }));
    }
    found
}

/// Whether an action computes a value from the one that it replaces.
fn counts(net: &Net, action: &Stored) -> bool {
    below(&net.exprs, action.value).any(|e| net.exprs[e].kind == ExprKind::Variable(action.target))
}
