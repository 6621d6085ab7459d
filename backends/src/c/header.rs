//! What a program around the chart sees: constants, steps, the structs of its variables and its memory, and functions.

use super::literals::{literal, type_name};
use super::names::CNames;
use super::text::comment;
use crate::comment::{clean, remark};
use crate::writer::{Writer, column_of};
use grafc_formula::Type;
use grafc_logic::scan::{Flag, Origin, Program, Role, Step, StepId, VarId, Variable};

/// All flags, with what they say.
pub(super) const FLAGS: [(Flag, &str); 4] = [
    (Flag::Livelock, "an evolution was given up: it found no stable situation"),
    (Flag::AllocConflict, "two stored actions gave a variable different values"),
    (Flag::ForceConflict, "two orders asked for different situations"),
    (Flag::Div0, "something was divided by zero"),
];

/// Writes it.
pub(super) fn write(out: &mut Writer, program: &Program, names: &CNames, kept: &[VarId]) {
    Header { out, program, names, kept }.write();
}

/// Whether the chart has internal variables that keep a value.
pub(super) fn has_variables(program: &Program) -> bool {
    program.of_role(Role::Internal).next().is_some()
}

/// Whether a restart leaves something as it is.
pub(super) fn retains(program: &Program) -> bool {
    program.variables.iter().any(|variable| variable.retain)
}

/// A declaration, and what is to be said of it.
struct Row {
    line: String,
    said: String,
    origin: Origin,
}

impl Row {
    fn new(line: impl Into<String>, said: impl Into<String>) -> Row {
        Row { line: line.into(), said: said.into(), origin: Origin::Chart }
    }
}

struct Header<'o, 'p> {
    out: &'o mut Writer,
    program: &'p Program,
    names: &'p CNames,
    /// The inputs that are kept.
    kept: &'p [VarId],
}

impl Header<'_, '_> {
    fn write(mut self) {
        let (chart, guard) = (self.names.chart.clone(), format!("GRAFC_{}_H", self.names.capitals));
        for line in [&format!("#ifndef {guard}"), &format!("#define {guard}")] {
            self.out.line(line);
        }
        self.out.blank();
        self.out.line("#include <stdbool.h>");
        self.out.line("#include <stdint.h>");
        self.out.blank();
        self.out.line("#ifdef __cplusplus");
        self.out.line("extern \"C\" {");
        self.out.line("#endif");
        self.constants();
        self.steps();
        let of = |role: Role| -> Vec<VarId> { self.program.of_role(role).map(|(id, _)| id).collect() };
        let [inputs, outputs, variables] = [Role::Input, Role::Output, Role::Internal].map(of);
        self.structure(&inputs, "inputs", "given for each scan");
        self.structure(&outputs, "outputs", "given to the plant after each scan");
        if has_variables(self.program) {
            self.structure(&variables, "variables", "internal variables");
        }
        if !self.kept.is_empty() {
            self.structure(self.kept, "kept", "the inputs of the last scan that outputs go by at once");
        }
        self.flags();
        self.states();
        if !self.program.timers.is_empty() {
            self.out.blank();
            self.out.comment("a delay: for how long, in milliseconds, and whether its input is true");
            self.out.open("typedef struct {");
            for line in ["int64_t elapsed;", "uint32_t last;", "bool running;"] {
                self.out.line(line);
            }
            self.out.close(&format!("}} {chart}_delay;"));
        }
        self.memory();
        self.functions();
        self.out.blank();
        self.out.line("#ifdef __cplusplus");
        self.out.line("}");
        self.out.line("#endif");
        self.out.blank();
        self.out.line(&format!("#endif /* {guard} */"));
    }

    /// What is declared in a group, each with what is to be said of it, in one column.
    fn declared(&mut self, rows: &[Row]) {
        let out = &mut *self.out;
        let length = |row: &Row| out.indent() + row.line.len();
        let told = rows.iter().filter(|row| !row.said.is_empty() && length(row) <= out.furthest_remark());
        let column = column_of(told.map(length).max().unwrap_or(0));
        for row in rows {
            let outer = out.origin(row.origin);
            let length = out.indent() + row.line.len();
            let behind = !row.said.is_empty() && out.fits_behind(length.max(column), &row.said);
            if !behind {
                out.comment(&row.said);
            }
            out.start();
            out.text(&row.line);
            if behind {
                out.trailing_comment(length, column, &row.said);
            }
            out.end();
            out.origin(outer);
        }
    }

    /// The chart's name of a variable if it had to be changed, its comment; of a time, that it counts milliseconds; its
    /// address.
    fn about(&self, id: VarId, given: &str) -> String {
        let variable = &self.program.variables[id];
        let unit = if variable.ty == Type::Time { Some("in milliseconds".to_owned()) } else { None };
        let address = variable.address.as_deref().map(|address| format!("at {address}"));
        let parts = remark(&variable.name, given, variable.comment.as_deref()).into_iter().chain(unit).chain(address);
        comment(&parts.collect::<Vec<_>>().join(", "))
    }

    fn constants(&mut self) {
        if self.program.of_role(Role::Constant).next().is_none() {
            return;
        }
        let row = |(id, variable): (VarId, &Variable)| {
            let value = literal(variable.initial(), variable.ty);
            let value = match variable.ty {
                Type::Bool | Type::Real | Type::Lreal => value.to_string(),
                Type::Int | Type::Dint | Type::Uint | Type::Udint | Type::Time => {
                    format!("(({}){value})", type_name(variable.ty))
                }
            };
            let said = self.about(id, &variable.name);
            let line = format!("#define {} {value}", self.names.variables[id]);
            Row { line, said, origin: Origin::declaration(id) }
        };
        let rows: Vec<Row> = self.program.of_role(Role::Constant).map(row).collect();
        self.out.blank();
        self.declared(&rows);
    }

    fn steps(&mut self) {
        let (chart, capitals) = (self.names.chart.clone(), self.names.capitals.clone());
        self.out.blank();
        self.out.comment("the steps, in order of declaration");
        self.out.open("typedef enum {");
        let last = self.program.steps.len();
        let row = |(place, (s, step)): (usize, (StepId, &Step))| {
            let comma = if place + 1 == last { "" } else { "," };
            let note = step.comment.as_deref().map(clean).filter(|text| !text.is_empty());
            let usual = format!("{capitals}_X{}", step.label.to_ascii_uppercase()) == self.names.steps[s].as_str();
            let said = match (usual, note) {
                (true, note) => note.unwrap_or_default(),
                (false, None) => format!("step `{}`", step.label),
                (false, Some(note)) => format!("step `{}`: {note}", step.label),
            };
            Row { line: format!("{}{comma}", self.names.steps[s]), said: comment(&said), origin: Origin::Step(s) }
        };
        let rows: Vec<Row> = self.program.steps.iter_enumerated().enumerate().map(row).collect();
        self.declared(&rows);
        if last == 0 {
            self.out.line(&format!("{capitals}_NO_STEP"));
        }
        self.out.close(&format!("}} {chart}_step;"));
        self.out.blank();
        self.out.line(&format!("#define {capitals}_STEP_COUNT {last}u"));
    }

    fn structure(&mut self, variables: &[VarId], name: &str, about: &str) {
        self.out.blank();
        self.out.comment(about);
        self.out.open("typedef struct {");
        let row = |id: &VarId| {
            let name = &self.names.variables[*id];
            let line = format!("{} {name};", type_name(self.program.variables[*id].ty));
            Row { line, said: self.about(*id, name), origin: Origin::declaration(*id) }
        };
        let mut rows: Vec<Row> = variables.iter().map(row).collect();
        if rows.is_empty() {
            rows.push(Row::new("bool none;", "the chart has none, and C has no empty struct"));
        }
        self.declared(&rows);
        self.out.close(&format!("}} {}_{name};", self.names.chart));
    }

    fn flags(&mut self) {
        self.out.blank();
        self.out.comment("what has gone wrong since the start, or since the flags were cleared");
        self.out.open("typedef struct {");
        self.declared(&FLAGS.map(|(flag, about)| Row::new(format!("bool {};", flag.name()), about)));
        self.out.close(&format!("}} {}_flags;", self.names.chart));
    }

    /// An enum for each state.
    fn states(&mut self) {
        for (state, names) in self.program.states.iter().zip(&self.names.states) {
            let about = self.program.variables[state.variable].comment.as_deref().map(comment).unwrap_or_default();
            self.out.blank();
            self.out.comment(&about);
            self.out.open("typedef enum {");
            for (place, (value, name)) in names.constants.iter().enumerate() {
                let comma = if place + 1 == names.constants.len() { "" } else { "," };
                self.out.line(&format!("{name} = {value}{comma}"));
            }
            self.out.close(&format!("}} {};", names.ty));
        }
    }

    /// All that the chart keeps.
    fn memory(&mut self) {
        let chart = self.names.chart.clone();
        let states = self.program.state_of();
        self.out.blank();
        self.out.comment("the chart: its variables, and its memory from scan to scan, which is nobody else's");
        self.out.open("typedef struct {");
        let mut rows = vec![Row::new(format!("{chart}_outputs outputs;"), "")];
        if has_variables(self.program) {
            rows.push(Row::new(format!("{chart}_variables variables;"), ""));
        }
        rows.push(Row::new(format!("{chart}_flags flags;"), ""));
        if !self.kept.is_empty() {
            rows.push(Row::new(format!("{chart}_kept kept;"), ""));
        }
        let kept = |variable: &Variable| matches!(variable.role, Role::Step | Role::State | Role::Memory);
        for (id, variable) in self.program.variables.iter_enumerated().filter(|(_, variable)| kept(variable)) {
            let ty = states.get(&id).map_or(type_name(variable.ty), |state| &self.names.states[*state].ty);
            let said = variable.comment.as_deref().map(comment).unwrap_or_default();
            rows.push(Row::new(format!("{ty} {};", self.names.variables[id]), said));
        }
        for (id, timer) in self.program.timers.iter_enumerated() {
            let said = timer.comment.as_deref().map(comment).unwrap_or_default();
            rows.push(Row::new(format!("{chart}_delay {};", self.names.timers[id]), said));
        }
        self.declared(&rows);
        self.out.close(&format!("}} {chart};"));
    }

    fn functions(&mut self) {
        let (chart, capitals) = (self.names.chart.clone(), self.names.capitals.clone());
        let mut function = |about: &str, head: String| {
            self.out.blank();
            self.out.comment(about);
            self.out.line(&format!("{head};"));
        };
        function(
            "the inputs before anything is known of them",
            format!("void {chart}_init_inputs({chart}_inputs *inputs)"),
        );
        function(
            "as before the first scan; the next one is the initial reaction",
            format!("void {chart}_init({chart} *chart)"),
        );
        if retains(self.program) {
            function(
                "as after a restart of the controller: as before the first scan, but for what the chart retains",
                format!("void {chart}_restart({chart} *chart)"),
            );
        }
        function(
            "one scan at a time in milliseconds, on a clock that wraps around at 2^32: call it at least every 24 days; the outputs, \
             which are those of the chart",
            format!(
                "const {chart}_outputs *{chart}_scan({chart} *chart, const {chart}_inputs *inputs, uint32_t now_ms)"
            ),
        );
        function(
            "whether a step is active; none is before the first scan",
            format!("bool {chart}_is_active(const {chart} *chart, {chart}_step step)"),
        );
        function("the label of a step, in UTF-8", format!("const char *{chart}_step_label({chart}_step step)"));
        function(
            match self.program.assertion {
                Some(_) => "lowers all flags, and forgets which assertion was false",
                None => "lowers all flags",
            },
            format!("void {chart}_clear_flags({chart} *chart)"),
        );
        function(
            "all memory as bytes, to be kept where power does not matter",
            format!("void {chart}_save(const {chart} *chart, uint8_t *bytes)"),
        );
        function(
            "goes on with what was saved, with the outputs of that situation; the time in between does not count for delays. \
             False if these are not the bytes of this very program, not all as they were saved, or no situation of the chart: it is \
             then as before its first scan",
            format!("bool {chart}_restore({chart} *chart, const uint8_t *bytes, uint32_t now_ms)"),
        );
        let length = super::saved::length(self.program, self.kept);
        self.out.blank();
        self.out.comment("how many bytes that are");
        self.out.line(&format!("#define {capitals}_SAVED_LEN {length}u"));
    }
}
