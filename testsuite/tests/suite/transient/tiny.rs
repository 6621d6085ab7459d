//! Tiny charts, drawn at random, that are rich in what lets one micro-step cause another: activities, variables
//! and wires in conditions, edges and delays of them, orders, enclosures, actions on clearing, several tokens.

use fastrand::Rng;
use std::ops::Range;

/// The text of a chart over the Boolean inputs `a` and `b`; a few texts have errors.
pub fn text(seed: u64) -> String {
    let mut rng = Rng::with_seed(seed);
    let shape = TinyShape::draw(&mut rng);
    let mut chart = String::from("input a, b : bool\noutput w, p, q : bool\nvar n : int\n");
    for (g, steps) in shape.grafcets.iter().enumerate() {
        let name = if shape.is_enclosed(g) { "X10/G2".to_owned() } else { format!("G{}", g + 1) };
        chart += &format!("grafcet {name} {{\n");
        for step in steps.clone() {
            chart += &shape.step(&mut rng, g, step);
        }
        for (before, after) in arcs(&mut rng, steps) {
            let action =
                if rng.f32() < 0.25 { format!(" {{ {} }}", shape.allocation(&mut rng)) } else { String::new() };
            chart += &format!("  transition {before} -> {after} : {}{action}\n", shape.condition(&mut rng));
        }
        chart += "}\n";
    }
    chart
}

struct TinyShape {
    /// The labels of the steps of each grafcet; one or two.
    grafcets: Vec<Range<usize>>,
    /// Step 10 encloses the second grafcet.
    enclosed: bool,
    /// Steps of the first grafcet may force the second.
    forced: bool,
    /// How often a condition waits for an edge; without that hardly a chart would have a bound.
    edges: f32,
}

impl TinyShape {
    fn draw(rng: &mut Rng) -> Self {
        let mut grafcets = vec![Range { start: 10, end: 10 + rng.usize(2..=4) }];
        if rng.f32() < 0.6 {
            grafcets.push(20..20 + rng.usize(1..=3));
        }
        let two = grafcets.len() > 1;
        TinyShape { grafcets, enclosed: two && rng.f32() < 0.4, forced: two && rng.f32() < 0.5, edges: rng.f32() }
    }

    fn is_enclosed(&self, g: usize) -> bool {
        self.enclosed && g == 1
    }

    fn step(&self, rng: &mut Rng, g: usize, step: usize) -> String {
        let first = step == self.grafcets[g].start;
        let mut words = String::new();
        if first || !self.is_enclosed(g) && rng.f32() < 0.3 {
            words += "initial ";
        }
        if self.enclosed && step == 10 {
            words += "enclosing ";
        }
        if self.is_enclosed(g) && (first || rng.f32() < 0.3) {
            words += "activated ";
        }
        let mut actions: Vec<String> = Vec::new();
        if rng.f32() < 0.3 {
            // Not by way of `w`, which must not depend on itself.
            let condition = self.level(rng).replace('w', "p");
            actions.push(if rng.bool() { "w".to_owned() } else { format!("w if {condition}") });
        }
        for _ in 0..rng.usize(0..=2) {
            let event = match rng.usize(0..4) {
                0 => "on deactivation".to_owned(),
                1 => format!("on event {}", self.condition(rng)),
                _ => "on activation".to_owned(),
            };
            actions.push(format!("{} {event}", self.allocation(rng)));
        }
        if self.forced && g == 0 && rng.f32() < 0.7 {
            let situation = match rng.usize(0..4) {
                0 => "*".to_owned(),
                1 => "INIT".to_owned(),
                2 => String::new(),
                _ => rng.usize(self.grafcets[1].clone()).to_string(),
            };
            actions.push(format!("force G2{{{situation}}}"));
        }
        format!("  {words}step {step} {{ {} }}\n", actions.join("\n    "))
    }

    fn allocation(&self, rng: &mut Rng) -> String {
        let name = ["p", "q"][rng.usize(0..2)];
        match rng.usize(0..6) {
            0 => "n := n + 1".to_owned(),
            1 => "n := 0".to_owned(),
            2 => format!("{name} := {}", self.level(rng)),
            3 => format!("{name} := 0"),
            _ => format!("{name} := 1"),
        }
    }

    /// An expression without an edge.
    fn level(&self, rng: &mut Rng) -> String {
        let of = self.grafcets[rng.usize(0..self.grafcets.len())].clone();
        let step = rng.usize(of);
        let literal = match rng.usize(0..18) {
            0..=4 => "a".to_owned(),
            5..=7 => "b".to_owned(),
            8..=10 => format!("X{step}"),
            11 => format!("XG{}", rng.usize(0..self.grafcets.len()) + 1),
            12 => "w".to_owned(),
            13 => "p".to_owned(),
            14 => "q".to_owned(),
            15 => ["[n < 2]", "[n >= 1]", "[n = 1]", "[5 / n > 2]"][rng.usize(0..4)].to_owned(),
            16 => format!("[T{step} {} 1s]", ["<", ">="][rng.usize(0..2)]),
            _ => {
                let operand = [format!("X{step}"), "a".to_owned(), "p".to_owned(), "(a and b)".to_owned()];
                let operand = &operand[rng.usize(0..4)];
                match rng.usize(0..3) {
                    0 => format!("1s/{operand}"),
                    1 => format!("{operand}/1s"),
                    _ => format!("1s/{operand}/1s"),
                }
            }
        };
        if rng.f32() < 0.3 { format!("not ({literal})") } else { literal }
    }

    fn edge(&self, rng: &mut Rng) -> String {
        let arrow = if rng.f32() < 0.7 { "↑" } else { "↓" };
        let operand = if rng.f32() < 0.7 { ["a", "b"][rng.usize(0..2)].to_owned() } else { self.level(rng) };
        format!("{arrow}({operand})")
    }

    fn condition(&self, rng: &mut Rng) -> String {
        if rng.f32() < self.edges {
            let edge = self.edge(rng);
            return if rng.bool() { edge } else { format!("{edge} and {}", self.level(rng)) };
        }
        match rng.usize(0..8) {
            0 => "1".to_owned(),
            1 => format!("{} or {}", self.edge(rng), self.level(rng)),
            2 => format!("not {}", self.edge(rng)),
            3 => format!("{} and {}", self.level(rng), self.level(rng)),
            4 => self.edge(rng),
            _ => self.level(rng),
        }
    }
}

/// A ring with gaps, and up to two arcs of any kind.
fn arcs(rng: &mut Rng, steps: &Range<usize>) -> Vec<(String, String)> {
    let mut arcs: Vec<(String, String)> = Vec::new();
    for step in steps.clone() {
        if rng.f32() < 0.6 {
            let next = if step + 1 == steps.end { steps.start } else { step + 1 };
            arcs.push((step.to_string(), next.to_string()));
        }
    }
    for _ in 0..rng.usize(0..=2) {
        let arc = (some(rng, steps), some(rng, steps));
        if arc != (String::new(), String::new()) {
            arcs.push(arc);
        }
    }
    arcs
}

/// No step, one or two.
fn some(rng: &mut Rng, steps: &Range<usize>) -> String {
    let (one, other) = (rng.usize(steps.clone()), rng.usize(steps.clone()));
    match rng.usize(0..10) {
        0 => String::new(),
        1 | 2 if one != other => format!("{one}, {other}"),
        _ => one.to_string(),
    }
}
