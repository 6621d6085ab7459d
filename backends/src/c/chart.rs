//! What can be done with a chart beside a scan.

use super::expressions::Expressions;
use super::header::{FLAGS, retains};
use super::places::Places;
use super::text::quoted;
use crate::writer::Writer;
use grafc_formula::FormulaId;
use grafc_logic::scan::{Origin, Program, Role, StepId, VarId};

/// Writes it.
pub(super) fn write(out: &mut Writer, program: &Program, places: &Places, expressions: &Expressions, kept: &[VarId]) {
    let chart = Chart { program, places, expressions, kept };
    chart.init_inputs(out);
    chart.init(out);
    if retains(program) {
        chart.restart(out);
    }
    chart.clear_flags(out);
    chart.is_active(out);
    chart.step_label(out);
}

struct Chart<'p> {
    program: &'p Program,
    places: &'p Places<'p>,
    expressions: &'p Expressions<'p>,
    /// The inputs that are kept.
    kept: &'p [VarId],
}

impl Chart<'_> {
    fn init_inputs(&self, out: &mut Writer) {
        let chart = &self.places.names.chart;
        out.blank();
        out.open(&format!("void {chart}_init_inputs({chart}_inputs *inputs)\n{{"));
        if self.program.of_role(Role::Input).next().is_none() {
            out.line("inputs->none = false;");
        }
        self.initial(out, Role::Input);
        out.close("}");
    }

    /// What the variables of a role are before the first scan.
    fn initial(&self, out: &mut Writer, role: Role) {
        for (id, variable) in self.program.of_role(role) {
            let outer = out.origin(Origin::declaration(id));
            let value = self.places.value(id, variable.initial());
            out.line(&format!("{} = {value};", self.places.read(id)));
            out.origin(outer);
        }
    }

    fn init(&self, out: &mut Writer) {
        let chart = &self.places.names.chart;
        out.blank();
        out.open(&format!("void {chart}_init({chart} *chart)\n{{"));
        if self.program.of_role(Role::Output).next().is_none() {
            out.line("chart->outputs.none = false;");
        }
        self.initial(out, Role::Output);
        self.initial(out, Role::Internal);
        for id in self.kept {
            let value = self.places.value(*id, self.program.variables[*id].initial());
            out.line(&format!("chart->kept.{} = {value};", self.places.names.variables[*id]));
        }
        for (flag, _) in FLAGS {
            out.line(&format!("chart->flags.{} = false;", flag.name()));
        }
        for (id, variable) in self.program.variables.iter_enumerated() {
            if matches!(variable.role, Role::Step | Role::State | Role::Memory) {
                let value = self.places.value(id, variable.initial());
                out.line(&format!("{} = {value};", self.places.read(id)));
            }
        }
        for timer in self.program.timers.indices() {
            let timer = self.places.timer(timer);
            out.line(&format!("{timer}.elapsed = 0;"));
            out.line(&format!("{timer}.last = 0u;"));
            out.line(&format!("{timer}.running = false;"));
        }
        out.close("}");
    }

    fn restart(&self, out: &mut Writer) {
        let chart = &self.places.names.chart;
        out.blank();
        out.open(&format!("void {chart}_restart({chart} *chart)\n{{"));
        let retained = || self.program.variables.iter_enumerated().filter(|(_, variable)| variable.retain);
        let of = |role: Role| retained().any(|(_, variable)| variable.role == role);
        if of(Role::Output) {
            out.line(&format!("const {chart}_outputs outputs = chart->outputs;"));
        }
        if of(Role::Internal) {
            out.line(&format!("const {chart}_variables variables = chart->variables;"));
        }
        // Memory of ours that belongs to what is retained.
        for (id, variable) in retained() {
            if !matches!(variable.role, Role::Output | Role::Internal) {
                let name = &self.places.names.variables[id];
                out.line(&format!("const {} {name} = {};", self.places.type_name(id), self.places.read(id)));
            }
        }
        out.blank();
        out.line(&format!("{chart}_init(chart);"));
        for (id, _) in retained() {
            let place = self.places.read(id);
            let from = place.strip_prefix("chart->").unwrap_or(place);
            out.line(&format!("{place} = {from};"));
        }
        out.close("}");
    }

    fn clear_flags(&self, out: &mut Writer) {
        let chart = &self.places.names.chart;
        out.blank();
        out.open(&format!("void {chart}_clear_flags({chart} *chart)\n{{"));
        for (flag, _) in FLAGS {
            out.line(&format!("chart->flags.{} = false;", flag.name()));
        }
        if let Some(v) = self.program.assertion {
            out.line(&format!("{} = 0;", self.places.read(v)));
        }
        out.close("}");
    }

    fn is_active(&self, out: &mut Writer) {
        let chart = &self.places.names.chart;
        out.blank();
        out.open(&format!("bool {chart}_is_active(const {chart} *chart, {chart}_step step)\n{{"));
        if let Some(started) = self.program.started {
            out.open(&format!("if (!{}) {{", self.places.read(started)));
            out.line("return false;");
            out.close("}");
        }
        if self.program.steps.is_empty() && self.program.started.is_none() {
            out.line("(void)chart;");
        }
        self.by_step(out, |out, place, step| {
            let active = self.expressions.text(out, step);
            (format!("case {}:", self.places.names.steps[place]), format!("return {active};"))
        });
        out.line("return false;");
        out.close("}");
    }

    fn step_label(&self, out: &mut Writer) {
        let chart = &self.places.names.chart;
        out.blank();
        out.open(&format!("const char *{chart}_step_label({chart}_step step)\n{{"));
        self.by_step(out, |_, place, _| {
            let label = quoted(&self.program.steps[place].label);
            (format!("case {}:", self.places.names.steps[place]), format!("return {label};"))
        });
        out.line("return \"\";");
        out.close("}");
    }

    /// A choice between all steps.
    fn by_step(&self, out: &mut Writer, arm: impl Fn(&Writer, StepId, FormulaId) -> (String, String)) {
        if self.program.steps.is_empty() {
            return out.line("(void)step;");
        }
        out.open("switch (step) {");
        for (place, step) in self.program.steps.iter_enumerated() {
            let outer = out.origin(Origin::Step(place));
            let (head, line) = arm(out, place, step.active);
            out.open(&head);
            out.line(&line);
            out.leave();
            out.origin(outer);
        }
        out.open("default:");
        out.line("break;");
        out.leave();
        out.close("}");
    }
}
