//! Plain grafcets, of which some command others, as a sequential function chart can be told to: orders in the order of a
//! round, so that nothing is started while it is active, and each grafcet with outputs of its own.

use super::plain::{Draw, condition};
use fastrand::Rng;
use std::collections::BTreeMap;
use std::fmt::Write as _;

/// What commands a grafcet.
enum Command {
    Nothing,
    /// Enclosed by a step.
    Enclosed(usize),
    /// A child, by actions of steps of another grafcet.
    Child(usize),
    /// Forced by actions of steps.
    Forced,
}

/// The text of such a chart.
pub(super) fn chart(rng: &mut Rng, name: &str) -> String {
    let count = rng.usize(2..=3);
    let rings: Vec<Draw> = (0..count)
        .map(|ring| {
            let regions = if ring == 0 { rng.usize(2..=4) } else { rng.usize(1..=2) };
            let depth = if rng.usize(0..8) == 0 { 2 } else { 1 };
            Draw::ring(rng, (ring + 1) * 100, regions, depth)
        })
        .collect();
    let mut of_steps: BTreeMap<usize, Vec<String>> = BTreeMap::new();
    let mut commands = vec![Command::Nothing];
    for ring in 1..count {
        let above = rng.usize(0..ring);
        let command = command(rng, &rings, above, ring, &mut of_steps);
        commands.push(command);
    }
    let names: Vec<String> = (0..count).map(|ring| grafcet(ring, &commands[ring])).collect();
    let options = if rng.usize(0..4) == 0 { "" } else { " evolution scan" };
    let mut out = format!("chart {name}{options}\n\ninput a, b, c, d, e : bool\n");
    for ring in 0..count {
        let _ = writeln!(out, "output w{ring}0, w{ring}1 : bool\noutput n{ring} : int");
    }
    out.push('\n');
    for (ring, draw) in rings.iter().enumerate() {
        let (heading, first) = match commands[ring] {
            Command::Nothing | Command::Forced => (format!("grafcet {}", names[ring]), "initial "),
            Command::Enclosed(step) => (format!("grafcet X{step}/{}", names[ring]), "activated "),
            Command::Child(above) => (format!("child grafcet {} of {}", names[ring], names[above]), "initial "),
        };
        let _ = writeln!(out, "{heading} {{");
        let encloses =
            |step: usize| commands.iter().any(|command| matches!(command, Command::Enclosed(s) if *s == step));
        for (index, step) in draw.steps.iter().enumerate() {
            let mut actions = of_steps.remove(step).unwrap_or_default();
            match rng.usize(0..6) {
                0 | 1 => actions.push(format!("w{ring}{}", rng.usize(0..2))),
                2 => {
                    let other = rng.usize(0..count);
                    let frozen = matches!(commands[other], Command::Child(_)) && rng.bool();
                    let [is, input] = [if frozen { "F" } else { "X" }, ["a", "b", "c"][rng.usize(0..3)]];
                    let said = if rng.usize(0..3) == 0 { format!("{is}{}", names[other]) } else { input.to_owned() };
                    actions.push(format!("w{ring}{} if {said}", rng.usize(0..2)));
                }
                // Branches would count at once, and not each tool has an activation of what is active at the start.
                3 | 4 if draw.spine[1..].contains(step) => {
                    actions.push(format!("n{ring} := n{ring} + 1 on activation"))
                }
                _ => {}
            }
            let actions = if actions.is_empty() { String::new() } else { format!(" {{ {} }}", actions.join("  ")) };
            let marks = [if index == 0 { first } else { "" }, if encloses(*step) { "enclosing " } else { "" }].concat();
            let _ = writeln!(out, "  {marks}step {step}{actions}");
        }
        draw.write_arcs(&mut out);
        out.push_str("}\n\n");
    }
    out
}

fn grafcet(ring: usize, command: &Command) -> String {
    match command {
        Command::Child(_) => format!("P{ring}"),
        Command::Nothing | Command::Enclosed(_) | Command::Forced => format!("G{ring}"),
    }
}

/// Draws what commands a ring, and gives the orders to the steps of one above it.
fn command(
    rng: &mut Rng,
    rings: &[Draw],
    above: usize,
    ring: usize,
    of_steps: &mut BTreeMap<usize, Vec<String>>,
) -> Command {
    let mut add = |step: usize, order: String| of_steps.entry(step).or_default().push(order);
    let spine = &rings[above].spine;
    let pick = |rng: &mut Rng| spine[rng.usize(0..spine.len())];
    match rng.usize(0..8) {
        0 | 1 => Command::Enclosed(pick(rng)),
        2 | 3 => {
            let first = rng.usize(0..spine.len());
            for step in spine.iter().skip(first).take(rng.usize(1..=2)) {
                add(*step, format!("run P{ring}"));
            }
            Command::Child(above)
        }
        4 => {
            let steps = &rings[ring].steps;
            let order = match rng.usize(0..4) {
                0 => "{}".to_owned(),
                1 => "{*}".to_owned(),
                2 => "{INIT}".to_owned(),
                _ => format!("{{{}}}", steps[rng.usize(0..steps.len())]),
            };
            add(pick(rng), format!("force G{ring}{order}"));
            Command::Forced
        }
        _ => {
            // In the order of a round, and at most one at a step.
            let mut kinds = vec!["start"];
            if rng.bool() {
                kinds.push("freeze");
                if rng.bool() {
                    kinds.push("resume");
                }
            }
            kinds.push("kill");
            if kinds.len() > spine.len() {
                kinds = vec!["start", "kill"];
            }
            let mut left = kinds.len();
            let mut kinds = kinds.into_iter().peekable();
            for (place, step) in spine.iter().enumerate() {
                let Some(kind) = kinds.peek() else { break };
                let must = spine.len() - place <= left;
                if !must && rng.bool() {
                    continue;
                }
                let when = match rng.usize(0..5) {
                    0 if *kind != "start" => "on deactivation".to_owned(),
                    1 if *kind == "kill" => format!("on event ↑{}", condition(rng).trim_start_matches(['↑', ' '])),
                    _ => "on activation".to_owned(),
                };
                let when =
                    if when.contains(" and ") || when.contains("not ") { "on activation".to_owned() } else { when };
                add(*step, format!("{kind} P{ring} {when}"));
                kinds.next();
                left -= 1;
            }
            Command::Child(above)
        }
    }
}
