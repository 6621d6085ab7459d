//! The circuit with truth values: 64 cases at once, each at its own clock.

use super::frames::{Source, sources};
use crate::circuit::{Literal, Node, Watched, of};

/// A circuit that is run.
pub(super) struct Run<'c> {
    watched: &'c Watched,
    sources: Vec<Option<Source>>,
    /// What the latches hold, a bit a case.
    pub(super) latches: Vec<u64>,
    nodes: Vec<u64>,
}

impl<'c> Run<'c> {
    pub(super) fn new(watched: &'c Watched) -> Self {
        let mut run = Run { watched, sources: sources(watched), latches: Vec::new(), nodes: Vec::new() };
        run.latches = run.initial();
        run
    }

    /// What latches hold at first.
    pub(super) fn initial(&self) -> Vec<u64> {
        self.watched.circuit.latches.iter().map(|latch| if latch.initial { u64::MAX } else { 0 }).collect()
    }

    /// What holds at a clock with these inputs; the latches stay.
    pub(super) fn look(&mut self, inputs: &[u64]) {
        self.nodes.clear();
        for (node, source) in self.watched.circuit.graph.nodes().iter().zip(&self.sources) {
            let word = match (node, source) {
                (Node::And(a, b), _) => of(&self.nodes, *a) & of(&self.nodes, *b),
                (Node::Given, Some(Source::Input(place))) => inputs.get(*place).copied().unwrap_or_default(),
                (Node::Given, Some(Source::Latch(place))) => self.latches[*place],
                (Node::False, _) | (Node::Given, None) => 0,
            };
            self.nodes.push(word);
        }
    }

    /// In which cases a literal holds at the clock that was looked at.
    pub(super) fn of(&self, literal: Literal) -> u64 {
        of(&self.nodes, literal)
    }

    /// The clock is over, in some cases.
    pub(super) fn advance(&mut self, cases: u64) {
        for (held, latch) in self.latches.iter_mut().zip(&self.watched.circuit.latches) {
            *held = *held & !cases | of(&self.nodes, latch.next) & cases;
        }
    }

    /// How large it is.
    pub(super) fn size(&self) -> u64 {
        self.sources.len() as u64
    }
}

#[cfg(test)]
mod tests {
    use super::super::by_hand::counter;
    use super::*;

    #[test]
    fn each_case_counts_by_itself() {
        let watched = counter();
        let mut run = Run::new(&watched);
        // The second case counts every clock, the third one every other; the fourth keeps still at the last.
        for (inputs, cases) in [(0b0110, u64::MAX), (0b0010, u64::MAX), (0b1110, 0b0111)] {
            run.look(&[inputs]);
            assert_eq!(run.of(watched.facts[0].1) & 0b1111, 0);
            run.advance(cases);
        }
        assert_eq!((run.latches[0] & 0b1111, run.latches[1] & 0b1111), (0b0010, 0b0110));
        run.look(&[0]);
        assert_eq!(run.of(watched.facts[0].1) & 0b1111, 0b0010);
    }
}
