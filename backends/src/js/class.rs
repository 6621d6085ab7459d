//! The class: what can be done with a chart.

use super::names::Names;
use super::places::Places;
use super::shows_all;
use super::tables::list;
use super::text::{comment, member, quoted};
use crate::writer::Writer;
use ecow::EcoString;
use grafc_logic::scan::{Program, Role, VarId};

/// Writes it.
pub(super) fn write(out: &mut Writer, program: &Program, names: &Names, places: &Places) {
    out.blank();
    let about = program.comment.as_deref().map(comment).unwrap_or_default();
    out.comment(&about);
    out.open(&format!("export class {} {{", names.class));
    let labels: Vec<EcoString> = program.steps.iter().map(|step| quoted(&step.label)).collect();
    out.comment("the labels of all steps, in order of declaration");
    list(out, "static steps = Object.freeze(", &labels, ");");
    out.blank();
    Class { out, program, places }.write();
}

struct Class<'o, 'p> {
    out: &'o mut Writer,
    program: &'p Program,
    places: &'p Places<'p>,
}

impl Class<'_, '_> {
    fn write(mut self) {
        self.lines(include_str!("runtime/class.js"));
        let observed = self.program.observing.as_ref().and_then(|observing| observing.wanted);
        let wanted = observed.map(|v| self.places.read(v).clone());
        self.micro_step(wanted.as_deref());
        self.clear_flags();
        self.lines(include_str!("runtime/state.js"));
        let retained: Vec<VarId> =
            self.program.variables.indices().filter(|v| self.program.variables[*v].retain).collect();
        if !retained.is_empty() {
            self.retained(&retained);
        }
        if shows_all(self.program) {
            self.lines(include_str!("runtime/observed.js"));
        }
        self.out.close("}");
        let name = self.places.names.class.clone();
        self.out.blank();
        self.out.line(&format!("export default {name};"));
    }

    fn lines(&mut self, text: &str) {
        for line in text.lines() {
            if line.is_empty() { self.out.blank() } else { self.out.line(line) }
        }
        self.out.blank();
    }

    fn micro_step(&mut self, wanted: Option<&str>) {
        let out = &mut *self.out;
        out.comment(
            "one micro-step, the first of a scan after the initial reaction if that is due: the transitions that were",
        );
        out.comment(
            "enabled, those that cleared, and whether the scan is over; until it is, inputs and time stay as they were",
        );
        out.open("microStep(inputs, now_ms) {");
        out.line("const s = this.#s;");
        out.line("this.#begin(inputs, now_ms);");
        let wanted = wanted.map(|place| place.replacen("seen.", "s.seen.", 1));
        wanted.iter().for_each(|wanted| out.line(&format!("{wanted} = true;")));
        out.line("const stable = !microStep(s);");
        wanted.iter().for_each(|wanted| out.line(&format!("{wanted} = false;")));
        out.open("if (stable) {");
        out.line("this.#end();");
        out.close("}");
        out.line("const of = (words = {}) => TRANSITIONS.filter((_, t) => words[WORDS[t]]);");
        out.line("return { enabled: of(s.seen.enabled), cleared: of(s.seen.cleared), stable };");
        out.close("}");
        out.blank();
    }

    fn clear_flags(&mut self) {
        let out = &mut *self.out;
        let told = self.program.assertion.map(|v| &self.places.names.variables[v]);
        out.comment(told.map_or("lowers all flags", |_| "lowers all flags, and forgets which assertion was false"));
        out.open("clearFlags() {");
        out.line("this.#s.flags = fresh().flags;");
        if let Some(name) = told {
            out.line(&format!("{} = 0;", member("this.#s.outputs", name)));
            out.line(&format!("{} = 0;", member("this.#shown", name)));
        }
        out.close("}");
        out.blank();
    }

    /// A restart of the controller.
    fn retained(&mut self, retained: &[VarId]) {
        let out = &mut *self.out;
        out.comment("as after a restart of the controller: as before the first scan, but for what the chart retains");
        out.open("restart() {");
        out.line("const s = fresh();");
        out.line("s.inputs = this.#s.inputs;");
        for v in retained {
            let variable = &self.program.variables[*v];
            let group = match variable.role {
                Role::Output => "outputs",
                Role::Internal => "variables",
                Role::Memory | Role::Step | Role::State | Role::Temporary => "m",
                Role::Input | Role::Constant | Role::Flag(_) | Role::Observed => continue,
            };
            let name = &self.places.names.variables[*v];
            let (to, from) = (member(&format!("s.{group}"), name), member(&format!("this.#s.{group}"), name));
            out.line(&format!("{to} = {from};"));
        }
        out.line("this.#s = s;");
        out.line("shown(s.outputs, this.#shown);");
        out.close("}");
        out.blank();
    }
}
