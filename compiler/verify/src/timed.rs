//! The search in real times: states together with what clocks can show there. What it does not find, no times allow.

use crate::atom::Atom;
use crate::beyond::Beyond;
use crate::explicit::Size;
use crate::facts::Fact;
use crate::goal::{Answers, Finding, Goal, Reason, Stop, Way};
use crate::limit::Limit;
use crate::machine::{End, Machine};
use crate::pack::State;
use crate::zone::Zone;
use grafc_logic::scan::Program;
use indexmap::IndexMap;
use rustc_hash::{FxBuildHasher, FxHashMap, FxHashSet};

/// A state, and what clocks can show there.
struct Node {
    state: State,
    zone: Zone,
    parent: Option<usize>,
    answers: Answers,
}

/// A goal, and of one that is met by states these.
pub(crate) struct Wanted {
    pub(crate) goal: Goal,
    pub(crate) states: FxHashSet<State>,
}

struct Search<'w> {
    wanted: &'w [Wanted],
    nodes: Vec<Node>,
    /// The nodes of each state.
    known: FxHashMap<State, Vec<usize>>,
    met: IndexMap<usize, Way, FxBuildHasher>,
    longest: Vec<i64>,
    limit: Option<Limit>,
}

/// Looks for goals, the fewest reactions first.
pub(crate) fn search(program: &Program, wanted: &[Wanted], size: Size, stop: Stop) -> Result<Vec<Finding>, Beyond> {
    let mut machine = Machine::by_bits(program)?;
    machine.look_on();
    let clocks = machine.clocks();
    let count = clocks.operand.iter().max().map_or(0, |most| most + 1);
    let mut longest = vec![0; count];
    for (t, operand) in clocks.operand.iter_enumerated() {
        longest[*operand] = longest[*operand].max(clocks.times[t].last().copied().unwrap_or(0));
    }
    let mut search = Search {
        wanted,
        nodes: Vec::new(),
        known: FxHashMap::default(),
        met: IndexMap::default(),
        longest,
        limit: None,
    };
    let (mut next, mut walked) = (None, 0);
    loop {
        search.reactions(&mut machine, next, size, &mut walked, stop)?;
        let place = next.map_or(0, |place: usize| place + 1);
        if search.met.len() == wanted.len() || search.limit.is_some() || place >= search.nodes.len() {
            break;
        }
        next = Some(place);
    }
    let Search { mut met, limit, .. } = search;
    let open = || limit.map_or(Finding::Never, |limit| Finding::Open(Reason::Limit(limit)));
    Ok((0..wanted.len()).map(|goal| met.swap_remove(&goal).map_or_else(open, Finding::Met)).collect())
}

impl Search<'_> {
    fn reactions(
        &mut self,
        machine: &mut Machine,
        from: Option<usize>,
        size: Size,
        walked: &mut usize,
        stop: Stop,
    ) -> Result<(), Beyond> {
        let state = from.map(|from| self.nodes[from].state.clone());
        let before = match from {
            Some(from) => {
                let mut zone = self.nodes[from].zone.clone();
                zone.pass();
                zone
            }
            None => Zone::new(self.longest.len()),
        };
        machine.reactions(state.as_ref(), |machine, end, path| {
            *walked += 1;
            if *walked >= size.paths || self.nodes.len() >= size.states {
                self.limit = Some(Limit::States);
            } else if *walked % 64 == 0 {
                self.limit = stop(self.nodes.len(), from.unwrap_or(0));
            }
            self.reaction(machine, from, &before, end, path);
            self.limit.is_none()
        })
    }

    fn reaction(&mut self, machine: &Machine, from: Option<usize>, before: &Zone, end: End, path: &[(Atom, bool)]) {
        let mut zone = before.clone();
        let fits = path.iter().all(|(atom, answer)| match atom {
            Atom::Ends(operand, time) => zone.restrict(*operand, *time, *answer),
            Atom::Holds(_) | Atom::AtLeast(..) | Atom::Bit(..) => true,
        });
        if !fits {
            return;
        }
        let rest = match &end {
            End::Rest(state, _) => Some(state),
            End::Livelock(_) => None,
            End::Barred => return,
        };
        let livelock = rest.is_none().then_some(Fact::Livelock);
        for (place, wanted) in self.wanted.iter().enumerate() {
            let is_met = match wanted.goal {
                Goal::Fact(fact) => livelock == Some(fact) || machine.facts().any(|seen| seen == fact),
                Goal::Stuck | Goal::Homeless | Goal::Lost(_) => rest.is_some_and(|state| wanted.states.contains(state)),
            };
            if is_met && !self.met.contains_key(&place) {
                self.met.insert(place, self.way(from, path));
            }
        }
        let Some(state) = rest else { return };
        for clock in 0..self.longest.len() {
            let of_it = machine.timers().iter_enumerated().filter(|(t, _)| machine.clocks().operand[*t] == clock);
            let (mut runs, mut begins) = (false, false);
            for (_, phase) in of_it {
                runs |= phase.on;
                begins |= phase.fresh;
            }
            if begins {
                zone.begin(clock);
            } else if !runs {
                zone.forget(clock);
            }
        }
        zone.widen(&self.longest);
        let same = self.known.entry(state.clone()).or_default();
        if !same.iter().any(|node| self.nodes[*node].zone.holds(&zone)) {
            same.push(self.nodes.len());
            self.nodes.push(Node { state: state.clone(), zone, parent: from, answers: path.to_vec() });
        }
    }

    fn way(&self, from: Option<usize>, last: &[(Atom, bool)]) -> Way {
        let mut way = vec![last.to_vec()];
        let mut at = from;
        while let Some(node) = at {
            way.push(self.nodes[node].answers.clone());
            at = self.nodes[node].parent;
        }
        way.reverse();
        way
    }
}
