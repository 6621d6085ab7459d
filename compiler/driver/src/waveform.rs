//! A run as a value change dump, for viewers of waveforms: real times, and a scope a grafcet. It is written as the run
//! goes on.

use grafc::Simulation;
use grafc_model::chart::{Chart, GrafcetId, Type, Value, VariableKind};
use grafc_model::simulate::{Call, Probe};
use std::io::{self, Write};
use vcd::{IdCode, SimulationCommand, TimescaleUnit, VarType, Writer};

/// A dump of all that is looked at, and of the outputs and flags.
pub struct Waveform<W: Write> {
    out: Writer<W>,
    lines: Vec<(IdCode, Line, Type)>,
    /// What was drawn last of each.
    before: Vec<Option<Value>>,
    time: Option<i64>,
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

impl<W: Write> Waveform<W> {
    /// Begins a dump, of runs that may or may not have restarts.
    pub fn new(simulation: &Simulation, restarts: bool, out: W) -> io::Result<Self> {
        let (chart, mut out) = (&simulation.chart, Writer::new(out));
        out.timescale(1, TimescaleUnit::MS)?;
        out.add_module(&word(&chart.name))?;
        let mut lines: Vec<(IdCode, Line, Type)> = Vec::new();
        let of_kind = |wanted: VariableKind| {
            let probes = simulation.probes.iter().enumerate();
            probes.filter(move |(_, probe)| matches!(probe, Probe::Variable(id) if chart.variables[*id].kind == wanted))
        };
        scope(&mut out, "inputs", of_kind(VariableKind::Input).map(|(n, p)| probe(chart, n, *p)), &mut lines)?;
        let outputs = chart.variables.iter().filter(|variable| variable.kind == VariableKind::Output);
        let outputs = outputs.enumerate().map(|(n, v)| (Line::Output(n), v.name.to_string(), v.ty));
        scope(&mut out, "outputs", outputs, &mut lines)?;
        let internal = of_kind(VariableKind::Internal).chain(of_kind(VariableKind::Constant));
        scope(&mut out, "variables", internal.map(|(n, p)| probe(chart, n, *p)), &mut lines)?;
        // What belongs to a grafcet, in order of the grafcets: each probe is looked at once.
        let mut of_grafcets = vec![Vec::new(); chart.grafcets.len()];
        for (n, p) in simulation.probes.iter().enumerate() {
            if let Some(id) = grafcet_of(chart, *p) {
                of_grafcets[id.index()].push((n, *p));
            }
        }
        for (grafcet, own) in chart.grafcets.iter().zip(of_grafcets) {
            let own = own.into_iter().map(|(n, p)| probe(chart, n, p));
            scope(&mut out, &grafcet.name, own, &mut lines)?;
        }
        let flags = FLAGS.map(|flag| (Line::Flag(flag), flag.to_string(), Type::Bool));
        scope(&mut out, "flags", flags.into_iter(), &mut lines)?;
        if restarts {
            let restart = [(Line::Restart, "restart".into(), Type::Bool)];
            scope(&mut out, "controller", restart.into_iter(), &mut lines)?;
        }
        out.upscope()?;
        out.enddefinitions()?;
        let before = vec![None; lines.len()];
        Ok(Waveform { out, lines, before, time: None })
    }

    /// Draws what a call has changed.
    pub fn called(&mut self, call: Call) -> io::Result<()> {
        let (first, now) = (self.time.is_none(), call.stimulus.t_ms);
        if self.time.replace(now) != Some(now) {
            self.out.timestamp(u64::try_from(now).unwrap_or_default())?;
        }
        if first {
            self.out.begin(SimulationCommand::Dumpvars)?;
        }
        for ((id, line, ty), before) in self.lines.iter().zip(&mut self.before) {
            let value = value(call, *line);
            if before.replace(value) != Some(value) {
                change(&mut self.out, *id, *ty, value)?;
            }
        }
        if first { self.out.end() } else { Ok(()) }
    }
}

/// Declares what a scope holds; nothing if that is nothing.
fn scope<W: Write>(
    out: &mut Writer<W>,
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
        Probe::Grafcet(id) | Probe::Frozen(id) => Some(id),
    }
}

fn value(call: Call, line: Line) -> Value {
    match line {
        Line::Probe(place) => call.looks[place],
        Line::Output(place) => call.response.outputs[place],
        Line::Flag(name) => Value::Bool(call.response.flags.names().any(|raised| raised == name)),
        Line::Restart => Value::Bool(call.stimulus.restart),
    }
}

fn change<W: Write>(out: &mut Writer<W>, id: IdCode, ty: Type, value: Value) -> io::Result<()> {
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

/// A name as the format takes it: without white space. With `$` begin the format's own words, such as `$end`; a name that
/// begins so is escaped as in Verilog.
fn word(name: &str) -> String {
    let word = name.split_whitespace().collect::<Vec<_>>().join("_");
    if word.starts_with('$') { format!("\\{word}") } else { word }
}
