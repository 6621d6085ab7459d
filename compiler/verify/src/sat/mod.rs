//! The engine that asks a solver of clauses (SAT): a walk that it leads, induction, and bounded search.
//!
//! ```text
//! Watched ─ walk ─▶ what happens, and places ─ candidates ─ induction ─▶ what never does ─ bounded ─▶ short ways to the rest
//! ```
//!
//! It works on the circuit of the program, whose clocks are micro-steps, with one variable of the solver for each
//! conjunction of a clock. What it finds to happen the machine has done; what it finds never to happen is proved for all
//! clocks, with delays free and without the bound on micro-steps, which is more than there is. That every state can be left,
//! and leads home, it may prove; that one cannot, and what leads to what, it leaves to others.
//!
//! | file | what |
//! | --- | --- |
//! | `frames` | clocks as clauses |
//! | `run` | clocks with truth values, 64 cases at once |
//! | `walk` | what happens, in real times |
//! | `candidates` | what may always hold, and help |
//! | `induction` | what always holds |
//! | `ways_out` | that every state can be left |
//! | `bounded` | the fewest micro-steps to something |
//! | `by_hand` | small circuits for tests |

mod bounded;
#[cfg(test)]
mod by_hand;
mod candidates;
mod frames;
mod induction;
mod run;
mod walk;
mod ways_out;

use crate::beyond::Beyond;
use crate::budget::Budget;
use crate::circuit::{self, Literal, Watched, watched};
use crate::facts::Fact;
use crate::goal::{Engine, Finding, Goal, Reason, Searched, Stop, Way};
use crate::limit::Limit;
use bounded::Bounded;
use candidates::{Samples, of_tokens};
use grafc_logic::scan::Program;
use induction::Induction;
use run::Run;
use rustc_hash::{FxHashMap, FxHashSet};
use std::collections::BTreeSet;
use walk::Walked;
use ways_out::Out;

/// So much may be done in walks, in inductions, in bounded search, and for ways out; and for one question in a walk.
const WALK: u64 = 6_000_000;
const INDUCTION: u64 = 6_000_000;
const BOUNDED: u64 = 2_000_000;
const WAYS_OUT: u64 = 6_000_000;
const WAYS_OUT_SOON: u64 = 2_500_000;
const QUESTION: u64 = 20_000;

/// A first walk ends soon, where nothing new is near; where that is all that is left, a second one goes on.
const SOON: usize = 3;
const LATE: usize = 12;

/// So many clocks in a row are held before the next one is asked for.
const MOST_CLOCKS: usize = 4;

/// A call is asked to come to rest within so many micro-steps.
const MOST_MICRO_STEPS: usize = 48;

/// So many clocks are searched.
const DEEPEST: usize = 64;

/// How far it goes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Reach {
    /// It walks.
    Walk,
    /// It walks, and proves what tokens prove.
    Short,
    /// It does all that it can.
    All,
}

/// The engine.
pub(crate) struct Sat<'p> {
    program: &'p Program,
    reach: Reach,
    /// Whether it was asked anything.
    pub(crate) was_asked: bool,
    /// Whether the assumptions are known to allow some inputs in every state.
    pub(crate) allows_inputs: bool,
    searched: Searched,
    barred: Option<Way>,
    findings: FxHashMap<Goal, Finding>,
}

impl<'p> Sat<'p> {
    /// For a program that shows its transitions.
    pub(crate) fn new(program: &'p Program) -> Self {
        let searched = Searched { states: 0.0, limit: Some(Limit::Depth) };
        let (reach, was_asked, allows_inputs) = (Reach::All, false, false);
        Sat { program, reach, was_asked, allows_inputs, searched, barred: None, findings: FxHashMap::default() }
    }

    /// One that finds out what does not take long.
    pub(crate) fn in_short(program: &'p Program) -> Self {
        Sat { reach: Reach::Short, ..Sat::new(program) }
    }

    /// One that only walks, in real times.
    pub(crate) fn that_walks(program: &'p Program) -> Self {
        Sat { reach: Reach::Walk, ..Sat::new(program) }
    }

    fn search(&mut self, goals: &[Goal], budget: &Budget) -> Result<(), Beyond> {
        let mut watched = watched(self.program).map_err(|beyond| match beyond {
            circuit::Beyond::Real(name) => Beyond::Real(name),
            circuit::Beyond::Duration(name) => Beyond::Duration(name),
        })?;
        let wanted = |fact: &Fact| is_among(goals, *fact);
        let sought: Vec<(Fact, Literal)> = watched.facts.iter().filter(|(fact, _)| wanted(fact)).copied().collect();
        // What nothing in the circuit shows does not happen; that of a reaction nothing shows at a clock.
        let shown: FxHashSet<Fact> = watched.facts.iter().map(|(fact, _)| *fact).collect();
        let is_shown = |fact: &Fact| *fact == Fact::Livelock || shown.contains(fact);
        for goal in goals {
            if let Goal::Fact(fact) = goal
                && !is_shown(fact)
            {
                self.findings.insert(*goal, Finding::Never);
            }
        }
        let tokens = of_tokens(self.program, &mut watched);

        budget.allow(WALK, QUESTION);
        // What is near leads to what is far, also where it is known.
        let is_near = |fact: &Fact| wanted(fact) || needs_no_way(*fact);
        let near: Vec<(Fact, Literal)> = watched.facts.iter().filter(|(fact, _)| is_near(fact)).copied().collect();
        let walked = walk::walk(self.program, &watched, &near, (Walked::default(), SOON), budget)?;
        self.take(&walked, goals);
        if self.reach == Reach::Walk {
            return Ok(());
        }

        let places: Vec<Vec<u64>> = walked.places.iter().map(|place| place.latches.clone()).collect();
        let samples = Samples::new(&watched, &places);
        let tokens = samples.agree(&watched, tokens);
        let [firsts, pairs] = samples.of_pairs(&mut watched);
        let home = home(&mut watched, &walked);
        let watched = watched;
        // What was seen, but needs a short way, is looked for again.
        let needs_more = |fact: &Fact| self.findings.get(&Goal::Fact(*fact)) != Some(&Finding::Happens);
        let open: Vec<(Fact, Literal)> = sought.iter().filter(|(fact, _)| needs_more(fact)).copied().collect();
        let mut bounded = Bounded::new(self.program, &watched, &open, budget)?;
        if bounded.starts() == Some(false) {
            self.barred = Some(Way::new());
            return Ok(());
        }
        budget.allow(INDUCTION, INDUCTION);
        let mut induction = Induction::new(&watched, budget);
        self.prove(goals, [[tokens, firsts].concat(), pairs], &mut induction, &mut bounded)?;
        let ways_out = if self.reach == Reach::Short { WAYS_OUT_SOON } else { WAYS_OUT };
        budget.allow(ways_out, ways_out);
        self.leave(goals, home, &watched, &induction, budget);
        if self.reach == Reach::Short {
            return Ok(());
        }

        let is_open = |fact: &Fact| !self.findings.contains_key(&Goal::Fact(*fact));
        let open: Vec<(Fact, Literal)> = sought.iter().filter(|(fact, _)| is_open(fact)).copied().collect();
        if !open.is_empty() {
            budget.allow(WALK, QUESTION);
            let walked = walk::walk(self.program, &watched, &open, (walked, LATE), budget)?;
            self.take(&walked, goals);
        }
        budget.allow(BOUNDED, BOUNDED);
        while bounded.left().next().is_some() && bounded.clear < DEEPEST && !budget.is_over() {
            budget.depth.set(bounded.clear);
            if !bounded.look()? {
                break;
            }
        }
        for (fact, way) in std::mem::take(&mut bounded.met) {
            let goal = Goal::Fact(fact);
            let is_shorter = match self.findings.get(&goal) {
                None => is_among(goals, fact),
                Some(Finding::Met(other)) => way.len() < other.len(),
                Some(Finding::Never | Finding::Happens | Finding::Open(_)) => false,
            };
            if is_shorter {
                self.findings.insert(goal, Finding::Met(way));
            }
        }
        Ok(())
    }

    /// What a walk has shown.
    fn take(&mut self, walked: &Walked, goals: &[Goal]) {
        self.searched.states = walked.places.len() as f64;
        for fact in walked.met() {
            let goal = Goal::Fact(fact);
            if !is_among(goals, fact) || self.findings.contains_key(&goal) {
                continue;
            }
            let way = if needs_no_way(fact) { Some(Finding::Happens) } else { walked.way(fact).map(Finding::Met) };
            self.findings.extend(way.map(|finding| (goal, finding)));
        }
    }

    /// Proves what it can.
    fn prove(
        &mut self,
        goals: &[Goal],
        guesses: [Vec<Literal>; 2],
        induction: &mut Induction,
        bounded: &mut Bounded,
    ) -> Result<(), Beyond> {
        let [tokens, pairs] = guesses;
        let mut guesses = tokens;
        for more in [pairs, Vec::new()] {
            // Samples hold all that is there at the start.
            let Some(kept) = induction.kept(&guesses, 1) else { return Ok(()) };
            let (mut proved, mut left) = (Vec::new(), Vec::new());
            guesses.iter().zip(kept).for_each(|(guess, kept)| if kept { &mut proved } else { &mut left }.push(*guess));
            proved.into_iter().for_each(|guess| induction.proved(guess));
            for clocks in 0..=MOST_CLOCKS {
                self.facts(induction, bounded, clocks)?;
            }
            self.ends(goals, induction);
            if self.reach == Reach::Short || self.is_done(goals) {
                return Ok(());
            }
            guesses = [left, more].concat();
        }
        Ok(())
    }

    /// Proves that every state can be left, and leads home.
    fn leave(&mut self, goals: &[Goal], home: Literal, watched: &Watched, induction: &Induction, budget: &Budget) {
        for (goal, out) in [(Goal::Stuck, Out::Moved), (Goal::Homeless, Out::Home(home))] {
            if goals.binary_search(&goal).is_err() {
                continue;
            }
            // What cannot be left is further from home.
            if ways_out::always(watched, out, induction.known(), self.bound(), budget) != Some(true) {
                return;
            }
            self.findings.insert(goal, Finding::Never);
            // A way out begins with inputs that are allowed.
            self.allows_inputs |= goal == Goal::Stuck;
        }
    }

    /// At most so many micro-steps are a reaction.
    fn bound(&self) -> usize {
        let limit = self.program.repeat.and_then(|repeat| repeat.limit);
        limit.map_or(usize::MAX, |limit| limit.bound as usize)
    }

    /// Whether all is known that can be.
    fn is_done(&self, goals: &[Goal]) -> bool {
        goals.iter().all(|goal| !matches!(goal, Goal::Fact(_)) || self.findings.contains_key(goal))
    }

    /// Proves that every reaction ends.
    fn ends(&mut self, goals: &[Goal], induction: &mut Induction) {
        let livelock = Goal::Fact(Fact::Livelock);
        if !is_among(goals, Fact::Livelock) || self.findings.contains_key(&livelock) {
            return;
        }
        for clocks in 1..=MOST_MICRO_STEPS.min(self.bound()) {
            match induction.ends_within(clocks) {
                Some(true) => {
                    self.findings.insert(livelock, Finding::Never);
                    return;
                }
                Some(false) => {}
                None => return,
            }
        }
    }

    /// Proves facts never to be seen, which are not in the first clocks.
    fn facts(&mut self, induction: &mut Induction, bounded: &mut Bounded, clocks: usize) -> Result<(), Beyond> {
        while bounded.clear < clocks {
            if !bounded.look()? {
                return Ok(());
            }
        }
        let is_open = |fact: &Fact| !self.findings.contains_key(&Goal::Fact(*fact));
        let sought: Vec<(Fact, Literal)> = bounded.left().filter(|(fact, _)| is_open(fact)).collect();
        if sought.is_empty() {
            return Ok(());
        }
        let claims: Vec<Literal> = sought.iter().map(|(_, seen)| !*seen).collect();
        let Some(kept) = induction.kept(&claims, clocks) else { return Ok(()) };
        for ((fact, _), claim) in sought.into_iter().zip(claims).zip(kept).filter_map(|(of, kept)| kept.then_some(of)) {
            induction.proved(claim);
            bounded.drop(fact);
            self.findings.insert(Goal::Fact(fact), Finding::Never);
        }
        Ok(())
    }
}

/// Where the chart is in a situation that the initial reaction was seen to end in.
fn home(watched: &mut Watched, walked: &Walked) -> Literal {
    let mut run = Run::new(watched);
    let mut situations: BTreeSet<Vec<bool>> = BTreeSet::new();
    for latches in walked.starts() {
        run.latches = latches;
        run.look(&[]);
        situations.insert(watched.standing.iter().map(|step| run.of(*step) & 1 == 1).collect());
    }
    let (graph, standing) = (&mut watched.circuit.graph, &watched.standing);
    let mut home = Literal::FALSE;
    for situation in situations {
        let steps = standing.iter().zip(situation).map(|(step, active)| if active { *step } else { !*step });
        let here = graph.all(steps);
        home = graph.or(home, here);
    }
    home
}

/// Whether a fact is among goals, which are in order.
fn is_among(goals: &[Goal], fact: Fact) -> bool {
    goals.binary_search(&Goal::Fact(fact)).is_ok()
}

/// Of what is wanted it need not be shown how it comes about.
fn needs_no_way(fact: Fact) -> bool {
    match fact {
        Fact::Active(_) | Fact::Cleared(_) | Fact::Wanted(_) => true,
        Fact::Selection(_)
        | Fact::Reentry(_)
        | Fact::AllocConflict
        | Fact::ForceConflict
        | Fact::Livelock
        | Fact::Broken(_) => false,
    }
}

impl Engine for Sat<'_> {
    fn find(&mut self, goals: &[Goal], stop: Stop) -> Result<Vec<Finding>, Beyond> {
        self.was_asked = true;
        let budget = Budget::new(stop);
        let mut sorted = goals.to_vec();
        sorted.sort_unstable();
        self.search(&sorted, &budget)?;
        self.searched.limit = budget.limit().or(Some(Limit::Depth));
        let limit = budget.limit().unwrap_or(Limit::Depth);
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
