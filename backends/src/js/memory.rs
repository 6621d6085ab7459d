//! All that a chart keeps, in groups by what it is for: as it is before the first scan, and what each input may be.

use super::expressions::stored;
use super::places::{Places, claims};
use super::shows_all;
use super::text::{comment, key};
use crate::writer::Writer;
use ecow::EcoString;
use grafc_formula::Type;
use grafc_logic::scan::{Flag, Origin, Origins, Program, Role, VarId};

/// All flags.
const FLAGS: [Flag; 4] = [Flag::Livelock, Flag::AllocConflict, Flag::ForceConflict, Flag::Div0];

/// Writes the function that makes it.
pub(super) fn write(out: &mut Writer, program: &Program, places: &Places) {
    out.blank();
    out.comment("all that the chart keeps, as before its first scan");
    out.open("function fresh() {");
    out.open("return {");
    let memory = Memory { program, places };
    memory.group(out, "given for each scan", "inputs", |id| program.variables[id].role == Role::Input);
    memory.group(out, "given to the plant after each scan", "outputs", |id| program.variables[id].role == Role::Output);
    memory.group(out, "internal variables", "variables", |id| program.variables[id].role == Role::Internal);
    let flags: Vec<String> = FLAGS.iter().map(|flag| format!("{}: false", flag.name())).collect();
    out.line(&format!("flags: {{ {} }},", flags.join(", ")));
    memory.group(out, "active steps, and memory from scan to scan", "m", |id| places.is_kept(id));
    memory.delays(out);
    memory.seen(out);
    out.comment("the time of the scan, whether there has been one, and whether one is under way");
    out.line("now: 0,");
    out.line("begun: false,");
    out.line("scanning: false,");
    out.close("};");
    out.close("}");
}

/// The comment of a variable; of a time, that it counts milliseconds; its address.
pub(super) fn about(program: &Program, id: VarId) -> String {
    let variable = &program.variables[id];
    let parts = [
        variable.comment.as_deref().map(comment).filter(|text| !text.is_empty()),
        (variable.ty == Type::Time).then(|| "in milliseconds".to_owned()),
        variable.address.as_deref().map(|address| format!("at {}", comment(address))),
    ];
    parts.into_iter().flatten().collect::<Vec<_>>().join(", ")
}

/// A property on a line of its own, and what is to be said of it.
pub(super) fn property(out: &mut Writer, line: &str, remark: &str) {
    out.start();
    out.text(line);
    if !remark.is_empty() {
        let length = out.indent() + line.chars().count();
        out.trailing_comment(length, length, remark);
    }
    out.end();
}

struct Memory<'p> {
    program: &'p Program,
    places: &'p Places<'p>,
}

impl Memory<'_> {
    fn origin(&self, of: impl Fn(&Origins) -> Origin) -> Origin {
        self.places.origins.as_ref().map_or(Origin::Chart, of)
    }

    fn group(&self, out: &mut Writer, about_group: &str, name: &str, is_of: impl Fn(VarId) -> bool) {
        let ids: Vec<VarId> = self.program.variables.indices().filter(|id| is_of(*id)).collect();
        if ids.is_empty() {
            return out.line(&format!("{name}: {{}},"));
        }
        out.comment(about_group);
        out.open(&format!("{name}: {{"));
        for id in ids {
            let variable = &self.program.variables[id];
            let outer = out.origin(self.origin(|origins| origins.variables[id]));
            let line =
                format!("{}: {},", key(&self.places.names.variables[id]), stored(variable.initial(), variable.ty));
            property(out, &line, &about(self.program, id));
            out.origin(outer);
        }
        out.close("},");
    }

    fn delays(&self, out: &mut Writer) {
        if self.program.timers.is_empty() {
            return out.line("delays: {},");
        }
        out.open("delays: {");
        for (id, timer) in self.program.timers.iter_enumerated() {
            let outer = out.origin(self.origin(|origins| origins.timers[id]));
            let line = format!("{}: delay(),", key(&self.places.names.timers[id]));
            property(out, &line, &timer.comment.as_deref().map(comment).unwrap_or_default());
            out.origin(outer);
        }
        out.close("},");
    }

    fn seen(&self, out: &mut Writer) {
        let Some(observing) = &self.program.observing else { return out.line("seen: {},") };
        let words = |name: &str, is_shown: bool| is_shown.then(|| EcoString::from(format!("{name}: {{}}")));
        let filled = |name: &str, length: usize, value: &str| match length {
            0 => None,
            _ => Some(EcoString::from(format!("{name}: Array({length}).fill({value})"))),
        };
        let list = |name: &str, length: usize| filled(name, length, "false");
        let transitions = observing.transitions.len();
        let all = shows_all(self.program);
        let lists = [
            words("enabled", transitions > 0),
            words("cleared", transitions > 0),
            words("satisfied", transitions > 0 && all),
            list("frozen", observing.frozen.len()),
            list("forced", observing.forced.len()),
            list("orders", observing.orders.len()),
            list("actions", observing.actions.len()),
            // What is false is told, which nothing is before the first scan.
            filled("asserted", claims(self.program, true).count(), "true"),
            list("wanted", claims(self.program, false).count()),
        ];
        out.comment("what is seen of the last micro-step");
        out.open("seen: {");
        let alone = self.program.variables.indices().filter(|id| self.places.is_shown_alone(*id));
        for id in alone {
            out.line(&format!("{}: false,", key(&self.places.names.variables[id])));
        }
        for list in lists.into_iter().flatten() {
            out.line(&format!("{list},"));
        }
        out.close("},");
    }
}
