//! Changes that can cause each other in a circle, as parts of the graph of causes: its strongly connected components, by
//! the algorithm of Tarjan with a stack of its own.

use super::causes::Effects;

/// Not yet met.
const UNSEEN: u32 = u32::MAX;
/// In a part that is complete, or impossible.
const DONE: u32 = u32::MAX - 1;

/// The parts of the graph that can be reached.
pub(super) struct Parts {
    /// The changes, part by part, effects before causes.
    changes: Vec<u32>,
    /// Where each part ends.
    ends: Vec<usize>,
}

/// A change whose effects are being followed.
struct Followed {
    change: u32,
    /// How many of them have been.
    effects: usize,
    /// When it was met.
    number: u32,
}

impl Parts {
    /// Those that can be reached from some changes, by way of possible ones alone.
    pub(super) fn of(count: usize, effects: &Effects, from: &[u32], possible: impl Fn(u32) -> bool) -> Parts {
        let mut parts = Parts { changes: Vec::new(), ends: Vec::new() };
        // The number of each change, or a lower one of what can be reached from it and is in no complete part.
        let mut low = vec![UNSEEN; count];
        // What is in no complete part yet, and the way from the start to where we are.
        let mut open: Vec<u32> = Vec::new();
        let mut way: Vec<Followed> = Vec::new();
        let mut met = 0;
        let mut meet = |change: u32, low: &mut [u32], open: &mut Vec<u32>| {
            let number = met;
            met += 1;
            low[change as usize] = number;
            open.push(change);
            Followed { change, effects: 0, number }
        };
        for start in from {
            if low[*start as usize] != UNSEEN || !possible(*start) {
                continue;
            }
            way.push(meet(*start, &mut low, &mut open));
            while let Some(Followed { change, effects: followed, number }) = way.last_mut() {
                let at = *change as usize;
                if let Some(effect) = effects.of(*change).get(*followed) {
                    *followed += 1;
                    let known = low[effect.change as usize];
                    if known != UNSEEN {
                        low[at] = low[at].min(known);
                    } else if possible(effect.change) {
                        way.push(meet(effect.change, &mut low, &mut open));
                    } else {
                        low[effect.change as usize] = DONE;
                    }
                    continue;
                }
                if low[at] == *number {
                    while let Some(member) = open.pop() {
                        low[member as usize] = DONE;
                        parts.changes.push(member);
                        if member == *change {
                            break;
                        }
                    }
                    parts.ends.push(parts.changes.len());
                }
                way.pop();
                if let Some(before) = way.last() {
                    let before = before.change as usize;
                    low[before] = low[before].min(low[at]);
                }
            }
        }
        parts
    }

    /// The parts, causes before effects.
    pub(super) fn in_order(&self) -> impl Iterator<Item = &[u32]> {
        (0..self.ends.len()).rev().map(|part| {
            let begin = part.checked_sub(1).map_or(0, |before| self.ends[before]);
            &self.changes[begin..self.ends[part]]
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn circles_are_parts_and_causes_come_first() {
        // 0 -> 1 -> 2 -> 1, 2 -> 3, 3 -> 3, 4 -> 0, and 5, which is impossible, between 3 and 6.
        let effects = Effects::by_hand(7, &[(0, 1), (1, 2), (2, 1), (2, 3), (3, 3), (3, 5), (5, 6), (4, 0)]);
        let parts = Parts::of(7, &effects, &[1, 0, 5], |change| change != 5);
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
        let edges: Vec<(u32, u32)> = (0..200_000).map(|change| (change, change + 1)).collect();
        let parts = Parts::of(200_001, &Effects::by_hand(200_001, &edges), &[0], |_| true);
        assert_eq!(parts.in_order().count(), 200_001);
    }
}
