//! Statements of a part of the scan.

use super::expressions::{Expressions, function, sign};
use super::places::Places;
use super::text::comment;
use crate::writer::{Writer, column_of};
use ecow::{EcoString, eco_format};
use grafc_formula::{Arithmetic, FormulaId, Type, Value};
use grafc_logic::scan::{Arm, Division, Guard, Statement, VarId, is_empty, origin_of, origin_of_end};

/// Writes statements.
pub(super) struct Statements<'p> {
    pub places: &'p Places<'p>,
    pub expressions: &'p Expressions<'p>,
    /// Whether they give memory back.
    pub restoring: bool,
}

impl Statements<'_> {
    /// A block. Statements nest no deeper than lowering nests them.
    pub fn block(&self, out: &mut Writer, statements: &[Statement]) {
        // The column of the remarks of this run of assignments, and where the run ends.
        let (mut column, mut end) = (0, 0);
        for (place, statement) in statements.iter().enumerate() {
            let outer = out.inner_origin(statement.origin());
            match statement {
                Statement::Heading(heading) => {
                    out.blank();
                    out.comment(&comment(&self.places.program.heading(*heading)));
                }
                Statement::Assign { target, value, origin, told } => {
                    if place >= end {
                        (column, end) = self.remark_column(out, statements, place);
                    }
                    self.about(out, *target, *value);
                    let remark = self.places.program.remark(*origin, *told);
                    self.assign(out, *target, *value, &remark.map(|text| comment(&text)).unwrap_or_default(), column);
                    self.unread(out, *target);
                }
                Statement::Divide(division) => {
                    self.about(out, division.target, division.dividend);
                    self.divide(out, division);
                }
                Statement::CallTimer { timer, input, .. } => {
                    let head = format!("delay_run(&{}, ", self.places.timer(*timer));
                    self.enclosed(out, &head, *input, ", now_ms);");
                }
                Statement::Case { of, arms } => self.case(out, *of, arms),
                Statement::If { branches, otherwise } => self.branch(out, branches, otherwise),
            }
            out.origin(outer);
        }
    }

    /// A constant that nobody reads, since comparisons that ask for it are decided without it.
    fn unread(&self, out: &mut Writer, target: VarId) {
        if self.places.is_constant(target) && !self.expressions.is_read(target, self.restoring) {
            out.line(&format!("(void){};", self.places.read(target)));
        }
    }

    /// What an assignment is about, beside what it comes from.
    fn about(&self, out: &mut Writer, target: VarId, value: FormulaId) {
        if let Some(origins) = &self.places.origins {
            out.also(origins.written(&self.places.program.pool, target, value));
        }
    }

    /// The left side of an assignment, which declares what is written once.
    fn target(&self, target: VarId) -> EcoString {
        let name = self.places.read(target);
        if self.places.is_constant(target) {
            eco_format!("const {} {name}", self.places.type_name(target))
        } else {
            name.clone()
        }
    }

    /// The right side of an assignment, if it is a value of a state.
    fn named(&self, target: VarId, value: FormulaId) -> Option<EcoString> {
        self.places.state(target)?;
        let constant: Value = self.places.program.pool.as_constant(value)?;
        Some(self.places.value(target, constant))
    }

    fn width(&self, target: VarId, value: FormulaId) -> usize {
        self.named(target, value).map_or_else(|| self.expressions.width(value), |name| name.len())
    }

    /// The columns of `target = value;`.
    fn length(&self, indent: usize, target: VarId, value: FormulaId) -> usize {
        (indent + self.target(target).len() + " = ;".len()).saturating_add(self.width(target, value))
    }

    /// Where the remarks of the assignments from `start` on begin, and the place after the last of them.
    fn remark_column(&self, out: &Writer, statements: &[Statement], start: usize) -> (usize, usize) {
        let mut column = 0;
        for (place, statement) in statements.iter().enumerate().skip(start) {
            let Statement::Assign { target, value, origin, told } = statement else {
                return (column_of(column), place);
            };
            let length = self.length(out.indent(), *target, *value);
            if self.places.program.says(*origin, *told) && length <= out.furthest_remark() {
                column = column.max(length);
            }
        }
        (column_of(column), statements.len())
    }

    fn assign(&self, out: &mut Writer, target: VarId, value: FormulaId, remark: &str, column: usize) {
        let length = self.length(out.indent(), target, value);
        let named = self.named(target, value);
        if length > out.width() && named.is_none() {
            out.comment(remark);
            out.line(&format!("{} =", self.target(target)));
            out.enter();
            self.expressions.lines(out, value, ";");
            out.leave();
            return;
        }
        let behind = !remark.is_empty() && out.fits_behind(length.max(column), remark);
        if !behind {
            out.comment(remark);
        }
        out.start();
        out.text(&self.target(target));
        out.text(" = ");
        match named {
            Some(name) => out.text(&name),
            None => self.expressions.flat(out, value),
        }
        out.text(";");
        if behind {
            out.trailing_comment(length, column, remark);
        }
        out.end();
    }

    /// `head value tail`, the value on lines of its own where it is long.
    fn enclosed(&self, out: &mut Writer, head: &str, value: FormulaId, tail: &str) {
        if (out.indent() + head.len() + tail.len()).saturating_add(self.expressions.width(value)) <= out.width() {
            out.start();
            out.text(head);
            self.expressions.flat(out, value);
            out.text(tail);
            return out.end();
        }
        out.open(head.trim_end());
        self.expressions.lines(out, value, "");
        out.leave();
        out.line(tail);
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
        let (a, b) = (self.expressions.text(out, dividend), self.expressions.text(out, divisor));
        let op = if modulo { Arithmetic::Modulo } else { Arithmetic::Divide };
        out.open(&format!("if ({b} == {zero}) {{"));
        raised.iter().for_each(|line| out.line(line));
        out.leave();
        out.open("} else {");
        match is_real {
            true => out.line(&format!("{target} = {a} {} {b};", sign(op))),
            false => out.line(&format!("{target} = {}({a}, {b});", function(op, ty))),
        }
        out.close("}");
    }

    /// An arm a value, with what the value stands for beside it; a single arm is an `if`.
    fn case(&self, out: &mut Writer, of: VarId, arms: &[Arm]) {
        let single = arms.len() == 1;
        if !single {
            out.open(&format!("switch ({}) {{", self.places.read(of)));
        }
        for arm in arms {
            let outer = out.inner_origin(arm.origin);
            let remark =
                self.places.program.remark(arm.origin, arm.told).map(|text| comment(&text)).unwrap_or_default();
            let value = self.places.value(of, Value::Int(arm.value));
            let head =
                if single { format!("if ({} == {value}) {{", self.places.read(of)) } else { format!("case {value}:") };
            let length = out.indent() + head.len();
            let behind = !remark.is_empty() && out.fits_behind(length, &remark);
            if !behind {
                out.comment(&remark);
            }
            out.start();
            out.text(&head);
            if behind {
                out.trailing_comment(length, length, &remark);
            }
            out.end();
            out.enter();
            self.block(out, &arm.body);
            if single {
                out.close("}");
            } else {
                out.line("break;");
                out.leave();
            }
            out.origin(outer);
        }
        if !single {
            // Of an enum, compilers ask for all values.
            out.open("default:");
            out.line("break;");
            out.leave();
            out.close("}");
        }
    }

    fn branch(&self, out: &mut Writer, branches: &[(FormulaId, Vec<Statement>)], otherwise: &[Statement]) {
        let mut head = "if (";
        for (condition, body) in branches {
            let outer = out.inner_origin(origin_of(body));
            self.enclosed(out, head, *condition, ") {");
            out.enter();
            self.block(out, body);
            out.leave();
            out.origin(outer);
            head = "} else if (";
        }
        if branches.is_empty() {
            return self.block(out, otherwise);
        }
        if !is_empty(otherwise) {
            let outer = out.inner_origin(origin_of(otherwise));
            out.open("} else {");
            self.block(out, otherwise);
            out.leave();
            out.origin(outer);
        }
        let outer = out.inner_origin(origin_of_end(branches, otherwise));
        out.line("}");
        out.origin(outer);
    }
}
