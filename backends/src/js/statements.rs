//! Statements of a part of the scan.

use super::expressions::{Expressions, wrapped};
use super::places::Places;
use super::text::comment;
use crate::braces::Braces;
use crate::writer::Writer;
use ecow::{EcoString, eco_format};
use grafc_formula::{FormulaId, Type};
use grafc_logic::scan::{Division, Guard, Origins, Program, TimerId, VarId};

/// Writes statements.
pub(super) struct Statements<'p> {
    pub places: &'p Places<'p>,
    pub expressions: &'p Expressions<'p>,
}

impl Braces for Statements<'_> {
    const EQUAL: &'static str = "===";
    const HAS_DEFAULT: bool = false;

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
        match self.places.local(target) {
            Some(uses) if uses.is_constant() => eco_format!("const {name}"),
            Some(_) | None => name.clone(),
        }
    }

    fn label(&self, _: VarId, value: i64) -> EcoString {
        eco_format!("{value}")
    }

    fn width(&self, _: VarId, value: FormulaId) -> usize {
        self.expressions.width(value)
    }

    fn flat(&self, out: &mut Writer, _: VarId, value: FormulaId) {
        self.expressions.flat(out, value);
    }

    fn lines(&self, out: &mut Writer, _: VarId, value: FormulaId) {
        self.expressions.lines(out, value, ";");
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
        (format!("run({}, ", self.places.timer(timer)), ", now);")
    }

    /// A division under its guard. What a processor may stop at is no fault here: a quotient wraps around.
    fn divide(&self, out: &mut Writer, division: &Division) {
        let Division { target, modulo, dividend, divisor, flag, .. } = *division;
        let ty = self.places.program.variables[target].ty;
        let (target, flag) = (self.target(target), self.places.read(flag));
        let zero = if ty == Type::Time { "0n" } else { "0" };
        let raised = [format!("{target} = {zero};"), format!("{flag} = true;")];
        if self.places.program.guard(division) == Guard::Never {
            return raised.iter().for_each(|line| out.line(line));
        }
        let operand = |id: FormulaId| match ty {
            Type::Time => self.expressions.big(id),
            Type::Bool | Type::Int | Type::Dint | Type::Uint | Type::Udint | Type::Real | Type::Lreal => {
                self.expressions.text(out, id).into()
            }
        };
        let (a, b) = (operand(dividend), operand(divisor));
        let sign = if modulo { "%" } else { "/" };
        out.open(&format!("if ({b} === {zero}) {{"));
        raised.iter().for_each(|line| out.line(line));
        out.leave();
        out.open("} else {");
        out.line(&format!("{target} = {};", wrapped(ty, &format!("{a} {sign} {b}"))));
        out.close("}");
    }

    fn assigned(&self, _: &mut Writer, _: VarId) {}
}
