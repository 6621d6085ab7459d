//! Children and pulse orders of a random chart; drawn apart, so that charts without them stay as they are.

use super::structure::{Frame, FrameKind, RandomStepKind};
use fastrand::Rng;

/// Lets steps of some charts command later grafcets, some of which become their children; what is commanded may command in
/// turn.
pub(super) fn draw(rng: &mut Rng, frames: &mut [Frame]) {
    if rng.u8(0..3) != 0 {
        return;
    }
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
    }
}

/// One order of a frame.
fn command(rng: &mut Rng, host: &mut Frame, name: &str) {
    let word = ["start", "start", "start", "kill", "freeze", "resume", "resume"][rng.usize(0..7)];
    if rng.f32() < 0.15 && !host.arcs.is_empty() {
        host.clearing.push((rng.usize(0..host.arcs.len()), format!("{word} {name}")));
        return;
    }
    let steps: Vec<usize> = (0..host.nodes.len()).filter(|&i| host.nodes[i].kind != RandomStepKind::Macro).collect();
    if steps.is_empty() {
        return;
    }
    let pulse = match rng.u8(0..10) {
        0..3 => format!("run {name}"),
        3..7 => format!("{word} {name} on activation"),
        7 => format!("{word} {name} on deactivation"),
        _ => format!("{word} {name} on event ?"),
    };
    host.nodes[steps[rng.usize(0..steps.len())]].pulses.push(pulse);
}
