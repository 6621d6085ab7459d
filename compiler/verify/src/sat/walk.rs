//! A walk in real times that a solver leads: from a state that was reached it is asked for inputs that show something not
//! seen before. What is seen has been done by the machine, at times that a clock can show.

use super::frames::{Begin, Frames};
use super::run::Run;
use crate::atom::Atom;
use crate::beyond::Beyond;
use crate::budget::Budget;
use crate::circuit::{Literal, Watched};
use crate::facts::Fact;
use crate::goal::{Answers, Way};
use crate::machine::{End, Machine};
use crate::pack::State;
use crate::times;
use batsat::Lit;
use grafc_logic::scan::Program;
use indexmap::IndexMap;
use rustc_hash::{FxBuildHasher, FxHashMap};

/// So many clocks are looked ahead, and so many at most.
const NEAR: usize = 4;
const FAR: usize = 12;

/// So many places are kept to go on from.
const KEPT: usize = 64;

/// A place that was reached.
#[derive(Clone)]
pub(super) struct Place {
    /// What the latches hold.
    pub(super) latches: Vec<u64>,
    /// The state; none before the start.
    state: Option<State>,
    /// The reaction that led to it.
    row: Option<usize>,
    /// In milliseconds.
    now: i64,
    /// When each timer began, if it runs.
    began: Vec<i64>,
}

/// A reaction.
struct Row {
    before: Option<usize>,
    answers: Answers,
}

/// What was found.
#[derive(Default)]
pub(super) struct Walked {
    /// The reactions, each after the one before it.
    rows: Vec<Row>,
    /// In which reaction each fact was seen first.
    met: IndexMap<Fact, usize, FxBuildHasher>,
    /// Places that were reached, for samples.
    pub(super) places: Vec<Place>,
}

struct Walk<'w, 'c, 'b, 's> {
    watched: &'c Watched,
    machine: Machine<'w>,
    run: Run<'c>,
    frames: Frames<'c, 'b, 's>,
    budget: &'b Budget<'s>,
    rng: fastrand::Rng,
    found: Walked,
    /// Whether each fact that is looked for was not seen yet.
    unseen: IndexMap<Fact, (Literal, Lit), FxBuildHasher>,
    /// That something is seen at a clock.
    shows: Vec<Lit>,
}

/// Walks on from what was found so far, until so often in a row nothing new is found.
pub(super) fn walk<'c, 'b, 's>(
    program: &Program,
    watched: &'c Watched,
    sought: &[(Fact, Literal)],
    (found, most_stale): (Walked, usize),
    budget: &'b Budget<'s>,
) -> Result<Walked, Beyond> {
    let mut machine = Machine::by_bits(program)?;
    machine.look_on();
    let mut frames = Frames::new(watched, Begin::Anywhere, budget);
    let unseen = sought.iter().map(|(fact, seen)| (*fact, (*seen, frames.free()))).collect();
    let run = Run::new(watched);
    let began = vec![0; watched.timers.len()];
    let first = Place { latches: run.initial(), state: None, row: None, now: 0, began };
    let step = found.places.len().div_ceil(KEPT - 1).max(1);
    let kept = std::iter::once(first).chain(found.places.iter().step_by(step).cloned()).collect();
    let rng = fastrand::Rng::with_seed(1);
    let mut walk = Walk { watched, machine, run, frames, budget, rng, found, unseen, shows: Vec::new() };
    walk.all(kept, most_stale)?;
    walk.found.keep_what_times_allow(program)?;
    Ok(walk.found)
}

impl Walk<'_, '_, '_, '_> {
    fn all(&mut self, mut kept: Vec<Place>, most_stale: usize) -> Result<(), Beyond> {
        let (mut place, mut stale) = (kept[kept.len() - 1].clone(), 0);
        while !self.unseen.is_empty() && stale < most_stale && !self.budget.is_over() {
            let left = self.unseen.len();
            let far = (NEAR + stale).min(FAR);
            if let Some(next) = self.led(&place, far)? {
                place = next;
            }
            if self.unseen.len() < left {
                stale = 0;
                if kept.len() >= KEPT {
                    kept.swap_remove(self.rng.usize(1..KEPT));
                }
                kept.push(place.clone());
                continue;
            }
            stale += 1;
            if stale % 2 == 0 {
                place = kept[self.rng.usize(..kept.len())].clone();
            }
            for _ in 0..stale {
                let inputs: Vec<u64> =
                    self.watched.circuit.inputs.iter().map(|_| if self.rng.bool() { u64::MAX } else { 0 }).collect();
                if let Some((next, _)) = self.react(&place, &inputs)? {
                    place = next;
                }
            }
            if self.unseen.len() < left {
                stale = 0;
            }
        }
        Ok(())
    }

    /// Goes to where something new is seen, if a solver finds that near.
    fn led(&mut self, place: &Place, far: usize) -> Result<Option<Place>, Beyond> {
        let in_time = self.in_time(place);
        for depth in 0..far {
            self.open(depth);
            let mut assumed = vec![self.shows[depth], in_time];
            for (latch, held) in self.watched.circuit.latches.iter().zip(&place.latches) {
                if let Some(lit) = self.frames.asked(0, latch.now) {
                    assumed.push(if held & 1 == 1 { lit } else { !lit });
                }
            }
            match self.frames.solve(&assumed) {
                Some(false) => continue,
                None => break,
                Some(true) => {}
            }
            let inputs: Vec<Vec<u64>> = (0..=depth).map(|frame| self.frames.inputs(frame)).collect();
            let (mut at, mut clock) = (place.clone(), 0);
            let mut moved = false;
            while let Some(inputs) = inputs.get(clock) {
                let Some((next, clocks)) = self.react(&at, inputs)? else { break };
                (at, moved) = (next, true);
                clock += clocks;
            }
            self.frames.clause(vec![!in_time]);
            return Ok(moved.then_some(at));
        }
        self.frames.clause(vec![!in_time]);
        Ok(None)
    }

    /// The clock of this number is there, and what is new at it.
    fn open(&mut self, depth: usize) {
        while self.shows.len() <= depth {
            let frame = self.shows.len();
            self.frames.open(frame + 1);
            let shows = self.frames.free();
            let mut one_of = vec![!shows];
            for (seen, is_unseen) in self.unseen.values() {
                let seen = self.frames.literal(frame, *seen);
                let here = self.frames.free();
                self.frames.clause(vec![!here, seen]);
                self.frames.clause(vec![!here, *is_unseen]);
                one_of.push(here);
            }
            self.frames.clause(one_of);
            self.shows.push(shows);
        }
    }

    /// Delays that run at a place, with what is left of each: its end, at the first clock.
    fn pending(&self, place: &Place) -> Vec<(i64, usize, i64)> {
        let mut pending = Vec::new();
        for (t, timing) in self.watched.timers.iter().enumerate() {
            if place.latches[timing.on] & 1 == 0 {
                continue;
            }
            let of_it = timing.times.iter().filter(|(_, passed)| place.latches[*passed] & 1 == 0);
            pending.extend(of_it.map(|(ms, _)| (place.began[t] + ms - place.now, timing.operand, *ms)));
        }
        pending.sort_unstable();
        pending.dedup();
        pending
    }

    fn ends(&self, operand: usize, ms: i64) -> Option<Literal> {
        let at = self.watched.atoms.binary_search_by_key(&Atom::Ends(operand, ms), |(atom, _)| *atom).ok()?;
        Some(self.watched.atoms[at].1)
    }

    /// What says that at the first clock delays end as they can: what is over soonest, first.
    fn in_time(&mut self, place: &Place) -> Lit {
        let in_time = self.frames.free();
        self.frames.open(1);
        let mut before: Option<(i64, Lit)> = None;
        for (left, operand, ms) in self.pending(place) {
            let Some(ends) = self.ends(operand, ms) else { continue };
            let ends = self.frames.literal(0, ends);
            // Between two reactions there is a millisecond at least.
            if left <= 1 {
                self.frames.clause(vec![!in_time, ends]);
            }
            if let Some((sooner, first)) = before {
                self.frames.clause(vec![!in_time, !ends, first]);
                if sooner == left {
                    self.frames.clause(vec![!in_time, !first, ends]);
                }
            }
            before = Some((left, ends));
        }
        in_time
    }

    /// One reaction with the inputs of its first clock, and how many clocks it takes; none if it cannot be, or does not end.
    fn react(&mut self, place: &Place, inputs: &[u64]) -> Result<Option<(Place, usize)>, Beyond> {
        self.run.latches.clone_from(&place.latches);
        self.run.look(inputs);
        self.budget.spend(1 + self.run.size() / 64);
        if self.run.of(self.watched.circuit.assumed) & 1 == 0 {
            return Ok(None);
        }
        let (mut least, mut below) = (i64::from(place.row.is_some()), i64::MAX);
        for (left, operand, ms) in self.pending(place) {
            if self.ends(operand, ms).is_some_and(|ends| self.run.of(ends) & 1 == 1) {
                least = least.max(left);
            } else {
                below = below.min(left);
            }
        }
        if least >= below {
            return Ok(None);
        }
        let now = place.now + least;
        let given: Answers = self.watched.atoms.iter().map(|(atom, is)| (*atom, self.run.of(*is) & 1 == 1)).collect();
        let (end, answers) = self.machine.follow(place.state.as_ref(), &given)?;
        if end == End::Barred {
            return Ok(None);
        }
        let row = self.found.rows.len();
        self.found.rows.push(Row { before: place.row, answers });
        let livelock = matches!(end, End::Livelock(_)).then_some(Fact::Livelock);
        for fact in self.machine.facts().chain(livelock) {
            self.found.met.entry(fact).or_insert(row);
            if let Some((_, is_unseen)) = self.unseen.swap_remove(&fact) {
                self.frames.clause(vec![!is_unseen]);
            }
        }
        let End::Rest(state, _) = end else { return Ok(None) };
        let mut began = place.began.clone();
        let mut clocks = 1;
        loop {
            let ran: Vec<u64> = self.watched.timers.iter().map(|timing| self.run.latches[timing.on] & 1).collect();
            self.run.advance(u64::MAX);
            for (t, timing) in self.watched.timers.iter().enumerate() {
                if ran[t] == 0 && self.run.latches[timing.on] & 1 == 1 {
                    began[t] = now;
                }
            }
            if self.run.of(self.watched.circuit.rests) & 1 == 1 {
                break;
            }
            self.run.look(inputs);
            self.budget.spend(1 + self.run.size() / 64);
            clocks += 1;
            // The machine came to an end, so it does, too.
            if self.budget.is_over() {
                return Ok(None);
            }
        }
        let reached = Place { latches: self.run.latches.clone(), state: Some(state), row: Some(row), now, began };
        self.found.places.push(reached.clone());
        self.budget.met.set(self.found.places.len());
        Ok(Some((reached, clocks)))
    }
}

impl Walked {
    /// The facts that were seen.
    pub(super) fn met(&self) -> impl Iterator<Item = Fact> + '_ {
        self.met.keys().copied()
    }

    /// What latches hold after initial reactions.
    pub(super) fn starts(&self) -> impl Iterator<Item = Vec<u64>> + '_ {
        let is_start = |place: &&Place| place.row.is_some_and(|row| self.rows[row].before.is_none());
        self.places.iter().filter(is_start).map(|place| place.latches.clone())
    }

    /// The way to where a fact was seen first.
    pub(super) fn way(&self, fact: Fact) -> Option<Way> {
        self.met.get(&fact).map(|row| self.way_to(*row))
    }

    fn way_to(&self, row: usize) -> Way {
        let mut way = Way::new();
        let mut at = Some(row);
        while let Some(row) = at {
            way.push(self.rows[row].answers.clone());
            at = self.rows[row].before;
        }
        way.reverse();
        way
    }

    /// Times were chosen on the way; they are found once more from the answers alone.
    fn keep_what_times_allow(&mut self, program: &Program) -> Result<(), Beyond> {
        let mut is_needed = vec![false; self.rows.len()];
        self.met.values().for_each(|row| is_needed[*row] = true);
        let mut below: FxHashMap<usize, usize> = FxHashMap::default();
        for row in (0..self.rows.len()).rev().filter(|row| is_needed[*row]) {
            // The furthest row whose way goes through this one.
            let mut at = Some(row);
            while let Some(through) = at {
                if below.contains_key(&through) {
                    break;
                }
                below.insert(through, row);
                at = self.rows[through].before;
            }
        }
        let mut machine = Machine::by_bits(program)?;
        let mut is_allowed: FxHashMap<usize, bool> = FxHashMap::default();
        let mut furthest: Vec<usize> = below.values().copied().collect();
        furthest.sort_unstable();
        furthest.dedup();
        for row in furthest {
            let allowed = times::walk(&mut machine, &self.way_to(row))?.times.is_some();
            is_allowed.insert(row, allowed);
        }
        self.met.retain(|_, row| is_allowed[&below[row]]);
        Ok(())
    }
}
