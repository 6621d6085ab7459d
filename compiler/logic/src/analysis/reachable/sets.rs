//! Sets of situations of a few steps as a zero-suppressed decision diagram.
//!
//! A node asks for one step: `with` holds the situations in which it is active, without it, `without` the others. A step
//! that no node asks for is inactive. Of many steps few are active at a time, so this takes far fewer nodes than a diagram
//! that has to say so of each step. Nodes are shared between all sets.
//!
//! What is done is counted, and ends when more than was allowed would be: the same net always comes to the same end.
//! Recursion is no deeper than there are steps in a part, which is bounded.

use rustc_hash::{FxHashMap, FxHashSet};

/// A set of situations.
pub(super) type SetId = u32;

/// No situation.
pub(super) const NONE: SetId = 0;

/// Only the one in which nothing is active.
pub(super) const EMPTY: SetId = 1;

#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub(super) struct Node {
    /// The number of the step; those below ask for steps with larger numbers.
    pub(super) step: u16,
    pub(super) without: SetId,
    pub(super) with: SetId,
}

/// What a change asks of one step and makes of it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Act {
    pub(super) step: u16,
    /// Active or not before.
    pub(super) must: Option<bool>,
    /// Active or not afterwards; else as before.
    pub(super) becomes: Option<bool>,
}

pub(super) struct Sets {
    nodes: Vec<Node>,
    numbers: FxHashMap<Node, SetId>,
    unions: FxHashMap<(SetId, SetId), SetId>,
    work: usize,
    allowed: usize,
}

impl Sets {
    pub(super) fn new(allowed: usize) -> Sets {
        let end = Node { step: u16::MAX, without: NONE, with: NONE };
        let (numbers, unions) = (FxHashMap::default(), FxHashMap::default());
        Sets { nodes: vec![end, end], numbers, unions, work: 0, allowed }
    }

    /// Counts work; none if it is more than was allowed.
    pub(super) fn spend(&mut self, work: usize) -> Option<()> {
        self.work += work;
        (self.work <= self.allowed).then_some(())
    }

    fn node(&mut self, step: u16, without: SetId, with: SetId) -> SetId {
        if with == NONE {
            return without;
        }
        let node = Node { step, without, with };
        let next = self.nodes.len() as SetId;
        let number = *self.numbers.entry(node).or_insert(next);
        if number == next {
            self.nodes.push(node);
        }
        number
    }

    /// The situation in which just these steps are active, in ascending order.
    pub(super) fn one(&mut self, steps: &[u16]) -> SetId {
        steps.iter().rev().fold(EMPTY, |below, step| self.node(*step, NONE, below))
    }

    /// The situations of both; none if that takes too much work.
    pub(super) fn union(&mut self, a: SetId, b: SetId) -> Option<SetId> {
        if a == b || b == NONE {
            return Some(a);
        }
        if a == NONE {
            return Some(b);
        }
        let key = (a.min(b), a.max(b));
        if let Some(known) = self.unions.get(&key) {
            return Some(*known);
        }
        self.spend(1)?;
        let (x, y) = (self.nodes[key.0 as usize], self.nodes[key.1 as usize]);
        let union = if x.step == y.step {
            let (without, with) = (self.union(x.without, y.without)?, self.union(x.with, y.with)?);
            self.node(x.step, without, with)
        } else if x.step < y.step {
            let without = self.union(x.without, key.1)?;
            self.node(x.step, without, x.with)
        } else {
            let without = self.union(key.0, y.without)?;
            self.node(y.step, without, y.with)
        };
        self.unions.insert(key, union);
        Some(union)
    }

    /// What a change makes of the situations in which it is possible; none if that takes too much work.
    pub(super) fn changed(&mut self, set: SetId, acts: &[Act]) -> Option<SetId> {
        self.change(set, acts, &mut FxHashMap::default())
    }

    fn change(&mut self, set: SetId, acts: &[Act], known: &mut FxHashMap<(SetId, usize), SetId>) -> Option<SetId> {
        let Some((act, later)) = acts.split_first() else { return Some(set) };
        if set == NONE {
            return Some(NONE);
        }
        if let Some(changed) = known.get(&(set, acts.len())) {
            return Some(*changed);
        }
        self.spend(1)?;
        let Node { step, without, with } = self.nodes[set as usize];
        let changed = if step < act.step {
            let (without, with) = (self.change(without, acts, known)?, self.change(with, acts, known)?);
            self.node(step, without, with)
        } else {
            let (without, with) = if step == act.step { (without, with) } else { (set, NONE) };
            let inactive = if act.must == Some(true) { NONE } else { self.change(without, later, known)? };
            let active = if act.must == Some(false) { NONE } else { self.change(with, later, known)? };
            match act.becomes {
                None => self.node(act.step, inactive, active),
                Some(becomes) => {
                    let all = self.union(inactive, active)?;
                    if becomes { self.node(act.step, NONE, all) } else { all }
                }
            }
        };
        known.insert((set, acts.len()), changed);
        Some(changed)
    }

    /// Whether in one of the situations these steps are active or inactive, in ascending order; none if that takes too
    /// much work.
    pub(super) fn has(&mut self, set: SetId, wanted: &[(u16, bool)]) -> Option<bool> {
        let mut work = 0;
        let has = has(&self.nodes, set, wanted, &mut work);
        self.spend(work)?;
        Some(has)
    }

    /// A diagram of one set alone.
    pub(super) fn only(&self, set: SetId) -> Diagram {
        let mut number: FxHashMap<SetId, SetId> = FxHashMap::default();
        let mut nodes = self.nodes[..2].to_vec();
        number.extend([(NONE, NONE), (EMPTY, EMPTY)]);
        // Nodes have smaller numbers than those that refer to them.
        let mut needed: FxHashSet<SetId> = FxHashSet::default();
        let mut stack = vec![set];
        while let Some(at) = stack.pop() {
            if at > EMPTY && needed.insert(at) {
                stack.extend([self.nodes[at as usize].without, self.nodes[at as usize].with]);
            }
        }
        let mut needed: Vec<SetId> = needed.into_iter().collect();
        needed.sort_unstable();
        for at in needed {
            let Node { step, without, with } = self.nodes[at as usize];
            number.insert(at, nodes.len() as SetId);
            nodes.push(Node { step, without: number[&without], with: number[&with] });
        }
        Diagram { nodes, root: number[&set] }
    }
}

/// One set of situations.
#[derive(Clone)]
pub(super) struct Diagram {
    pub(super) nodes: Vec<Node>,
    root: SetId,
}

impl Diagram {
    /// Whether in one of the situations these steps are active or inactive, in ascending order.
    pub(super) fn has(&self, wanted: &[(u16, bool)]) -> bool {
        has(&self.nodes, self.root, wanted, &mut 0)
    }

    /// The active steps of each situation; none if there are more situations than that.
    pub(super) fn each(&self, most: usize) -> Option<Vec<Vec<u16>>> {
        let mut situations: Vec<Vec<u16>> = Vec::new();
        let mut open: Vec<(SetId, Vec<u16>)> = vec![(self.root, Vec::new())];
        while let Some((set, steps)) = open.pop() {
            match set {
                NONE => {}
                EMPTY if situations.len() == most => return None,
                EMPTY => situations.push(steps),
                _ => {
                    let node = self.nodes[set as usize];
                    open.push((node.with, steps.iter().copied().chain([node.step]).collect()));
                    open.push((node.without, steps));
                }
            }
        }
        Some(situations)
    }

    /// How many situations there are, if that is no astronomical number.
    pub(super) fn count(&self) -> Option<u64> {
        let mut counts: Vec<Option<u64>> = vec![Some(0), Some(1)];
        for node in &self.nodes[2..] {
            let both = counts[node.without as usize].zip(counts[node.with as usize]);
            counts.push(both.and_then(|(a, b)| a.checked_add(b)));
        }
        counts[self.root as usize]
    }
}

fn has(nodes: &[Node], set: SetId, wanted: &[(u16, bool)], work: &mut usize) -> bool {
    let mut seen: FxHashSet<(SetId, usize)> = FxHashSet::default();
    let mut stack = vec![(set, 0)];
    while let Some((set, mut at)) = stack.pop() {
        let Node { step, without, with } = nodes[set as usize];
        // A step that is passed over is inactive.
        while wanted.get(at).is_some_and(|(s, active)| *s < step && !active) {
            at += 1;
        }
        if set == NONE || wanted.get(at).is_some_and(|(s, _)| *s < step) || !seen.insert((set, at)) {
            continue;
        }
        *work += 1;
        match wanted.get(at) {
            // Every node holds some situation.
            None => return true,
            Some((s, active)) if *s == step => stack.push((if *active { with } else { without }, at + 1)),
            Some(_) => stack.extend([(without, at), (with, at)]),
        }
    }
    false
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    const STEPS: u16 = 6;

    fn all(sets: &mut Sets, set: SetId) -> BTreeSet<u32> {
        let situations = 0..1_u32 << STEPS;
        let holds = |sets: &mut Sets, situation: u32| {
            let wanted: Vec<(u16, bool)> = (0..STEPS).map(|s| (s, situation >> s & 1 == 1)).collect();
            sets.has(set, &wanted).expect("no limit")
        };
        situations.filter(|situation| holds(sets, *situation)).collect()
    }

    #[test]
    fn changes_and_unions_are_those_of_each_situation() {
        let mut random = fastrand::Rng::with_seed(1);
        for _ in 0..300 {
            let mut sets = Sets::new(usize::MAX);
            let mut made = (NONE, BTreeSet::new());
            for _ in 0..random.usize(0..12) {
                let situation = random.u32(0..1 << STEPS);
                let steps: Vec<u16> = (0..STEPS).filter(|s| situation >> s & 1 == 1).collect();
                let one = sets.one(&steps);
                made.0 = sets.union(made.0, one).expect("no limit");
                made.1.insert(situation);
            }
            assert_eq!(all(&mut sets, made.0), made.1);
            let choose = |random: &mut fastrand::Rng| [None, None, Some(false), Some(true)][random.usize(0..4)];
            let acts: Vec<Act> = (0..STEPS)
                .map(|step| Act { step, must: choose(&mut random), becomes: choose(&mut random) })
                .filter(|act| act.must.is_some() || act.becomes.is_some())
                .collect();
            let mut expected = BTreeSet::new();
            for situation in &made.1 {
                let is = |s: u16| situation >> s & 1 == 1;
                if acts.iter().all(|act| act.must.is_none_or(|must| must == is(act.step))) {
                    let mut after = *situation;
                    for act in &acts {
                        match act.becomes {
                            Some(true) => after |= 1 << act.step,
                            Some(false) => after &= !(1 << act.step),
                            None => {}
                        }
                    }
                    expected.insert(after);
                }
            }
            let changed = sets.changed(made.0, &acts).expect("no limit");
            assert_eq!(all(&mut sets, changed), expected, "{acts:?}");
            let wanted: Vec<(u16, bool)> = acts.iter().filter_map(|act| Some((act.step, act.must?))).collect();
            assert_eq!(sets.has(made.0, &wanted), Some(!expected.is_empty()));
            let only = sets.only(made.0);
            assert_eq!(only.has(&wanted), !expected.is_empty());
            assert_eq!(only.count(), Some(made.1.len() as u64));
            let of = |steps: Vec<u16>| steps.iter().map(|s| 1_u32 << s).sum::<u32>();
            let each: Option<BTreeSet<u32>> = only.each(made.1.len()).map(|each| each.into_iter().map(of).collect());
            assert_eq!(each, Some(made.1.clone()));
            assert!(made.1.is_empty() || only.each(made.1.len() - 1).is_none());
        }
    }

    #[test]
    fn too_much_work_is_not_done() {
        let mut sets = Sets::new(3);
        let (a, b) = (sets.one(&[0, 1, 2, 3, 4]), sets.one(&[0, 1, 2, 3, 5]));
        assert_eq!(sets.union(a, b), None);
    }
}
