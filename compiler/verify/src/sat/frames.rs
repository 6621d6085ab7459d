//! Clocks of a circuit one after the other, as clauses: a conjunction becomes a variable with three of them, where it is
//! first asked for.

use crate::budget::{Asked, Budget};
use crate::circuit::{Literal, Node, Watched};
use batsat::{Lit, Solver, SolverInterface, SolverOpts, lbool};

/// What is given to a circuit.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Source {
    /// The input of this place.
    Input(usize),
    /// The latch of this place.
    Latch(usize),
}

/// What is given, by its node.
pub(super) fn sources(watched: &Watched) -> Vec<Option<Source>> {
    let mut sources = vec![None; watched.circuit.graph.nodes().len()];
    for (place, input) in watched.circuit.inputs.iter().enumerate() {
        sources[input.literal.node()] = Some(Source::Input(place));
    }
    for (place, latch) in watched.circuit.latches.iter().enumerate() {
        sources[latch.now.node()] = Some(Source::Latch(place));
    }
    sources
}

/// Where the first clock is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Begin {
    /// At the start.
    AtStart,
    /// Anywhere.
    Anywhere,
}

/// Clocks, and a solver that knows them.
pub(super) struct Frames<'c, 'b, 's> {
    watched: &'c Watched,
    solver: Solver<Asked<'b, 's>>,
    sources: Vec<Option<Source>>,
    begin: Begin,
    yes: Lit,
    /// By clock and node.
    known: Vec<Vec<Option<Lit>>>,
    /// What holds at every clock.
    always: Vec<Literal>,
    budget: &'b Budget<'s>,
}

impl<'c, 'b, 's> Frames<'c, 'b, 's> {
    /// Clocks whose inputs are as the assumptions allow.
    pub(super) fn new(watched: &'c Watched, begin: Begin, budget: &'b Budget<'s>) -> Self {
        Frames::with(watched, begin, vec![watched.circuit.assumed], budget)
    }

    /// Clocks at which all of this holds.
    pub(super) fn with(watched: &'c Watched, begin: Begin, always: Vec<Literal>, budget: &'b Budget<'s>) -> Self {
        let mut solver = Solver::new(SolverOpts::default(), budget.asked());
        let yes = Lit::new(solver.new_var_default(), true);
        solver.add_clause_reuse(&mut vec![yes]);
        Frames { watched, solver, sources: sources(watched), begin, yes, known: Vec::new(), always, budget }
    }

    /// From here on it is known to hold at every clock.
    pub(super) fn always(&mut self, literal: Literal) {
        self.always.push(literal);
        for frame in 0..self.known.len() {
            let holds = self.literal(frame, literal);
            self.clause(vec![holds]);
        }
    }

    /// There are so many clocks, or more.
    pub(super) fn open(&mut self, count: usize) {
        while self.known.len() < count {
            let frame = self.known.len();
            self.known.push(vec![None; self.sources.len()]);
            for place in 0..self.always.len() {
                let holds = self.literal(frame, self.always[place]);
                self.clause(vec![holds]);
            }
        }
    }

    /// A new truth.
    pub(super) fn free(&mut self) -> Lit {
        Lit::new(self.solver.new_var_default(), true)
    }

    /// One of these holds.
    pub(super) fn clause(&mut self, mut literals: Vec<Lit>) {
        self.solver.add_clause_reuse(&mut literals);
    }

    fn constant(&self, value: bool) -> Lit {
        if value { self.yes } else { !self.yes }
    }

    fn known(&self, frame: usize, literal: Literal) -> Option<Lit> {
        let lit = self.known[frame][literal.node()]?;
        Some(if literal.is_negated() { !lit } else { lit })
    }

    /// What a literal of the circuit is at a clock.
    pub(super) fn literal(&mut self, frame: usize, literal: Literal) -> Lit {
        let mut open = vec![(frame, literal.node())];
        let mut made = 0;
        while let Some((frame, node)) = open.pop() {
            if self.known[frame][node].is_some() {
                continue;
            }
            made += 1;
            let lit = match (self.watched.circuit.graph.nodes()[node], self.sources[node]) {
                (Node::False, _) => !self.yes,
                (Node::And(a, b), _) => match (self.known(frame, a), self.known(frame, b)) {
                    (Some(a), Some(b)) => self.both(a, b),
                    (_, _) => {
                        open.extend([(frame, node), (frame, a.node()), (frame, b.node())]);
                        continue;
                    }
                },
                (Node::Given, Some(Source::Latch(place))) => {
                    let latch = &self.watched.circuit.latches[place];
                    match (frame, self.begin) {
                        (0, Begin::AtStart) => self.constant(latch.initial),
                        (0, Begin::Anywhere) => self.free(),
                        (_, _) => match self.known(frame - 1, latch.next) {
                            Some(before) => before,
                            None => {
                                let before = (frame - 1, latch.next.node());
                                open.extend([(frame, node), before]);
                                continue;
                            }
                        },
                    }
                }
                (Node::Given, Some(Source::Input(_)) | None) => self.free(),
            };
            self.known[frame][node] = Some(lit);
        }
        self.budget.spend(made / 8);
        // It was made just now.
        self.known(frame, literal).unwrap_or(self.yes)
    }

    /// A conjunction.
    fn both(&mut self, a: Lit, b: Lit) -> Lit {
        if a == !self.yes || b == !self.yes || a == !b {
            return !self.yes;
        }
        if a == self.yes || a == b {
            return b;
        }
        if b == self.yes {
            return a;
        }
        let both = self.free();
        self.clause(vec![!both, a]);
        self.clause(vec![!both, b]);
        self.clause(vec![both, !a, !b]);
        both
    }

    /// Whether there are clocks of which all of this holds; none if that was not found out.
    pub(super) fn solve(&mut self, assumed: &[Lit]) -> Option<bool> {
        if self.budget.is_over() {
            return None;
        }
        let found = self.solver.solve_limited(assumed);
        // Neither is a third that there is.
        [(lbool::TRUE, true), (lbool::FALSE, false)].into_iter().find(|(of, _)| *of == found).map(|(_, found)| found)
    }

    /// Whether it holds in what was found.
    pub(super) fn holds(&self, lit: Lit) -> bool {
        self.solver.value_lit(lit) == lbool::TRUE
    }

    /// Whether that there was nothing to be found hangs on this, which was assumed.
    pub(super) fn is_needed(&self, lit: Lit) -> bool {
        self.solver.unsat_core_contains_var(lit.var())
    }

    /// What a node is at a clock, if anything asked for it.
    pub(super) fn asked(&self, frame: usize, literal: Literal) -> Option<Lit> {
        self.known(frame, literal)
    }

    /// The inputs of a clock of what was found; what nothing asks for is false.
    pub(super) fn inputs(&self, frame: usize) -> Vec<u64> {
        let of = |lit: Option<Lit>| if lit.is_some_and(|lit| self.holds(lit)) { u64::MAX } else { 0 };
        self.watched.circuit.inputs.iter().map(|input| of(self.known(frame, input.literal))).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::super::by_hand::{circuit, counter, ring};
    use super::*;
    use crate::circuit::of;
    use crate::limit::Limit;

    /// Whether what is seen first is seen at a clock.
    fn shows(frames: &mut Frames, watched: &Watched, frame: usize) -> Option<bool> {
        frames.open(frame + 1);
        let seen = frames.literal(frame, watched.facts[0].1);
        frames.solve(&[seen])
    }

    #[test]
    fn clauses_are_what_the_graph_is() {
        let watched = circuit(3, &[], |graph, inputs, _| {
            let (a, b, c) = (inputs[0], inputs[1], inputs[2]);
            let (xor, choice) = (graph.xor(a, !b), graph.choose(c, a, !b));
            (Vec::new(), vec![xor, choice, graph.and(xor, !choice), graph.or(choice, a)])
        });
        let mut go_on = |_, _| None;
        let budget = Budget::new(&mut go_on);
        let mut frames = Frames::new(&watched, Begin::AtStart, &budget);
        frames.open(1);
        // Each of the eight cases is a bit.
        let words = watched.circuit.graph.evaluate([0b1111_0000, 0b1100_1100, 0b1010_1010]);
        for case in 0..8 {
            let mut assumed: Vec<Lit> = Vec::new();
            for (place, word) in [0b1111_0000, 0b1100_1100, 0b1010_1010].into_iter().enumerate() {
                let input = frames.literal(0, watched.circuit.inputs[place].literal);
                assumed.push(if word >> case & 1 == 1 { input } else { !input });
            }
            for (fact, seen) in &watched.facts {
                let lit = frames.literal(0, *seen);
                let expected = of(&words, *seen) >> case & 1 == 1;
                for (lit, expected) in [(lit, expected), (!lit, !expected)] {
                    assert_eq!(frames.solve(&[&assumed[..], &[lit]].concat()), Some(expected), "{fact:?} {case}");
                }
            }
        }
    }

    #[test]
    fn a_counter_takes_three_clocks_to_three() {
        let watched = counter();
        let mut go_on = |_, _| None;
        let budget = Budget::new(&mut go_on);
        let mut frames = Frames::new(&watched, Begin::AtStart, &budget);
        let shown: Vec<Option<bool>> = (0..5).map(|frame| shows(&mut frames, &watched, frame)).collect();
        assert_eq!(shown, [Some(false), Some(false), Some(false), Some(true), Some(true)]);
        assert_eq!(shows(&mut frames, &watched, 3), Some(true));
        let counted: Vec<u64> = (0..3).map(|frame| frames.inputs(frame)[0]).collect();
        assert_eq!(counted, [u64::MAX; 3], "it counts at each clock");
        // Anywhere, it may be there.
        let mut frames = Frames::new(&watched, Begin::Anywhere, &budget);
        assert_eq!(shows(&mut frames, &watched, 0), Some(true));
        frames.always(!watched.facts[0].1);
        assert_eq!(shows(&mut frames, &watched, 2), Some(false), "what is known holds at later clocks, too");
    }

    #[test]
    fn a_token_begins_where_it_is_put() {
        let watched = ring();
        let mut go_on = |_, _| None;
        let budget = Budget::new(&mut go_on);
        let mut frames = Frames::new(&watched, Begin::AtStart, &budget);
        frames.open(3);
        let last = |frames: &mut Frames, frame| frames.literal(frame, watched.facts[3].1);
        let shown = [0, 1, 2].map(|frame| last(&mut frames, frame)).map(|seen| frames.solve(&[seen]));
        assert_eq!(shown, [Some(false), Some(false), Some(true)]);
    }

    #[test]
    fn what_is_assumed_is_asked_of_each_clock() {
        let mut watched = counter();
        watched.circuit.assumed = !watched.circuit.inputs[0].literal;
        let mut go_on = |_, _| None;
        let budget = Budget::new(&mut go_on);
        let mut frames = Frames::new(&watched, Begin::AtStart, &budget);
        assert_eq!(shows(&mut frames, &watched, 3), Some(false), "it never counts");
    }

    #[test]
    fn a_search_that_is_stopped_says_nothing() {
        let watched = counter();
        let mut stop = |_, _| Some(Limit::Interrupted);
        let budget = Budget::new(&mut stop);
        let mut frames = Frames::new(&watched, Begin::AtStart, &budget);
        assert_eq!(shows(&mut frames, &watched, 3), None);
        assert_eq!(budget.limit(), Some(Limit::Interrupted));
    }
}
