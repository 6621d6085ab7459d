//! Few and short round trips through what can happen, from an initial situation and back, that cover all of it.
//!
//! Each trip takes the shortest way to what is not covered yet, and goes home as soon as that is nearer than the next such
//! thing. That is no proof that there are no fewer and no shorter ones: [`Totals`] say how far from it they can be.

use grafc_verify::{Move, Moves};
use petgraph::algo::kosaraju_scc;
use petgraph::graph::DiGraph;
use rustc_hash::FxHashMap;
use std::collections::{BTreeMap, BTreeSet, VecDeque};

/// What is to be covered.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Cover {
    /// Each transition is cleared.
    Transitions,
    /// Each situation is come to.
    Situations,
    /// Each pair of different situations is taken that a reaction connects.
    Edges,
}

/// Something to cover: a transition, a situation, or a pair of situations.
pub(crate) type Item = (usize, usize);

/// One reaction of a trip: where it comes from, nothing at the start, and which of the moves from there it is.
pub(crate) type Leg = (Option<usize>, usize);

/// How many tests and rows there are, and how few there can be at least.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Totals {
    /// So many tests.
    pub tests: usize,
    /// No fewer can cover the same.
    pub fewest_tests: usize,
    /// So many rows in all of them.
    pub rows: usize,
    /// No fewer can cover the same.
    pub fewest_rows: usize,
}

/// What a graph of moves holds for somebody who covers it.
pub(crate) struct Plan<'m> {
    moves: &'m Moves,
    cover: Cover,
    /// Transitions behind these are none of the chart.
    transitions: usize,
    /// Moves that are not taken.
    pub banned: BTreeSet<Leg>,
    /// Whether trips may begin with any initial reaction, not only with one that clears nothing.
    any_start: bool,
}

impl<'m> Plan<'m> {
    pub(crate) fn new(moves: &'m Moves, cover: Cover, transitions: usize) -> Self {
        // A round trip begins where the chart does, with inputs at rest, if there are such.
        let any_start = moves.first.iter().all(|first| !first.cleared.is_empty());
        Plan { moves, cover, transitions, banned: BTreeSet::new(), any_start }
    }

    fn list(&self, from: Option<usize>) -> &'m [Move] {
        from.map_or(&self.moves.first, |from| &self.moves.from[from])
    }

    pub(crate) fn at(&self, (from, place): Leg) -> &'m Move {
        &self.list(from)[place]
    }

    fn legs(&self, from: Option<usize>) -> impl Iterator<Item = (Leg, &'m Move)> + '_ {
        let legs = self.list(from).iter().enumerate().map(move |(place, to)| ((from, place), to));
        legs.filter(move |(leg, to)| {
            let may_begin = from.is_some() || self.any_start || to.cleared.is_empty();
            may_begin && !self.banned.contains(leg)
        })
    }

    /// The situations that trips begin in, and come back to.
    pub(crate) fn home(&self) -> BTreeSet<usize> {
        self.legs(None).map(|(_, to)| self.moves.situation_of[to.to]).collect()
    }

    /// What a move covers.
    pub(crate) fn items(&self, leg: Leg) -> Vec<Item> {
        let to = self.at(leg);
        let situation = |node: usize| self.moves.situation_of[node];
        match self.cover {
            Cover::Transitions => to.cleared.iter().filter(|t| **t < self.transitions).map(|t| (*t, 0)).collect(),
            Cover::Situations => vec![(situation(to.to), 0)],
            Cover::Edges => match leg.0.map(situation) {
                Some(from) if from != situation(to.to) => vec![(from, situation(to.to))],
                Some(_) | None => Vec::new(),
            },
        }
    }

    /// The steps that are active after a move, by their places.
    pub(crate) fn situation(&self, leg: Leg) -> &'m [usize] {
        &self.moves.situations[self.moves.situation_of[self.at(leg).to]]
    }

    /// All legs that can be come to, breadth first, with how many rows it takes at least to have taken them.
    fn reachable(&self) -> Vec<(Leg, usize)> {
        let mut rows: FxHashMap<usize, usize> = FxHashMap::default();
        let mut open = VecDeque::from([(None, 0)]);
        let mut found = Vec::new();
        while let Some((from, before)) = open.pop_front() {
            for (leg, to) in self.legs(from) {
                found.push((leg, before + 1));
                rows.entry(to.to).or_insert_with(|| {
                    open.push_back((Some(to.to), before + 1));
                    before + 1
                });
            }
        }
        found
    }

    /// All that can be covered.
    pub(crate) fn coverable(&self) -> BTreeSet<Item> {
        self.reachable().into_iter().flat_map(|(leg, _)| self.items(leg)).collect()
    }

    /// The same, whatever reaction it begins with.
    pub(crate) fn coverable_from_any_start(mut self) -> BTreeSet<Item> {
        self.any_start = true;
        self.coverable()
    }

    /// The shortest way from a place over a leg of which it is true.
    fn way(&self, from: Option<usize>, wanted: &dyn Fn(Leg) -> bool) -> Option<Vec<Leg>> {
        let mut came: FxHashMap<usize, Leg> = FxHashMap::default();
        let mut open = VecDeque::from([from]);
        while let Some(at) = open.pop_front() {
            for (leg, to) in self.legs(at) {
                if wanted(leg) {
                    let mut way = vec![leg];
                    let mut before = leg.0;
                    while before != from {
                        let Some(leg) = before.and_then(|node| came.get(&node)) else { break };
                        way.push(*leg);
                        before = leg.0;
                    }
                    way.reverse();
                    return Some(way);
                }
                if Some(to.to) != from && !came.contains_key(&to.to) {
                    came.insert(to.to, leg);
                    open.push_back(Some(to.to));
                }
            }
        }
        None
    }

    /// Trips that cover all that can be covered.
    pub(crate) fn trips(&mut self) -> Vec<Vec<Leg>> {
        let mut open = self.coverable();
        let mut trips = self.trips_to(&mut open);
        if !self.any_start {
            // What only another start comes to.
            self.any_start = true;
            let mut rest = self.coverable();
            trips.iter().flatten().flat_map(|leg| self.items(*leg)).for_each(|item| _ = rest.remove(&item));
            let more = self.trips_to(&mut rest);
            self.any_start = !more.is_empty();
            trips.extend(more);
        }
        trips
    }

    fn trips_to(&self, open: &mut BTreeSet<Item>) -> Vec<Vec<Leg>> {
        let home = self.home();
        let is_home = |leg: Leg| home.contains(&self.moves.situation_of[self.at(leg).to]);
        let mut trips = Vec::new();
        while !open.is_empty() {
            let mut trip: Vec<Leg> = Vec::new();
            let mut at = None;
            loop {
                let next = self.way(at, &|leg| self.items(leg).iter().any(|item| open.contains(item)));
                let back = if trip.is_empty() { None } else { self.way(at, &is_home) };
                let is_at_home = trip.last().is_some_and(|leg| is_home(*leg));
                let way = match (next, back) {
                    // What is farther away than home begins a trip of its own; at home, a trip of more than its start ends.
                    (Some(next), Some(back)) if next.len() > back.len() && !is_at_home => back,
                    (Some(_), _) if is_at_home && trip.len() > 1 => break,
                    (Some(next), _) => next,
                    (None, _) if is_at_home => break,
                    (None, Some(back)) => back,
                    (None, None) => break,
                };
                for leg in way {
                    self.items(leg).iter().for_each(|item| _ = open.remove(item));
                    at = Some(self.at(leg).to);
                    trip.push(leg);
                }
            }
            if trip.is_empty() {
                break;
            }
            trips.push(trip);
        }
        trips
    }

    /// How many tests and rows the trips have, and how few there can be.
    ///
    /// A row covers one situation, one pair, or as many transitions as one reaction clears at most; and what is farthest away
    /// takes as many rows as the way there. A test ends in one part of the graph that nothing leads out of, so there is one
    /// test at least for each such part with something that only moves into it cover.
    pub(crate) fn totals(&self, trips: &[Vec<Leg>]) -> Totals {
        let legs = self.reachable();
        let mut nearest: BTreeMap<Item, usize> = BTreeMap::new();
        let mut most_a_row = 1;
        for (leg, rows) in &legs {
            let items = self.items(*leg);
            most_a_row = most_a_row.max(items.len());
            for item in items {
                nearest.entry(item).or_insert(*rows);
            }
        }
        let mut graph: DiGraph<(), ()> = DiGraph::new();
        let nodes: Vec<_> = self.moves.from.iter().map(|_| graph.add_node(())).collect();
        for ((from, place), _) in &legs {
            if let Some(node) = from {
                graph.add_edge(nodes[*node], nodes[self.at((*from, *place)).to], ());
            }
        }
        let mut part_of = vec![0; nodes.len()];
        let parts = kosaraju_scc(&graph);
        for (number, part) in parts.iter().enumerate() {
            part.iter().for_each(|node| part_of[node.index()] = number);
        }
        let mut is_end = vec![true; parts.len()];
        for ((from, place), _) in &legs {
            if let Some(node) = from {
                is_end[part_of[*node]] &= part_of[*node] == part_of[self.at((*from, *place)).to];
            }
        }
        // For each item, the only part that moves lead into that cover it, if there is one.
        let mut only: BTreeMap<Item, Option<usize>> = BTreeMap::new();
        for (leg, _) in &legs {
            let part = part_of[self.at(*leg).to];
            for item in self.items(*leg) {
                let known = only.entry(item).or_insert(Some(part));
                *known = known.filter(|known| *known == part);
            }
        }
        let ends: BTreeSet<usize> = only.values().flatten().copied().filter(|part| is_end[*part]).collect();
        let fewest_tests = usize::from(!nearest.is_empty()).max(ends.len());
        let of_items = match self.cover {
            // The first row of a test takes no edge.
            Cover::Edges => nearest.len() + fewest_tests,
            Cover::Situations | Cover::Transitions => nearest.len().div_ceil(most_a_row),
        };
        let fewest_rows = of_items.max(nearest.values().copied().max().unwrap_or(0)).max(fewest_tests);
        Totals { tests: trips.len(), fewest_tests, rows: trips.iter().map(Vec::len).sum(), fewest_rows }
    }
}
