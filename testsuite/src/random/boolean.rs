//! Small charts of Boolean inputs alone, without delays, in which everything may be tried: any transitions between any
//! steps, edges, stored bits, actions on events, orders and enclosures.

use fastrand::Rng;
use std::fmt::Write as _;

const INPUTS: [&str; 5] = ["a", "b", "c", "d", "e"];

/// The text of a small Boolean chart. Children and pulse orders are drawn apart, so that charts without them stay as they are.
pub(super) fn chart(rng: &mut Rng, commands: &mut Rng, alone: &mut Rng, name: &str) -> String {
    let inputs = &INPUTS[..rng.usize(2..=5)];
    let mut out = format!("chart {name}\n\ninput {} : bool\noutput w, v : bool\nvar q : bool\n\n", inputs.join(", "));
    // Up to ten steps in up to three grafcets.
    let grafcets = rng.usize(1..=3);
    let sizes: Vec<usize> = (0..grafcets).map(|_| rng.usize(2..=3 + usize::from(grafcets < 3))).collect();
    let labels = |grafcet: usize| (1..=sizes[grafcet]).map(move |step| grafcet * 10 + step);
    let all: Vec<usize> = (0..grafcets).flat_map(labels).collect();
    // A later grafcet may be enclosed by a step of an earlier one, or forced by one.
    let encloser: Vec<Option<usize>> = (0..grafcets)
        .map(|grafcet| {
            (grafcet > 0 && rng.u8(0..3) == 0).then(|| (grafcet - 1) * 10 + rng.usize(1..=sizes[grafcet - 1]))
        })
        .collect();
    // A later one may be commanded by pulses, and be a child.
    let commander: Vec<Option<Commander>> = (0..grafcets)
        .map(|grafcet| {
            (grafcet > 0 && encloser[grafcet].is_none()).then(|| Commander::draw(commands, alone, grafcet))?
        })
        .collect();
    for grafcet in 0..grafcets {
        let enclosed = encloser[grafcet];
        match enclosed.map(Ok).or(commander[grafcet].as_ref().filter(|by| by.is_parent).map(Err)) {
            Some(Ok(step)) => writeln!(out, "grafcet X{step}/G{grafcet} {{"),
            Some(Err(by)) => writeln!(out, "child grafcet G{grafcet} of G{} {{", by.grafcet),
            None => writeln!(out, "grafcet G{grafcet} {{"),
        }
        .expect("a string takes all");
        let first = rng.usize(1..=sizes[grafcet]);
        for step in labels(grafcet) {
            let encloses = encloser.contains(&Some(step));
            let is_first = step == grafcet * 10 + first;
            let mut words = String::new();
            if is_first && enclosed.is_none() || rng.u8(0..8) == 0 {
                words.push_str("initial ");
            }
            if encloses {
                words.push_str("enclosing ");
            }
            let link = if is_first && enclosed.is_some() { "*" } else { "" };
            let mut actions = Vec::new();
            match rng.u8(0..10) {
                0..3 => actions.push("w".to_owned()),
                3 => actions.push(format!("v if {}", condition(rng, inputs, &all))),
                4 | 5 => actions.push("q := not q on activation".to_owned()),
                6 => actions.push("q := true on deactivation".to_owned()),
                7 => actions.push(format!("q := {} on event {}", rng.bool(), event(rng, inputs))),
                _ => {}
            }
            let forced = grafcet + 1;
            if forced < grafcets && encloser[forced].is_none() && rng.u8(0..4) == 0 {
                let to = match rng.u8(0..4) {
                    0 => "{*}".to_owned(),
                    1 => "{}".to_owned(),
                    2 => "{INIT}".to_owned(),
                    _ => format!("{{{}}}", forced * 10 + rng.usize(1..=sizes[forced])),
                };
                actions.push(format!("force G{forced}{to}"));
            }
            for (target, by) in commander.iter().enumerate() {
                let Some(by) = by.as_ref().filter(|by| by.grafcet == grafcet) else { continue };
                if commands.u8(0..5) < 3 {
                    let drawn = pulse(commands, inputs, target);
                    actions.push(if by.is_alone { format!("run G{target}") } else { drawn });
                }
            }
            let body = if actions.is_empty() { String::new() } else { format!(" {{ {} }}", actions.join("  ")) };
            let _ = writeln!(out, "  {words}step {link}{step}{body}");
        }
        for _ in 0..rng.usize(sizes[grafcet]..=sizes[grafcet] + 2) {
            let some = |rng: &mut Rng| {
                let mut steps: Vec<String> = labels(grafcet).map(|step| step.to_string()).collect();
                rng.shuffle(&mut steps);
                steps.truncate(if rng.u8(0..5) == 0 { 2 } else { 1 });
                steps.join(", ")
            };
            let (before, after) = (some(rng), some(rng));
            let action = if rng.u8(0..10) == 0 { " { q := not q }" } else { "" };
            let _ = writeln!(out, "  transition {before} -> {after} : {}{action}", condition(rng, inputs, &all));
        }
        out.push_str("}\n\n");
    }
    out
}

/// What commands a grafcet by pulses.
struct Commander {
    grafcet: usize,
    /// Whether the commanded one is its child.
    is_parent: bool,
    /// Whether it does nothing but run it.
    is_alone: bool,
}

impl Commander {
    fn draw(rng: &mut Rng, alone: &mut Rng, commanded: usize) -> Option<Self> {
        if rng.u8(0..2) == 0 {
            return None;
        }
        let (grafcet, is_parent) = (rng.usize(0..commanded), rng.u8(0..3) > 0);
        Some(Commander { grafcet, is_parent, is_alone: alone.bool() })
    }
}

/// An order of a step.
fn pulse(rng: &mut Rng, inputs: &[&str], commanded: usize) -> String {
    let word = ["start", "start", "kill", "freeze", "resume"][rng.usize(0..5)];
    match rng.u8(0..8) {
        0..3 => format!("run G{commanded}"),
        3 => format!("{word} G{commanded} on deactivation"),
        4 => format!("{word} G{commanded} on event {}", event(rng, inputs)),
        _ => format!("{word} G{commanded} on activation"),
    }
}

fn condition(rng: &mut Rng, inputs: &[&str], steps: &[usize]) -> String {
    let first = literal(rng, inputs, steps);
    match rng.u8(0..5) {
        0 => format!("{first} and {}", literal(rng, inputs, steps)),
        1 => format!("{first} or {}", literal(rng, inputs, steps)),
        _ => first,
    }
}

fn literal(rng: &mut Rng, inputs: &[&str], steps: &[usize]) -> String {
    let input = inputs[rng.usize(0..inputs.len())];
    match rng.u8(0..12) {
        0 | 1 => format!("↑{input}"),
        2 => format!("↓{input}"),
        3 | 4 => format!("not {input}"),
        5 => format!("X{}", steps[rng.usize(0..steps.len())]),
        6 => "q".to_owned(),
        7 if rng.u8(0..4) == 0 => "1".to_owned(),
        _ => input.to_owned(),
    }
}

fn event(rng: &mut Rng, inputs: &[&str]) -> String {
    let [one, other] = [0, 1].map(|_| inputs[rng.usize(0..inputs.len())]);
    match rng.u8(0..4) {
        0 => format!("(↑{one} or {other})"),
        1 => format!("↓{one}"),
        _ => format!("↑{one}"),
    }
}
