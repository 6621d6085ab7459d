//! Induction over clocks: what holds at k clocks in a row holds at the next one, too. All that is not known yet is taken
//! together: what does not follow from the rest is taken out, until all that is left follows (Houdini).

use super::frames::{Begin, Frames};
use crate::budget::Budget;
use crate::circuit::{Literal, Watched};
use batsat::Lit;

/// Clocks that begin anywhere.
pub(super) struct Induction<'c, 'b, 's> {
    frames: Frames<'c, 'b, 's>,
    rests: Literal,
    begins: Literal,
    known: Vec<Literal>,
}

/// Claims that are held together, by their places.
struct Group {
    held: Lit,
    claims: Vec<usize>,
}

/// So many claims are held together: a solver takes what it assumes one after the other.
const GROUP: usize = 64;

impl<'c, 'b, 's> Induction<'c, 'b, 's> {
    pub(super) fn new(watched: &'c Watched, budget: &'b Budget<'s>) -> Self {
        let frames = Frames::new(watched, Begin::Anywhere, budget);
        Induction { frames, rests: watched.circuit.rests, begins: watched.begins, known: Vec::new() }
    }

    /// It is proved to hold at every clock.
    pub(super) fn proved(&mut self, literal: Literal) {
        self.frames.always(literal);
        self.known.push(literal);
    }

    /// All that is proved.
    pub(super) fn known(&self) -> &[Literal] {
        &self.known
    }

    /// Which of these hold at every clock if all of them hold at the first so many; none if that was not found out.
    pub(super) fn kept(&mut self, claims: &[Literal], clocks: usize) -> Option<Vec<bool>> {
        self.frames.open(clocks + 1);
        let breaks = self.frames.free();
        let mut one_of = vec![!breaks];
        // What says that a claim is still among them, and that it holds afterwards.
        let mut of: Vec<(Lit, Lit)> = Vec::with_capacity(claims.len());
        for claim in claims {
            let (is_left, holds) = (self.frames.free(), self.frames.literal(clocks, *claim));
            let here = self.frames.free();
            self.frames.clause(vec![!here, !holds]);
            self.frames.clause(vec![!here, is_left]);
            one_of.push(here);
            of.push((is_left, holds));
        }
        self.frames.clause(one_of);
        let mut kept = vec![true; claims.len()];
        let all: Vec<usize> = (0..claims.len()).collect();
        let mut groups: Vec<Group> = all.chunks(GROUP).map(|group| self.held(group.to_vec(), claims, clocks)).collect();
        loop {
            let mut assumed = vec![breaks];
            assumed.extend(groups.iter().map(|group| group.held));
            let found = self.frames.solve(&assumed);
            if found == Some(true) {
                for place in 0..claims.len() {
                    kept[place] &= self.frames.holds(of[place].1);
                }
                let mut rest = Vec::with_capacity(groups.len());
                for group in groups {
                    if group.claims.iter().all(|place| kept[*place]) {
                        rest.push(group);
                        continue;
                    }
                    self.frames.clause(vec![!group.held]);
                    let (left, broken): (Vec<usize>, Vec<usize>) =
                        group.claims.into_iter().partition(|place| kept[*place]);
                    broken.into_iter().for_each(|place| self.frames.clause(vec![!of[place].0]));
                    rest.push(self.held(left, claims, clocks));
                }
                groups = rest;
                continue;
            }
            // They need not be told apart any more.
            self.frames.clause(vec![!breaks]);
            groups.iter().for_each(|group| self.frames.clause(vec![!group.held]));
            return found.map(|_| kept);
        }
    }

    /// Some claims, held at so many clocks.
    fn held(&mut self, group: Vec<usize>, claims: &[Literal], clocks: usize) -> Group {
        let held = self.frames.free();
        for frame in 0..clocks {
            for place in &group {
                let holds = self.frames.literal(frame, claims[*place]);
                self.frames.clause(vec![!held, holds]);
            }
        }
        Group { held, claims: group }
    }

    /// Whether every call comes to rest within so many clocks; none if that was not found out.
    pub(super) fn ends_within(&mut self, clocks: usize) -> Option<bool> {
        self.frames.open(clocks);
        let mut goes_on = vec![self.frames.literal(0, self.begins)];
        for frame in 0..clocks {
            goes_on.push(!self.frames.literal(frame, self.rests));
        }
        self.frames.solve(&goes_on).map(|found| !found)
    }
}

#[cfg(test)]
mod tests {
    use super::super::by_hand::{apart, circuit, counter, ring};
    use super::*;

    /// Which of what is seen is proved never to be, if all of it is not at the first so many clocks.
    fn never(watched: &Watched, clocks: usize) -> Option<Vec<bool>> {
        let mut go_on = |_, _| None;
        let budget = Budget::new(&mut go_on);
        let claims: Vec<Literal> = watched.facts.iter().map(|(_, seen)| !*seen).collect();
        Induction::new(watched, &budget).kept(&claims, clocks)
    }

    #[test]
    fn a_token_is_in_one_place() {
        // Each pair follows from the pair before it; that the last place is empty follows from nothing.
        assert_eq!(never(&ring(), 1), Some(vec![true, true, true, false]));
        // Without the others none follows.
        assert_eq!(never(&ring(), 0), Some(vec![false; 4]));
    }

    #[test]
    fn what_follows_only_from_what_does_not_hold_is_out() {
        // The second latch follows the first, which follows the input.
        let watched = circuit(1, &[false, false], |_, inputs, now| (vec![inputs[0], now[0]], now.to_vec()));
        assert_eq!(never(&watched, 1), Some(vec![false, false]));
    }

    #[test]
    fn what_one_clock_does_not_prove_two_may() {
        // What leads to 3 is 2, which may be anywhere; what leads to 2 is 3.
        assert_eq!(never(&apart(), 1), Some(vec![false]));
        assert_eq!(never(&apart(), 2), Some(vec![true]));
        // A counter comes to 3 from everywhere, however many clocks it was not there.
        assert_eq!(never(&counter(), 2), Some(vec![false]));
    }

    #[test]
    fn what_is_proved_helps() {
        let watched = apart();
        let mut go_on = |_, _| None;
        let budget = Budget::new(&mut go_on);
        let mut induction = Induction::new(&watched, &budget);
        // It is never in the upper half.
        let upper = watched.circuit.latches[1].now;
        assert_eq!(induction.kept(&[!upper], 1), Some(vec![true]));
        induction.proved(!upper);
        assert_eq!(induction.kept(&[!watched.facts[0].1], 0), Some(vec![true]));
    }

    #[test]
    fn a_call_that_takes_two_clocks_ends_within_two() {
        // It rests, goes on once, and rests again; but for ever where the second holds, which no call begins with.
        let mut watched = circuit(0, &[true, false], |graph, _, now| {
            let stays = graph.and(now[1], !now[0]);
            (vec![graph.and(!now[0], !now[1]), stays], Vec::new())
        });
        (watched.begins, watched.circuit.rests) = (watched.truths[0], watched.circuit.latches[0].next);
        let mut go_on = |_, _| None;
        let budget = Budget::new(&mut go_on);
        let mut induction = Induction::new(&watched, &budget);
        assert_eq!((induction.ends_within(1), induction.ends_within(2)), (Some(false), Some(true)));
    }
}
