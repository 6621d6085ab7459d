//! A run as a value change dump, for viewers of waveforms: real times, and a scope a grafcet.

use grafc::Simulation;
use grafc_model::chart::{Chart, GrafcetId, Type, Value, VariableKind};
use grafc_model::simulate::Probe;
use std::io;
use vcd::{IdCode, SimulationCommand, TimescaleUnit, VarType, Writer};

/// The text of a dump of all that was looked at, and of the outputs and flags.
pub fn draw(simulation: &Simulation) -> String {
    let mut out = Vec::new();
    // Writing to memory does not fail.
    let _ = write(simulation, &mut Writer::new(&mut out));
    String::from_utf8_lossy(&out).into_owned()
}

/// Something that is drawn.
#[derive(Clone, Copy)]
enum Line {
    /// A probe, by its place.
    Probe(usize),
    /// An output, by its place.
    Output(usize),
    /// A flag, by its name.
    Flag(&'static str),
    /// Whether the controller has restarted.
    Restart,
}

const FLAGS: [&str; 4] = ["LIVELOCK", "ALLOC_CONFLICT", "FORCE_CONFLICT", "DIV0"];

fn write(simulation: &Simulation, out: &mut Writer<&mut Vec<u8>>) -> io::Result<()> {
    let chart = &simulation.chart;
    out.timescale(1, TimescaleUnit::MS)?;
    out.add_module(&word(&chart.name))?;
    let mut lines: Vec<(IdCode, Line, Type)> = Vec::new();
    let of_kind = |wanted: VariableKind| {
        let probes = simulation.probes.iter().enumerate();
        probes.filter(move |(_, probe)| matches!(probe, Probe::Variable(id) if chart.variables[*id].kind == wanted))
    };
    scope(out, "inputs", of_kind(VariableKind::Input).map(|(n, p)| probe(chart, n, *p)), &mut lines)?;
    let outputs = chart.variables.iter().filter(|variable| variable.kind == VariableKind::Output);
    let outputs = outputs.enumerate().map(|(n, v)| (Line::Output(n), v.name.to_string(), v.ty));
    scope(out, "outputs", outputs, &mut lines)?;
    let internal = of_kind(VariableKind::Internal).chain(of_kind(VariableKind::Constant));
    scope(out, "variables", internal.map(|(n, p)| probe(chart, n, *p)), &mut lines)?;
    for (id, grafcet) in chart.grafcets.iter_enumerated() {
        let own = simulation.probes.iter().enumerate().filter(|(_, probe)| grafcet_of(chart, **probe) == Some(id));
        scope(out, &grafcet.name, own.map(|(n, p)| probe(chart, n, *p)), &mut lines)?;
    }
    let flags = FLAGS.map(|flag| (Line::Flag(flag), flag.to_string(), Type::Bool));
    scope(out, "flags", flags.into_iter(), &mut lines)?;
    if simulation.record.stimuli.iter().any(|stimulus| stimulus.restart) {
        scope(out, "controller", [(Line::Restart, "restart".into(), Type::Bool)].into_iter(), &mut lines)?;
    }
    out.upscope()?;
    out.enddefinitions()?;

    let mut before: Vec<Option<Value>> = vec![None; lines.len()];
    let mut time = None;
    for call in 0..simulation.record.stimuli.len() {
        let first = time.is_none();
        let now = simulation.record.stimuli[call].t_ms;
        if time.replace(now) != Some(now) {
            out.timestamp(u64::try_from(now).unwrap_or_default())?;
        }
        if first {
            out.begin(SimulationCommand::Dumpvars)?;
        }
        for ((id, line, ty), before) in lines.iter().zip(&mut before) {
            let value = value(simulation, call, *line);
            if before.replace(value) != Some(value) {
                change(out, *id, *ty, value)?;
            }
        }
        if first {
            out.end()?;
        }
    }
    Ok(())
}

/// Declares what a scope holds; nothing if that is nothing.
fn scope(
    out: &mut Writer<&mut Vec<u8>>,
    name: &str,
    within: impl Iterator<Item = (Line, String, Type)>,
    lines: &mut Vec<(IdCode, Line, Type)>,
) -> io::Result<()> {
    let mut within = within.peekable();
    if within.peek().is_none() {
        return Ok(());
    }
    out.add_module(&word(name))?;
    for (line, name, ty) in within {
        let (kind, width) = match ty {
            Type::Bool => (VarType::Wire, 1),
            Type::Int | Type::Uint => (VarType::Integer, 16),
            Type::Dint | Type::Udint => (VarType::Integer, 32),
            Type::Real | Type::Lreal => (VarType::Real, 64),
            Type::Time => (VarType::Integer, 64),
        };
        lines.push((out.add_var(kind, width, &word(&name), None)?, line, ty));
    }
    out.upscope()
}

fn probe(chart: &Chart, place: usize, probe: Probe) -> (Line, String, Type) {
    (Line::Probe(place), probe.name(chart).to_string(), probe.ty(chart))
}

/// The grafcet in whose scope it is shown.
fn grafcet_of(chart: &Chart, probe: Probe) -> Option<GrafcetId> {
    match probe {
        Probe::Variable(_) => None,
        Probe::Step(id) | Probe::Duration(id) => Some(chart.steps[id].grafcet),
        Probe::Macro(id) => Some(chart.macro_steps[id].grafcet),
        Probe::Grafcet(id) => Some(id),
    }
}

fn value(simulation: &Simulation, call: usize, line: Line) -> Value {
    let (record, response) = (&simulation.record, &simulation.record.responses[call]);
    match line {
        Line::Probe(place) => record.looks[call][place],
        Line::Output(place) => response.outputs[place],
        Line::Flag(name) => Value::Bool(response.flags.names().any(|raised| raised == name)),
        Line::Restart => Value::Bool(record.stimuli[call].restart),
    }
}

fn change(out: &mut Writer<&mut Vec<u8>>, id: IdCode, ty: Type, value: Value) -> io::Result<()> {
    let width = match ty {
        Type::Int | Type::Uint => 16,
        Type::Bool | Type::Dint | Type::Udint | Type::Real | Type::Lreal => 32,
        Type::Time => 64,
    };
    match value {
        Value::Bool(truth) => out.change_scalar(id, truth),
        Value::Int(number) | Value::Time(number) => {
            out.change_vector(id, (0..width).rev().map(|bit| vcd::Value::from(number >> bit & 1 == 1)))
        }
        Value::Real(number) => out.change_real(id, number),
    }
}

/// A name as the format takes it: without white space.
fn word(name: &str) -> String {
    name.split_whitespace().collect::<Vec<_>>().join("_")
}
