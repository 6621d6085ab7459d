//! Reactions one after the other that real times allow: what to give the chart, and when, so that it comes from one state
//! to the next.
//!
//! States are those of the exploration, each with how long its delays have run. Between two reactions there is as little
//! time as the answers of the path allow, and at least a period: that is one way to time a path, so what is found can
//! happen, and what is not found may still.

use crate::atom::Atom;
use crate::beyond::Beyond;
use crate::machine::{End, Machine};
use crate::pack::State;
use grafc_formula::{TimerId, Value, VarId};
use grafc_logic::scan::{Program, Role, TransitionId};
use index_vec::IndexVec;
use indexmap::{IndexMap, IndexSet};
use rustc_hash::{FxBuildHasher, FxHashMap};

/// How time passes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Times {
    /// As on a clock, with so many milliseconds between two reactions at least.
    Real(i64),
    /// Delays end in any order: more may happen than on any clock.
    Free,
}

/// A reaction.
#[derive(Clone, PartialEq, Debug)]
pub struct Move {
    /// The node that it leads to.
    pub to: usize,
    /// The transitions that it clears, by their places in order of declaration, each once.
    pub cleared: Vec<usize>,
    /// The inputs that count, by their places among the inputs; others are as they like.
    pub given: Vec<(usize, Value)>,
    /// So many milliseconds after the reaction before.
    pub after_ms: i64,
}

/// All that was found.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Moves {
    /// The initial reactions.
    pub first: Vec<Move>,
    /// What leads on from each node.
    pub from: Vec<Vec<Move>>,
    /// The situation of each node, by its place in the list of situations.
    pub situation_of: Vec<usize>,
    /// The situations, each as the places of its steps.
    pub situations: Vec<Vec<usize>>,
    /// Whether that is all that is possible by the clock chosen: no limit was hit.
    pub complete: bool,
}

/// The same state with so many different readings of its delays is looked at.
const MOST_READINGS: usize = 32;
/// So many paths are walked for each state that may be looked at, and so many in any case.
const PATHS_PER_STATE: usize = 10;
const FEWEST_PATHS: usize = 10_000;

type Set<T> = IndexSet<T, FxBuildHasher>;
/// How long each timer has run.
type Readings = Box<[i64]>;

/// Finds reactions from state to state, up to a number of states.
///
/// # Errors
/// What of the chart cannot be followed.
pub fn moves(program: &Program, times: Times, most: usize) -> Result<Moves, Beyond> {
    let mut machine = Machine::new(program)?;
    let mut search = Search {
        program,
        times,
        input_of: program
            .variables
            .iter_enumerated()
            .filter(|(_, variable)| variable.role == Role::Input)
            .enumerate()
            .map(|(place, (v, _))| (v, place))
            .collect(),
        nodes: Set::default(),
        readings_of: FxHashMap::default(),
        situations: Set::default(),
        found: Moves { complete: true, ..Moves::default() },
        most,
    };
    let mut left = most.saturating_mul(PATHS_PER_STATE).saturating_add(FEWEST_PATHS);
    search.found.first = search.reactions(&mut machine, None, &mut left)?;
    let mut next = 0;
    while next < search.nodes.len() && left > 0 {
        let list = search.reactions(&mut machine, Some(next), &mut left)?;
        search.found.from.push(list);
        next += 1;
    }
    search.found.from.resize(search.nodes.len(), Vec::new());
    search.found.complete &= left > 0;
    search.found.situations = search.situations.into_iter().collect();
    Ok(search.found)
}

struct Search<'p> {
    program: &'p Program,
    times: Times,
    input_of: FxHashMap<VarId, usize>,
    nodes: Set<(State, Readings)>,
    /// The nodes of each state.
    readings_of: FxHashMap<State, Vec<usize>>,
    situations: Set<Vec<usize>>,
    found: Moves,
    most: usize,
}

impl Search<'_> {
    fn reactions(&mut self, machine: &mut Machine, from: Option<usize>, left: &mut usize) -> Result<Vec<Move>, Beyond> {
        let node = from.and_then(|from| self.nodes.get_index(from)).cloned();
        let (operands, ends): (IndexVec<TimerId, usize>, Vec<i64>) = {
            let clocks = machine.clocks();
            (clocks.operand.clone(), clocks.times.iter().map(|times| times.last().copied().unwrap_or(0)).collect())
        };
        // Of several ways to the same, the first.
        let mut list: IndexMap<(usize, Vec<usize>), Move, FxBuildHasher> = IndexMap::default();
        let state = node.as_ref().map(|(state, _)| state);
        machine.reactions(state, |machine, end, answers| {
            *left = left.saturating_sub(1);
            let End::Rest(state, situation) = end else { return *left > 0 };
            let before = node.as_ref().map(|(_, readings)| readings);
            let Some(after_ms) = self.after(answers, before, &operands) else { return *left > 0 };
            let mut cleared: Vec<usize> = machine.passed().iter().map(|t: &TransitionId| t.index()).collect();
            cleared.sort_unstable();
            cleared.dedup();
            let readings: Readings = match self.times {
                Times::Free => Box::default(),
                Times::Real(_) => {
                    let read = |(timer, phase): (TimerId, &crate::clocks::Phase)| match (phase.on, phase.fresh) {
                        (false, _) | (true, true) => 0,
                        // What is longer than all that is asked for is no longer.
                        (true, false) => before
                            .map_or(0, |readings| readings[timer.index()].saturating_add(after_ms))
                            .min(ends[timer.index()]),
                    };
                    machine.timers().iter_enumerated().map(read).collect()
                }
            };
            if cleared.is_empty() && node.as_ref().is_some_and(|(before, _)| *before == state) {
                return *left > 0;
            }
            if let Some(to) = self.node(state, readings, situation) {
                let given = self.given(answers);
                list.entry((to, cleared.clone())).or_insert(Move { to, cleared, given, after_ms });
            }
            *left > 0
        })?;
        Ok(list.into_values().collect())
    }

    /// The node of a state with these readings, or, if there are enough of them, another one with the same state; none if
    /// there are too many states.
    fn node(&mut self, state: State, readings: Readings, situation: Vec<usize>) -> Option<usize> {
        let known = self.readings_of.get(&state).map_or(0, Vec::len);
        let key = (state, readings);
        if let Some(place) = self.nodes.get_index_of(&key) {
            return Some(place);
        }
        // Another reading is another state: what follows need not be possible from there.
        if known >= MOST_READINGS {
            return None;
        }
        if self.nodes.len() >= self.most {
            self.found.complete = false;
            return None;
        }
        let situation = self.situations.insert_full(situation).0;
        self.found.situation_of.push(situation);
        let place = self.nodes.len();
        self.readings_of.entry(key.0.clone()).or_default().push(place);
        self.nodes.insert(key);
        Some(place)
    }

    /// The time that has to pass for these answers; none if there is none.
    fn after(
        &self,
        answers: &[(Atom, bool)],
        before: Option<&Readings>,
        operands: &IndexVec<TimerId, usize>,
    ) -> Option<i64> {
        let Times::Real(period) = self.times else { return Some(0) };
        let Some(readings) = before else { return Some(0) };
        let (mut least, mut below) = (period, i64::MAX);
        for (atom, answer) in answers {
            let Atom::Ends(operand, time) = atom else { continue };
            let measured = operands.iter_enumerated().filter(|(_, of)| *of == operand);
            let has_run = measured.map(|(timer, _)| readings[timer.index()]).max().unwrap_or(0);
            let rest = time - has_run;
            if *answer { least = least.max(rest) } else { below = below.min(rest) }
        }
        (least < below).then_some(least)
    }

    /// A value for each input that was asked for.
    fn given(&self, answers: &[(Atom, bool)]) -> Vec<(usize, Value)> {
        let mut given: IndexMap<VarId, Value, FxBuildHasher> = IndexMap::default();
        for (atom, answer) in answers {
            match *atom {
                Atom::Holds(v) => _ = given.insert(v, Value::Bool(*answer)),
                // Each later answer is closer to the values that are left than all before it on the same side, and both ends
                // of what is left are values: the one of the latest answer will do.
                Atom::AtLeast(v, bound) => {
                    let (at_least, below) = bound.sides(self.program.variables[v].ty);
                    given.insert(v, if *answer { at_least } else { below });
                }
                // Numbers are taken apart in proofs alone.
                Atom::Bit(..) | Atom::Ends(..) => {}
            }
        }
        let mut list: Vec<(usize, Value)> =
            given.into_iter().filter_map(|(v, value)| Some((*self.input_of.get(&v)?, value))).collect();
        list.sort_by_key(|(place, _)| *place);
        list
    }
}
