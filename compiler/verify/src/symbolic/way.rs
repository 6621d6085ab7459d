//! Ways to what was found: backwards from ring to ring, then once more through the machine, which says what each reaction
//! asks for.

use super::found::{Found, Layers};
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
        self.way_through(&self.layers, depth, states, machine, sets)
    }

    /// A shortest way to a reaction, of this number, with one of these heads at this micro-step.
    pub(super) fn way_to_head(
        &self,
        depth: usize,
        micro_step: usize,
        heads: &Bdd,
        machine: &mut Machine,
        sets: &mut Sets,
    ) -> Result<Way, Halt> {
        let given = self.back_from_head(&self.layers, depth, (micro_step, heads.clone()), sets)?;
        followed(&given, machine)
    }

    /// The initial reaction with some of these inputs.
    pub(super) fn way_at_start(&self, inputs: &Bdd, machine: &mut Machine) -> Result<Way, Halt> {
        let chosen = inputs.sat_witness().ok_or(Halt::Limit(Limit::Nodes))?;
        followed(&[self.answers(&chosen)], machine)
    }

    /// A shortest way to one of these states, which are in this ring of some layers.
    pub(super) fn way_through(
        &self,
        layers: &Layers,
        depth: usize,
        states: &Bdd,
        machine: &mut Machine,
        sets: &mut Sets,
    ) -> Result<Way, Halt> {
        let (layers, states) = self.layers_of(layers, depth, states, sets)?;
        let heads = self.last_heads(layers, depth, &states, sets)?;
        followed(&self.back_from_head(layers, depth, heads, sets)?, machine)
    }

    /// A shortest way to one of the last reactions of some layers, which do not end.
    pub(super) fn way_to_no_end(&self, layers: &Layers, machine: &mut Machine, sets: &mut Sets) -> Result<Way, Halt> {
        let depth = layers.reactions.len() - 1;
        let last = layers.reactions[depth].heads.len() - 1;
        let endless = (last, sets.and(&layers.reactions[depth].heads[last], &self.relation.again)?);
        followed(&self.back_from_head(layers, depth, endless, sets)?, machine)
    }

    /// The layers through which these states are reached: where others begin, it is those of all states.
    fn layers_of<'l>(
        &'l self,
        layers: &'l Layers,
        depth: usize,
        states: &Bdd,
        sets: &mut Sets,
    ) -> Result<(&'l Layers, Bdd), Halt> {
        if let (Some(seeds), Some(ring)) = (&layers.seeds, self.layers.rings.get(depth)) {
            let here = sets.and(states, seeds)?;
            let here = sets.and(&here, ring)?;
            if !here.is_false() {
                return Ok((&self.layers, here));
            }
        }
        Ok((layers, states.clone()))
    }

    /// Of the reactions that lead to a ring, heads after which they end in one of these states, and the micro-step.
    fn last_heads(&self, layers: &Layers, depth: usize, states: &Bdd, sets: &mut Sets) -> Result<(usize, Bdd), Halt> {
        for (micro_step, heads) in layers.reactions[depth].heads.iter().enumerate() {
            let resting = sets.minus(heads, &self.relation.again)?;
            let last = self.relation.last.before(states, &resting, sets)?;
            if !last.is_false() {
                return Ok((micro_step, last));
            }
        }
        // Something leads to each state.
        Err(Halt::Limit(Limit::Nodes))
    }

    /// All inputs and times of the reactions that lead to one of these heads.
    fn back_from_head<'l>(
        &'l self,
        mut layers: &'l Layers,
        depth: usize,
        mut heads: (usize, Bdd),
        sets: &mut Sets,
    ) -> Result<Vec<Answers>, Halt> {
        let mut given = Vec::with_capacity(depth + 1);
        for depth in (0..=depth).rev() {
            let chosen = self.reaction_through(layers, depth, &heads, sets)?;
            given.push(self.answers(&chosen));
            if depth > 0 {
                let (of, state) = self.layers_of(layers, depth - 1, &self.state(&chosen), sets)?;
                layers = of;
                heads = self.last_heads(layers, depth - 1, &state, sets)?;
            }
        }
        given.reverse();
        Ok(given)
    }

    /// Of a reaction of this number that comes through one of these heads: the state that it begins in, and its inputs.
    fn reaction_through(
        &self,
        layers: &Layers,
        depth: usize,
        (micro_step, heads): &(usize, Bdd),
        sets: &mut Sets,
    ) -> Result<BddValuation, Halt> {
        let mut heads = heads.clone();
        for earlier in layers.reactions[depth].heads[..*micro_step].iter().rev() {
            let more = sets.and(earlier, &self.relation.again)?;
            heads = self.relation.step.before(&heads, &more, sets)?;
        }
        let begins = if depth == 0 {
            sets.and(&heads, &self.relation.start)?
        } else {
            let among = sets.and(&layers.rings[depth - 1], &self.relation.allowed)?;
            self.relation.begin.before(&heads, &among, sets)?
        };
        // There is a beginning of everything that was met.
        begins.sat_witness().ok_or(Halt::Limit(Limit::Nodes))
    }

    /// The state of a valuation.
    fn state(&self, chosen: &BddValuation) -> Bdd {
        let state: Vec<(BddVariable, bool)> = self.relation.kept.iter().map(|v| (*v, chosen.value(*v))).collect();
        self.relation.bits.all.mk_conjunctive_clause(&BddPartialValuation::from_values(&state))
    }

    /// The answers that a valuation gives.
    fn answers(&self, chosen: &BddValuation) -> Answers {
        let mut answers: Answers = self.relation.bits.asked.iter().map(|(atom, v)| (*atom, chosen.value(*v))).collect();
        answers.sort_unstable_by_key(|(atom, _): &(Atom, bool)| *atom);
        answers
    }
}

/// The way that agrees with what is given: of it, what is asked.
fn followed(given: &[Answers], machine: &mut Machine) -> Result<Way, Halt> {
    let mut way = Way::new();
    let mut state: Option<State> = None;
    for given in given {
        let (end, answers) = machine.follow(state.as_ref(), given)?;
        way.push(answers);
        state = match end {
            End::Rest(state, _) => Some(state),
            End::Livelock(_) | End::Barred => None,
        };
    }
    Ok(way)
}
