//! Steps, transitions and jumps, and the arcs between them, all of which lead down.
//!
//! An arc that closes a circle, as a search from the initial steps meets it, becomes a jump; so does one into a step
//! that other arcs lead to, if it comes from a fork, since only transitions can be joined there; and one that is too long
//! to be followed.

use crate::sequence::texts::Texts;
use grafc_logic::scan::StepId;
use grafc_logic::sequence::Sequence;
use rustc_hash::FxHashSet;
use std::collections::VecDeque;

/// What is drawn.
pub(super) struct Graph {
    pub nodes: Vec<Vertex>,
    /// From what leads to what it leads to.
    pub arcs: Vec<(usize, usize)>,
    /// For each node, the arcs that come from it and those that lead to it.
    pub leaving: Vec<Vec<usize>>,
    pub entering: Vec<Vec<usize>>,
}

/// A box.
pub(super) struct Vertex {
    pub kind: VertexKind,
    /// What it takes to the left and to the right of its axis, and downwards: itself, and with its actions.
    pub left: i64,
    pub right: i64,
    pub body: i64,
    pub height: i64,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum VertexKind {
    /// A step, by its place, with whether it is initial.
    Step { step: usize, initial: bool },
    /// A transition, by its place.
    Transition(usize),
    /// A jump to a step.
    Jump(usize),
}

/// A way past more steps and transitions than this is a jump: no eye follows it.
const LONGEST: usize = 40;

/// The width of a letter.
const LETTER: i64 = 7;

/// The width of a text.
pub(super) fn text_width(text: &str) -> i64 {
    LETTER * i64::try_from(text.chars().count()).unwrap_or(i64::MAX / 100)
}

/// The width of a step.
pub(super) fn step_width(name: &str) -> i64 {
    (text_width(name) + 20).max(60) / 2 * 2
}

/// The width of a step's action block.
pub(super) fn block_width(texts: &Texts, step: usize) -> i64 {
    texts.actions[step].iter().map(|action| text_width(action.content.text()) + 50).max().unwrap_or(0).max(100)
}

/// The width of the comment on a step, if there is one; a long one is wrapped by the tool.
pub(super) fn comment_width(texts: &Texts, step: usize) -> Option<i64> {
    let text = &texts.comments[step];
    (!text.is_empty()).then(|| (text_width(text) + 20).min(WIDEST_COMMENT))
}

/// No comment is wider.
const WIDEST_COMMENT: i64 = 240;

/// The gap between a step and its actions.
pub(super) const TO_ACTIONS: i64 = 20;
/// The height of a row of an action block, and of a step.
pub(super) const ROW: i64 = 30;

/// The height of a transition, and of a jump.
pub(super) const BAR: i64 = 2;
pub(super) const JUMP: i64 = 13;

impl Graph {
    /// Finds what is drawn.
    pub fn new(sequence: &Sequence, texts: &Texts) -> Graph {
        let mut nodes: Vec<Vertex> = Vec::new();
        for (place, step) in sequence.steps.iter().enumerate() {
            let kind = VertexKind::Step { step: place, initial: step.initial };
            let half = step_width(&texts.steps[place]) / 2;
            let rows = i64::try_from(texts.actions[place].len()).unwrap_or(i64::MAX / 100);
            let actions = if rows > 0 { TO_ACTIONS + block_width(texts, place) } else { 0 };
            let comment = comment_width(texts, place).map_or(0, |width| TO_ACTIONS + width);
            let right = half + actions + comment;
            nodes.push(Vertex { kind, left: half, right, body: ROW, height: ROW * rows.max(1) });
        }
        let first_transition = nodes.len();
        for (place, condition) in texts.conditions.iter().enumerate() {
            let right = 15 + text_width(condition);
            nodes.push(Vertex { kind: VertexKind::Transition(place), left: 10, right, body: BAR, height: BAR });
        }
        let mut arcs: Vec<(usize, usize)> = Vec::new();
        let kept = kept(sequence);
        for (place, transition) in sequence.transitions.iter().enumerate() {
            let own = first_transition + place;
            arcs.extend(transition.before.iter().map(|step| (step.index(), own)));
            let drawn = transition.after.iter().zip(&kept[place]).filter(|(_, kept)| **kept);
            arcs.extend(drawn.map(|(step, _)| (own, step.index())));
        }
        let depth = depths(nodes.len(), &arcs);
        arcs.retain(|(from, to)| *from < first_transition || depth[*to] - depth[*from] <= LONGEST);
        let drawn: FxHashSet<(usize, usize)> = arcs.iter().copied().collect();
        for (place, transition) in sequence.transitions.iter().enumerate() {
            let own = first_transition + place;
            for step in transition.after.iter().filter(|step| !drawn.contains(&(own, step.index()))) {
                arcs.push((own, nodes.len()));
                let right = 11 + text_width(&texts.steps[step.index()]);
                nodes.push(Vertex { kind: VertexKind::Jump(step.index()), left: 6, right, body: JUMP, height: JUMP });
            }
        }
        let (mut leaving, mut entering) = (vec![Vec::new(); nodes.len()], vec![Vec::new(); nodes.len()]);
        for (arc, (from, to)) in arcs.iter().enumerate() {
            leaving[*from].push(arc);
            entering[*to].push(arc);
        }
        Graph { nodes, arcs, leaving, entering }
    }

    /// Whether what leads from a box to several sides is a bar below it. Below a step that a synchronisation leaves among
    /// others there is none: the wires come from the step itself, since no bar of a selection may lead to a bar of a
    /// synchronisation.
    pub fn has_bar_below(&self, node: usize) -> bool {
        let leaving = &self.leaving[node];
        let joins = |arc: &usize| self.entering[self.arcs[*arc].1].len() > 1;
        leaving.len() > 1 && !(matches!(self.nodes[node].kind, VertexKind::Step { .. }) && leaving.iter().any(joins))
    }

    /// For each node the part of the chart that it belongs to: parts that no arc joins have different numbers, which ascend
    /// in the order of their first steps.
    pub fn parts(&self) -> Vec<usize> {
        let mut near: Vec<Vec<usize>> = vec![Vec::new(); self.nodes.len()];
        for (upper, lower) in &self.arcs {
            near[*upper].push(*lower);
            near[*lower].push(*upper);
        }
        let mut part = vec![usize::MAX; self.nodes.len()];
        for root in 0..self.nodes.len() {
            if part[root] != usize::MAX {
                continue;
            }
            let mut open = vec![root];
            while let Some(node) = open.pop() {
                if part[node] == usize::MAX {
                    part[node] = root;
                    open.extend(&near[node]);
                }
            }
        }
        part
    }
}

/// For each transition and each step after it, whether an arc is drawn, and not a jump.
pub(super) fn kept(sequence: &Sequence) -> Vec<Vec<bool>> {
    let mut after: Vec<Vec<(usize, usize, StepId)>> = vec![Vec::new(); sequence.steps.len()];
    for (t, transition) in sequence.transitions.iter().enumerate() {
        for step in &transition.before {
            after[step.index()].extend(transition.after.iter().enumerate().map(|(place, to)| (t, place, *to)));
        }
    }
    let mut kept: Vec<Vec<bool>> = sequence.transitions.iter().map(|t| vec![true; t.after.len()]).collect();

    // An arc to a step that is still being searched closes a circle.
    #[derive(Clone, Copy, PartialEq)]
    enum State {
        New,
        Open,
        Done,
    }
    let mut states = vec![State::New; sequence.steps.len()];
    let initial = sequence.steps.iter_enumerated().filter(|(_, step)| step.initial);
    let roots: Vec<usize> = initial.map(|(id, _)| id.index()).chain(0..sequence.steps.len()).collect();
    for root in roots {
        if states[root] != State::New {
            continue;
        }
        states[root] = State::Open;
        let mut open = vec![(root, 0)];
        while let Some((step, next)) = open.last_mut() {
            let Some(&(t, place, to)) = after[*step].get(*next) else {
                states[*step] = State::Done;
                open.pop();
                continue;
            };
            *next += 1;
            match states[to.index()] {
                State::New => {
                    states[to.index()] = State::Open;
                    open.push((to.index(), 0));
                }
                State::Open => kept[t][place] = false,
                State::Done => {}
            }
        }
    }

    // Only transitions can be joined above a step; a fork leads to it alone.
    let mut entering: Vec<Vec<(usize, usize)>> = vec![Vec::new(); sequence.steps.len()];
    for (t, transition) in sequence.transitions.iter().enumerate() {
        for (place, to) in transition.after.iter().enumerate().filter(|(place, _)| kept[t][*place]) {
            entering[to.index()].push((t, place));
        }
    }
    for entering in entering {
        let is_fork = |t: usize| sequence.transitions[t].after.len() > 1;
        let joined = entering.iter().any(|(t, _)| !is_fork(*t));
        for (t, place) in entering.iter().filter(|(t, _)| is_fork(*t)).skip(usize::from(!joined)) {
            kept[*t][*place] = false;
        }
    }
    kept
}

/// For each node how many stand above it on the longest way to it.
fn depths(count: usize, arcs: &[(usize, usize)]) -> Vec<usize> {
    let mut depth = vec![0; count];
    let mut below: Vec<Vec<usize>> = vec![Vec::new(); count];
    let mut waiting = vec![0_usize; count];
    for (from, to) in arcs {
        below[*from].push(*to);
        waiting[*to] += 1;
    }
    let mut ready: VecDeque<usize> = (0..count).filter(|node| waiting[*node] == 0).collect();
    while let Some(node) = ready.pop_front() {
        for &to in &below[node] {
            depth[to] = depth[to].max(depth[node] + 1);
            waiting[to] -= 1;
            if waiting[to] == 0 {
                ready.push_back(to);
            }
        }
    }
    depth
}
