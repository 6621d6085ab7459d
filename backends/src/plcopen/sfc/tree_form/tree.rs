//! The nesting of a chart: sequences, selections and simultaneous sequences, in the order in which they are written.
//!
//! Each step is placed once, where it is met first; a way to it from elsewhere is a jump. A selection closes above the
//! step that all its ways lead to, if there is one. Recursion is as deep as what is nested, which is bounded.

use grafc_logic::scan::StepId;
use grafc_logic::sequence::Sequence;
use petgraph::algo::dominators::{Dominators, simple_fast};
use petgraph::graph::{DiGraph, NodeIndex};

/// More is no drawing any more.
const DEEPEST: usize = 50;

/// An element, with what feeds it. Elements are numbered as they stand.
#[derive(Clone, Debug)]
pub(super) enum Element {
    Step { step: usize, from: Option<usize> },
    Transition { transition: usize, from: usize },
    Jump { step: usize, from: usize },
    Divergence { simultaneous: bool, from: usize },
    Convergence { simultaneous: bool, from: Vec<usize> },
}

/// Why a chart is not nested, and near which step.
pub(super) type NotNested = (StepId, &'static str);

/// How a sequence ends.
enum End {
    /// With a jump.
    Jump(usize),
    /// With what leads to the step above which the selection closes.
    Merge(usize),
    /// With a step before a transition that joins.
    Join(usize, usize),
}

pub(super) struct Tree<'s> {
    sequence: &'s Sequence,
    after: Vec<Vec<usize>>,
    merges: Dominators<NodeIndex>,
    exit: usize,
    placed: Vec<bool>,
    /// Steps above which an open selection will close.
    expected: Vec<bool>,
    elements: Vec<Element>,
}

impl<'s> Tree<'s> {
    pub fn new(sequence: &'s Sequence) -> Self {
        let count = sequence.steps.len();
        let mut after = vec![Vec::new(); count];
        for (t, transition) in sequence.transitions.iter().enumerate() {
            transition.before.iter().for_each(|step| after[step.index()].push(t));
        }
        // Against the arcs, from an end that all sequences have: what dominates a step comes after it on every way.
        let kept = super::super::graph::kept(sequence);
        let mut back: DiGraph<(), ()> = DiGraph::with_capacity(count + 1, count);
        for _ in 0..=count {
            back.add_node(());
        }
        let mut ends = vec![true; count];
        for (t, transition) in sequence.transitions.iter().enumerate() {
            for (to, _) in transition.after.iter().zip(&kept[t]).filter(|(_, kept)| **kept) {
                for step in &transition.before {
                    ends[step.index()] = false;
                    back.add_edge(NodeIndex::new(to.index()), NodeIndex::new(step.index()), ());
                }
            }
        }
        for (step, _) in ends.iter().enumerate().filter(|(_, ends)| **ends) {
            back.add_edge(NodeIndex::new(count), NodeIndex::new(step), ());
        }
        let merges = simple_fast(&back, NodeIndex::new(count));
        let (placed, expected) = (vec![false; count], vec![false; count]);
        Tree { sequence, after, merges, exit: count, placed, expected, elements: Vec::new() }
    }

    /// The elements of the whole chart.
    pub fn build(mut self) -> Result<Vec<Element>, NotNested> {
        let mut initial = self.sequence.steps.iter_enumerated().filter(|(_, step)| step.initial).map(|(id, _)| id);
        let first = initial.next().ok_or((StepId::from_usize(0), "no step is initial"))?;
        if let Some(second) = initial.next() {
            return Err((second, "a second initial step"));
        }
        match self.sequence(first.index(), None, None, 0)? {
            End::Jump(_) => {}
            End::Merge(_) | End::Join(..) => return Err((first, "what follows does not lead back to a step")),
        }
        match self.placed.iter().position(|placed| !placed) {
            Some(step) => Err((StepId::from_usize(step), "nothing leads to this step")),
            None => Ok(self.elements),
        }
    }

    fn add(&mut self, element: Element) -> usize {
        self.elements.push(element);
        self.elements.len() - 1
    }

    /// From a step on, to the jump, the join or the merge that ends it.
    fn sequence(
        &mut self,
        first: usize,
        from: Option<usize>,
        stop: Option<usize>,
        depth: usize,
    ) -> Result<End, NotNested> {
        let (mut step, mut from) = (first, from);
        if depth > DEEPEST {
            return Err((StepId::from_usize(step), "nested too deeply for a drawing"));
        }
        loop {
            if let Some(feeder) = from {
                if stop == Some(step) {
                    return Ok(End::Merge(feeder));
                }
                if self.placed[step] || self.expected[step] {
                    return Ok(End::Jump(self.add(Element::Jump { step, from: feeder })));
                }
            }
            self.placed[step] = true;
            let own = self.add(Element::Step { step, from });
            let after = std::mem::take(&mut self.after[step]);
            (step, from) = match after[..] {
                [] => return Err((StepId::from_usize(step), "no transition follows")),
                [join] if self.sequence.transitions[join].before.len() > 1 => return Ok(End::Join(own, join)),
                [only] => self.transition(only, own, depth)?,
                _ => match self.selection(step, own, &after, depth)? {
                    (Some(merge), from) => (merge, Some(from)),
                    (None, jump) => return Ok(End::Jump(jump)),
                },
            };
        }
    }

    /// A transition, simultaneous sequences after it and the transition that joins them; the step that follows.
    fn transition(&mut self, first: usize, from: usize, depth: usize) -> Result<(usize, Option<usize>), NotNested> {
        let (mut transition, mut from) = (first, from);
        loop {
            let own = self.add(Element::Transition { transition, from });
            let after = &self.sequence.transitions[transition].after;
            if let [step] = after[..] {
                return Ok((step.index(), Some(own)));
            }
            let divergence = self.add(Element::Divergence { simultaneous: true, from: own });
            let mut ends = Vec::new();
            let mut joined = None;
            for step in after {
                match self.sequence(step.index(), Some(divergence), None, depth + 1)? {
                    End::Join(end, join) if joined.is_none_or(|known| known == join) => {
                        joined = Some(join);
                        ends.push(end);
                    }
                    End::Join(..) | End::Jump(_) | End::Merge(_) => {
                        return Err((*step, "the sequences that begin here together do not end in one transition"));
                    }
                }
            }
            let step = after.first().copied().unwrap_or(StepId::from_usize(0));
            transition = joined
                .filter(|join| self.sequence.transitions[*join].before.len() == ends.len())
                .ok_or((step, "the transition that joins this sequence joins others, too"))?;
            from = self.add(Element::Convergence { simultaneous: true, from: ends });
        }
    }

    /// All transitions after a step; the step that they lead to in the end with what leads there, or a jump.
    fn selection(
        &mut self,
        step: usize,
        own: usize,
        after: &[usize],
        depth: usize,
    ) -> Result<(Option<usize>, usize), NotNested> {
        let merge = self.merges.immediate_dominator(NodeIndex::new(step)).map(NodeIndex::index);
        let merge = merge.filter(|merge| *merge != self.exit && !self.placed[*merge] && !self.expected[*merge]);
        merge.iter().for_each(|merge| self.expected[*merge] = true);
        let divergence = self.add(Element::Divergence { simultaneous: false, from: own });
        let mut ends = Vec::new();
        let mut merged = false;
        for transition in after {
            let (next, from) = self.transition(*transition, divergence, depth + 1)?;
            match self.sequence(next, from, merge, depth + 1)? {
                End::Jump(end) => ends.push(end),
                End::Merge(end) => {
                    merged = true;
                    ends.push(end);
                }
                End::Join(..) => {
                    return Err((StepId::from_usize(step), "one way from here ends in a join, others do not"));
                }
            }
        }
        merge.iter().for_each(|merge| self.expected[*merge] = false);
        if merged {
            return Ok((merge, self.add(Element::Convergence { simultaneous: false, from: ends })));
        }
        // All ways jump. The jump of the last, which was written last, goes below the convergence.
        let Some(Element::Jump { step: target, from }) = self.elements.pop() else {
            return Err((StepId::from_usize(step), "the last way from here does not end in a jump"));
        };
        ends.pop();
        ends.push(from);
        let convergence = self.add(Element::Convergence { simultaneous: false, from: ends });
        Ok((None, self.add(Element::Jump { step: target, from: convergence })))
    }
}
