//! All paths from all states, breadth first.

use crate::atom::Atom;
use crate::beyond::Beyond;
use crate::machine::{End, Machine, State};
use grafc_logic::scan::TransitionId;
use indexmap::{IndexMap, IndexSet};
use rustc_hash::FxBuildHasher;

type Set<T> = IndexSet<T, FxBuildHasher>;
type Map<K, V> = IndexMap<K, V, FxBuildHasher>;

/// The answers of a path, in order of the questions; those on time left out.
pub(crate) type Answers = Vec<(Atom, bool)>;

/// What reactions lead to.
#[derive(Default)]
pub(crate) struct Explored {
    /// The states, in the order in which they were met.
    pub(crate) states: Set<State>,
    /// The situation of each, by its place among the situations.
    pub(crate) situation_of: Vec<usize>,
    /// The situations, each as the places of its steps.
    pub(crate) situations: Set<Vec<usize>>,
    /// The states after the initial reaction.
    pub(crate) initial: Set<usize>,
    /// From state to state, with the answers that lead there.
    pub(crate) edges: Map<(usize, usize), Set<Answers>>,
    /// From a state, or from the start, into a ring of transitions without end.
    pub(crate) livelocks: Map<(Option<usize>, Vec<TransitionId>), Set<Answers>>,
    /// Whether there is no state that was not looked at.
    pub(crate) complete: bool,
}

/// Where many inputs count in a state, there are as many paths from it as there are vectors: so many are walked for each state
/// that may be looked at.
const PATHS_PER_STATE: usize = 10;

/// So many are walked in any case.
const FEWEST_PATHS: usize = 10_000;

/// Explores as far as this number of states, and the paths that go with it.
pub(crate) fn explore(machine: &mut Machine, most: usize) -> Result<Explored, Beyond> {
    let mut found = Explored { complete: true, ..Explored::default() };
    let mut left = most.saturating_mul(PATHS_PER_STATE).saturating_add(FEWEST_PATHS);
    found.reactions(machine, None, most, &mut left)?;
    let mut next = 0;
    while next < found.states.len() && left > 0 {
        found.reactions(machine, Some(next), most, &mut left)?;
        next += 1;
    }
    found.complete &= left > 0;
    Ok(found)
}

impl Explored {
    fn reactions(
        &mut self,
        machine: &mut Machine,
        from: Option<usize>,
        most: usize,
        left: &mut usize,
    ) -> Result<(), Beyond> {
        let state = from.and_then(|from| self.states.get_index(from)).cloned();
        machine.reactions(state.as_ref(), |end, path| {
            *left = left.saturating_sub(1);
            let goes_on = *left > 0;
            let answers = || path.iter().filter(|(atom, _)| !matches!(atom, Atom::Ends(..))).copied().collect();
            match end {
                End::Livelock(ring) => {
                    self.livelocks.entry((from, ring)).or_default().insert(answers());
                }
                End::Rest(state, situation) => {
                    let to = match self.states.get_index_of(&state) {
                        Some(to) => to,
                        None if self.states.len() >= most => {
                            self.complete = false;
                            return goes_on;
                        }
                        None => {
                            self.situation_of.push(self.situations.insert_full(situation).0);
                            self.states.insert_full(state).0
                        }
                    };
                    match from {
                        None => {
                            self.initial.insert(to);
                        }
                        Some(from) => {
                            self.edges.entry((from, to)).or_default().insert(answers());
                        }
                    }
                }
            }
            goes_on
        })
    }
}
