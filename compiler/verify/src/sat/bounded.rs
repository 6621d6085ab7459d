//! Bounded search: clock by clock from the start, so what is found first is found after the fewest micro-steps.

use super::frames::{Begin, Frames};
use super::run::Run;
use crate::beyond::Beyond;
use crate::budget::Budget;
use crate::circuit::{Literal, Watched};
use crate::facts::Fact;
use crate::goal::{Answers, Way};
use crate::machine::{End, Machine};
use batsat::Lit;
use grafc_logic::scan::Program;
use indexmap::IndexMap;
use rustc_hash::FxBuildHasher;

/// The clocks from the start on.
pub(super) struct Bounded<'w, 'c, 'b, 's> {
    watched: &'c Watched,
    machine: Machine<'w>,
    run: Run<'c>,
    frames: Frames<'c, 'b, 's>,
    /// What is looked for, with what says that it still is.
    sought: IndexMap<Fact, (Literal, Lit), FxBuildHasher>,
    /// So many clocks show nothing of that.
    pub(super) clear: usize,
    /// What was found.
    pub(super) met: IndexMap<Fact, Way, FxBuildHasher>,
}

impl<'w, 'c, 'b, 's> Bounded<'w, 'c, 'b, 's> {
    pub(super) fn new(
        program: &'w Program,
        watched: &'c Watched,
        sought: &[(Fact, Literal)],
        budget: &'b Budget<'s>,
    ) -> Result<Self, Beyond> {
        let mut machine = Machine::by_bits(program)?;
        machine.look_on();
        let mut frames = Frames::new(watched, Begin::AtStart, budget);
        let sought = sought.iter().map(|(fact, seen)| (*fact, (*seen, frames.free()))).collect();
        let met = IndexMap::default();
        Ok(Bounded { watched, machine, run: Run::new(watched), frames, sought, clear: 0, met })
    }

    /// Whether the assumptions allow any inputs at the start.
    pub(super) fn starts(&mut self) -> Option<bool> {
        self.frames.open(1);
        self.frames.solve(&[])
    }

    /// What is still looked for.
    pub(super) fn left(&self) -> impl Iterator<Item = (Fact, Literal)> + '_ {
        self.sought.iter().map(|(fact, (seen, _))| (*fact, *seen))
    }

    /// It is not looked for any more.
    pub(super) fn drop(&mut self, fact: Fact) {
        if let Some((_, is_sought)) = self.sought.swap_remove(&fact) {
            self.frames.clause(vec![!is_sought]);
        }
    }

    /// Looks at the next clock for all that it can show; false if that was not found out.
    pub(super) fn look(&mut self) -> Result<bool, Beyond> {
        let frame = self.clear;
        self.frames.open(frame + 1);
        let shows = self.frames.free();
        let mut one_of = vec![!shows];
        for (seen, is_sought) in self.sought.values() {
            let seen = self.frames.literal(frame, *seen);
            let here = self.frames.free();
            self.frames.clause(vec![!here, seen]);
            self.frames.clause(vec![!here, *is_sought]);
            one_of.push(here);
        }
        self.frames.clause(one_of);
        loop {
            match self.frames.solve(&[shows]) {
                None => return Ok(false),
                Some(false) => {
                    self.frames.clause(vec![!shows]);
                    self.clear = frame + 1;
                    return Ok(true);
                }
                Some(true) => {
                    let inputs: Vec<Vec<u64>> = (0..=frame).map(|frame| self.frames.inputs(frame)).collect();
                    let shown = self.follow(&inputs)?;
                    // It would be found again and again.
                    if shown.is_empty() {
                        return Ok(false);
                    }
                    // What the machine does not show lies beyond the bound on micro-steps.
                    for fact in shown {
                        self.drop(fact);
                    }
                }
            }
        }
    }

    /// Goes a way by the inputs of its clocks, and says what the last of them shows.
    fn follow(&mut self, inputs: &[Vec<u64>]) -> Result<Vec<Fact>, Beyond> {
        self.run.latches = self.run.initial();
        let (mut way, mut state, mut is_over) = (Way::new(), None, false);
        for inputs in inputs {
            self.run.look(inputs);
            if self.run.of(self.watched.begins) & 1 == 1 && !is_over {
                let atoms = self.watched.atoms.iter();
                let given: Answers = atoms.map(|(atom, is)| (*atom, self.run.of(*is) & 1 == 1)).collect();
                let (end, answers) = self.machine.follow(state.as_ref(), &given)?;
                way.push(answers);
                for fact in self.machine.facts() {
                    self.met.entry(fact).or_insert_with(|| way.clone());
                }
                match end {
                    End::Rest(next, _) => state = Some(next),
                    End::Livelock(_) | End::Barred => is_over = true,
                }
            }
            self.run.advance(u64::MAX);
        }
        Ok(self.left().filter(|(_, seen)| self.run.of(*seen) & 1 == 1).map(|(fact, _)| fact).collect())
    }
}
