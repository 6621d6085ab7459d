//! The structure of a random chart: grafcets and expansions with their steps and arcs, nothing else.

use super::ChartKind;
use fastrand::Rng;

/// A grafcet or an expansion.
#[derive(Debug)]
pub(super) struct Frame {
    /// Its name; of an expansion that of its macro-step.
    pub name: String,
    /// What it is.
    pub place: FrameKind,
    /// Its steps and macro-steps.
    pub nodes: Vec<RandomStep>,
    /// Its arcs, a transition a pair.
    pub arcs: Vec<(Vec<String>, Vec<String>)>,
    /// The grafcet that it is a child of.
    pub parent: Option<String>,
    /// Pulse orders on clearing, by the place of the arc.
    pub clearing: Vec<(usize, String)>,
}

/// What a frame is, and where.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum FrameKind {
    /// A partial grafcet at the top.
    Top,
    /// Enclosed by this step.
    In(String),
    /// The expansion of a macro-step in the grafcet of this name.
    Expansion(String),
}

/// A step or a macro-step.
#[derive(Debug)]
pub(super) struct RandomStep {
    pub label: String,
    pub kind: RandomStepKind,
    pub initial: bool,
    pub activated: bool,
    /// Forcing orders, as text after `force`.
    pub orders: Vec<String>,
    /// Pulse orders; `?` stands for the event that one waits for.
    pub pulses: Vec<String>,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum RandomStepKind {
    Step,
    Enclosing,
    Macro,
}

/// Draws all frames, a `size` of 1 being that of a small chart; those that enclose or force come before those that are enclosed or forced.
pub(super) fn draw(rng: &mut Rng, kind: ChartKind, size: usize) -> Vec<Frame> {
    let mut frames = Vec::new();
    let count = match kind {
        ChartKind::Flat | ChartKind::Plain | ChartKind::Ordered | ChartKind::Boolean => rng.usize(1..=2 + size),
        ChartKind::Hierarchical | ChartKind::Commanded => rng.usize(2..=4 + size),
    };
    for index in 0..count {
        let macros = rng.f32() < 0.25;
        let name = format!("G{index}");
        draw_frame(rng, &mut frames, name, FrameKind::Top, ((index + 1) * 100 * size, size), macros);
    }
    if matches!(kind, ChartKind::Hierarchical | ChartKind::Commanded) {
        enclose(rng, &mut frames);
        force(rng, &mut frames);
    }
    keep_alive(rng, &mut frames);
    frames
}

fn node(label: String, kind: RandomStepKind) -> RandomStep {
    RandomStep { label, kind, initial: false, activated: false, orders: Vec::new(), pulses: Vec::new() }
}

/// Draws one frame, and behind it the expansions of its macro-steps.
fn draw_frame(
    rng: &mut Rng,
    frames: &mut Vec<Frame>,
    name: String,
    place: FrameKind,
    (base, size): (usize, usize),
    macros: bool,
) {
    let expansion = matches!(place, FrameKind::Expansion(_));
    let grafcet = if let FrameKind::Expansion(of) = &place { of.clone() } else { name.clone() };
    let count = if expansion { rng.usize(0..=3) } else { rng.usize(2..=8 * size) };
    let mut nodes: Vec<RandomStep> = Vec::new();
    for index in 0..count {
        let label = if rng.f32() < 0.15 {
            format!("{}{}", LABELS[rng.usize(0..LABELS.len())], base + index)
        } else {
            (base + index).to_string()
        };
        nodes.push(node(label, RandomStepKind::Step));
    }
    let mut expansions = Vec::new();
    if macros && !nodes.is_empty() {
        let last = nodes.len() - 1;
        nodes[last] = node(format!("M{}", base + last), RandomStepKind::Macro);
        expansions.push(nodes[last].label.clone());
    }
    let mut labels: Vec<String> = nodes.iter().map(|n| n.label.clone()).collect();
    let mut arcs = Vec::new();
    if let Some(number) = name.strip_prefix('M').filter(|_| expansion) {
        let (entry, exit) = (format!("E{number}"), format!("S{number}"));
        region(rng, &mut arcs, &entry, &labels, &exit);
        nodes.insert(0, node(entry.clone(), RandomStepKind::Step));
        nodes.push(node(exit.clone(), RandomStepKind::Step));
        nodes[0].initial = rng.f32() < 0.05;
        labels.extend([entry, exit]);
    } else {
        let first = labels[0].clone();
        region(rng, &mut arcs, &first, &labels[1..], &first);
        if nodes[0].kind == RandomStepKind::Step {
            nodes[0].initial = rng.f32() < 0.9;
        }
        for other in nodes.iter_mut().skip(1).filter(|n| n.kind == RandomStepKind::Step) {
            other.initial = rng.f32() < 0.08;
        }
    }
    for _ in 0..rng.usize(0..=2) {
        let mut side = |empty: f32| -> Vec<String> {
            if rng.f32() < empty {
                return Vec::new();
            }
            let mut side: Vec<String> =
                (0..if rng.f32() < 0.3 { 2 } else { 1 }).map(|_| labels[rng.usize(0..labels.len())].clone()).collect();
            side.sort();
            side.dedup();
            side
        };
        let arc = (side(0.12), side(0.15));
        if !(arc.0.is_empty() && arc.1.is_empty()) {
            arcs.push(arc);
        }
    }
    rng.shuffle(&mut arcs);
    frames.push(Frame { name, place, nodes, arcs, parent: None, clearing: Vec::new() });
    for (index, label) in expansions.into_iter().enumerate() {
        let nested = rng.f32() < 0.2;
        let base = (base + 20 * size * (index + 1), size);
        draw_frame(rng, frames, label, FrameKind::Expansion(grafcet.clone()), base, nested);
    }
}

const LABELS: [&str; 5] = ["Fill", "шаг", "Höhe", "n_", "STEP"];

/// Arcs that lead from `from` over all of `labels` to `to`: sequences, branches, parallel branches.
fn region(rng: &mut Rng, arcs: &mut Vec<(Vec<String>, Vec<String>)>, from: &str, labels: &[String], to: &str) {
    let one = |label: &str| vec![label.to_string()];
    if labels.is_empty() {
        arcs.push((one(from), one(to)));
        return;
    }
    let split = if labels.len() > 1 { rng.usize(1..labels.len()) } else { 1 };
    let (left, right) = labels.split_at(split);
    match rng.u8(0..10) {
        // An OR-divergence and its convergence; the right branch may be empty.
        0..3 => {
            region(rng, arcs, from, left, to);
            region(rng, arcs, from, right, to);
        }
        // An AND-divergence, a sequence a branch, and the synchronisation.
        3..6 if !right.is_empty() => {
            arcs.push((one(from), vec![left[0].clone(), right[0].clone()]));
            for pair in left.windows(2).chain(right.windows(2)) {
                arcs.push((one(&pair[0]), one(&pair[1])));
            }
            arcs.push((vec![left[left.len() - 1].clone(), right[right.len() - 1].clone()], one(to)));
        }
        // A sequence.
        _ => {
            arcs.push((one(from), one(&labels[0])));
            region(rng, arcs, &labels[0], &labels[1..], to);
        }
    }
}

/// Encloses some grafcets by steps of earlier ones, up to three levels and more.
fn enclose(rng: &mut Rng, frames: &mut [Frame]) {
    for index in 1..frames.len() {
        if frames[index].place != FrameKind::Top || rng.f32() < 0.35 {
            continue;
        }
        let (before, rest) = frames.split_at_mut(index);
        let hosts: Vec<usize> =
            (0..before.len()).filter(|&i| !matches!(before[i].place, FrameKind::Expansion(_))).collect();
        let host = &mut before[hosts[rng.usize(0..hosts.len())]];
        let steps: Vec<usize> =
            (0..host.nodes.len()).filter(|&i| host.nodes[i].kind != RandomStepKind::Macro).collect();
        if steps.is_empty() {
            continue;
        }
        let step = &mut host.nodes[steps[rng.usize(0..steps.len())]];
        step.kind = RandomStepKind::Enclosing;
        let (label, initial) = (step.label.clone(), step.initial);
        let inside = &mut rest[0];
        inside.place = FrameKind::In(label);
        let candidates: Vec<usize> =
            (0..inside.nodes.len()).filter(|&i| inside.nodes[i].kind != RandomStepKind::Macro).collect();
        for &i in &candidates {
            inside.nodes[i].initial &= initial;
            inside.nodes[i].activated = rng.f32() < 0.3;
        }
        inside.nodes[candidates[0]].initial = initial;
        if candidates.iter().all(|&i| !inside.nodes[i].activated) {
            inside.nodes[candidates[rng.usize(0..candidates.len())]].activated = true;
        }
        if !initial {
            // Nor may an expansion start something in an enclosure that is not active.
            let name = inside.name.clone();
            for expansion in rest.iter_mut().filter(|f| f.place == FrameKind::Expansion(name.clone())) {
                expansion.nodes.iter_mut().for_each(|n| n.initial = false);
            }
        }
    }
}

/// Lets steps force later grafcets.
fn force(rng: &mut Rng, frames: &mut [Frame]) {
    for target in 1..frames.len() {
        if matches!(frames[target].place, FrameKind::Expansion(_)) {
            continue;
        }
        let steps: Vec<String> =
            frames[target].nodes.iter().filter(|n| n.kind != RandomStepKind::Macro).map(|n| n.label.clone()).collect();
        let name = frames[target].name.clone();
        for _ in 0..if rng.f32() < 0.5 { 0 } else { rng.usize(1..=2) } {
            let host = &mut frames[rng.usize(0..target)];
            let same = host.name == name || host.place == FrameKind::Expansion(name.clone());
            let choices: Vec<usize> =
                (0..host.nodes.len()).filter(|&i| host.nodes[i].kind != RandomStepKind::Macro).collect();
            if same || choices.is_empty() {
                continue;
            }
            let situation = match rng.u8(0..5) {
                0 => "*".to_string(),
                1 => String::new(),
                2 => "INIT".to_string(),
                _ => {
                    let mut forced: Vec<String> =
                        (0..rng.usize(1..=2)).map(|_| steps[rng.usize(0..steps.len())].clone()).collect();
                    forced.dedup();
                    forced.join(", ")
                }
            };
            host.nodes[choices[rng.usize(0..choices.len())]].orders.push(format!("{name}{{{situation}}}"));
        }
    }
}

/// Gives each top grafcet that nothing would ever activate an initial step, or at times a source transition.
fn keep_alive(rng: &mut Rng, frames: &mut [Frame]) {
    for frame in frames.iter_mut().filter(|f| f.place == FrameKind::Top && f.parent.is_none()) {
        if frame.nodes.iter().any(|n| n.initial) || frame.arcs.iter().any(|(pre, _)| pre.is_empty()) {
            continue;
        }
        match frame.nodes.iter_mut().find(|n| n.kind != RandomStepKind::Macro) {
            Some(step) if rng.f32() < 0.5 && step.kind == RandomStepKind::Step => step.initial = true,
            _ => frame.arcs.push((Vec::new(), vec![frame.nodes[0].label.clone()])),
        }
    }
}
