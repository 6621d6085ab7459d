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
//! | `counters` | numbers that count on |
//! | `parts` | more states than there are, part by part |
//! | `updates` | what moves a set of states on, or back |
//! | `relation` | a reaction as relations |
//! | `found` | all states, ring by ring |
//! | `back` | what leads to what |
//! | `way` | ways to what was found |

mod back;
mod bits;
mod counters;
mod found;
mod number;
mod order;
mod parts;
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
use back::Meeting;
use counters::Counters;
use found::{Found, Looking, Reactions};
use grafc_logic::scan::Program;
use parts::Parts;
use relation::Relation;
use rustc_hash::FxHashMap;
use sets::{Halt, Sets};

/// At most so many nodes in a diagram.
const MOST_NODES: usize = 3_000_000;

/// So many nodes may be made in all before numbers that count on are looked at only as far as they count.
const MOST_EXACT: usize = 4_000_000;

/// So many nodes may be made to look at them so for all that a chart does at once.
const MOST_WIDE: usize = 10_000_000;

/// The engine.
pub(crate) struct Symbolic<'p> {
    program: &'p Program,
    /// Asked for what happens or not before all states are looked for to the end.
    aid: Option<&'p mut dyn Engine>,
    searched: Searched,
    barred: Option<Way>,
    findings: FxHashMap<Goal, Finding>,
}

impl<'p> Symbolic<'p> {
    /// For a program that shows its transitions.
    pub(crate) fn new(program: &'p Program) -> Self {
        let searched = Searched { states: 0.0, limit: Some(Limit::Nodes) };
        Symbolic { program, aid: None, searched, barred: None, findings: FxHashMap::default() }
    }

    /// With another engine, which is asked for facts where it takes long to know all states.
    pub(crate) fn aided(program: &'p Program, aid: &'p mut dyn Engine) -> Self {
        Symbolic { aid: Some(aid), ..Symbolic::new(program) }
    }

    /// Finds what it can; what is found before a limit is hit is kept.
    fn search(&mut self, goals: &[Goal], sets: &mut Sets) -> Result<(), Halt> {
        let program = self.program;
        let mut machine = Machine::by_bits(self.program)?;
        let mut found = Found::new(Relation::new(program, sets)?, program);
        let facts = goals.iter().filter_map(|goal| match goal {
            Goal::Fact(Fact::Livelock) | Goal::Stuck | Goal::Homeless | Goal::Lost(_) => None,
            Goal::Fact(fact) => Some(*fact),
        });
        let mut looking = Looking { machine: &mut machine, facts: facts.collect(), findings: &mut self.findings };
        let counters = Counters::new(program, &found.relation.bits, sets)?;
        let explored = found.explore(MOST_EXACT, &mut looking, sets);
        self.searched.states = found.count();
        if !explored? {
            let mut unseen = std::mem::take(&mut looking.facts);
            match self.by_parts(goals, &mut found, &counters, &mut unseen, sets) {
                // It may be that all states take less.
                Ok(()) | Err(Halt::Limit(Limit::Nodes)) => {}
                Err(other) => return Err(other),
            }
            self.ask_aid(goals, sets);
            unseen.retain(|fact| !self.findings.contains_key(&Goal::Fact(*fact)));
            let left: Vec<Goal> = goals.iter().filter(|goal| !self.findings.contains_key(goal)).copied().collect();
            // Where inputs may be missing, it must be known whether that is in a state that there is.
            if left.is_empty() && sets.exists(&found.relation.allowed, &found.relation.asked)?.is_true() {
                self.searched.limit = Some(Limit::Enough);
                return Ok(());
            }
            let mut looking = Looking { machine: &mut machine, facts: unseen, findings: &mut self.findings };
            if !counters.is_empty() {
                found.widen(counters);
                self.searched.limit = Some(Limit::Numbers);
                if !found.explore(MOST_WIDE, &mut looking, sets)? {
                    return Err(Halt::Limit(Limit::Numbers));
                }
                looking.none_is_left();
                if !found.is_endless {
                    self.findings.insert(Goal::Fact(Fact::Livelock), Finding::Never);
                }
                return self.of_wider(&left, &found, sets);
            }
            let explored = found.explore(usize::MAX, &mut looking, sets);
            self.searched.states = found.count();
            explored?;
            looking.none_is_left();
        } else {
            looking.none_is_left();
        }
        self.searched.limit = None;
        self.barred = found.barred(&mut machine, sets)?;
        let livelock = Goal::Fact(Fact::Livelock);
        let goals: Vec<Goal> = goals.iter().filter(|goal| !self.findings.contains_key(goal)).copied().collect();
        if goals.contains(&livelock) {
            let finding = found.endless(&mut machine, sets)?;
            self.findings.insert(livelock, finding);
        }
        if goals.iter().all(|goal| matches!(goal, Goal::Fact(_))) {
            return Ok(());
        }
        let all = found.all_reactions(sets)?;
        let mut homeless = None;
        if goals.contains(&Goal::Homeless) {
            let meeting = found.homeless(&all, sets)?;
            self.findings.insert(Goal::Homeless, found.of_states(&meeting, &mut machine, sets)?);
            homeless = Some(meeting);
        }
        for goal in &goals {
            let finding = match goal {
                Goal::Lost(place) => found.lost(*place, &all, &mut machine, sets)?,
                Goal::Stuck => {
                    let stuck = found.stuck(homeless.as_ref(), &all, sets)?;
                    found.of_states(&stuck, &mut machine, sets)?
                }
                Goal::Fact(_) | Goal::Homeless => continue,
            };
            self.findings.insert(*goal, finding);
        }
        Ok(())
    }
}

impl Symbolic<'_> {
    /// What the other engine finds of facts.
    fn ask_aid(&mut self, goals: &[Goal], sets: &mut Sets) {
        let is_open = |goal: &&Goal| matches!(goal, Goal::Fact(_)) && !self.findings.contains_key(goal);
        let left: Vec<Goal> = goals.iter().filter(is_open).copied().collect();
        let Some(aid) = self.aid.take().filter(|_| !left.is_empty()) else { return };
        // What it cannot follow it leaves.
        let Ok(found) = aid.find(&left, sets.stop()) else { return };
        let decided = left.into_iter().zip(found).filter(|(_, finding)| !matches!(finding, Finding::Open(_)));
        self.findings.extend(decided);
    }

    /// Part by part it is soon known what never happens.
    fn by_parts(
        &mut self,
        goals: &[Goal],
        found: &mut Found,
        counters: &Counters,
        facts: &mut Vec<Fact>,
        sets: &mut Sets,
    ) -> Result<(), Halt> {
        let parts = Parts::new(&found.relation, counters, sets)?;
        let mut unseen = Vec::new();
        for fact in facts.iter() {
            let never = found.relation.facts.get(fact).map_or(Ok(true), |seen| parts.never(seen, sets))?;
            if never {
                self.findings.insert(Goal::Fact(*fact), Finding::Never);
            } else {
                unseen.push(*fact);
            }
        }
        *facts = unseen;
        let reached = std::mem::replace(&mut found.reached, parts.states(sets)?);
        found.is_wide = true;
        let done = self.of_wider(goals, found, sets);
        (found.reached, found.is_wide) = (reached, false);
        done
    }

    /// From where there is a way in more states than there are, there is one.
    fn of_wider(&mut self, goals: &[Goal], found: &Found, sets: &mut Sets) -> Result<(), Halt> {
        let is_of_states = |goal: &&Goal| !matches!(goal, Goal::Fact(_));
        if !goals.iter().any(|goal| is_of_states(&goal)) || !found.no_inputs(sets)?.is_false() {
            return Ok(());
        }
        let all = found.all_reactions(sets)?;
        let homeless = found.homeless(&all, sets)?;
        for goal in goals.iter().filter(is_of_states) {
            let is_never = match goal {
                Goal::Homeless => homeless.possible.is_false(),
                Goal::Stuck => found.stuck(Some(&homeless), &all, sets)?.possible.is_false(),
                // A reaction that does not end would lose it.
                Goal::Lost(place) => {
                    self.findings.get(&Goal::Fact(Fact::Livelock)) == Some(&Finding::Never)
                        && found.is_never_lost(*place, &all, sets)?
                }
                Goal::Fact(_) => false,
            };
            if is_never {
                self.findings.insert(*goal, Finding::Never);
            }
        }
        Ok(())
    }
}

impl Found {
    /// The states in which no inputs are allowed.
    fn no_inputs(&self, sets: &mut Sets) -> Result<biodivine_lib_bdd::Bdd, Halt> {
        let open = sets.exists(&self.relation.allowed, &self.relation.asked)?;
        sets.minus(&self.reached, &open)
    }

    /// The way to a state in which no inputs are allowed.
    fn barred(&self, machine: &mut Machine, sets: &mut Sets) -> Result<Option<Way>, Halt> {
        if self.relation.start.is_false() {
            return Ok(Some(Way::new()));
        }
        let open = sets.exists(&self.relation.allowed, &self.relation.asked)?;
        for (depth, ring) in self.layers.rings.iter().enumerate() {
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
        for (depth, ring) in self.layers.rings.iter().enumerate() {
            let here = sets.and(ring, &met.certain)?;
            if !here.is_false() {
                return Ok(Finding::Met(self.way_to_state(depth, &here, machine, sets)?));
            }
        }
        Ok(Finding::Never)
    }

    /// A reaction that does not end.
    fn endless(&self, machine: &mut Machine, sets: &mut Sets) -> Result<Finding, Halt> {
        let endless = self.layers.reactions.iter().enumerate().find(|(_, reactions)| reactions.is_endless);
        let Some((depth, Reactions { heads, .. })) = endless else { return Ok(Finding::Never) };
        let last = heads.len() - 1;
        let endless = sets.and(&heads[last], &self.relation.again)?;
        Ok(Finding::Met(self.way_to_head(depth, last, &endless, machine, sets)?))
    }
}

impl Engine for Symbolic<'_> {
    fn find(&mut self, goals: &[Goal], stop: Stop) -> Result<Vec<Finding>, Beyond> {
        let mut sets = Sets::new(stop, MOST_NODES);
        let mut limit = Limit::Nodes;
        match self.search(goals, &mut sets) {
            Ok(()) => {}
            Err(Halt::Beyond(beyond)) => return Err(beyond),
            Err(Halt::Limit(hit)) => {
                limit = hit;
                self.searched.limit = Some(hit);
            }
        }
        let of = |goal| self.findings.remove(goal).unwrap_or(Finding::Open(Reason::Limit(limit)));
        Ok(goals.iter().map(of).collect())
    }

    fn searched(&self) -> Searched {
        self.searched
    }

    fn barred(&self) -> Option<&Way> {
        self.barred.as_ref()
    }
}
