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
        let mut draw = Draw { steps: Vec::new(), arcs: Vec::new(), next: (ring + 1) * 100 };
        let first = draw.step();
        let mut last = first;
        for _ in 0..rng.usize(1..=3) {
            last = draw.region(rng, last, 2);
        }
        let condition = condition(rng);
        draw.arcs.push((vec![last], vec![first], condition));
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
        for (pre, post, condition) in &draw.arcs {
            let list = |steps: &[usize]| steps.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ");
            let _ = writeln!(out, "  transition {} -> {} : {condition}", list(pre), list(post));
        }
        out.push_str("}\n\n");
    }
    out
}

fn condition(rng: &mut Rng) -> String {
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

struct Draw {
    steps: Vec<usize>,
    arcs: Vec<(Vec<usize>, Vec<usize>, String)>,
    next: usize,
}

impl Draw {
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
