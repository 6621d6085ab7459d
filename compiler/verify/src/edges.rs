//! What leads from state to state, in little room, and what can be reached along it.

use indexmap::IndexMap;
use rustc_hash::FxBuildHasher;

/// Edges, kept in order of the states that they leave.
#[derive(Default)]
pub(crate) struct Edges {
    /// For each state that was left, where its edges begin.
    starts: Vec<usize>,
    to: Vec<u32>,
    /// Whether an edge can be taken whatever delays have run before.
    sure: Vec<bool>,
    /// Those of the state at hand.
    open: IndexMap<u32, bool, FxBuildHasher>,
}

impl Edges {
    /// An edge from the state at hand.
    pub(crate) fn push(&mut self, to: usize, sure: bool) {
        *self.open.entry(to as u32).or_default() |= sure;
    }

    /// The state at hand, which is the next one, has no more.
    pub(crate) fn close(&mut self) {
        self.starts.push(self.to.len());
        for (to, sure) in self.open.drain(..) {
            self.to.push(to);
            self.sure.push(sure);
        }
    }

    /// The states that one leads to, in order of meeting.
    pub(crate) fn from(&self, state: usize) -> impl Iterator<Item = usize> + '_ {
        let start = self.starts.get(state).copied().unwrap_or(self.to.len());
        let end = self.starts.get(state + 1).copied().unwrap_or(self.to.len());
        self.to[start..end].iter().map(|to| *to as usize)
    }

    /// All edges, or those that can be taken whatever delays have run before.
    pub(crate) fn all(&self, sure_only: bool) -> impl Iterator<Item = (usize, usize)> + '_ {
        let ends = self.starts.iter().skip(1).copied().chain([self.to.len()]);
        let ranges = self.starts.iter().copied().zip(ends).enumerate();
        ranges.flat_map(move |(from, (start, end))| {
            let kept = (start..end).filter(move |edge| !sure_only || self.sure[*edge]);
            kept.map(move |edge| (from, self.to[edge] as usize))
        })
    }
}

/// The states from which one of the seeds can be reached along edges, the seeds among them.
pub(crate) fn reach_back<I: Iterator<Item = (usize, usize)>>(seeds: Vec<bool>, edges: impl Fn() -> I) -> Vec<bool> {
    // What leads to each state, one after the other.
    let mut begins = vec![0_usize; seeds.len() + 1];
    for (_, to) in edges() {
        begins[to + 1] += 1;
    }
    for state in 0..seeds.len() {
        begins[state + 1] += begins[state];
    }
    let mut before = vec![0_u32; begins[seeds.len()]];
    let mut next = begins.clone();
    for (from, to) in edges() {
        before[next[to]] = from as u32;
        next[to] += 1;
    }
    let mut open: Vec<usize> = (0..seeds.len()).filter(|state| seeds[*state]).collect();
    let mut reaches = seeds;
    while let Some(state) = open.pop() {
        for from in &before[begins[state]..begins[state + 1]] {
            let from = *from as usize;
            if !std::mem::replace(&mut reaches[from], true) {
                open.push(from);
            }
        }
    }
    reaches
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_leads_to_a_seed_reaches_it() {
        let edges = [(0, 1), (1, 2), (3, 3), (4, 1)];
        let reaches = reach_back(vec![false, false, true, false, false], || edges.into_iter());
        assert_eq!(reaches, [true, true, true, false, true]);
    }

    #[test]
    fn an_edge_is_sure_if_one_way_along_it_is() {
        let mut edges = Edges::default();
        edges.push(1, false);
        edges.push(1, true);
        edges.push(2, false);
        edges.close();
        edges.close();
        edges.push(0, true);
        edges.close();
        assert_eq!(edges.all(false).collect::<Vec<_>>(), [(0, 1), (0, 2), (2, 0)]);
        assert_eq!(edges.all(true).collect::<Vec<_>>(), [(0, 1), (2, 0)]);
    }
}
