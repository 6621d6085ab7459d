//! The body of the function block.

use super::expressions::Expressions;
use crate::branches::{Words, write_branches};
use crate::comment::clean;
use crate::iec::literals::{literal, zero};
use crate::iec::names::Names;
use crate::writer::{STEP, Writer, column_of};
use grafc_formula::{Formula, FormulaId, Value};
use grafc_logic::scan::{
    Arm, ByMinusOne, Choice, Division, Guard, Origins, Program, Repeat, Statement, TimerId, Told, VarId, origin_of,
};

/// Writes the statements of one call.
pub(super) fn write(out: &mut Writer, program: &Program, names: &Names, expressions: &Expressions) {
    let body = StStatements::new(out, program, names, expressions);
    out.blank();
    body.block(out, &program.first);
    body.block(out, &program.before);
    match program.repeat {
        Some(repeat) => body.repeat(out, repeat),
        None => body.block(out, &program.micro_step),
    }
    body.block(out, &program.after);
    if let Some(variable) = program.idle_variable() {
        out.comment("nothing ever changes");
        out.line(&format!("{0} := {0};", body.name(variable)));
    }
}

/// Writes what comes first and before a micro-step.
pub(super) fn before(out: &mut Writer, program: &Program, names: &Names, expressions: &Expressions) {
    let body = StStatements::new(out, program, names, expressions);
    body.block(out, &program.first);
    body.block(out, &program.before);
}

/// Writes what comes last.
pub(super) fn after(out: &mut Writer, program: &Program, names: &Names, expressions: &Expressions) {
    StStatements::new(out, program, names, expressions).block(out, &program.after);
}

struct StStatements<'p> {
    program: &'p Program,
    names: &'p Names,
    expressions: &'p Expressions<'p>,
    /// Where variables come from, if somebody asks.
    origins: Option<Origins>,
}

impl<'p> StStatements<'p> {
    fn new(out: &Writer, program: &'p Program, names: &'p Names, expressions: &'p Expressions<'p>) -> Self {
        StStatements { program, names, expressions, origins: out.is_traced().then(|| program.origins()) }
    }

    /// What an assignment is about, beside what it comes from.
    fn about(&self, out: &mut Writer, target: VarId, value: FormulaId) {
        if let Some(origins) = &self.origins {
            out.also(origins.written(&self.program.pool, target, value));
        }
    }

    fn name(&self, id: VarId) -> &str {
        &self.names.variables[id]
    }

    /// The stability loop; where it has a limit, the flag when it was cut off.
    fn repeat(&self, out: &mut Writer, repeat: Repeat) {
        let again = self.name(repeat.again);
        let limit = repeat.limit.map(|limit| (self.name(limit.count), limit.bound));
        out.blank();
        if let Some((count, _)) = limit {
            out.line(&format!("{count} := 0;"));
        }
        out.open("REPEAT");
        if let Some((count, _)) = limit {
            out.line(&format!("{count} := {count} + 1;"));
        }
        self.block(out, &self.program.micro_step);
        out.leave();
        out.line(&match limit {
            Some((count, bound)) => format!("UNTIL NOT {again} OR ({count} >= {bound})"),
            None => format!("UNTIL NOT {again}"),
        });
        out.line("END_REPEAT;");
        if let Some(limit) = repeat.limit {
            out.open(&format!("IF {again} THEN"));
            out.line(&format!("{} := TRUE;", self.name(limit.flag)));
            out.close("END_IF;");
        }
        out.blank();
    }

    fn block(&self, out: &mut Writer, statements: &[Statement]) {
        // The column of the remarks of this run of assignments, and where the run ends.
        let (mut column, mut end) = (0, 0);
        for (place, statement) in statements.iter().enumerate() {
            let outer = out.inner_origin(statement.origin());
            match statement {
                Statement::Heading(heading) => {
                    out.blank();
                    out.comment(&clean(&self.program.heading(*heading)));
                }
                Statement::Assign { target, value, origin, told } => {
                    if place >= end {
                        (column, end) = self.remark_column(out, statements, place);
                    }
                    self.about(out, *target, *value);
                    self.assign(out, *target, *value, self.program.remark(*origin, *told), column);
                }
                Statement::Divide(division) => {
                    self.about(out, division.target, division.dividend);
                    self.divide(out, division);
                }
                Statement::CallTimer { timer, input, .. } => self.call_timer(out, *timer, *input),
                Statement::Case { of, arms } => self.case(out, *of, arms),
                Statement::If(choice) => self.branch(out, &choice.branches, &choice.otherwise),
            }
            out.origin(outer);
        }
    }

    /// The columns of `target := value;`.
    fn length(&self, indent: usize, target: VarId, value: FormulaId) -> usize {
        (indent + self.name(target).len() + 5).saturating_add(self.expressions.value_width(value))
    }

    /// Where the remarks of the assignments from `start` on begin, and the place after the last of them.
    fn remark_column(&self, out: &Writer, statements: &[Statement], start: usize) -> (usize, usize) {
        let mut column = 0;
        for (place, statement) in statements.iter().enumerate().skip(start) {
            let Statement::Assign { target, value, origin, told } = statement else {
                return (column_of(column), place);
            };
            let length = self.length(out.indent(), *target, *value);
            if self.program.says(*origin, *told) && length <= out.furthest_remark() {
                column = column.max(length);
            }
        }
        (column_of(column), statements.len())
    }

    fn assign(&self, out: &mut Writer, target: VarId, value: FormulaId, remark: Option<String>, column: usize) {
        let length = self.length(out.indent(), target, value);
        let remark = remark.map(|text| clean(&text)).filter(|text| !text.is_empty());
        if length > out.width() {
            out.comment(&remark.unwrap_or_default());
            out.line(&format!("{} :=", self.name(target)));
            out.enter();
            self.expressions.lines(out, value, ";");
            out.leave();
            return;
        }
        let behind = remark.as_deref().filter(|text| out.fits_behind(length.max(column), text));
        if behind.is_none() {
            out.comment(remark.as_deref().unwrap_or_default());
        }
        out.start();
        out.text(self.name(target));
        out.text(" := ");
        self.expressions.value(out, value);
        out.text(";");
        if let Some(remark) = behind {
            out.trailing_comment(length, column, remark);
        }
        out.end();
    }

    /// A division under the guards that it needs.
    fn divide(&self, out: &mut Writer, division: &Division) {
        let Division { target, modulo, dividend: a, divisor: b, flag, .. } = *division;
        let (ty, result) = (self.program.pool.ty(b), self.program.variables[target].ty);
        let guard = self.program.guard(division);
        if guard != Guard::Never {
            self.compare(out, "IF", b, &zero(ty));
        }
        self.calculate(out, target, |out| out.text(&zero(result)));
        self.calculate(out, flag, |out| out.text("TRUE"));
        if guard == Guard::Never {
            return;
        }
        if let Some(quotient) = guard.by_minus_one() {
            out.leave();
            self.compare(out, "ELSIF", b, &literal(Value::Int(-1), ty));
            self.calculate(out, target, |out| match quotient {
                ByMinusOne::Zero => out.text("0"),
                // MATIEC computes with constants, and refuses the difference.
                ByMinusOne::Dividend => self.operand(out, a),
                ByMinusOne::Negative => {
                    out.text("0 - ");
                    self.operand(out, a);
                }
            });
        }
        out.leave();
        out.open("ELSE");
        self.calculate(out, target, |out| {
            self.operand(out, a);
            out.text(if modulo { " MOD " } else { " / " });
            self.operand(out, b);
        });
        out.close("END_IF;");
    }

    /// `IF a = constant THEN`, and one level deeper.
    fn compare(&self, out: &mut Writer, word: &str, a: FormulaId, constant: &str) {
        out.start();
        out.text(word);
        out.text(" ");
        self.expressions.flat(out, a);
        out.text(&format!(" = {constant} THEN"));
        out.end();
        out.enter();
    }

    /// `target := …;`
    fn calculate(&self, out: &mut Writer, target: VarId, value: impl FnOnce(&mut Writer)) {
        out.start();
        out.text(self.name(target));
        out.text(" := ");
        value(out);
        out.text(";");
        out.end();
    }

    /// An operand of a division.
    fn operand(&self, out: &mut Writer, id: FormulaId) {
        let single = matches!(
            self.program.pool.get(id),
            Formula::Variable(_) | Formula::TimerElapsed(_) | Formula::Constant(_) | Formula::Widen(_)
        );
        out.text(if single { "" } else { "(" });
        self.expressions.flat(out, id);
        out.text(if single { "" } else { ")" });
    }

    fn call_timer(&self, out: &mut Writer, timer: TimerId, input: FormulaId) {
        let name = &self.names.timers[timer];
        let preset = self.names.preset(self.program.timers[timer].given_preset());
        let length = out.indent() + name.len() + "(IN := , PT := );".len() + preset.len();
        if length.saturating_add(self.expressions.value_width(input)) <= out.width() {
            out.start();
            out.text(&format!("{name}(IN := "));
            self.expressions.value(out, input);
            out.text(&format!(", PT := {preset});"));
            out.end();
        } else {
            out.open(&format!("{name}("));
            out.line("IN :=");
            out.enter();
            self.expressions.lines(out, input, ",");
            out.leave();
            out.line(&format!("PT := {preset}"));
            out.close(");");
        }
    }

    /// An arm a value, with what the value stands for beside it. Labels are literals: constants are not taken everywhere.
    fn case(&self, out: &mut Writer, of: VarId, arms: &[Arm]) {
        out.open(&format!("CASE {} OF", self.name(of)));
        for arm in arms {
            let outer = out.inner_origin(arm.origin);
            let label = format!("{}:", arm.value);
            if self.arm_on_lines(out, arm, &format!("{label:<3} ")) {
                out.origin(outer);
                continue;
            }
            let remark = self.program.remark(arm.origin, arm.told);
            let remark = remark.map(|text| clean(&text)).filter(|text| !text.is_empty());
            let length = out.indent() + label.len();
            let behind = remark.as_deref().filter(|text| out.fits_behind(length, text));
            out.start();
            out.text(&label);
            if let Some(remark) = behind {
                out.trailing_comment(length, length, remark);
            }
            out.end();
            out.enter();
            if behind.is_none() {
                out.comment(remark.as_deref().unwrap_or_default());
            }
            self.block(out, &arm.body);
            out.leave();
            out.origin(outer);
        }
        out.close("END_CASE;");
    }

    /// `1:  IF a THEN x := 1; END_IF;`, if an arm does no more and its step has no comment.
    fn arm_on_lines(&self, out: &mut Writer, arm: &Arm, lead: &str) -> bool {
        let [Statement::If(choice)] = arm.body.as_slice() else { return false };
        let Choice { branches, otherwise } = &**choice;
        // What follows the first line stands below its `IF`.
        let below = lead.len() == STEP || branches.len() == 1;
        if !below || self.program.says(arm.origin, Told::Comment) {
            return false;
        }
        let Some(lengths) = self.lengths_of_lines(out, branches, otherwise, lead.len()) else { return false };
        self.branches_on_lines(out, branches, &lengths, lead);
        true
    }

    /// The columns of the branches of a choice that are short enough for a line each: each stores few constants.
    fn lengths_of_lines(
        &self,
        out: &Writer,
        branches: &[(FormulaId, Vec<Statement>)],
        otherwise: &[Statement],
        lead: usize,
    ) -> Option<Vec<usize>> {
        const MOST: usize = 5;
        if branches.is_empty() || !otherwise.is_empty() {
            return None;
        }
        let mut lengths = Vec::with_capacity(branches.len());
        for (place, (when, body)) in branches.iter().enumerate() {
            let word = if place == 0 { "IF  THEN" } else { "ELSIF  THEN" };
            let end = if branches.len() == 1 { " END_IF;" } else { "" };
            let mut length =
                (out.indent() + lead + word.len() + end.len()).saturating_add(self.expressions.width(*when));
            if body.len() > MOST {
                return None;
            }
            for (place, statement) in body.iter().enumerate() {
                let Statement::Assign { target, value, origin, told } = statement else { return None };
                let aside = place > 0 && self.program.says(*origin, *told);
                if aside || self.program.pool.as_constant(*value).is_none() {
                    return None;
                }
                length = length.saturating_add(1 + self.length(0, *target, *value));
            }
            if length > out.width() {
                return None;
            }
            lengths.push(length);
        }
        Some(lengths)
    }

    /// `IF a THEN x := 1; END_IF;`, or a line for each branch.
    fn branches_on_lines(
        &self,
        out: &mut Writer,
        branches: &[(FormulaId, Vec<Statement>)],
        lengths: &[usize],
        lead: &str,
    ) {
        let furthest = out.furthest_remark();
        let column = column_of(lengths.iter().copied().filter(|length| *length <= furthest).max().unwrap_or(0));
        for (place, ((when, body), length)) in branches.iter().zip(lengths).enumerate() {
            let outer = out.inner_origin(origin_of(body));
            let said = match body.first() {
                Some(Statement::Assign { origin, told, .. }) => self.program.remark(*origin, *told),
                _ => None,
            };
            let said = said.map(|text| clean(&text)).filter(|text| !text.is_empty());
            let behind = said.as_deref().filter(|text| out.fits_behind((*length).max(column), text));
            if behind.is_none() {
                out.comment(said.as_deref().unwrap_or_default());
            }
            out.start();
            out.text(if place == 0 { lead } else { "" });
            out.text(if place == 0 { "IF " } else { "ELSIF " });
            self.expressions.flat(out, *when);
            out.text(" THEN");
            for statement in body {
                let Statement::Assign { target, value, .. } = statement else { continue };
                self.about(out, *target, *value);
                out.text(" ");
                out.text(self.name(*target));
                out.text(" := ");
                self.expressions.value(out, *value);
                out.text(";");
            }
            out.text(if branches.len() == 1 { " END_IF;" } else { "" });
            if let Some(text) = behind {
                out.trailing_comment(*length, column, text);
            }
            out.end();
            out.origin(outer);
            if place == 0 && !lead.is_empty() {
                out.enter();
            }
        }
        if branches.len() > 1 {
            out.line("END_IF;");
        }
        if !lead.is_empty() {
            out.leave();
        }
    }

    fn branch(&self, out: &mut Writer, branches: &[(FormulaId, Vec<Statement>)], otherwise: &[Statement]) {
        if let Some(lengths) = self.lengths_of_lines(out, branches, otherwise, 0) {
            return self.branches_on_lines(out, branches, &lengths, "");
        }
        let words = Words { first: "IF", next: "ELSIF", otherwise: "ELSE", end: "END_IF;" };
        let head = |out: &mut Writer, word: &str, condition| {
            if out.indent() + word.len() + self.expressions.width(condition) + 6 <= out.width() {
                out.start();
                out.text(word);
                out.text(" ");
                self.expressions.flat(out, condition);
                out.text(" THEN");
                out.end();
            } else {
                out.open(word);
                self.expressions.lines(out, condition, "");
                out.close("THEN");
            }
        };
        write_branches(out, words, (branches, otherwise), head, |out, body| self.block(out, body));
    }
}
