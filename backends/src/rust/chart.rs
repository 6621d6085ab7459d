//! The chart: its memory, and what can be done with it.

use super::interface::{fields, has_variables, values};
use super::items::{doc, function};
use super::literals::{literal, type_name};
use super::memory::{self, words};
use super::names::RustNames;
use super::places::Places;
use super::split::Split;
use super::{retained, saved, scan, situation};
use crate::writer::Writer;
use ecow::{EcoString, eco_format};
use grafc_logic::scan::{Flag, Origin, Origins, Program, Role, VarId};

/// All flags.
const FLAGS: [Flag; 4] = [Flag::Livelock, Flag::AllocConflict, Flag::ForceConflict, Flag::Div0];

/// Writes the chart's struct and its functions.
pub(super) fn write(out: &mut Writer, program: &Program, names: &RustNames, places: &Places, split: &Split) {
    let chart = Chart { program, names, places };
    chart.structure(out);
    scan::values(out, program, names, places, &split.shared);
    out.blank();
    out.line(&format!("impl Default for {} {{", names.chart));
    out.enter();
    out.open("fn default() -> Self {");
    out.line("Self::new()");
    out.close("}");
    out.close("}");
    out.blank();
    out.open(&format!("impl {} {{", names.chart));
    chart.constructor(out);
    scan::write(out, program, names, places, split);
    out.blank();
    chart.accessors(out);
    situation::write(out, program, names, places);
    saved::write(out, program, places, split);
    retained::write(out, program, names, places, split.longest);
    out.close("}");
}

struct Chart<'p> {
    program: &'p Program,
    names: &'p RustNames,
    places: &'p Places<'p>,
}

impl Chart<'_> {
    fn structure(&self, out: &mut Writer) {
        out.blank();
        match &self.program.comment {
            Some(comment) => {
                doc(out, &crate::comment::clean(comment));
                out.line("///");
                out.line("/// Its state between two scans; see [`Self::scan`].");
            }
            None => out.line("/// The chart, with its state between two scans; see [`Self::scan`]."),
        }
        out.line("#[derive(Clone, Debug)]");
        out.open(&format!("pub struct {} {{", self.names.chart));
        if words(self.program) > 0 {
            out.comment("which steps are active, a bit each");
            out.line(&format!("situation: [u32; {}],", words(self.program)));
        }
        for (about, group) in memory::fields(self.program, self.places) {
            if group.is_empty() {
                continue;
            }
            out.comment(about);
            for id in group {
                let of_variable = |origins: &Origins| origins.variables[id];
                let outer = out.origin(self.places.origins.as_ref().map_or(Origin::Chart, of_variable));
                if let Some(comment) = &self.program.variables[id].comment {
                    doc(out, &crate::comment::clean(comment));
                }
                out.line(&format!("{}: {},", self.names.variables[id], self.type_of(id)));
                out.origin(outer);
            }
        }
        if !self.program.timers.is_empty() {
            out.comment("delays");
            for (id, timer) in self.names.timers.iter_enumerated() {
                let outer =
                    out.origin(self.places.origins.as_ref().map_or(Origin::Chart, |origins| origins.timers[id]));
                out.line(&format!("{timer}: Timer,"));
                out.origin(outer);
            }
        }
        out.comment("what can be seen from outside");
        if has_variables(self.program) {
            out.line("variables: Variables,");
        }
        out.line("outputs: Outputs,");
        out.line("flags: Flags,");
        out.close("}");
    }

    fn type_of(&self, id: VarId) -> EcoString {
        match self.places.state(id) {
            Some(state) => state.ty.clone(),
            None => type_name(self.program.variables[id].ty).into(),
        }
    }

    /// A variable's value before the first scan: of a state any, since nothing reads it before the first scan sets it.
    fn initial(&self, id: VarId) -> EcoString {
        match self.places.state(id) {
            Some(state) => eco_format!("{}::{}", state.ty, state.variants.first().map_or("", |(_, name)| name)),
            None => literal(self.program.variables[id].initial(), self.program.variables[id].ty),
        }
    }

    fn constructor(&self, out: &mut Writer) {
        out.line("/// The chart before its first scan.");
        out.open("pub const fn new() -> Self {");
        out.open("Self {");
        if words(self.program) > 0 {
            out.line(&format!("situation: [0; {}],", words(self.program)));
        }
        for id in memory::fields(self.program, self.places).into_iter().flat_map(|(_, group)| group) {
            out.line(&format!("{}: {},", self.names.variables[id], self.initial(id)));
        }
        for timer in &self.names.timers {
            out.line(&format!("{timer}: Timer::new(),"));
        }
        if has_variables(self.program) {
            fields(out, "variables: Variables", &values(self.program, self.names, Role::Internal), ",");
        }
        fields(out, "outputs: Outputs", &values(self.program, self.names, Role::Output), ",");
        out.open("flags: Flags {");
        for flag in FLAGS.map(Flag::name) {
            out.line(&format!("{flag}: false,"));
        }
        out.close("},");
        out.close("}");
        out.close("}");
    }

    fn accessors(&self, out: &mut Writer) {
        function(out, "The outputs of the last scan.", "pub const fn outputs(&self) -> &Outputs", &["&self.outputs"]);
        if has_variables(self.program) {
            let head = "pub const fn variables(&self) -> &Variables";
            function(out, "The internal variables after the last scan.", head, &["&self.variables"]);
        }
        function(
            out,
            "What has gone wrong since the start, or since the flags were cleared.",
            "pub const fn flags(&self) -> Flags",
            &["self.flags"],
        );
        let lowered = FLAGS.iter().map(|flag| format!("self.flags.{} = false;", flag.name()));
        let told = self.program.assertion.map(|v| format!("{} = 0;", self.places.read(v)));
        let about = match told {
            Some(_) => "Lowers all flags, and forgets which assertion was false.",
            None => "Lowers all flags.",
        };
        let lowered: Vec<String> = lowered.chain(told).collect();
        let lines: Vec<&str> = lowered.iter().map(String::as_str).collect();
        function(out, about, "pub const fn clear_flags(&mut self)", &lines);
        function(
            out,
            "Back to the state before the first scan; the next one is the initial reaction.",
            "pub const fn reset(&mut self)",
            &["*self = Self::new();"],
        );
    }
}
