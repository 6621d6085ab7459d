//! A sketch of Arduino: the chart in one file, with its pins before it and `setup` and `loop` behind it.
//!
//! Arduino compiles it as C++, with a header before it that defines macros in capitals by the hundred, those of the
//! processor included. So what the sketch needs of them is kept in constants first, and macros with names of the chart are
//! undefined. No function stands before the types of the chart: Arduino puts prototypes before the first.

use super::names::CNames;
use super::pins::Pins;
use super::wiring::{Wire, wires};
use crate::keywords::Family;
use crate::namer::Namer;
use crate::writer::Writer;
use ecow::EcoString;
use grafc_diagnostics::Diagnostics;
use grafc_formula::Type;
use grafc_logic::scan::{Program, Role};

/// The pins of one chart.
pub(super) struct Sketch<'p> {
    program: &'p Program,
    names: &'p CNames,
    /// Each with the constant of its pin.
    wires: Vec<(Wire, EcoString)>,
}

impl<'p> Sketch<'p> {
    /// # Errors
    /// Inputs and outputs that have no pin of their own.
    pub fn new(program: &'p Program, names: &'p CNames, pins: &Pins) -> Result<Self, Diagnostics> {
        let wires = wires(program, pins)?;
        let constants =
            Namer::new(Family::C).names(wires.iter().map(|wire| program.variables[wire.variable].name.clone()));
        let constants = constants.into_iter().map(|name| ecow::eco_format!("pin_{name}"));
        Ok(Sketch { program, names, wires: wires.into_iter().zip(constants).collect() })
    }

    /// What stands before the chart.
    pub fn head(&self, out: &mut Writer) {
        out.line("#include <Arduino.h>");
        if !self.wires.is_empty() {
            out.blank();
            out.comment("what the chart is connected to");
        }
        for (wire, constant) in &self.wires {
            out.line(&format!("static const uint8_t {constant} = {};", wire.pin.pin));
        }
        let modes = [("mode_input", "INPUT"), ("mode_pullup", "INPUT_PULLUP"), ("mode_output", "OUTPUT")];
        for (name, mode) in
            modes.into_iter().filter(|(name, _)| self.wires.iter().any(|(wire, _)| self.mode(wire) == Some(*name)))
        {
            out.line(&format!("static const uint8_t {name} = {mode};"));
        }
        let all = self.names.variables.iter().chain(&self.names.timers).chain([&self.names.chart]);
        let mut hidden: Vec<&EcoString> = all.filter(|name| may_be_macro(name)).collect();
        hidden.sort_unstable();
        hidden.dedup();
        if !hidden.is_empty() {
            out.blank();
            out.comment("names of the chart, which may be macros");
        }
        for name in hidden {
            out.line(&format!("#undef {name}"));
        }
    }

    /// What stands behind it.
    pub fn tail(&self, out: &mut Writer) {
        let chart = &self.names.chart;
        out.blank();
        out.line(&format!("static {chart} chart;"));
        out.line(&format!("static {chart}_inputs inputs;"));
        out.blank();
        out.open("void setup(void)\n{");
        for (wire, constant) in &self.wires {
            if wire.pin.inverted && self.is_output(wire) {
                out.line(&format!("digitalWrite({constant}, 1);"));
            }
            if let Some(mode) = self.mode(wire) {
                out.line(&format!("pinMode({constant}, {mode});"));
            }
        }
        out.line(&format!("{chart}_init_inputs(&inputs);"));
        out.line(&format!("{chart}_init(&chart);"));
        out.close("}");
        out.blank();
        out.open("void loop(void)\n{");
        for (wire, constant) in self.wires.iter().filter(|(wire, _)| !self.is_output(wire)) {
            let value = match (self.ty(wire), wire.pin.inverted) {
                (Type::Bool, false) => format!("digitalRead({constant}) != 0"),
                (Type::Bool, true) => format!("digitalRead({constant}) == 0"),
                (ty, _) => format!("({})analogRead({constant})", super::type_name(ty)),
            };
            out.line(&format!("inputs.{} = {value};", self.names.variables[wire.variable]));
        }
        out.line(&format!("(void){chart}_scan(&chart, &inputs, millis());"));
        for (wire, constant) in self.wires.iter().filter(|(wire, _)| self.is_output(wire)) {
            let value = format!("chart.outputs.{}", self.names.variables[wire.variable]);
            out.line(&match (self.ty(wire), wire.pin.inverted) {
                (Type::Bool, false) => format!("digitalWrite({constant}, {value} ? 1 : 0);"),
                (Type::Bool, true) => format!("digitalWrite({constant}, {value} ? 0 : 1);"),
                (Type::Uint | Type::Udint, _) => {
                    format!("analogWrite({constant}, {value} > 255u ? 255 : (int){value});")
                }
                (Type::Int | Type::Dint | Type::Real | Type::Lreal | Type::Time, _) => {
                    format!("analogWrite({constant}, {value} > 255 ? 255 : {value} > 0 ? (int){value} : 0);")
                }
            });
        }
        out.close("}");
    }

    fn is_output(&self, wire: &Wire) -> bool {
        self.program.variables[wire.variable].role == Role::Output
    }

    fn ty(&self, wire: &Wire) -> Type {
        self.program.variables[wire.variable].ty
    }

    /// How the pin is set up; what is measured needs nothing.
    fn mode(&self, wire: &Wire) -> Option<&'static str> {
        match (self.is_output(wire), self.ty(wire) == Type::Bool) {
            (true, _) => Some("mode_output"),
            (false, true) => Some(if wire.pin.pullup { "mode_pullup" } else { "mode_input" }),
            (false, false) => None,
        }
    }
}

/// Whether a header may have a macro of this name that stands for something; steps, `X1`, are none.
fn may_be_macro(name: &str) -> bool {
    let is_step = name.strip_prefix('X').is_some_and(|label| label.bytes().all(|byte| byte.is_ascii_digit()));
    !is_step && !name.bytes().any(|byte| byte.is_ascii_lowercase())
}
