//! All paths from all states, breadth first.

use crate::atom::Atom;
use crate::beyond::Beyond;
use crate::limit::Limit;
use crate::machine::{End, Machine};
use crate::pack::State;
use grafc_logic::scan::TransitionId;
use indexmap::IndexSet;
use rustc_hash::FxBuildHasher;

type Set<T> = IndexSet<T, FxBuildHasher>;

/// What was met on the way; places are those in the order of meeting.
#[derive(Default)]
pub(crate) struct Explored {
    /// The states.
    pub(crate) states: Set<State>,
    /// The situation of each, by its place among the situations.
    pub(crate) situation_of: Vec<usize>,
    /// The situations, each as the places of its steps.
    pub(crate) situations: Set<Vec<usize>>,
    /// The states after the initial reaction.
    pub(crate) initial: Set<usize>,
    /// A state, or the start, in which the assumptions allow no inputs at all.
    pub(crate) barred: Option<Option<usize>>,
    /// The start, and so many states in a row after it, have a reaction that the assumptions allow.
    pub(crate) allowed: usize,
    /// Why there are states that were not looked at, or paths; none if there are not.
    pub(crate) limit: Option<Limit>,
}

/// One reaction, as far as its inputs are known.
pub(crate) struct Reaction<'a> {
    /// From this state, by its place; none for the initial reaction.
    pub(crate) from: Option<(usize, &'a State)>,
    /// Where it ended.
    pub(crate) to: To,
    /// What was asked, and answered.
    pub(crate) path: &'a [(Atom, bool)],
}

/// Where a reaction ended.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum To {
    /// In this state.
    State(usize),
    /// In one that there was no more room for.
    NotKept,
    /// Nowhere: these transitions are cleared again and again.
    Livelock(Vec<TransitionId>),
    /// Nowhere: an assumption bars these inputs.
    Barred,
}

/// What looks at the reactions.
pub(crate) trait Keep {
    /// A reaction, with the machine that did it; whether that is enough.
    fn reaction(&mut self, machine: &Machine, reaction: Reaction) -> bool;
}

/// How far to go.
pub(crate) struct Bounds<'b> {
    /// At most so many states.
    pub(crate) states: usize,
    /// At most so many paths.
    pub(crate) paths: usize,
    /// Asked now and then, with how many states are known and how many of them were looked at: why to stop.
    pub(crate) stop: &'b mut dyn FnMut(usize, usize) -> Option<Limit>,
}

/// So many paths are walked between two questions whether to go on.
const PATHS_AT_ONCE: usize = 64;

/// Explores all that there is, or as far as the bounds.
pub(crate) fn explore(machine: &mut Machine, bounds: &mut Bounds, keep: &mut dyn Keep) -> Result<Explored, Beyond> {
    let mut found = Explored::default();
    let mut walked = 0;
    let mut next = None;
    loop {
        found.reactions(machine, next, bounds, &mut walked, keep)?;
        let place = next.map_or(0, |place| place + 1);
        if found.limit.is_none_or(|limit| limit == Limit::States) && found.allowed == place {
            found.barred = Some(next);
            return Ok(found);
        }
        if found.limit.is_some_and(|limit| limit != Limit::States) || place >= found.states.len() {
            return Ok(found);
        }
        next = Some(place);
    }
}

impl Explored {
    fn reactions(
        &mut self,
        machine: &mut Machine,
        from: Option<usize>,
        bounds: &mut Bounds,
        walked: &mut usize,
        keep: &mut dyn Keep,
    ) -> Result<(), Beyond> {
        let state = from.and_then(|from| self.states.get_index(from)).cloned();
        machine.reactions(state.as_ref(), |machine, end, path| {
            let to = match end {
                End::Livelock(ring) => To::Livelock(ring),
                End::Barred => To::Barred,
                End::Rest(state, situation) => match self.states.get_index_of(&state) {
                    Some(to) => To::State(to),
                    None if self.states.len() >= bounds.states => {
                        self.limit = Some(Limit::States);
                        To::NotKept
                    }
                    None => {
                        self.situation_of.push(self.situations.insert_full(situation).0);
                        To::State(self.states.insert_full(state).0)
                    }
                },
            };
            if let (None, To::State(to)) = (from, &to) {
                self.initial.insert(*to);
            }
            if to != To::Barred && self.allowed == from.map_or(0, |from| from + 1) {
                self.allowed += 1;
            }
            *walked += 1;
            if keep.reaction(machine, Reaction { from: from.zip(state.as_ref()), to, path }) {
                self.limit = Some(Limit::Enough);
                return false;
            }
            let limit = if *walked >= bounds.paths {
                Some(Limit::Paths)
            } else if *walked % PATHS_AT_ONCE == 0 {
                (bounds.stop)(self.states.len(), from.unwrap_or(0))
            } else {
                None
            };
            self.limit = limit.or(self.limit);
            limit.is_none()
        })
    }
}
