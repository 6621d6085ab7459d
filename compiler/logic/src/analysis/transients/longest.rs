//! The longest path through the graph of causes.

use super::causes::{Causes, Change};
use grafc_model::chart::TransitionId;
use petgraph::algo::kosaraju_scc;
use petgraph::graph::{DiGraph, NodeIndex};
use petgraph::visit::EdgeRef;
use rustc_hash::FxHashMap;
use std::collections::hash_map::Entry;
use std::collections::{BTreeSet, VecDeque};

/// The last micro-step in which each change can happen, by number, with the cause that comes last; none if it never
/// can.
pub(super) struct Times {
    last: Vec<Option<(u32, Option<u32>)>>,
}

/// A part of the graph in which changes can cause each other endlessly.
pub(super) struct Endless {
    /// Transitions that clear in it, in order.
    pub(super) transitions: BTreeSet<TransitionId>,
    /// Those of one way round, as far as transitions take part in it.
    pub(super) cycle: Vec<TransitionId>,
}

impl Times {
    /// Finds them, or that there is no last one. Changes of which `never` is true do not happen.
    pub(super) fn find(
        causes: &Causes,
        transition_of: &dyn Fn(Change) -> Option<TransitionId>,
        never: &dyn Fn(Change) -> bool,
    ) -> Result<Times, Endless> {
        let never: Vec<bool> = causes.changes().map(never).collect();
        let possible = |change: u32| !never[change as usize];
        let mut graph: DiGraph<(), bool> = DiGraph::with_capacity(causes.len(), causes.edges.len());
        (0..causes.len()).for_each(|_| _ = graph.add_node(()));
        for (cause, effect, next) in causes.edges.iter().filter(|(c, e, _)| possible(*c) && possible(*e)) {
            graph.add_edge(NodeIndex::new(*cause as usize), NodeIndex::new(*effect as usize), *next);
        }
        let mut last: Vec<Option<(u32, Option<u32>)>> = vec![None; causes.len()];
        for start in causes.at_start.iter().filter(|s| possible(**s)) {
            last[*start as usize] = Some((1, None));
        }
        let mut endless: Option<Endless> = None;
        // Causes before effects.
        for part in kosaraju_scc(&graph).iter().rev() {
            let cyclic = part.len() > 1 || part.iter().any(|n| graph.contains_edge(*n, *n));
            let reached = part.iter().any(|n| last[n.index()].is_some());
            if cyclic && reached {
                let found = endless.get_or_insert_with(|| Endless {
                    transitions: BTreeSet::new(),
                    cycle: cycle(causes, &graph, part, transition_of),
                });
                found.transitions.extend(part.iter().filter_map(|n| transition_of(causes.change(n.index() as u32))));
                // What follows can be reached as well; when, is not asked any more.
                part.iter().for_each(|n| last[n.index()] = Some((1, None)));
            }
            for node in part {
                let Some((time, _)) = last[node.index()] else { continue };
                for edge in graph.edges(*node) {
                    let reached = time + u32::from(*edge.weight());
                    let known = &mut last[edge.target().index()];
                    if known.is_none_or(|(t, _)| t < reached) {
                        *known = Some((reached, Some(node.index() as u32)));
                    }
                }
            }
        }
        match endless {
            None => Ok(Times { last }),
            Some(endless) => Err(endless),
        }
    }

    /// The last micro-step in which a change can happen.
    pub(super) fn of(&self, change: u32) -> Option<u32> {
        self.last[change as usize].map(|(time, _)| time)
    }

    /// A change and what leads to it, the last first.
    pub(super) fn back_from(&self, change: u32) -> impl Iterator<Item = u32> + '_ {
        std::iter::successors(Some(change), |c| self.last[*c as usize].and_then(|(_, cause)| cause))
    }
}

/// The shortest way round within a part from its first transition back to itself.
fn cycle(
    causes: &Causes,
    graph: &DiGraph<(), bool>,
    part: &[NodeIndex],
    transition_of: &dyn Fn(Change) -> Option<TransitionId>,
) -> Vec<TransitionId> {
    let transition = |n: NodeIndex| transition_of(causes.change(n.index() as u32));
    let Some(first) = part.iter().copied().filter(|n| transition(*n).is_some()).min_by_key(|n| (transition(*n), *n))
    else {
        return Vec::new();
    };
    let mut member = vec![false; graph.node_count()];
    part.iter().for_each(|n| member[n.index()] = true);
    let mut from: FxHashMap<NodeIndex, NodeIndex> = FxHashMap::default();
    let mut open = VecDeque::from([first]);
    while let Some(node) = open.pop_front().filter(|_| !from.contains_key(&first)) {
        for next in graph.neighbors(node).filter(|n| member[n.index()]) {
            if let Entry::Vacant(entry) = from.entry(next) {
                entry.insert(node);
                open.push_back(next);
            }
        }
    }
    let mut cycle: Vec<TransitionId> = transition(first).into_iter().collect();
    let mut at = first;
    while let Some(before) = from.get(&at).copied().filter(|n| *n != first) {
        cycle.extend(transition(before));
        at = before;
    }
    // The way was followed back: first, then the last before it, and so on.
    cycle[1..].reverse();
    cycle.dedup();
    cycle
}
