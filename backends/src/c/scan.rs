//! The scan: one function, and what follows from memory that has been given back.
//!
//! The scan reads inputs where they are given. Of those that outputs go by at once, the chart keeps the values: what gives
//! memory back has no others.

use super::expressions::Expressions;
use super::places::Places;
use super::statements::Statements;
use crate::braces::Braces as _;
use crate::writer::Writer;
use grafc_logic::scan::{Program, Role, VarId};

/// Writes the scan.
pub(super) fn write(out: &mut Writer, places: &Places, expressions: &Expressions, kept: &[VarId]) {
    let statements = Statements { places, expressions };
    let (program, chart) = (places.program, &places.names.chart);
    out.open(&format!(
        "const {chart}_outputs *{chart}_scan({chart} *chart, const {chart}_inputs *inputs, uint32_t now_ms)\n{{"
    ));
    declare(out, &statements, &places.declared(false));
    let counts = program.repeat.filter(|repeat| repeat.limit.is_none()).is_some();
    if counts {
        out.line(&format!("uint32_t {};", places.names.count));
    }
    out.blank();
    if program.timers.is_empty() {
        out.line("(void)now_ms;");
    }
    let is_unread = |(id, _)| !expressions.is_read(id);
    if kept.is_empty() && program.of_role(Role::Input).all(is_unread) {
        out.line("(void)inputs;");
    }
    statements.block(out, &program.first);
    statements.block(out, &program.before);
    micro_steps(out, program, places, &statements);
    statements.block(out, &program.after);
    out.blank();
    for id in kept {
        let name = &places.names.variables[*id];
        out.line(&format!("chart->kept.{name} = inputs->{name};"));
    }
    out.line("return &chart->outputs;");
    out.close("}");
}

/// Writes what follows from memory that has been given back, if something does.
pub(super) fn write_restoring(out: &mut Writer, places: &Places, expressions: &Expressions) {
    let Some(restoring) = places.program.restoring.as_ref().filter(|_| restores(places.program)) else { return };
    let statements = Statements { places, expressions };
    out.blank();
    out.comment("what follows from memory that has been given back");
    out.open(&format!("static void restoring({} *chart)\n{{", places.names.chart));
    declare(out, &statements, &places.declared(true));
    out.blank();
    statements.block(out, &restoring.statements);
    out.close("}");
}

/// Whether there is a function that does what follows from memory that has been given back.
pub(super) fn restores(program: &Program) -> bool {
    program.restoring.as_ref().is_some_and(|restoring| !restoring.statements.is_empty())
}

/// The inputs whose values that function asks for.
pub(super) fn kept(program: &Program, restoring: &Expressions) -> Vec<VarId> {
    let is_read = |id: &VarId| restores(program) && restoring.is_read(*id);
    program.of_role(Role::Input).map(|(id, _)| id).filter(is_read).collect()
}

/// Local variables, each with a value: compilers do not see that nothing is read before it is written.
fn declare(out: &mut Writer, statements: &Statements, variables: &[VarId]) {
    let places = statements.places;
    for v in variables {
        let variable = &places.program.variables[*v];
        let value = places.value(*v, grafc_formula::number::zero(variable.ty));
        out.line(&format!("{} {} = {value};", places.type_name(*v), places.read(*v)));
    }
    for v in variables.iter().filter(|v| !statements.expressions.is_read(**v)) {
        // Comparisons that ask for it are decided without it.
        out.line(&format!("(void){};", places.read(*v)));
    }
}

/// The evolution (R9): micro-steps until nothing more happens, and never more than the bound.
fn micro_steps(out: &mut Writer, program: &Program, places: &Places, statements: &Statements) {
    let Some(repeat) = program.repeat else { return statements.block(out, &program.micro_step) };
    let (count, most) = match repeat.limit {
        Some(limit) => (places.read(limit.count), limit.bound),
        None => (&places.names.count, program.most),
    };
    let again = places.read(repeat.again);
    out.blank();
    let unsigned = if repeat.limit.is_none() { "u" } else { "" };
    out.open(&format!("for ({count} = 0; {count} < {most}{unsigned}; {count}++) {{"));
    statements.block(out, &program.micro_step);
    out.blank();
    out.open(&format!("if (!{again}) {{"));
    out.line("break;");
    out.close("}");
    out.close("}");
    if let Some(limit) = repeat.limit {
        out.open(&format!("if ({again}) {{"));
        out.line(&format!("{} = true;", places.read(limit.flag)));
        out.close("}");
    }
}
