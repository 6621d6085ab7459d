//! The chart that the cost of a scan is measured with: rings of steps side by side, each with one token.
//!
//! Step i is left by input `x_i` and sets output `w_i`; the first step of each ring is initial. With an input a transition
//! and an output a step a spelling can hide nothing: all that a scan does is to look, in each ring, for the one transition
//! that may clear, and to move one output.
//!
//! A token may go through some of the steps only, which tells what is drawn from what is active: after so many steps the
//! ring leads back to its first step, and the others are reached from there by the input `aside`, which is never true.

use serde::Serialize;
use std::fmt::Write as _;

/// So many steps in so many rings of equal length.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
pub struct Rings {
    /// The steps of all rings.
    pub steps: usize,
    /// The rings, each of which has one token.
    pub tokens: usize,
    /// The steps that a token goes through, the first ones of its ring.
    pub walked: usize,
}

impl Rings {
    /// One ring.
    pub fn one(steps: usize) -> Rings {
        Rings { steps, tokens: 1, walked: steps }
    }

    /// Rings of at least two steps each, if the steps can be shared out equally.
    pub fn of(steps: usize, tokens: usize) -> Option<Rings> {
        (tokens > 0 && steps % tokens == 0 && steps / tokens >= 2).then(|| Rings {
            steps,
            tokens,
            walked: steps / tokens,
        })
    }

    /// The same with tokens that go through so many steps; none if there are not so many, or too few.
    pub fn walked(self, steps: usize) -> Option<Rings> {
        (2..=self.length()).contains(&steps).then_some(Rings { walked: steps, ..self })
    }

    /// Where the way from the first step of a ring to the steps that are not walked through leads.
    pub fn aside(self, step: usize) -> Option<usize> {
        (self.is_initial(step) && self.walked < self.length()).then_some(step + self.walked)
    }

    /// The steps of one ring.
    pub fn length(self) -> usize {
        self.steps / self.tokens
    }

    /// Whether a step is the first of its ring.
    pub fn is_initial(self, step: usize) -> bool {
        step % self.length() == 0
    }

    /// The step after a step.
    pub fn next(self, step: usize) -> usize {
        let (first, place) = (step - step % self.length(), step % self.length() + 1);
        if place == self.walked || place == self.length() { first } else { first + place }
    }

    /// The chart.
    pub fn chart(self) -> String {
        let mut out = String::from("chart Ring\n\n");
        if self.walked < self.length() {
            out.push_str("input aside : bool\n");
        }
        for i in 0..self.steps {
            let _ = writeln!(out, "input x_{i} : bool\noutput w_{i} : bool");
        }
        for i in 0..self.steps {
            let initial = if self.is_initial(i) { "initial " } else { "" };
            let _ = writeln!(out, "{initial}step {i} {{ w_{i} }}");
        }
        for i in 0..self.steps {
            let _ = writeln!(out, "transition {i} -> {} : x_{i}", self.next(i));
            if let Some(aside) = self.aside(i) {
                let _ = writeln!(out, "transition {i} -> {aside} : aside and not x_{i}");
            }
        }
        out
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_ring_is_closed() {
        let rings = Rings::of(6, 2).expect("two rings of three steps");
        let next: Vec<usize> = (0..6).map(|step| rings.next(step)).collect();
        assert_eq!(next, [1, 2, 0, 4, 5, 3]);
        let initial: Vec<usize> = (0..6).filter(|step| rings.is_initial(*step)).collect();
        assert_eq!(initial, [0, 3]);
    }

    #[test]
    fn a_token_may_go_through_some_steps_only() {
        let rings = Rings::of(8, 2).and_then(|rings| rings.walked(2)).expect("two rings of four steps");
        let next: Vec<usize> = (0..8).map(|step| rings.next(step)).collect();
        assert_eq!(next, [1, 0, 3, 0, 5, 4, 7, 4]);
        let aside: Vec<Option<usize>> = (0..8).map(|step| rings.aside(step)).collect();
        assert_eq!(aside, [Some(2), None, None, None, Some(6), None, None, None]);
        assert_eq!(Rings::one(8).walked(9), None);
    }

    #[test]
    fn rings_are_equal_and_no_step_leads_to_itself() {
        assert_eq!(Rings::of(10, 3), None);
        assert_eq!(Rings::of(10, 10), None);
        assert_eq!(Rings::of(10, 0), None);
        assert_eq!(Rings::of(20, 10).map(Rings::length), Some(2));
    }
}
