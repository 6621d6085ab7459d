//! The chart that the cost of a scan is measured with: rings of steps side by side, each with one token.
//!
//! Step i is left by input `x_i` and sets output `w_i`; the first step of each ring is initial. With an input a transition
//! and an output a step a spelling can hide nothing: all that a scan does is to look, in each ring, for the one transition
//! that may clear, and to move one output.

use serde::Serialize;
use std::fmt::Write as _;

/// So many steps in so many rings of equal length.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
pub struct Rings {
    /// The steps of all rings.
    pub steps: usize,
    /// The rings, each of which has one token.
    pub tokens: usize,
}

impl Rings {
    /// One ring.
    pub fn one(steps: usize) -> Rings {
        Rings { steps, tokens: 1 }
    }

    /// Rings of at least two steps each, if the steps can be shared out equally.
    pub fn of(steps: usize, tokens: usize) -> Option<Rings> {
        (tokens > 0 && steps % tokens == 0 && steps / tokens >= 2).then_some(Rings { steps, tokens })
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
        let next = step + 1;
        if next % self.length() == 0 { next - self.length() } else { next }
    }

    /// The chart.
    pub fn chart(self) -> String {
        let mut out = String::from("chart Ring\n\n");
        for i in 0..self.steps {
            let _ = writeln!(out, "input x_{i} : bool\noutput w_{i} : bool");
        }
        for i in 0..self.steps {
            let initial = if self.is_initial(i) { "initial " } else { "" };
            let _ = writeln!(out, "{initial}step {i} {{ w_{i} }}");
        }
        for i in 0..self.steps {
            let _ = writeln!(out, "transition {i} -> {} : x_{i}", self.next(i));
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
    fn rings_are_equal_and_no_step_leads_to_itself() {
        assert_eq!(Rings::of(10, 3), None);
        assert_eq!(Rings::of(10, 10), None);
        assert_eq!(Rings::of(10, 0), None);
        assert_eq!(Rings::of(20, 10).map(Rings::length), Some(2));
    }
}
