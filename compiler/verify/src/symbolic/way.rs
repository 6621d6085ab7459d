//! Ways to what was found: backwards from ring to ring, then once more through the machine, which says what each reaction
//! asks for.

use super::Found;
use super::sets::{Halt, Sets};
use crate::atom::Atom;
use crate::goal::{Answers, Way};
use crate::limit::Limit;
use crate::machine::{End, Machine};
use crate::pack::State;
use biodivine_lib_bdd::{Bdd, BddPartialValuation, BddValuation, BddVariable};

impl Found {
    /// A shortest way to one of these states, which are in this ring.
    pub(super) fn way_to_state(
        &self,
        depth: usize,
        states: &Bdd,
        machine: &mut Machine,
        sets: &mut Sets,
    ) -> Result<Way, Halt> {
        let last = self.relation.last.before(states, sets)?;
        let last = sets.minus(&last, &self.relation.again)?;
        self.way_to_head(depth, &last, machine, sets)
    }

    /// A shortest way to a reaction, of this number, with one of these heads.
    pub(super) fn way_to_head(
        &self,
        depth: usize,
        heads: &Bdd,
        machine: &mut Machine,
        sets: &mut Sets,
    ) -> Result<Way, Halt> {
        let mut given: Vec<Answers> = Vec::new();
        let mut heads = heads.clone();
        for depth in (0..=depth).rev() {
            let chosen = self.reaction_through(depth, &heads, sets)?;
            given.push(self.answers(&chosen));
            if depth > 0 {
                let state: Vec<(BddVariable, bool)> =
                    self.relation.kept.iter().map(|v| (*v, chosen.value(*v))).collect();
                let state = self.relation.bits.all.mk_conjunctive_clause(&BddPartialValuation::from_values(&state));
                let last = self.relation.last.before(&state, sets)?;
                heads = sets.minus(&last, &self.relation.again)?;
            }
        }
        given.reverse();
        let mut way = Way::new();
        let mut state: Option<State> = None;
        for given in &given {
            let (end, answers) = machine.follow(state.as_ref(), given)?;
            way.push(answers);
            state = match end {
                End::Rest(state, _) => Some(state),
                End::Livelock(_) | End::Barred => None,
            };
        }
        Ok(way)
    }

    /// Of a reaction of this number that comes through one of these heads: the state that it begins in, and its inputs.
    fn reaction_through(&self, depth: usize, heads: &Bdd, sets: &mut Sets) -> Result<BddValuation, Halt> {
        let mut new = sets.and(heads, &self.heads[depth])?;
        let mut met = new.clone();
        loop {
            let begins = if depth == 0 {
                sets.and(&new, &self.relation.start)?
            } else {
                let begins = self.relation.begin.before(&new, sets)?;
                let begins = sets.and(&begins, &self.relation.allowed)?;
                sets.and(&begins, &self.rings[depth - 1])?
            };
            if let Some(chosen) = begins.sat_witness() {
                return Ok(chosen);
            }
            let before = self.relation.step.before(&new, sets)?;
            let before = sets.and(&before, &self.relation.again)?;
            let before = sets.and(&before, &self.heads[depth])?;
            new = sets.minus(&before, &met)?;
            if new.is_false() {
                // There is a beginning of everything that was met.
                return Err(Halt::Limit(Limit::Nodes));
            }
            met = sets.or(&met, &new)?;
        }
    }

    /// The answers that a valuation gives.
    fn answers(&self, chosen: &BddValuation) -> Answers {
        let mut answers: Answers = self.relation.bits.asked.iter().map(|(atom, v)| (*atom, chosen.value(*v))).collect();
        answers.sort_unstable_by_key(|(atom, _): &(Atom, bool)| *atom);
        answers
    }
}
