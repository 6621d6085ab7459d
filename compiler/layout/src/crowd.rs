//! Which links go straight down, which take a lane, and for which there is no room.

use crate::graph::{Graph, Kind};
use rustc_hash::FxHashMap;

/// How a link is drawn.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Way {
    /// Down, mostly straight.
    Down,
    /// By a lane that leads up or down to all rows between.
    Lane {
        /// Whether it leads up.
        up: bool,
    },
    /// A label stands for it.
    Label,
}

/// A branch that is shorter by so many rows than the others does not keep its column down to where they meet.
const LONGEST: i32 = 40;
/// More lanes side by side than this no eye can follow.
const MOST: i32 = 12;

/// The way of each link. Lanes to one box in one direction are one; the shortest get their place first.
pub(crate) fn ways(graph: &Graph, rows: &[i32], up: &[bool]) -> Vec<Way> {
    let mut ways: Vec<Way> = Vec::with_capacity(graph.links.len());
    let mut nets: Vec<Net> = Vec::new();
    let mut net_of: FxHashMap<(usize, bool), usize> = FxHashMap::default();
    for (link, &(from, to)) in graph.links.iter().enumerate() {
        let up_to_it = up[link] && rows[from] >= rows[to];
        let is_long = graph.nodes[to].kind == Kind::Step && rows[to] - rows[from] > LONGEST;
        if !up[link] && !is_long {
            ways.push(Way::Down);
            continue;
        }
        ways.push(Way::Lane { up: up_to_it });
        let net = *net_of.entry((to, up_to_it)).or_insert_with(|| {
            nets.push(Net { first: rows[to], last: rows[to], links: Vec::new() });
            nets.len() - 1
        });
        nets[net].first = nets[net].first.min(rows[from]);
        nets[net].last = nets[net].last.max(rows[from]);
        nets[net].links.push(link);
    }
    // A stable sort: of equal ones the first in the text is first.
    nets.sort_by_key(|net| net.last - net.first);
    let least = rows.iter().copied().min().unwrap_or(0);
    let most = rows.iter().copied().max().unwrap_or(0);
    let mut depth = Depth::new((most - least + 1) as usize);
    for net in nets {
        let (first, last) = ((net.first - least) as usize, (net.last - least) as usize);
        if depth.max(first, last) < MOST {
            depth.add(first, last);
        } else {
            net.links.iter().for_each(|link| ways[*link] = Way::Label);
        }
    }
    ways
}

struct Net {
    first: i32,
    last: i32,
    links: Vec<usize>,
}

/// How many lanes pass each row: a tree of intervals, with what covers a whole interval kept at it.
struct Depth {
    size: usize,
    /// What covers the whole interval.
    own: Vec<i32>,
    /// The most within it, with that.
    most: Vec<i32>,
}

impl Depth {
    fn new(rows: usize) -> Depth {
        let size = rows.next_power_of_two();
        Depth { size, own: vec![0; 2 * size], most: vec![0; 2 * size] }
    }

    fn add(&mut self, first: usize, last: usize) {
        let (mut low, mut high) = (first + self.size, last + self.size + 1);
        let (start, end) = (low, high - 1);
        while low < high {
            if low & 1 == 1 {
                self.own[low] += 1;
                self.most[low] += 1;
                low += 1;
            }
            if high & 1 == 1 {
                high -= 1;
                self.own[high] += 1;
                self.most[high] += 1;
            }
            low /= 2;
            high /= 2;
        }
        for mut at in [start / 2, end / 2] {
            while at > 0 {
                self.most[at] = self.own[at] + self.most[2 * at].max(self.most[2 * at + 1]);
                at /= 2;
            }
        }
    }

    fn max(&self, first: usize, last: usize) -> i32 {
        let above = |mut at: usize| {
            let mut sum = 0;
            while at > 1 {
                at /= 2;
                sum += self.own[at];
            }
            sum
        };
        let (mut low, mut high) = (first + self.size, last + self.size + 1);
        let mut found = 0;
        while low < high {
            if low & 1 == 1 {
                found = found.max(self.most[low] + above(low));
                low += 1;
            }
            if high & 1 == 1 {
                high -= 1;
                found = found.max(self.most[high] + above(high));
            }
            low /= 2;
            high /= 2;
        }
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn depth_is_that_of_a_plain_count() {
        let mut random = fastrand::Rng::with_seed(7);
        let (mut depth, mut plain) = (Depth::new(37), vec![0; 37]);
        for _ in 0..300 {
            let a = random.usize(0..37);
            let b = random.usize(a..37);
            assert_eq!(depth.max(a, b), plain[a..=b].iter().copied().max().unwrap_or(0));
            depth.add(a, b);
            plain[a..=b].iter_mut().for_each(|count| *count += 1);
        }
    }
}
