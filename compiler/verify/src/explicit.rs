//! The engine that looks at one state after the other.

use crate::atom::Atom;
use crate::beyond::Beyond;
use crate::edges::{Edges, reach_back};
use crate::explore::{Bounds, Explored, Keep, Reaction, To, explore};
use crate::facts::Fact;
use crate::goal::{Answers, Engine, Finding, Goal, Reason, Searched, Stop, Way};
use crate::limit::Limit;
use crate::machine::{End, MOST_LEADS, Machine};
use crate::pack::State;
use grafc_logic::scan::Program;
use indexmap::IndexMap;
use rustc_hash::{FxBuildHasher, FxHashMap, FxHashSet};

/// All paths from all states, breadth first.
pub(crate) struct Explicit<'p> {
    machine: Machine<'p>,
    bounds: Size,
    explored: Explored,
    ways: Ways,
    barred: Option<Way>,
}

/// How much may be looked at.
#[derive(Clone, Copy)]
pub(crate) struct Size {
    /// So many states.
    pub(crate) states: usize,
    /// So many paths.
    pub(crate) paths: usize,
}

/// The reactions, as far as they are kept.
#[derive(Default)]
struct Ways {
    /// The state from which each was met first; none at the start.
    parents: Vec<Option<u32>>,
    edges: Edges,
    /// Whether something that a state leads to is not kept.
    cut: FxHashSet<usize>,
    /// The first reaction in which each fact was seen: from which state, by which answers.
    met: IndexMap<Fact, (Option<usize>, Answers), FxBuildHasher>,
    /// From which states a reaction does not end, by which answers.
    livelocks: IndexMap<usize, Answers, FxBuildHasher>,
    at: Option<usize>,
    /// What the timers measure of which no more is known at the state at hand than that they run.
    vague: FxHashSet<usize>,
}

impl Keep for Ways {
    fn reaction(&mut self, machine: &Machine, Reaction { from, to, path }: Reaction) -> bool {
        let at = from.map(|(from, _)| from);
        if at != self.at {
            if self.at.is_some() {
                self.edges.close();
            }
            self.at = at;
            let phases = from.into_iter().flat_map(|(_, state)| machine.phases(state).enumerate());
            let vague = phases.filter(|(_, phase)| phase.vague);
            self.vague = vague.map(|(t, _)| machine.clocks().operand.raw[t]).collect();
        }
        if to == To::Barred {
            return false;
        }
        let livelock = matches!(to, To::Livelock(_)).then_some(Fact::Livelock);
        for fact in machine.facts().chain(livelock) {
            self.met.entry(fact).or_insert_with(|| (at, path.to_vec()));
        }
        match to {
            To::State(to) => {
                if to == self.parents.len() {
                    self.parents.push(at.map(|at| at as u32));
                }
                if from.is_some() {
                    self.edges.push(to, is_sure(path, &self.vague));
                }
            }
            To::NotKept => self.cut.extend(at),
            To::Livelock(_) => {
                if let Some(at) = at {
                    self.livelocks.entry(at).or_insert_with(|| path.to_vec());
                }
            }
            To::Barred => {}
        }
        false
    }
}

/// Whether a reaction can come about from any state: because all delays that it asks for are over, which they are after long
/// enough a time, or because none is, of which it was known that they were not the time before.
fn is_sure(path: &[(Atom, bool)], vague: &FxHashSet<usize>) -> bool {
    let (mut over, mut running) = (false, false);
    for (atom, answer) in path {
        if let Atom::Ends(operand, _) = atom {
            over |= *answer;
            running |= !*answer;
            if !answer && vague.contains(operand) {
                return false;
            }
        }
    }
    !(over && running)
}

impl<'p> Explicit<'p> {
    /// For a program that shows its transitions.
    ///
    /// # Errors
    /// What of it cannot be followed.
    pub(crate) fn new(program: &'p Program, bounds: Size) -> Result<Self, Beyond> {
        let mut machine = Machine::by_bits(program)?;
        machine.look_on();
        Ok(Explicit { machine, bounds, explored: Explored::default(), ways: Ways::default(), barred: None })
    }

    /// The states that meet a goal, whatever delays do; none if it is none of states.
    pub(crate) fn states_that_meet(&self, goal: Goal) -> FxHashSet<State> {
        let met = match goal {
            Goal::Fact(_) | Goal::Lost(_) => Vec::new(),
            Goal::Stuck => self.stuck(false),
            Goal::Homeless => self.homeless(false),
        };
        let met = met.into_iter().filter_map(|state| self.explored.states.get_index(state).cloned());
        met.collect()
    }

    /// Whether it is known all that a state leads to.
    fn is_known(&self, state: usize) -> bool {
        let is_over = self.explored.limit.is_none_or(|limit| limit == Limit::States);
        (is_over || self.ways.at.is_some_and(|at| state < at)) && !self.ways.cut.contains(&state)
    }

    /// The states from which no other situation can be reached, for all that is known.
    fn stuck(&self, sure_only: bool) -> Vec<usize> {
        let Explored { states, situation_of, .. } = &self.explored;
        let mut seeds: Vec<bool> = (0..states.len()).map(|state| !self.is_known(state)).collect();
        let moves = |(from, to): &(usize, usize)| situation_of[*from] != situation_of[*to];
        for (from, _) in self.ways.edges.all(sure_only).filter(|edge| moves(edge)) {
            seeds[from] = true;
        }
        let alive = reach_back(seeds, || self.ways.edges.all(sure_only).filter(|edge| !moves(edge)));
        let is_final = |state: &State| self.machine.marks_of(state).is_final();
        let is_stuck = |(place, state): &(usize, &State)| !alive[*place] && !is_final(state);
        states.iter().enumerate().filter(is_stuck).map(|(place, _)| place).collect()
    }

    /// The states from which no initial situation can be reached, for all that is known.
    fn homeless(&self, sure_only: bool) -> Vec<usize> {
        let Explored { states, situation_of, initial, .. } = &self.explored;
        let home: FxHashSet<usize> = initial.iter().map(|state| situation_of[*state]).collect();
        let is_seed = |state: usize| home.contains(&situation_of[state]) || !self.is_known(state);
        let seeds = (0..states.len()).map(is_seed).collect();
        let alive = reach_back(seeds, || self.ways.edges.all(sure_only));
        (0..states.len()).filter(|state| !alive[*state]).collect()
    }

    fn of_states(&mut self, certain: &[usize], possible: &[usize]) -> Result<Finding, Beyond> {
        Ok(match (certain.first(), possible.first(), self.explored.limit) {
            (Some(state), _, _) => Finding::Met(self.way_to(Some(*state))?),
            (None, Some(_), _) => Finding::Open(Reason::Delays),
            (None, None, Some(limit)) => Finding::Open(Reason::Limit(limit)),
            (None, None, None) => Finding::Never,
        })
    }

    /// The shortest way to a state; an empty one to before the start.
    fn way_to(&mut self, state: Option<usize>) -> Result<Way, Beyond> {
        let mut way = Way::new();
        let mut at = state;
        while let Some(state) = at {
            let before = self.ways.parents[state].map(|before| before as usize);
            way.push(self.between(before, state)?);
            at = before;
        }
        way.reverse();
        Ok(way)
    }

    /// The answers of a reaction from a state, or of the initial one, to another.
    fn between(&mut self, from: Option<usize>, to: usize) -> Result<Answers, Beyond> {
        let wanted = self.explored.states.get_index(to).cloned();
        let from = from.and_then(|from| self.explored.states.get_index(from)).cloned();
        let mut answers = Answers::new();
        self.machine.reactions(from.as_ref(), |_, end, path| {
            let is_it = matches!(&end, End::Rest(to, _) if Some(to) == wanted.as_ref());
            if is_it {
                answers = path.to_vec();
            }
            !is_it
        })?;
        Ok(answers)
    }

    /// What of one thing leads to another is lost.
    fn lost(&mut self, place: usize) -> Result<Finding, Beyond> {
        let Explored { states, limit, .. } = &self.explored;
        let (limit, count) = (*limit, states.len());
        if place >= MOST_LEADS {
            return Ok(Finding::Open(Reason::Limit(Limit::States)));
        }
        let marks: Vec<(bool, bool)> = states.iter().map(|state| self.machine.marks_of(state).leads(place)).collect();
        let region = region(&marks, &self.ways);
        let leads = |sure_only: bool| {
            let seeds = (0..count).map(|state| marks[state].1 || !self.is_known(state)).collect();
            reach_back(seeds, || self.ways.edges.all(sure_only))
        };
        let (may, must) = (leads(false), leads(true));
        let is_bad = |state: &usize| !may[*state] || self.ways.livelocks.contains_key(state);
        if let Some(state) = region.order.iter().copied().find(is_bad) {
            let mut steps = Vec::new();
            let mut at = state;
            while let Some(before) = region.before[&at] {
                steps.push((before, at));
                at = before;
            }
            let after = may[state].then(|| self.ways.livelocks.get(&state).cloned()).flatten();
            let mut way = self.way_to(Some(at))?;
            for (before, at) in steps.into_iter().rev() {
                way.push(self.between(Some(before), at)?);
            }
            way.extend(after);
            return Ok(Finding::Met(way));
        }
        let is_open = region.order.iter().any(|state| !must[*state]);
        Ok(match limit {
            _ if is_open => Finding::Open(Reason::Delays),
            Some(limit) => Finding::Open(Reason::Limit(limit)),
            None => Finding::Never,
        })
    }
}

/// The states that are reached from one with the first of a pair without meeting the second.
struct Region {
    /// The nearest to the start first.
    order: Vec<usize>,
    /// For each the one before it; none for one with the first itself.
    before: FxHashMap<usize, Option<usize>>,
}

fn region(marks: &[(bool, bool)], ways: &Ways) -> Region {
    let mut depths: Vec<usize> = Vec::with_capacity(marks.len());
    for parent in &ways.parents {
        let depth = parent.map_or(0, |parent| depths[parent as usize] + 1);
        depths.push(depth);
    }
    let mut at_depth: Vec<Vec<(usize, Option<usize>)>> = Vec::new();
    let put = |list: &mut Vec<Vec<(usize, Option<usize>)>>, depth: usize, state, before| {
        if list.len() <= depth {
            list.resize(depth + 1, Vec::new());
        }
        list[depth].push((state, before));
    };
    for (state, (from, to)) in marks.iter().enumerate() {
        if *from && !to {
            put(&mut at_depth, depths[state], state, None);
        }
    }
    let mut found = Region { order: Vec::new(), before: FxHashMap::default() };
    let mut depth = 0;
    while depth < at_depth.len() {
        for (state, before) in std::mem::take(&mut at_depth[depth]) {
            if found.before.contains_key(&state) {
                continue;
            }
            found.before.insert(state, before);
            found.order.push(state);
            for next in ways.edges.from(state).filter(|next| !marks[*next].1) {
                put(&mut at_depth, depth + 1, next, Some(state));
            }
        }
        depth += 1;
    }
    found
}

impl Engine for Explicit<'_> {
    fn find(&mut self, goals: &[Goal], stop: Stop) -> Result<Vec<Finding>, Beyond> {
        let Size { states, paths } = self.bounds;
        self.ways = Ways::default();
        self.explored = explore(&mut self.machine, &mut Bounds { states, paths, stop }, &mut self.ways)?;
        self.ways.edges.close();
        if let Some(state) = self.explored.barred {
            self.barred = Some(self.way_to(state)?);
        }
        let mut findings = Vec::with_capacity(goals.len());
        for goal in goals {
            findings.push(match goal {
                Goal::Fact(fact) => match self.ways.met.get(fact).cloned() {
                    Some((from, last)) => {
                        let mut way = self.way_to(from)?;
                        way.push(last);
                        Finding::Met(way)
                    }
                    None => match self.explored.limit {
                        Some(limit) => Finding::Open(Reason::Limit(limit)),
                        None => Finding::Never,
                    },
                },
                Goal::Stuck => self.of_states(&self.stuck(false), &self.stuck(true))?,
                Goal::Homeless => self.of_states(&self.homeless(false), &self.homeless(true))?,
                Goal::Lost(place) => self.lost(*place)?,
            });
        }
        Ok(findings)
    }

    fn searched(&self) -> Searched {
        Searched { states: self.explored.states.len() as f64, limit: self.explored.limit }
    }

    fn barred(&self) -> Option<&Way> {
        self.barred.as_ref()
    }
}
