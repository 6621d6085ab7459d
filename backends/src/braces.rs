//! Statements between braces, as C and JavaScript have them: what both notations share, which is all but how things are
//! spelt.

use crate::branches::{Words, write_branches};
use crate::writer::{Writer, column_of};
use ecow::EcoString;
use grafc_formula::FormulaId;
use grafc_logic::scan::{Arm, Division, Origins, Program, Statement, TimerId, VarId};

/// How a language with braces spells statements.
pub(crate) trait Braces {
    /// The comparison for equality.
    const EQUAL: &'static str;
    /// Whether a choice has an arm for all other values, which does nothing.
    const HAS_DEFAULT: bool;

    fn program(&self) -> &Program;

    /// Where variables come from, if somebody asks.
    fn origins(&self) -> Option<&Origins>;

    /// A text of the user's in a comment.
    fn comment(&self, text: &str) -> String;

    /// A variable as an operand.
    fn read(&self, v: VarId) -> &EcoString;

    /// The left side of an assignment, which may declare what is written once.
    fn target(&self, target: VarId) -> EcoString;

    /// A value of the variable that a choice asks.
    fn label(&self, of: VarId, value: i64) -> EcoString;

    /// The columns that the right side of an assignment takes on one line.
    fn width(&self, target: VarId, value: FormulaId) -> usize;

    /// Writes the right side of an assignment on the current line.
    fn flat(&self, out: &mut Writer, target: VarId, value: FormulaId);

    /// Writes the right side of an assignment on lines of its own, with `;` behind it.
    fn lines(&self, out: &mut Writer, target: VarId, value: FormulaId);

    /// The columns that a condition takes on one line.
    fn width_of_condition(&self, condition: FormulaId) -> usize;

    /// Writes a condition on the current line.
    fn flat_condition(&self, out: &mut Writer, condition: FormulaId);

    /// Writes a condition on lines of its own.
    fn lines_of_condition(&self, out: &mut Writer, condition: FormulaId);

    /// What stands before and behind the input of a timer that is brought up to date.
    fn timer(&self, timer: TimerId) -> (String, &'static str);

    /// A division under its guard.
    fn divide(&self, out: &mut Writer, division: &Division);

    /// What follows an assignment.
    fn assigned(&self, out: &mut Writer, target: VarId);

    /// A block. Statements nest no deeper than lowering nests them.
    fn block(&self, out: &mut Writer, statements: &[Statement]) {
        // The column of the remarks of this run of assignments, and where the run ends.
        let (mut column, mut end) = (0, 0);
        for (place, statement) in statements.iter().enumerate() {
            let outer = out.inner_origin(statement.origin());
            match statement {
                Statement::Heading(heading) => {
                    out.blank();
                    out.comment(&self.comment(&self.program().heading(*heading)));
                }
                Statement::Assign { target, value, origin, told } => {
                    if place >= end {
                        (column, end) = self.remark_column(out, statements, place);
                    }
                    self.about(out, *target, *value);
                    let remark = self.program().remark(*origin, *told);
                    let remark = remark.map(|text| self.comment(&text)).unwrap_or_default();
                    self.assign(out, *target, *value, &remark, column);
                    self.assigned(out, *target);
                }
                Statement::Divide(division) => {
                    self.about(out, division.target, division.dividend);
                    self.divide(out, division);
                }
                Statement::CallTimer { timer, input, .. } => {
                    let (head, tail) = self.timer(*timer);
                    self.enclosed(out, &head, *input, tail);
                }
                Statement::Case { of, arms } => self.case(out, *of, arms),
                Statement::If(choice) => self.branch(out, &choice.branches, &choice.otherwise),
            }
            out.origin(outer);
        }
    }

    /// What an assignment is about, beside what it comes from.
    fn about(&self, out: &mut Writer, target: VarId, value: FormulaId) {
        if let Some(origins) = self.origins() {
            out.also(origins.written(&self.program().pool, target, value));
        }
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
            if self.program().says(*origin, *told) && length <= out.furthest_remark() {
                column = column.max(length);
            }
        }
        (column_of(column), statements.len())
    }

    fn assign(&self, out: &mut Writer, target: VarId, value: FormulaId, remark: &str, column: usize) {
        let length = self.length(out.indent(), target, value);
        if length > out.width() {
            out.comment(remark);
            out.line(&format!("{} =", self.target(target)));
            out.enter();
            self.lines(out, target, value);
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
        self.flat(out, target, value);
        out.text(";");
        if behind {
            out.trailing_comment(length, column, remark);
        }
        out.end();
    }

    /// `head condition tail`, the condition on lines of its own where it is long.
    fn enclosed(&self, out: &mut Writer, head: &str, condition: FormulaId, tail: &str) {
        let around = out.indent() + head.len() + tail.len();
        if around.saturating_add(self.width_of_condition(condition)) <= out.width() {
            out.start();
            out.text(head);
            self.flat_condition(out, condition);
            out.text(tail);
            return out.end();
        }
        out.open(head.trim_end());
        self.lines_of_condition(out, condition);
        out.leave();
        out.line(tail);
    }

    /// An arm a value, with what the value stands for beside it; a single arm is an `if`.
    fn case(&self, out: &mut Writer, of: VarId, arms: &[Arm]) {
        let single = arms.len() == 1;
        if !single {
            out.open(&format!("switch ({}) {{", self.read(of)));
        }
        for arm in arms {
            let outer = out.inner_origin(arm.origin);
            let remark = self.program().remark(arm.origin, arm.told);
            let remark = remark.map(|text| self.comment(&text)).unwrap_or_default();
            let value = self.label(of, arm.value);
            let head = if single {
                format!("if ({} {} {value}) {{", self.read(of), Self::EQUAL)
            } else {
                format!("case {value}:")
            };
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
                leave_arm(out);
            }
            out.origin(outer);
        }
        if !single {
            if Self::HAS_DEFAULT {
                out.open("default:");
                leave_arm(out);
            }
            out.close("}");
        }
    }

    fn branch(&self, out: &mut Writer, branches: &[(FormulaId, Vec<Statement>)], otherwise: &[Statement]) {
        let words = Words { first: "if (", next: "} else if (", otherwise: "} else {", end: "}" };
        let head = |out: &mut Writer, word: &str, condition| self.enclosed(out, word, condition, ") {");
        write_branches(out, words, (branches, otherwise), head, |out, body| self.block(out, body));
    }
}

/// Behind the last statement of an arm.
fn leave_arm(out: &mut Writer) {
    out.line("break;");
    out.leave();
}
