//! The graph of reachable situations, or of states.

use crate::atom::Atom;
use crate::beyond::Beyond;
use crate::claim::designation;
use crate::explore::{Bounds, Explored, Keep, Reaction, To, explore};
use crate::machine::Machine;
use crate::when::{Answers, When};
use grafc_logic::scan::{Program, TransitionId};
use indexmap::{IndexMap, IndexSet};
use rustc_hash::{FxBuildHasher, FxHashSet};
use std::collections::VecDeque;

/// What the nodes of a graph are.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Of {
    /// Situations: the graph of reachable markings.
    #[default]
    Situations,
    /// States: with stored variables, operands of edges and delays.
    States,
}

/// A graph of what a chart can come to.
#[derive(Clone, PartialEq, Debug)]
pub struct Graph {
    /// The chart's name.
    pub chart: String,
    /// What can be come to; ids are places in this list, breadth first.
    pub nodes: Vec<Node>,
    /// Those that the initial reaction leads to.
    pub initial: Vec<usize>,
    /// From one to another that some reaction leads to, in order of ids.
    pub edges: Vec<Edge>,
    /// Those from which no other situation can be reached: of situations, if that holds for one of their states. Empty if
    /// the graph is not complete, or if the chart has no transitions.
    pub deadlocks: Vec<usize>,
    /// Reactions that would not end (R9).
    pub livelocks: Vec<Livelock>,
    /// How many states there are.
    pub states: usize,
    /// Whether that is all.
    pub complete: bool,
    /// Where the assumptions allow no inputs at all, so that what follows is left out: at the start, if no steps are named.
    pub barred: Option<Vec<String>>,
    /// Whether delays were free to end at any time, so that real times may allow less.
    pub free_delays: bool,
}

/// A situation or a state.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Node {
    /// The labels of the active steps, in order of declaration.
    pub steps: Vec<String>,
    /// Of a state, the names and values of what else it is made of.
    pub values: Vec<(String, String)>,
}

/// What leads from one to another.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Edge {
    /// From here.
    pub from: usize,
    /// To there.
    pub to: usize,
    /// Inputs with which some reaction does, as a condition; `true` if any will do.
    pub when: String,
}

/// A reaction that would not end.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Livelock {
    /// From here; none for the initial reaction.
    pub from: Option<usize>,
    /// With these inputs.
    pub when: String,
    /// The transitions that are cleared again and again, by their designations or places.
    pub ring: Vec<String>,
}

impl Graph {
    /// Whether the initial reaction leads to a node.
    pub fn is_initial(&self, id: usize) -> bool {
        self.initial.binary_search(&id).is_ok()
    }

    /// Whether a node is one of the deadlocks.
    pub fn is_deadlock(&self, id: usize) -> bool {
        self.deadlocks.binary_search(&id).is_ok()
    }

    /// What leads on from a node.
    pub fn edges_from(&self, id: usize) -> &[Edge] {
        let first = self.edges.partition_point(|edge| edge.from < id);
        let count = self.edges[first..].partition_point(|edge| edge.from == id);
        &self.edges[first..first + count]
    }

    /// The reactions from a node, or at the start, that would not end.
    pub fn livelocks_from(&self, id: Option<usize>) -> &[Livelock] {
        let first = self.livelocks.partition_point(|livelock| livelock.from < id);
        let count = self.livelocks[first..].partition_point(|livelock| livelock.from == id);
        &self.livelocks[first..first + count]
    }
}

/// Where many inputs count in a state, there are as many paths from it as there are vectors: so many are walked for each state
/// that may be looked at.
const PATHS_PER_STATE: usize = 10;

/// So many are walked in any case.
const FEWEST_PATHS: usize = 10_000;

type Map<K, V> = IndexMap<K, V, FxBuildHasher>;

/// The reactions, by what they connect.
#[derive(Default)]
struct Kept {
    /// From state to state, with the answers that lead there.
    edges: Map<(usize, usize), IndexSet<Answers, FxBuildHasher>>,
    /// From a state, or from the start, into a ring of transitions without end.
    livelocks: Map<(Option<usize>, Vec<TransitionId>), IndexSet<Answers, FxBuildHasher>>,
}

impl Keep for Kept {
    fn reaction(&mut self, _: &Machine, Reaction { from, to, path }: Reaction) -> bool {
        let answers = path.iter().filter(|(atom, _)| !matches!(atom, Atom::Ends(..))).copied().collect();
        match (from.map(|(from, _)| from), to) {
            (from, To::Livelock(ring)) => {
                self.livelocks.entry((from, ring)).or_default().insert(answers);
            }
            (Some(from), To::State(to)) => {
                self.edges.entry((from, to)).or_default().insert(answers);
            }
            (None, To::State(_)) | (_, To::NotKept | To::Barred) => {}
        }
        false
    }
}

/// Explores a program that shows its transitions, up to a number of states.
///
/// # Errors
/// What of the chart cannot be followed.
pub fn graph(program: &Program, of: Of, most: usize) -> Result<Graph, Beyond> {
    let mut machine = Machine::new(program)?;
    let mut kept = Kept::default();
    let paths = most.saturating_mul(PATHS_PER_STATE).saturating_add(FEWEST_PATHS);
    let explored = explore(&mut machine, &mut Bounds { states: most, paths, stop: &mut |_, _| None }, &mut kept)?;
    let keys: Vec<Vec<usize>> = explored.situations.iter().cloned().collect();
    // The nodes that states belong to, and what they are sorted by.
    let (node_of, sorting): (Vec<usize>, Vec<Vec<usize>>) = match of {
        Of::Situations => (explored.situation_of.clone(), keys),
        Of::States => {
            let states = (0..explored.states.len()).collect();
            (states, explored.situation_of.iter().map(|s| keys[*s].clone()).collect())
        }
    };
    let order = numbered(&explored, &kept, &node_of, &sorting);
    let node = |state: usize| order[node_of[state]];

    let mut edges: Map<(usize, usize), Vec<&Answers>> = IndexMap::default();
    for ((from, to), answers) in kept.edges.iter().filter(|((from, to), _)| node_of[*from] != node_of[*to]) {
        edges.entry((node(*from), node(*to))).or_default().extend(answers);
    }
    let mut rings: Map<(Option<usize>, &[TransitionId]), Vec<&Answers>> = IndexMap::default();
    for ((from, ring), answers) in &kept.livelocks {
        rings.entry((from.map(node), ring)).or_default().extend(answers);
    }
    let asked = edges.values().chain(rings.values()).flatten().flat_map(|path| path.iter());
    let when = When::new(program, asked.map(|(atom, _)| *atom));
    let mut edges: Vec<Edge> =
        edges.into_iter().map(|((from, to), paths)| Edge { from, to, when: when.text(paths) }).collect();
    edges.sort_by_key(|edge| (edge.from, edge.to));
    let mut livelocks: Vec<(Option<usize>, &[TransitionId], String)> =
        rings.into_iter().map(|((from, ring), paths)| (from, ring, when.text(paths))).collect();
    livelocks.sort();

    let label = |place: &usize| program.steps.raw[*place].label.to_string();
    let mut nodes = vec![Node { steps: Vec::new(), values: Vec::new() }; sorting.len()];
    for (place, key) in sorting.iter().enumerate() {
        nodes[order[place]].steps = key.iter().map(label).collect();
    }
    if of == Of::States {
        for (place, state) in explored.states.iter().enumerate() {
            nodes[order[place]].values = machine.told(state);
        }
    }
    let sorted = |mut ids: Vec<usize>| {
        ids.sort_unstable();
        ids.dedup();
        ids
    };
    let has_transitions = program.observing.as_ref().is_some_and(|observing| !observing.transitions.is_empty());
    let deadlocks = if explored.limit.is_none() && has_transitions { deadlocks(&explored, &kept) } else { Vec::new() };
    Ok(Graph {
        chart: program.name.clone(),
        nodes,
        initial: sorted(explored.initial.iter().map(|state| node(*state)).collect()),
        edges,
        deadlocks: sorted(deadlocks.into_iter().map(node).collect()),
        livelocks: livelocks
            .into_iter()
            .map(|(from, ring, when)| Livelock {
                from,
                when,
                ring: ring.iter().map(|t| designation(program, *t)).collect(),
            })
            .collect(),
        states: explored.states.len(),
        complete: explored.limit.is_none(),
        barred: explored.barred.map(|state| {
            let situation = state.and_then(|state| explored.situations.get_index(explored.situation_of[state]));
            situation.into_iter().flatten().map(|place| program.steps.raw[*place].label.to_string()).collect()
        }),
        free_delays: !program.timers.is_empty(),
    })
}

/// A number for each node: breadth first, the roots and what follows each in order of their steps.
fn numbered(explored: &Explored, kept: &Kept, node_of: &[usize], sorting: &[Vec<usize>]) -> Vec<usize> {
    let mut after: Vec<Vec<usize>> = vec![Vec::new(); sorting.len()];
    for (from, to) in kept.edges.keys().filter(|(from, to)| node_of[*from] != node_of[*to]) {
        after[node_of[*from]].push(node_of[*to]);
    }
    // Of two states with the same steps, the one that was met first.
    let sort = |list: &mut Vec<usize>| {
        list.sort_by_key(|node| (&sorting[*node], *node));
        list.dedup();
    };
    let mut roots: Vec<usize> = explored.initial.iter().map(|state| node_of[*state]).collect();
    sort(&mut roots);
    let mut met: IndexSet<usize, FxBuildHasher> = roots.iter().copied().collect();
    let mut open: VecDeque<usize> = roots.into();
    while let Some(node) = open.pop_front() {
        sort(&mut after[node]);
        for next in &after[node] {
            if met.insert(*next) {
                open.push_back(*next);
            }
        }
    }
    let mut order = vec![0; sorting.len()];
    for (number, node) in met.iter().enumerate() {
        order[*node] = number;
    }
    order
}

/// The states from which no path reaches another situation.
fn deadlocks(explored: &Explored, kept: &Kept) -> Vec<usize> {
    let mut before: Vec<Vec<usize>> = vec![Vec::new(); explored.states.len()];
    let mut alive: FxHashSet<usize> = FxHashSet::default();
    let mut open: Vec<usize> = Vec::new();
    for (from, to) in kept.edges.keys() {
        if explored.situation_of[*from] != explored.situation_of[*to] {
            if alive.insert(*from) {
                open.push(*from);
            }
        } else {
            before[*to].push(*from);
        }
    }
    while let Some(state) = open.pop() {
        for earlier in &before[state] {
            if alive.insert(*earlier) {
                open.push(*earlier);
            }
        }
    }
    (0..explored.states.len()).filter(|state| !alive.contains(state)).collect()
}
