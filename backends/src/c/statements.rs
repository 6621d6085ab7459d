//! Statements of a part of the scan.

use super::expressions::{Expressions, function, sign};
use super::places::Places;
use super::text::comment;
use crate::braces::Braces;
use crate::writer::Writer;
use ecow::{EcoString, eco_format};
use grafc_formula::{Arithmetic, FormulaId, Type, Value};
use grafc_logic::scan::{Division, Guard, Origins, Program, TimerId, VarId};

/// Writes statements.
pub(super) struct Statements<'p> {
    pub places: &'p Places<'p>,
    pub expressions: &'p Expressions<'p>,
}

impl Statements<'_> {
    /// The right side of an assignment, if it is a value of a state.
    fn named(&self, target: VarId, value: FormulaId) -> Option<EcoString> {
        self.places.state(target)?;
        let constant: Value = self.places.program.pool.as_constant(value)?;
        Some(self.places.value(target, constant))
    }
}

impl Braces for Statements<'_> {
    const EQUAL: &'static str = "==";
    // Of an enum, compilers ask for all values.
    const HAS_DEFAULT: bool = true;

    fn program(&self) -> &Program {
        self.places.program
    }

    fn origins(&self) -> Option<&Origins> {
        self.places.origins.as_ref()
    }

    fn comment(&self, text: &str) -> String {
        comment(text)
    }

    fn read(&self, v: VarId) -> &EcoString {
        self.places.read(v)
    }

    fn target(&self, target: VarId) -> EcoString {
        let name = self.places.read(target);
        if self.places.is_constant(target) {
            eco_format!("const {} {name}", self.places.type_name(target))
        } else {
            name.clone()
        }
    }

    fn label(&self, of: VarId, value: i64) -> EcoString {
        self.places.value(of, Value::Int(value))
    }

    fn width(&self, target: VarId, value: FormulaId) -> usize {
        self.named(target, value).map_or_else(|| self.expressions.width(value), |name| name.len())
    }

    fn flat(&self, out: &mut Writer, target: VarId, value: FormulaId) {
        match self.named(target, value) {
            Some(name) => out.text(&name),
            None => self.expressions.flat(out, value),
        }
    }

    fn lines(&self, out: &mut Writer, target: VarId, value: FormulaId) {
        match self.named(target, value) {
            Some(name) => out.line(&format!("{name};")),
            None => self.expressions.lines(out, value, ";"),
        }
    }

    fn width_of_condition(&self, condition: FormulaId) -> usize {
        self.expressions.width(condition)
    }

    fn flat_condition(&self, out: &mut Writer, condition: FormulaId) {
        self.expressions.flat(out, condition);
    }

    fn lines_of_condition(&self, out: &mut Writer, condition: FormulaId) {
        self.expressions.lines(out, condition, "");
    }

    fn timer(&self, timer: TimerId) -> (String, &'static str) {
        (format!("delay_run(&{}, ", self.places.timer(timer)), ", now_ms);")
    }

    /// A division under its guard. What a processor may stop at is the affair of the function that divides.
    fn divide(&self, out: &mut Writer, division: &Division) {
        let Division { target, modulo, dividend, divisor, flag, .. } = *division;
        let ty = self.places.program.variables[target].ty;
        let (target, flag) = (self.target(target), self.places.read(flag));
        let is_real = matches!(ty, Type::Real | Type::Lreal);
        let zero = match ty {
            Type::Real => "0.0f",
            Type::Lreal => "0.0",
            Type::Bool | Type::Int | Type::Dint | Type::Uint | Type::Udint | Type::Time => "0",
        };
        let raised = [format!("{target} = {zero};"), format!("{flag} = true;")];
        if self.places.program.guard(division) == Guard::Never {
            return raised.iter().for_each(|line| out.line(line));
        }
        let compared = match ty {
            Type::Uint | Type::Udint => "0u",
            Type::Real | Type::Lreal | Type::Bool | Type::Int | Type::Dint | Type::Time => zero,
        };
        let (a, b) = (self.expressions.text(out, dividend), self.expressions.text(out, divisor));
        let op = if modulo { Arithmetic::Modulo } else { Arithmetic::Divide };
        out.open(&format!("if ({b} == {compared}) {{"));
        raised.iter().for_each(|line| out.line(line));
        out.leave();
        out.open("} else {");
        match is_real {
            true => out.line(&format!("{target} = {a} {} {b};", sign(op))),
            false => out.line(&format!("{target} = {}({a}, {b});", function(op, ty))),
        }
        out.close("}");
    }

    /// A constant that nobody reads, since comparisons that ask for it are decided without it.
    fn assigned(&self, out: &mut Writer, target: VarId) {
        if self.places.is_constant(target) && !self.expressions.is_read(target) {
            out.line(&format!("(void){};", self.places.read(target)));
        }
    }
}
