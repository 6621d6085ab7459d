//! What generated code needs at run time: copied into the file, or taken from the crate `grafc-runtime`. Both are the
//! same text.

use super::Runtime;
use super::names::RustNames;
use crate::writer::Writer;
use grafc_logic::scan::Program;
use grafc_runtime::source;

/// What a chart needs beside its flags.
#[derive(Clone, Copy)]
pub(super) struct Needs {
    pub saving: bool,
    pub timers: bool,
    pub division: bool,
    pub remainder: bool,
}

impl Needs {
    /// What a program needs.
    pub fn of(program: &Program) -> Self {
        let divided = program.divided();
        let saving = program.restoring.is_some() || program.variables.iter().any(|variable| variable.retain);
        Needs { saving, timers: !program.timers.is_empty(), division: divided.quotient, remainder: divided.remainder }
    }
}

/// Writes the `use` of what is needed.
pub(super) fn imports(out: &mut Writer, runtime: Runtime, needs: Needs) {
    let mut items = vec!["Flags"];
    items.extend(needs.saving.then_some(["Restorer", "Saver"]).into_iter().flatten());
    items.extend(needs.timers.then_some("Timer"));
    items.extend(needs.division.then_some("divide"));
    items.extend(needs.remainder.then_some("remainder"));
    items.extend(needs.saving.then_some("seal"));
    let from = match runtime {
        Runtime::Inline => "self::runtime",
        Runtime::Crate => "grafc_runtime",
    };
    match items.as_slice() {
        [only] => out.line(&format!("use {from}::{only};")),
        _ => out.line(&format!("use {from}::{{{}}};", items.join(", "))),
    }
}

/// Writes the module of its own.
pub(super) fn module(out: &mut Writer, needs: Needs) {
    out.blank();
    out.line("/// What the chart needs at run time.");
    out.open("pub mod runtime {");
    let mut pieces = vec![source::FLAGS];
    pieces.extend(needs.saving.then_some(source::SAVED));
    pieces.extend(needs.timers.then_some(source::TIMER));
    pieces.extend((needs.division || needs.remainder).then_some(source::NUMBER));
    for piece in pieces {
        out.blank();
        let lines = piece.lines().filter(|line| !line.starts_with("//!") && !line.starts_with("#[cfg_attr("));
        for line in lines {
            if line.is_empty() { out.blank() } else { out.line(line) }
        }
    }
    out.close("}");
}

/// Writes the implementation of the trait that all charts have in common.
pub(super) fn implementation(out: &mut Writer, names: &RustNames) {
    let chart = &names.chart;
    out.blank();
    out.open(&format!("impl grafc_runtime::Chart for {chart} {{"));
    out.line("type Inputs = Inputs;");
    out.line("type Outputs = Outputs;");
    out.line("type Step = Step;");
    out.line(&format!("const NAME: &'static str = {chart:?};"));
    out.line("const STEPS: &'static [Step] = &Step::ALL;");
    for (head, call) in [
        ("fn scan(&mut self, inputs: &Inputs, now: u32) -> &Outputs", "self.scan(inputs, now)"),
        ("fn outputs(&self) -> &Outputs", "self.outputs()"),
        ("fn is_active(&self, step: Step) -> bool", "self.is_active(step)"),
        ("fn flags(&self) -> Flags", "self.flags()"),
        ("fn clear_flags(&mut self)", "self.clear_flags();"),
        ("fn reset(&mut self)", "self.reset();"),
    ] {
        out.blank();
        out.open(&format!("{head} {{"));
        out.line(call);
        out.close("}");
    }
    out.close("}");
}
