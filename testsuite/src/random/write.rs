//! A random chart as text: declarations, then the frames with conditions and actions.
//!
//! What means the same either way is left to `ink`.

use super::expression::{Allowed, Scope};
use super::ink::Ink;
use super::options::Options;
use super::structure::{Frame, FrameKind, RandomStepKind};
use fastrand::Rng;
use grafc_model::chart::Type;
use grafc_model::dump::type_name;
use std::fmt::Write as _;

const TYPES: [Type; 8] =
    [Type::Int, Type::Dint, Type::Uint, Type::Udint, Type::Real, Type::Lreal, Type::Time, Type::Bool];

/// Names that targets stumble over; each is unique whatever its case.
const AWKWARD: [&str; 14] =
    ["`on`", "TON", "EN", "вход", "Größe", "a__b", "x_", "NULL", "`2s/X202`", "ADD", "R_EDGE", "`a b`", "_u", "REAL"];

/// The text of a chart with these frames.
pub(super) fn chart(rng: &mut Rng, ink: &mut Ink, name: &str, frames: &[Frame]) -> String {
    let mut out = String::new();
    let mut options = Options::draw(ink.seed());
    if !ink.chance(0.03) {
        let _ = writeln!(out, "chart {name}{}{}\n", ink.attached(0.1), options.text());
    } else {
        options = Options::default();
    }
    let mut writer = Writer {
        scope: Scope::default(),
        stored: Vec::new(),
        awkward: AWKWARD.to_vec(),
        scans: options.scans(),
        declared: Vec::new(),
        designations: 0,
        waits: ink.waits(),
        rng,
        ink,
    };
    writer.name_activities(frames);
    writer.declare(&mut out);
    let mut blocks: Vec<String> = Vec::new();
    for frame in frames {
        let mut block = String::new();
        writer.ink.remark(&mut block);
        writer.frame(&mut block, frame, frames.len() == 1);
        blocks.push(block);
    }
    nest(ink, frames, &mut blocks);
    out.extend(blocks);
    let out = ink.respell(&out);
    tested(ink.allow(out), name)
}

/// Some charts have a scenario, which changes nothing of what they do.
fn tested(mut out: String, name: &str) -> String {
    if name.ends_with('3') {
        out.push_str("scenario \"drawn\" { 0s :  after 20ms :  until 1 within 1s }\n");
    }
    out
}

/// Puts some expansions where their macro-steps are. They come after these.
fn nest(ink: &mut Ink, frames: &[Frame], blocks: &mut [String]) {
    for (index, frame) in frames.iter().enumerate().rev() {
        let holds = |host: &Frame| host.nodes.iter().any(|node| node.label == frame.name);
        if matches!(frame.place, FrameKind::Expansion(_))
            && ink.chance(0.3)
            && let Some(host) = frames.iter().position(holds)
            && let Some(end) = blocks[host].rfind('}')
        {
            let block = std::mem::take(&mut blocks[index]);
            blocks[host].insert_str(end, &block);
        }
    }
}

/// A declaration of one name.
struct Declared {
    retain: bool,
    kind: &'static str,
    ty: Type,
    /// The name, and its comment.
    name: String,
    /// What follows the type.
    tail: String,
}

struct Writer<'a> {
    scope: Scope,
    /// What stored actions may assign.
    stored: Vec<(String, Type)>,
    awkward: Vec<&'static str>,
    declared: Vec<Declared>,
    designations: u32,
    /// What says which actions are done each scan, if the chart evolves so.
    scans: Option<Rng>,
    /// What gives the times of a chart in which no step waits forever.
    waits: Option<Rng>,
    ink: &'a mut Ink,
    rng: &'a mut Rng,
}

impl Writer<'_> {
    fn name_activities(&mut self, frames: &[Frame]) {
        for frame in frames {
            if !matches!(frame.place, FrameKind::Expansion(_)) && self.rng.f32() < 0.5 {
                self.scope.activities.push(format!("X{}", frame.name));
            }
            for node in &frame.nodes {
                for pulse in &node.pulses {
                    let commanded = pulse.split(' ').nth(1).unwrap_or_default();
                    let frozen = format!("F{commanded}");
                    if !self.scope.activities.contains(&frozen) {
                        self.scope.activities.push(frozen);
                    }
                }
                self.scope.activities.push(format!("X{}", node.label));
                if node.kind != RandomStepKind::Macro {
                    self.scope.durations.push(format!("T{}", node.label));
                }
            }
        }
    }

    fn fresh(&mut self, prefix: &str, index: usize) -> String {
        if self.rng.f32() < 0.05 && !self.awkward.is_empty() {
            let at = self.rng.usize(0..self.awkward.len());
            return self.awkward.swap_remove(at).to_string();
        }
        format!("{prefix}{index}")
    }

    fn declare(&mut self, out: &mut String) {
        for index in 0..self.rng.usize(2..=5) {
            let name = self.fresh("a", index);
            let initial = self.initial(Type::Bool, 0.1);
            self.declares("input", &name, Type::Bool, &initial);
            self.scope.bools.push(name);
        }
        for index in 0..self.rng.usize(0..=2) {
            let (name, ty) = (self.fresh("n", index), TYPES[self.rng.usize(0..7)]);
            let initial = self.initial(ty, 0.2);
            self.declares("input", &name, ty, &initial);
            self.scope.numbers.push((name, ty));
        }
        for index in 0..self.rng.usize(1..=4) {
            let name = self.fresh("w", index);
            let kind = if self.rng.f32() < 0.8 { "output" } else { "var" };
            self.declares(kind, &name, Type::Bool, "");
            self.scope.wires.push(name);
        }
        for index in 0..self.rng.usize(0..=5) {
            let (name, ty) = (self.fresh("v", index), TYPES[self.rng.usize(0..8)]);
            let kind = if self.rng.f32() < 0.6 { "output" } else { "var" };
            let initial = self.initial(ty, 0.3);
            self.declares(kind, &name, ty, &initial);
            let retain = self.ink.retains();
            self.declared.last_mut().into_iter().for_each(|declared| declared.retain = retain);
            if ty == Type::Bool {
                self.scope.bools.push(name.clone());
            } else {
                self.scope.numbers.push((name.clone(), ty));
            }
            self.stored.push((name, ty));
        }
        for index in 0..self.rng.usize(0..=2) {
            let (name, ty) = (self.fresh("k", index), TYPES[self.rng.usize(0..8)]);
            let value = self.scope.literal(self.rng, ty);
            self.declares("const", &name, ty, &format!(" := {value}"));
            self.scope.constants.push(name.clone());
            match ty {
                Type::Bool => self.scope.bools.push(name),
                Type::Time => {
                    self.scope.delays.push(name.clone());
                    self.scope.numbers.push((name, ty));
                }
                _ => self.scope.numbers.push((name, ty)),
            }
        }
        self.write_declarations(out);
        out.push('\n');
    }

    fn declares(&mut self, kind: &'static str, name: &str, ty: Type, initial: &str) {
        let tail = match kind {
            "input" => self.ink.tail('I', ty, initial),
            "output" => self.ink.tail('Q', ty, initial),
            "var" => self.ink.tail('M', ty, initial),
            _ => initial.to_string(),
        };
        let name = format!("{name}{}", self.ink.attached(0.1));
        self.declared.push(Declared { retain: false, kind, ty, name, tail });
    }

    /// Neighbours of one type often share a line.
    fn write_declarations(&mut self, out: &mut String) {
        let mut declared = std::mem::take(&mut self.declared).into_iter().peekable();
        while let Some(first) = declared.next() {
            let retain = if first.retain { "retain " } else { "" };
            let _ = write!(out, "{retain}{} {}", first.kind, first.name);
            let alike = |next: &Declared| {
                (next.retain, next.kind, next.ty, &next.tail) == (first.retain, first.kind, first.ty, &first.tail)
            };
            while !first.tail.contains(" at ")
                && self.ink.chance(0.4)
                && let Some(next) = declared.next_if(alike)
            {
                let _ = write!(out, ", {}", next.name);
            }
            let _ = writeln!(out, " : {}{}", type_name(first.ty), first.tail);
        }
    }

    fn initial(&mut self, ty: Type, share: f32) -> String {
        if self.rng.f32() < share { format!(" := {}", self.scope.literal(self.rng, ty)) } else { String::new() }
    }

    fn frame(&mut self, out: &mut String, frame: &Frame, only: bool) {
        // A file with a single grafcet that nobody names needs none.
        let implied = only && !self.scope.activities.contains(&format!("X{}", frame.name)) && self.ink.chance(0.4);
        let comment = self.ink.attached(0.1);
        let _ = match &frame.place {
            _ if implied => Ok(()),
            FrameKind::Top => match &frame.parent {
                Some(parent) => writeln!(out, "child grafcet {} of {parent}{comment} {{", frame.name),
                None => writeln!(out, "grafcet {}{comment} {{", frame.name),
            },
            FrameKind::In(step) => writeln!(out, "grafcet X{step}/{}{comment} {{", frame.name),
            FrameKind::Expansion(_) => writeln!(out, "expansion {}{comment} {{", frame.name),
        };
        for node in &frame.nodes {
            let words = [
                if node.initial { "initial " } else { "" },
                if node.activated { "activated " } else { "" },
                match node.kind {
                    RandomStepKind::Step => "",
                    RandomStepKind::Enclosing => "enclosing ",
                    RandomStepKind::Macro => "macro ",
                },
            ];
            let comment = if self.rng.f32() < 0.1 { " \"says *) and (* \"" } else { "" };
            self.ink.remark(out);
            let _ = write!(out, "  {}step {}{comment}", words.concat(), node.label);
            let mut actions: Vec<String> = Vec::new();
            if node.kind != RandomStepKind::Macro {
                for _ in 0..[0, 0, 1, 1, 2, 3][self.rng.usize(0..6)] {
                    actions.extend(self.action());
                }
                actions.extend(node.orders.iter().map(|order| format!("force {order}")));
                for pulse in &node.pulses {
                    actions.push(match pulse.strip_suffix('?') {
                        Some(pulse) => format!("{pulse}{}", self.pulse_event()),
                        None => pulse.clone(),
                    });
                }
            }
            if actions.is_empty() {
                out.push_str(if node.kind != RandomStepKind::Macro && self.ink.chance(0.1) { " { }\n" } else { "\n" });
            } else {
                let _ = writeln!(out, " {{\n    {}\n  }}", actions.join("\n    "));
            }
        }
        for (index, (pre, post)) in frame.arcs.iter().enumerate() {
            let designated = self.rng.f32() < 0.5;
            let designation = self.designation(designated, &format!("{}_{index}", frame.name));
            let mut condition = self.transition_condition(pre.is_empty());
            if let (Some(waits), Some(source)) = (&mut self.waits, pre.first()) {
                let _ = match waits.u8(0..4) {
                    0 if !source.starts_with('M') => write!(condition, " or [T{source} >= 1s]"),
                    1 => write!(condition, " or 1s/(X{source} and {})", self.scope.bools[0]),
                    2 => write!(condition, " or 500ms/X{source}/1s"),
                    _ => write!(condition, " or {}/X{source}", ["500ms", "1s", "2s"][waits.usize(0..3)]),
                };
            }
            let _ = write!(out, "  transition {designation}{} -> {} : {condition}", pre.join(", "), post.join(", "));
            let mut inside =
                frame.clearing.iter().filter(|(at, _)| *at == index).map(|(_, p)| p.clone()).collect::<Vec<_>>();
            if self.rng.f32() < 0.15
                && let Some(assignment) = self.assignment()
            {
                let second = self.second_assignment();
                inside.push(format!("{assignment}{second}"));
            }
            if !inside.is_empty() {
                let _ = write!(out, " {{ {} }}", inside.join("  "));
            }
            out.push('\n');
        }
        out.push_str(if implied { "\n" } else { "}\n\n" });
    }

    /// What a pulse order waits for: mostly an edge.
    fn pulse_event(&mut self) -> String {
        if self.rng.f32() < 0.6 {
            return format!("↑{}", self.scope.bools[self.rng.usize(0..self.scope.bools.len())]);
        }
        let allowed = Allowed { edges: true, delays: true, wires: self.scope.wires.len(), arithmetic: false };
        self.scope.condition(self.rng, 2, allowed)
    }

    /// A designation and what else stands before the arcs.
    fn designation(&mut self, designated: bool, name: &str) -> String {
        self.designations += 1;
        let designation = match (designated, self.ink.chance(0.3)) {
            (false, _) => String::new(),
            (true, true) => format!("({}) ", self.designations),
            (true, false) => format!("({name}) "),
        };
        match self.ink.attached(0.1) {
            "" => designation,
            comment => format!("{designation}{} ", comment.trim_start()),
        }
    }

    /// Now and then another assignment on clearing.
    fn second_assignment(&mut self) -> String {
        if self.stored.is_empty() || !self.ink.chance(0.3) {
            return String::new();
        }
        let at = self.ink.rng().usize(0..self.stored.len());
        let (target, ty) = &self.stored[at];
        format!("  {target} := {}", self.scope.literal(self.ink.rng(), *ty))
    }

    /// Sources that are open all the time would flood the chart, so most wait for an edge.
    fn transition_condition(&mut self, source: bool) -> String {
        let allowed = Allowed { edges: true, delays: true, wires: self.scope.wires.len(), arithmetic: false };
        match self.rng.u8(0..20) {
            0 if !source => "1".to_string(),
            1..8 => {
                let sign = if source { "↑" } else { ["", "not ", "↑", "↑", "↓"][self.rng.usize(0..5)] };
                format!("{sign}{}", self.scope.bools[self.rng.usize(0..self.scope.bools.len())])
            }
            _ => self.scope.condition(self.rng, 2, allowed),
        }
    }

    fn action(&mut self) -> Option<String> {
        if self.rng.f32() < 0.45 || self.stored.is_empty() {
            let index = self.rng.usize(0..self.scope.wires.len());
            let target = &self.scope.wires[index];
            if self.rng.bool() {
                return Some(target.clone());
            }
            let allowed = Allowed { edges: false, delays: true, wires: index, arithmetic: false };
            return Some(format!("{target} if {}", self.scope.condition(self.rng, 2, allowed)));
        }
        let assignment = self.assignment()?;
        if let Some(scans) = &mut self.scans
            && scans.f32() < 0.4
        {
            let sign = ["↑", "not ", ""][scans.usize(0..3)];
            let guard = format!(" if {sign}{}", self.scope.bools[scans.usize(0..self.scope.bools.len())]);
            return Some(format!("{assignment} each scan{}", if scans.bool() { guard } else { String::new() }));
        }
        let event = match self.rng.u8(0..10) {
            0..4 => "on activation".to_string(),
            4..6 => "on deactivation".to_string(),
            _ => {
                let allowed = Allowed { edges: true, delays: true, wires: self.scope.wires.len(), arithmetic: false };
                let mut event = self.scope.condition(self.rng, 2, allowed);
                if !event.contains(['↑', '↓']) && self.rng.f32() < 0.7 {
                    event = format!("↑{}", self.scope.bools[self.rng.usize(0..self.scope.bools.len())]);
                }
                format!("on event {event}")
            }
        };
        Some(format!("{assignment} {event}"))
    }

    fn assignment(&mut self) -> Option<String> {
        let (target, ty) = self.stored.get(self.rng.usize(0..self.stored.len().max(1)))?.clone();
        let value = match ty {
            Type::Bool if self.rng.bool() => self.scope.literal(self.rng, ty),
            Type::Bool => {
                let edges = self.rng.f32() < 0.2;
                let allowed = Allowed { edges, delays: false, wires: self.scope.wires.len(), arithmetic: true };
                self.scope.condition(self.rng, 1, allowed)
            }
            // Counting is what charts do most.
            Type::Int | Type::Dint | Type::Uint | Type::Udint if self.rng.bool() => format!("{target} + 1"),
            // Longer products of times would leave the range of every target.
            Type::Time => match self.rng.u8(0..3) {
                0 => format!("{target} + 1s"),
                1 if !self.scope.durations.is_empty() => {
                    self.scope.durations[self.rng.usize(0..self.scope.durations.len())].clone()
                }
                _ => self.scope.literal(self.rng, ty),
            },
            Type::Int | Type::Dint | Type::Uint | Type::Udint | Type::Real | Type::Lreal => {
                self.scope.number(self.rng, ty, 2)
            }
        };
        Some(format!("{target} := {value}"))
    }
}
