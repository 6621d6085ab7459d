//! Plain charts: properly nested sequences, selections and parallel branches, as a textbook draws them. Conditions are
//! of inputs alone and those of a selection exclude each other, so that what can be proved of nets can be proved here.

use fastrand::Rng;
use std::fmt::Write as _;

const INPUTS: [&str; 5] = ["a", "b", "c", "d", "e"];

/// The text of a plain chart: rings, each a sequence of regions.
pub(super) fn chart(rng: &mut Rng, name: &str) -> String {
    let mut out =
        format!("chart {name}\n\ninput a, b, c, d, e : bool\noutput w0, w1, w2, w3 : bool\noutput n : int\n\n");
    for ring in 0..rng.usize(1..=2) {
        let regions = rng.usize(1..=3);
        let draw = Draw::ring(rng, (ring + 1) * 100, regions, 2);
        let _ = writeln!(out, "grafcet G{ring} {{");
        for (index, step) in draw.steps.iter().enumerate() {
            let initial = if index == 0 { "initial " } else { "" };
            let action = match rng.usize(0..6) {
                0 | 1 => format!(" {{ w{} }}", rng.usize(0..4)),
                2 => format!(" {{ w{} if {} }}", rng.usize(0..4), INPUTS[rng.usize(0..5)]),
                3 => " { n := n + 1 on activation }".to_owned(),
                _ => String::new(),
            };
            let _ = writeln!(out, "  {initial}step {step}{action}");
        }
        draw.write_arcs(&mut out);
        out.push_str("}\n\n");
    }
    out
}

/// A condition of inputs.
pub(super) fn condition(rng: &mut Rng) -> String {
    let mut literal = || {
        let input = INPUTS[rng.usize(0..5)];
        match rng.usize(0..6) {
            0 => format!("↑{input}"),
            1 | 2 => format!("not {input}"),
            _ => input.to_owned(),
        }
    };
    let first = literal();
    if first.len() % 2 == 0 { format!("{first} and {}", literal()) } else { first }
}

/// A ring of regions.
pub(super) struct Draw {
    /// Its steps; the first one begins it.
    pub(super) steps: Vec<usize>,
    /// The steps between regions, which each round comes by.
    pub(super) spine: Vec<usize>,
    arcs: Vec<(Vec<usize>, Vec<usize>, String)>,
    next: usize,
}

impl Draw {
    /// So many regions, nested so deep, with steps from a number on.
    pub(super) fn ring(rng: &mut Rng, number: usize, regions: usize, depth: usize) -> Draw {
        let mut draw = Draw { steps: Vec::new(), spine: Vec::new(), arcs: Vec::new(), next: number };
        let first = draw.step();
        draw.spine.push(first);
        for _ in 0..regions {
            let last = draw.spine[draw.spine.len() - 1];
            let next = draw.region(rng, last, depth);
            draw.spine.push(next);
        }
        let condition = condition(rng);
        draw.arcs.push((vec![draw.spine[regions]], vec![first], condition));
        draw
    }

    /// The transitions, a line each.
    pub(super) fn write_arcs(&self, out: &mut String) {
        for (pre, post, condition) in &self.arcs {
            let list = |steps: &[usize]| steps.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ");
            let _ = writeln!(out, "  transition {} -> {} : {condition}", list(pre), list(post));
        }
    }

    fn step(&mut self) -> usize {
        self.steps.push(self.next);
        self.next += 1;
        self.next - 1
    }

    /// A region after a step; the step that ends it.
    fn region(&mut self, rng: &mut Rng, from: usize, depth: usize) -> usize {
        match rng.usize(0..if depth == 0 { 1 } else { 3 }) {
            0 => {
                let to = self.step();
                self.arcs.push((vec![from], vec![to], condition(rng)));
                to
            }
            1 => {
                let input = INPUTS[rng.usize(0..5)];
                let (left, right) = (self.step(), self.step());
                self.arcs.push((vec![from], vec![left], input.to_owned()));
                self.arcs.push((vec![from], vec![right], format!("not {input} and {}", INPUTS[rng.usize(0..5)])));
                let ends = [self.region(rng, left, depth - 1), self.region(rng, right, depth - 1)];
                let to = self.step();
                for end in ends {
                    self.arcs.push((vec![end], vec![to], condition(rng)));
                }
                to
            }
            _ => {
                let starts: Vec<usize> = (0..rng.usize(2..=3)).map(|_| self.step()).collect();
                self.arcs.push((vec![from], starts.clone(), condition(rng)));
                let ends = starts.into_iter().map(|start| self.region(rng, start, depth - 1)).collect();
                let to = self.step();
                self.arcs.push((ends, vec![to], condition(rng)));
                to
            }
        }
    }
}
