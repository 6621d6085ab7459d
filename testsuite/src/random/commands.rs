//! Children and pulse orders of a random chart; drawn apart, so that charts without them stay as they are.

use super::structure::{Frame, FrameKind, RandomStepKind};
use fastrand::Rng;

/// Lets steps command later grafcets, some of which become their children; what is commanded may command in
/// turn.
pub(super) fn draw(rng: &mut Rng, frames: &mut [Frame]) {
    for target in 1..frames.len() {
        if matches!(frames[target].place, FrameKind::Expansion(_)) || rng.f32() < 0.35 {
            continue;
        }
        let name = frames[target].name.clone();
        let grafcet = |frame: &Frame| match &frame.place {
            FrameKind::Expansion(of) => of.clone(),
            FrameKind::Top | FrameKind::In(_) => frame.name.clone(),
        };
        let hosts: Vec<usize> = (0..target).filter(|&host| grafcet(&frames[host]) != name).collect();
        if hosts.is_empty() {
            continue;
        }
        let parent = grafcet(&frames[hosts[rng.usize(0..hosts.len())]]);
        let is_child = frames[target].place == FrameKind::Top && rng.f32() < 0.7;
        let is_host = |host: &usize| !is_child || grafcet(&frames[*host]) == parent;
        let hosts: Vec<usize> = hosts.iter().copied().filter(is_host).collect();
        if is_child {
            frames[target].parent = Some(parent);
        }
        for _ in 0..rng.usize(2..=6) {
            let host = hosts[rng.usize(0..hosts.len())];
            command(rng, &mut frames[host], &name);
        }
        // What is seldom by chance: a restart, an order of what is left just as it stops, an order that sets a situation.
        let host = hosts[rng.usize(0..hosts.len())];
        let Some(step) = some_step(rng, &frames[host]) else { continue };
        let step = &mut frames[host].nodes[step];
        match rng.u8(0..8) {
            0 | 1 => {
                let event = ["on activation", "on deactivation"][rng.usize(0..2)];
                step.pulses.extend(["kill", "start"].map(|word| format!("{word} {name} {event}")));
            }
            2 | 3 => step.pulses.push(format!("start {name} on deactivation")),
            4 => step.orders.push(format!("{name}{{INIT}}")),
            _ => {}
        }
    }
}

/// Lets some children do nothing but run with steps of one frame of their parent, where they may be told nothing else.
pub(super) fn leave_alone(rng: &mut Rng, frames: &mut [Frame]) {
    for target in 0..frames.len() {
        let Some(parent) = frames[target].parent.clone().filter(|_| rng.bool()) else { continue };
        let name = frames[target].name.clone();
        let is_of_it = |order: &String| order.split(' ').nth(1) == Some(name.as_str());
        for frame in frames.iter_mut() {
            frame.clearing.retain(|(_, order)| !is_of_it(order));
            for node in &mut frame.nodes {
                node.pulses.retain(|order| !is_of_it(order));
                node.orders.retain(|order| !order.starts_with(&format!("{name}{{")) || rng.u8(0..4) == 0);
            }
        }
        let Some(host) = frames.iter().position(|frame| frame.name == parent) else { continue };
        for _ in 0..rng.usize(1..=3) {
            let Some(step) = some_step(rng, &frames[host]) else { continue };
            let node = &mut frames[host].nodes[step];
            node.pulses.retain(|order| !is_of_it(order));
            node.pulses.push(match rng.u8(0..6) {
                0 => format!("start {name} on activation kill {name} on deactivation"),
                _ => format!("run {name}"),
            });
        }
    }
}

/// One order of a frame.
fn command(rng: &mut Rng, host: &mut Frame, name: &str) {
    let word = ["start", "start", "start", "kill", "freeze", "resume", "resume"][rng.usize(0..7)];
    if rng.f32() < 0.15 && !host.arcs.is_empty() {
        host.clearing.push((rng.usize(0..host.arcs.len()), format!("{word} {name}")));
        return;
    }
    let Some(step) = some_step(rng, host) else { return };
    let pulse = match rng.u8(0..10) {
        0..3 => format!("run {name}"),
        3..7 => format!("{word} {name} on activation"),
        7 => format!("{word} {name} on deactivation"),
        _ => format!("{word} {name} on event ?"),
    };
    host.nodes[step].pulses.push(pulse);
}

/// A step that can have actions.
fn some_step(rng: &mut Rng, host: &Frame) -> Option<usize> {
    let steps: Vec<usize> = (0..host.nodes.len()).filter(|&i| host.nodes[i].kind != RandomStepKind::Macro).collect();
    (!steps.is_empty()).then(|| steps[rng.usize(0..steps.len())])
}
