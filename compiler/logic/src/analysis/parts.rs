//! The strongly connected components of a graph, here called parts: the nodes that lead to each other in circles, and each
//! other node as a part of its own. By the algorithm of Tarjan, with a stack of its own.

/// Not yet met.
const UNSEEN: u32 = u32::MAX;
/// In a part that is complete, or left out.
const DONE: u32 = u32::MAX - 1;

/// The parts of the graph that can be reached.
pub(super) struct Parts {
    /// The nodes, part by part, a part behind those that it leads to.
    nodes: Vec<u32>,
    /// Which of them is the last one of its part.
    last: Vec<bool>,
}

/// A node whose successors are being followed. There may be as many as nodes.
struct Followed {
    node: u32,
    /// The place of the next one.
    next: u32,
    /// When it was met.
    number: u32,
}

impl Parts {
    /// Those that can be reached from some nodes, by way of nodes alone that are `wanted`; `successor` gives those of a node,
    /// place by place.
    pub(super) fn of(
        count: usize,
        from: impl IntoIterator<Item = u32>,
        successor: impl Fn(u32, usize) -> Option<u32>,
        wanted: impl Fn(u32) -> bool,
    ) -> Parts {
        let mut last = Vec::with_capacity(count);
        // The parts that are complete from the front, and what is in none yet from the back: a node is in one of them at most.
        let mut nodes = vec![0; count];
        let (mut complete, mut open) = (0, count);
        // The number of each node, or a lower one of what can be reached from it and is in no complete part.
        let mut low = vec![UNSEEN; count];
        // The way from the start to where we are.
        let mut way: Vec<Followed> = Vec::new();
        let mut met = 0;
        let mut meet = |node: u32, low: &mut [u32], nodes: &mut [u32], open: &mut usize| {
            let number = met;
            met += 1;
            low[node as usize] = number;
            *open -= 1;
            nodes[*open] = node;
            Followed { node, next: 0, number }
        };
        for start in from {
            if low[start as usize] != UNSEEN || !wanted(start) {
                continue;
            }
            way.push(meet(start, &mut low, &mut nodes, &mut open));
            while let Some(Followed { node, next: place, number }) = way.last_mut() {
                let at = *node as usize;
                if let Some(next) = successor(*node, *place as usize) {
                    *place += 1;
                    let known = low[next as usize];
                    if known != UNSEEN {
                        low[at] = low[at].min(known);
                    } else if wanted(next) {
                        // What leads nowhere, as much does, is a part at once.
                        if successor(next, 0).is_none() {
                            low[next as usize] = DONE;
                            nodes[complete] = next;
                            complete += 1;
                            last.push(true);
                        } else {
                            way.push(meet(next, &mut low, &mut nodes, &mut open));
                        }
                    } else {
                        low[next as usize] = DONE;
                    }
                    continue;
                }
                if low[at] == *number {
                    while low[at] != DONE {
                        let member = nodes[open];
                        open += 1;
                        low[member as usize] = DONE;
                        nodes[complete] = member;
                        complete += 1;
                        last.push(low[at] == DONE);
                    }
                }
                way.pop();
                if let Some(before) = way.last() {
                    let before = before.node as usize;
                    low[before] = low[before].min(low[at]);
                }
            }
        }
        nodes.truncate(complete);
        Parts { nodes, last }
    }

    /// The parts, each before those that it leads to.
    pub(super) fn in_order(&self) -> impl Iterator<Item = &[u32]> {
        let mut end = self.nodes.len();
        std::iter::from_fn(move || {
            let before = end.checked_sub(1)?;
            let begin = self.last[..before].iter().rposition(|last| *last).map_or(0, |place| place + 1);
            Some(&self.nodes[begin..std::mem::replace(&mut end, begin)])
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn circles_are_parts_and_what_leads_to_others_comes_first() {
        // And 5, which is not wanted, between 3 and 6.
        let edges = [(0, 1), (1, 2), (2, 1), (2, 3), (3, 3), (3, 5), (5, 6), (4, 0)];
        let successor = |node, place| edges.iter().filter(|(from, _)| *from == node).map(|(_, to)| *to).nth(place);
        let parts = Parts::of(7, [1, 0, 5], successor, |node| node != 5);
        let parts: Vec<Vec<u32>> = parts
            .in_order()
            .map(|part| {
                let mut part = part.to_vec();
                part.sort_unstable();
                part
            })
            .collect();
        assert_eq!(parts, [vec![0], vec![1, 2], vec![3]]);
    }

    #[test]
    fn a_long_way_needs_no_deep_stack() {
        let parts = Parts::of(200_001, [0], |node, place| (node + 1..=200_000).take(1).nth(place), |_| true);
        assert_eq!(parts.in_order().count(), 200_001);
    }
}
