//! That from every state there is a way out: to another situation, or home. For one state a solver finds inputs that lead out;
//! what of the state that needs is a cube, and all states of the cube are done with. So it goes on, until there is no state
//! that is in no cube, or none that a cube can be found for.
//!
//! On a way out all delays that run are over, which they are after long enough a time. Cubes that lead into cubes make long
//! ways of short ones.

use super::frames::{Begin, Frames};
use crate::atom::Atom;
use crate::budget::Budget;
use crate::circuit::{Literal, Watched};
use batsat::Lit;

/// So many clocks lead out at most.
const FAR: usize = 8;

/// So many cubes are made, and so many of more latches than are few: what needs more of a state has more ways than can be
/// gone through.
const MOST_CUBES: usize = 20_000;
const MOST_LARGE: usize = 20;
const FEW: usize = 12;

/// So many latches of a cube are tried to be left out.
const MOST_TRIED: usize = 64;

/// Where ways lead.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Out {
    /// To another situation.
    Moved,
    /// To where this holds of latches.
    Home(Literal),
}

/// Latches, by their places, that hold or not.
type Cube = Vec<(usize, bool)>;

struct WaysOut<'c, 'b, 's> {
    watched: &'c Watched,
    out: Out,
    /// States that there may be.
    states: Frames<'c, 'b, 's>,
    /// Ways from there.
    ways: Frames<'c, 'b, 's>,
    /// What all that a way needs is.
    needs: Frames<'c, 'b, 's>,
    /// By clock, that it leads out there, and that it leads into a cube that is not known yet.
    leads: Vec<(Lit, Lit)>,
    cubes: Vec<Cube>,
    far: usize,
}

/// Whether there is a way out from every state for which these hold, within the bound on micro-steps; none if that was not
/// found out.
pub(super) fn always<'c, 'b, 's>(
    watched: &'c Watched,
    out: Out,
    proved: &[Literal],
    bound: usize,
    budget: &'b Budget<'s>,
) -> Option<bool> {
    let assumed = watched.circuit.assumed;
    let over = watched.atoms.iter().filter(|(atom, _)| matches!(atom, Atom::Ends(..))).map(|(_, ends)| *ends);
    let on_ways: Vec<Literal> = over.chain(proved.iter().copied()).chain([assumed]).collect();
    let mut of = WaysOut {
        watched,
        out,
        states: Frames::with(watched, Begin::Anywhere, proved.to_vec(), budget),
        ways: Frames::with(watched, Begin::Anywhere, on_ways, budget),
        needs: Frames::with(watched, Begin::Anywhere, proved.to_vec(), budget),
        leads: Vec::new(),
        cubes: Vec::new(),
        far: FAR.min(bound.saturating_sub(1)),
    };
    of.begin();
    let is_large = |cube: &&Cube| cube.len() > FEW;
    while of.cubes.len() < MOST_CUBES && of.cubes.iter().filter(is_large).count() < MOST_LARGE {
        // All states are done with, if none is left.
        if !of.states.solve(&[])? {
            return Some(true);
        }
        let state: Vec<bool> =
            of.latches().into_iter().map(|lit| lit.is_some_and(|lit| of.states.holds(lit))).collect();
        if !of.step(Some(&state))? && !of.step(None)? {
            return Some(false);
        }
    }
    None
}

impl WaysOut<'_, '_, '_> {
    /// A state rests, has begun, and is not where ways lead.
    fn begin(&mut self) {
        let Watched { begins, begun, .. } = *self.watched;
        for frames in [&mut self.states, &mut self.ways, &mut self.needs] {
            frames.open(1);
            for literal in [begins, begun] {
                let holds = frames.literal(0, literal);
                frames.clause(vec![holds]);
            }
        }
        for frames in [&mut self.states, &mut self.ways] {
            // All latches are there, so that what a state is can be told.
            for latch in &self.watched.circuit.latches {
                frames.literal(0, latch.now);
            }
            if let Out::Home(home) = self.out {
                let home = frames.literal(0, home);
                frames.clause(vec![!home]);
            }
        }
    }

    fn latches(&self) -> Vec<Option<Lit>> {
        self.watched.circuit.latches.iter().map(|latch| self.states.asked(0, latch.now)).collect()
    }

    /// What says that a way leads out after so many clocks.
    fn lead(&mut self, clocks: usize) {
        let frames = &mut self.ways;
        frames.open(clocks + 1);
        let (leads, more) = (frames.free(), frames.free());
        let rests = frames.literal(clocks, self.watched.begins);
        frames.clause(vec![!leads, rests]);
        let mut one_of = vec![!leads, more];
        match self.out {
            Out::Home(home) => one_of.push(frames.literal(clocks, home)),
            Out::Moved => {
                for step in &self.watched.standing {
                    let (before, after) = (frames.literal(0, *step), frames.literal(clocks, *step));
                    let differs = frames.free();
                    frames.clause(vec![!differs, before, after]);
                    frames.clause(vec![!differs, !before, !after]);
                    one_of.push(differs);
                }
            }
        }
        frames.clause(one_of);
        self.leads.push((leads, more));
        for place in 0..self.cubes.len() {
            self.lead_into(clocks, place);
        }
    }

    /// After so many clocks a way may lead into this cube.
    fn lead_into(&mut self, clocks: usize, cube: usize) {
        let (leads, before) = self.leads[clocks - 1];
        let (here, more) = (self.ways.free(), self.ways.free());
        for (place, value) in &self.cubes[cube] {
            let lit = self.ways.literal(clocks, self.watched.circuit.latches[*place].now);
            self.ways.clause(vec![!here, if *value { lit } else { !lit }]);
        }
        self.ways.clause(vec![!before, here, more]);
        self.leads[clocks - 1] = (leads, more);
    }

    /// One more cube, that has this state, or any; false if there is no way.
    fn step(&mut self, state: Option<&[bool]>) -> Option<bool> {
        for clocks in 1..=self.far {
            if self.leads.len() < clocks {
                self.lead(clocks);
            }
            let (leads, more) = self.leads[clocks - 1];
            let mut assumed = vec![leads, !more];
            // What holds in a state tells most of it; if it is another one that has a way, so much the better.
            let held = self.watched.circuit.latches.iter().zip(state.into_iter().flatten()).filter(|(_, held)| **held);
            assumed.extend(held.filter_map(|(latch, _)| self.ways.asked(0, latch.now)));
            if self.ways.solve(&assumed)? {
                let cube = self.needed(clocks)?;
                self.done_with(cube);
                return Some(true);
            }
        }
        Some(false)
    }

    /// What of the state at hand its way needs.
    fn needed(&mut self, clocks: usize) -> Option<Cube> {
        let (ways, needs) = (&mut self.ways, &mut self.needs);
        needs.open(clocks + 1);
        let fails = needs.free();
        let mut assumed = vec![fails];
        let mut one_of = vec![!fails];
        for frame in 0..clocks {
            let allowed = needs.literal(frame, self.watched.circuit.assumed);
            one_of.push(!allowed);
            for (input, given) in self.watched.circuit.inputs.iter().zip(ways.inputs(frame)) {
                let lit = needs.literal(frame, input.literal);
                assumed.push(if given == 0 { !lit } else { lit });
            }
        }
        one_of.push(!needs.literal(clocks, self.watched.begins));
        // What it leads to, in one of the ways in which it does.
        let held =
            |ways: &Frames, frame: usize, literal: Literal| ways.asked(frame, literal).map(|lit| ways.holds(lit));
        let is_in = |ways: &Frames, cube: &Cube| {
            let latches = &self.watched.circuit.latches;
            cube.iter().all(|(place, value)| held(ways, clocks, latches[*place].now) == Some(*value))
        };
        let moved = |ways: &Frames| {
            let differs = |step: &&Literal| held(ways, 0, **step) != held(ways, clocks, **step);
            self.watched.standing.iter().find(differs).copied()
        };
        let direct = match self.out {
            Out::Home(home) if held(ways, clocks, home) == Some(true) => {
                one_of.push(!needs.literal(clocks, home));
                true
            }
            Out::Home(_) => false,
            Out::Moved => match moved(ways) {
                Some(step) => {
                    let (before, after) = (needs.literal(0, step), needs.literal(clocks, step));
                    let was = held(ways, 0, step) == Some(true);
                    one_of.extend(if was { [!before, after] } else { [before, !after] });
                    true
                }
                None => false,
            },
        };
        if !direct {
            // There is a cube that it leads into, or nothing would have said that it leads out.
            let cube = self.cubes.iter().find(|cube| is_in(ways, cube))?;
            for (place, value) in cube {
                let lit = needs.literal(clocks, self.watched.circuit.latches[*place].now);
                one_of.push(if *value { !lit } else { lit });
            }
        }
        needs.clause(one_of);
        let mut latches = Vec::new();
        for (place, latch) in self.watched.circuit.latches.iter().enumerate() {
            if let (Some(lit), Some(value)) = (needs.asked(0, latch.now), held(ways, 0, latch.now)) {
                latches.push((place, value, if value { lit } else { !lit }));
            }
        }
        // What holds says more than what does not: a token in one place that there is none elsewhere.
        latches.sort_by_key(|(_, value, _)| !value);
        let is_enough = |needs: &mut Frames, latches: &[(usize, bool, Lit)]| {
            let all: Vec<Lit> = assumed.iter().copied().chain(latches.iter().map(|(.., lit)| *lit)).collect();
            needs.solve(&all).map(|found| !found)
        };
        let holding = latches.iter().take_while(|(_, value, _)| *value).count();
        if is_enough(needs, &latches[..holding])? {
            latches.truncate(holding);
        } else if !is_enough(needs, &latches)? {
            return None;
        }
        latches.retain(|(.., lit)| needs.is_needed(*lit));
        // Each that can be left out is.
        let mut place = latches.len().min(MOST_TRIED);
        while place > 0 {
            place -= 1;
            let mut fewer = latches.clone();
            fewer.remove(place);
            if is_enough(needs, &fewer)? {
                fewer.retain(|(.., lit)| needs.is_needed(*lit));
                latches = fewer;
                place = place.min(latches.len());
            }
        }
        needs.clause(vec![!fails]);
        Some(latches.into_iter().map(|(place, value, _)| (place, value)).collect())
    }

    /// No state of a cube is looked for any more, and ways may lead into it.
    fn done_with(&mut self, cube: Cube) {
        let latches = &self.watched.circuit.latches;
        for frames in [&mut self.states, &mut self.ways] {
            let mut outside = Vec::with_capacity(cube.len());
            for (place, value) in &cube {
                let lit = frames.literal(0, latches[*place].now);
                outside.push(if *value { !lit } else { lit });
            }
            frames.clause(outside);
        }
        self.cubes.push(cube);
        for clocks in 1..=self.leads.len() {
            self.lead_into(clocks, self.cubes.len() - 1);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::by_hand::{circuit, ring};
    use super::*;

    fn found(watched: &Watched, out: Out, proved: &[Literal]) -> Option<bool> {
        let mut go_on = |_, _| None;
        let budget = Budget::new(&mut go_on);
        always(watched, out, proved, 100, &budget)
    }

    /// Rests at every clock.
    fn resting(mut watched: Watched) -> Watched {
        (watched.begins, watched.circuit.rests) = (Literal::TRUE, Literal::TRUE);
        watched.standing.clone_from(&watched.truths);
        watched
    }

    #[test]
    fn a_token_in_a_ring_moves_on_and_comes_home() {
        let watched = resting(ring());
        // Without a token nothing moves, so it must be known that there is one.
        assert_eq!(found(&watched, Out::Moved, &[]), Some(false));
        let mut known = ring();
        let [a, b, c] = [0, 1, 2].map(|place| known.circuit.latches[place].now);
        let one = known.circuit.graph.any([a, b, c]);
        let alone: Vec<Literal> = known.facts[..3].iter().map(|(_, seen)| !*seen).chain([one]).collect();
        let known = resting(known);
        assert_eq!(found(&known, Out::Moved, &alone), Some(true));
        assert_eq!(found(&known, Out::Home(a), &alone), Some(true));
    }

    #[test]
    fn a_place_without_a_way_out() {
        // From the first to the second while the input holds; there it stays.
        let watched = circuit(1, &[true, false], |graph, inputs, now| {
            let goes = graph.and(now[0], inputs[0]);
            let next = vec![graph.and(now[0], !goes), graph.or(now[1], goes)];
            (next, vec![graph.xor(now[0], now[1])])
        });
        let watched = resting(watched);
        let one = watched.facts[0].1;
        assert_eq!(found(&watched, Out::Moved, &[one]), Some(false));
        assert_eq!(found(&watched, Out::Home(watched.truths[0]), &[one]), Some(false));
        assert_eq!(found(&watched, Out::Home(watched.truths[1]), &[one]), Some(true));
    }

    #[test]
    fn inputs_that_are_barred_lead_nowhere() {
        let mut watched = resting(ring());
        watched.circuit.assumed = !watched.circuit.inputs[0].literal;
        let token = watched.truths[0];
        assert_eq!(found(&watched, Out::Moved, &[token]), Some(false));
    }
}
