//! The engine that looks at all states at once, as decision diagrams.
//!
//! ```text
//! rings of states ─ begin ─▶ heads of micro-steps, with their inputs ─ step ─▶ heads … ─▶ the next ring
//! ```
//!
//! A *head* is what stands before a micro-step, with the inputs of its reaction. A reaction goes from head to head; since
//! inputs are fixed, each head has one that follows. A *ring* is all states that take so many reactions to be reached, and no
//! fewer: from there, a shortest way is found backwards.
//!
//! | file | what |
//! | --- | --- |
//! | `sets` | operations that end when there is no more room or time |
//! | `order`, `bits` | the variables of the diagrams, and their order |
//! | `seen`, `number` | what a formula is for all states; whole numbers, bit by bit |
//! | `run` | statements, run once for all states |
//! | `updates` | what moves a set of states on, or back |
//! | `relation` | a reaction as relations |
//! | `way` | ways to what was found |

mod bits;
mod number;
mod order;
mod relation;
mod run;
mod seen;
mod sets;
mod updates;
mod way;

use crate::beyond::Beyond;
use crate::facts::Fact;
use crate::goal::{Engine, Finding, Goal, Reason, Searched, Stop, Way};
use crate::limit::Limit;
use crate::machine::Machine;
use biodivine_lib_bdd::Bdd;
use grafc_logic::scan::{ClaimKind, Program};
use relation::Relation;
use sets::{Halt, Sets};

/// At most so many nodes in a diagram.
const MOST_NODES: usize = 3_000_000;

/// The engine.
pub(crate) struct Symbolic<'p> {
    program: &'p Program,
    searched: Searched,
    /// Whether the chart says where it may come to its end.
    has_finals: bool,
    barred: Option<Way>,
}

/// What was found on the way.
struct Found {
    relation: Relation,
    /// All states.
    reached: Bdd,
    /// States by the number of reactions.
    rings: Vec<Bdd>,
    /// Heads that were met first in the reaction of this number.
    heads: Vec<Bdd>,
    /// Heads from which no reaction ends.
    livelocked: Bdd,
    /// All heads.
    all_heads: Bdd,
}

impl<'p> Symbolic<'p> {
    /// For a program that shows its transitions.
    pub(crate) fn new(program: &'p Program) -> Self {
        let has_finals = program.claims.iter().any(|claim| claim.kind == ClaimKind::Final);
        let searched = Searched { states: 0.0, limit: Some(Limit::Nodes) };
        Symbolic { program, searched, has_finals, barred: None }
    }

    fn search(&mut self, goals: &[Goal], sets: &mut Sets) -> Result<Vec<Finding>, Halt> {
        let relation = Relation::new(self.program, sets)?;
        let mut found = Found::new(relation);
        found.explore(self.program, sets)?;
        self.searched = Searched { states: found.count(), limit: None };
        let mut machine = Machine::new(self.program)?;
        self.barred = found.barred(&mut machine, sets)?;
        let homeless = goals.contains(&Goal::Homeless).then(|| found.homeless(sets)).transpose()?;
        goals
            .iter()
            .map(|goal| match goal {
                Goal::Fact(fact) => found.of_fact(*fact, &mut machine, sets),
                Goal::Homeless => match &homeless {
                    Some(homeless) => found.of_states(homeless, &mut machine, sets),
                    None => Ok(Finding::Open(Reason::Limit(Limit::Nodes))),
                },
                // What leads to what is not followed here.
                Goal::Lost(_) => Ok(Finding::Open(Reason::Limit(Limit::States))),
                Goal::Stuck if self.has_finals => Ok(Finding::Open(Reason::Limit(Limit::States))),
                Goal::Stuck => {
                    let stuck = found.stuck(homeless.as_ref(), sets)?;
                    found.of_states(&stuck, &mut machine, sets)
                }
            })
            .collect()
    }
}

/// States that meet a goal, whatever delays do, and those that may.
struct Meeting {
    certain: Bdd,
    possible: Bdd,
}

/// Which ways of time are looked at.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Time {
    /// Any.
    Any,
    /// All delays that run are over, or none.
    Sure,
}

impl Found {
    fn new(relation: Relation) -> Found {
        let no = relation.bits.all.mk_false();
        let start = relation.start.clone();
        Found {
            relation,
            reached: no.clone(),
            rings: Vec::new(),
            heads: vec![start],
            livelocked: no.clone(),
            all_heads: no,
        }
    }

    /// All states, ring by ring.
    fn explore(&mut self, program: &Program, sets: &mut Sets) -> Result<(), Halt> {
        let most = program.repeat.and_then(|repeat| repeat.limit).map_or(u32::MAX, |limit| limit.bound);
        let mut enter = std::mem::take(&mut self.heads).remove(0);
        loop {
            sets.depth = self.rings.len();
            let (met, ended) = self.reactions(enter, most, sets)?;
            self.heads.push(met);
            let ring = sets.minus(&ended, &self.reached)?;
            self.reached = sets.or(&self.reached, &ring)?;
            let is_last = ring.is_false();
            self.rings.push(ring);
            if is_last {
                break;
            }
            enter = self.begin(&self.rings[self.rings.len() - 1], sets)?;
        }
        if program.repeat.is_some_and(|repeat| repeat.limit.is_some()) {
            self.find_livelocks(program, sets)?;
        }
        Ok(())
    }

    /// The heads of first micro-steps after states.
    fn begin(&self, states: &Bdd, sets: &mut Sets) -> Result<Bdd, Halt> {
        let with_inputs = sets.and(states, &self.relation.allowed)?;
        let heads = self.relation.begin.image(&with_inputs, sets)?;
        sets.exists(&heads, &self.relation.ends)
    }

    /// The heads that were not met before, and the states that reactions end in.
    fn reactions(&mut self, enter: Bdd, most: u32, sets: &mut Sets) -> Result<(Bdd, Bdd), Halt> {
        let no = self.relation.bits.all.mk_false();
        let (mut met, mut ended, mut heads) = (no.clone(), no, enter);
        // What counts up without end meets no head again.
        for _ in 0..=most {
            let new = sets.minus(&heads, &self.all_heads)?;
            if new.is_false() {
                return Ok((met, ended));
            }
            self.all_heads = sets.or(&self.all_heads, &new)?;
            met = sets.or(&met, &new)?;
            let last = sets.minus(&new, &self.relation.again)?;
            let last = self.relation.last.image(&last, sets)?;
            let last = sets.exists(&last, &self.relation.asked)?;
            let last = sets.exists(&last, &self.relation.within)?;
            ended = sets.or(&ended, &last)?;
            let more = sets.and(&new, &self.relation.again)?;
            heads = self.relation.step.image(&more, sets)?;
        }
        Err(Halt::Limit(Limit::Paths))
    }

    /// What ends is what leads to a head after which nothing more is needed (R9).
    fn find_livelocks(&mut self, program: &Program, sets: &mut Sets) -> Result<(), Halt> {
        let more = sets.and(&self.all_heads, &self.relation.again)?;
        let mut new = sets.minus(&self.all_heads, &self.relation.again)?;
        let mut ends = new.clone();
        let mut longest = 1;
        while !new.is_false() {
            let before = self.relation.step.before(&new, sets)?;
            let before = sets.and(&before, &more)?;
            new = sets.minus(&before, &ends)?;
            ends = sets.or(&ends, &new)?;
            longest += u32::from(!new.is_false());
        }
        // One that would end, but not in so many micro-steps.
        if program.repeat.and_then(|repeat| repeat.limit).is_some_and(|limit| longest > limit.bound) {
            return Err(Halt::Limit(Limit::Paths));
        }
        self.livelocked = sets.minus(&self.all_heads, &ends)?;
        Ok(())
    }

    fn count(&self) -> f64 {
        let unused = self.relation.bits.all.num_vars() as usize - self.relation.kept.len();
        (self.reached.exact_cardinality() >> unused).to_string().parse().unwrap_or(f64::INFINITY)
    }

    /// The states with a reaction that ends in one of these.
    fn before(&self, states: &Bdd, time: Time, sets: &mut Sets) -> Result<Bdd, Halt> {
        let ending = self.ending_in(states, sets)?;
        let before = self.relation.begin.before(&ending, sets)?;
        let before = sets.and(&before, &self.relation.allowed)?;
        let before = match time {
            Time::Any => before,
            Time::Sure => {
                let all = |over: bool| self.relation.ends.iter().map(|v| (*v, over)).collect::<Vec<_>>();
                let (over, running) = (before.restrict(&all(true)), before.restrict(&all(false)));
                sets.or(&over, &running)?
            }
        };
        let before = sets.exists(&before, &self.relation.asked)?;
        sets.and(&before, &self.reached)
    }

    /// The heads from which a reaction ends in one of these states.
    fn ending_in(&self, states: &Bdd, sets: &mut Sets) -> Result<Bdd, Halt> {
        let last = self.relation.last.before(states, sets)?;
        let mut new = sets.minus(&last, &self.relation.again)?;
        new = sets.and(&new, &self.all_heads)?;
        let mut ending = new.clone();
        while !new.is_false() {
            let before = self.relation.step.before(&new, sets)?;
            let before = sets.and(&before, &self.relation.again)?;
            let before = sets.and(&before, &self.all_heads)?;
            new = sets.minus(&before, &ending)?;
            ending = sets.or(&ending, &new)?;
        }
        Ok(ending)
    }

    /// The states from which one of these can be reached.
    fn leading_to(&self, states: &Bdd, time: Time, sets: &mut Sets) -> Result<Bdd, Halt> {
        let (mut all, mut new) = (states.clone(), states.clone());
        while !new.is_false() {
            let before = self.before(&new, time, sets)?;
            new = sets.minus(&before, &all)?;
            all = sets.or(&all, &new)?;
        }
        Ok(all)
    }

    fn homeless(&self, sets: &mut Sets) -> Result<Meeting, Halt> {
        let Some(first) = self.rings.first() else {
            let no = self.relation.bits.all.mk_false();
            return Ok(Meeting { certain: no.clone(), possible: no });
        };
        let home = self.with_situation_of(first, sets)?;
        let home = sets.and(&home, &self.reached)?;
        let mut away = |time| {
            let returns = self.leading_to(&home, time, sets)?;
            sets.minus(&self.reached, &returns)
        };
        let certain = away(Time::Any)?;
        let possible = if self.relation.ends.is_empty() { certain.clone() } else { away(Time::Sure)? };
        Ok(Meeting { certain, possible })
    }

    /// The states in a situation that one of these has. What holds the situation is kept, all else is left open.
    fn with_situation_of(&self, states: &Bdd, sets: &mut Sets) -> Result<Bdd, Halt> {
        let mut holds = std::collections::HashSet::new();
        self.relation.active.iter().for_each(|active| holds.extend(active.support_set()));
        let others: Vec<_> = self.relation.kept.iter().filter(|v| !holds.contains(v)).copied().collect();
        sets.exists(states, &others)
    }

    /// The states from which no other situation can be reached. One that is not homeless can leave its situation if that is
    /// none of the start.
    fn stuck(&self, homeless: Option<&Meeting>, sets: &mut Sets) -> Result<Meeting, Halt> {
        let certain = self.stuck_in(homeless.map(|homeless| &homeless.certain), Time::Any, sets)?;
        let possible = if self.relation.ends.is_empty() {
            certain.clone()
        } else {
            self.stuck_in(homeless.map(|homeless| &homeless.possible), Time::Sure, sets)?
        };
        Ok(Meeting { certain, possible })
    }

    fn stuck_in(&self, homeless: Option<&Bdd>, time: Time, sets: &mut Sets) -> Result<Bdd, Halt> {
        let mut rest = self.reached.clone();
        if let (Some(homeless), Some(first)) = (homeless, self.rings.first()) {
            let home = self.with_situation_of(first, sets)?;
            let home = sets.and(&home, &self.reached)?;
            rest = sets.or(&home, homeless)?;
        }
        let looked_at = rest.clone();
        for active in &self.relation.active {
            for (here, there) in [(active.clone(), active.not()), (active.not(), active.clone())] {
                let may_move = sets.and(&rest, &here)?;
                if may_move.is_false() {
                    continue;
                }
                let there = sets.and(&self.reached, &there)?;
                let before = self.before(&there, time, sets)?;
                let moves = sets.and(&may_move, &before)?;
                rest = sets.minus(&rest, &moves)?;
            }
        }
        // What does not move in one reaction may in several, all in one situation.
        let mut alive = sets.minus(&looked_at, &rest)?;
        if homeless.is_some() {
            let others = sets.minus(&self.reached, &looked_at)?;
            alive = sets.or(&alive, &others)?;
        }
        while !rest.is_false() {
            let before = self.before(&alive, time, sets)?;
            let moves = sets.and(&rest, &before)?;
            if moves.is_false() {
                break;
            }
            rest = sets.minus(&rest, &moves)?;
            alive = moves;
        }
        Ok(rest)
    }

    /// The way to a state in which no inputs are allowed.
    fn barred(&self, machine: &mut Machine, sets: &mut Sets) -> Result<Option<Way>, Halt> {
        if self.relation.start.is_false() {
            return Ok(Some(Way::new()));
        }
        let open = sets.exists(&self.relation.allowed, &self.relation.asked)?;
        for (depth, ring) in self.rings.iter().enumerate() {
            let here = sets.minus(ring, &open)?;
            if !here.is_false() {
                return Ok(Some(self.way_to_state(depth, &here, machine, sets)?));
            }
        }
        Ok(None)
    }

    fn of_states(&self, met: &Meeting, machine: &mut Machine, sets: &mut Sets) -> Result<Finding, Halt> {
        if met.certain.is_false() {
            return Ok(if met.possible.is_false() { Finding::Never } else { Finding::Open(Reason::Delays) });
        }
        for (depth, ring) in self.rings.iter().enumerate() {
            let here = sets.and(ring, &met.certain)?;
            if !here.is_false() {
                return Ok(Finding::Met(self.way_to_state(depth, &here, machine, sets)?));
            }
        }
        Ok(Finding::Never)
    }

    fn of_fact(&self, fact: Fact, machine: &mut Machine, sets: &mut Sets) -> Result<Finding, Halt> {
        for (_, inputs) in self.relation.at_start.iter().filter(|(other, _)| *other == fact) {
            let here = sets.and(&self.relation.start, inputs)?;
            if !here.is_false() {
                return Ok(Finding::Met(self.way_to_head(0, &here, machine, sets)?));
            }
        }
        let seen: Vec<&Bdd> = match fact {
            Fact::Livelock => vec![&self.livelocked],
            _ => self.relation.facts.iter().filter(|(other, _)| *other == fact).map(|(_, seen)| seen).collect(),
        };
        for (depth, heads) in self.heads.iter().enumerate() {
            for seen in &seen {
                let here = sets.and(heads, seen)?;
                if !here.is_false() {
                    return Ok(Finding::Met(self.way_to_head(depth, &here, machine, sets)?));
                }
            }
        }
        Ok(Finding::Never)
    }
}

impl Engine for Symbolic<'_> {
    fn find(&mut self, goals: &[Goal], stop: Stop) -> Result<Vec<Finding>, Beyond> {
        let mut sets = Sets::new(stop, MOST_NODES);
        match self.search(goals, &mut sets) {
            Ok(findings) => Ok(findings),
            Err(Halt::Beyond(beyond)) => Err(beyond),
            Err(Halt::Limit(limit)) => {
                self.searched.limit = Some(limit);
                Ok(goals.iter().map(|_| Finding::Open(Reason::Limit(limit))).collect())
            }
        }
    }

    fn searched(&self) -> Searched {
        self.searched
    }

    fn barred(&self) -> Option<&Way> {
        self.barred.as_ref()
    }
}
