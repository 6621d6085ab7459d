//! The statements of a function.

use super::RustStatements;
use crate::branches::{Words, write_branches};
use crate::comment::clean;
use crate::rust::expressions::{SMALL, WIDTH};
use crate::rust::literals::type_name;
use crate::writer::Writer;
use ecow::{EcoString, eco_format};
use grafc_formula::{Arithmetic, Formula, FormulaId, Type};
use grafc_logic::scan::{Arm, Division, Statement, TimerId, Told, VarId, is_empty};

impl RustStatements<'_> {
    /// A block of statements, in a block of the text.
    fn statements(&self, out: &mut Writer, statements: &[Statement]) {
        let inside = self.block();
        for (place, statement) in statements.iter().enumerate() {
            self.declare(out, inside, place);
            self.statement(out, inside, place, statement);
        }
    }

    pub(super) fn statement(&self, out: &mut Writer, block: usize, place: usize, statement: &Statement) {
        let outer = out.inner_origin(statement.origin());
        match statement {
            Statement::Heading(heading) => {
                out.blank();
                out.comment(&clean(&self.program.heading(*heading)));
            }
            Statement::Assign { target, value, origin, told } => {
                self.about(out, *target, *value);
                // What a step is for is said where it is declared, and states are spelt by their steps.
                let told = if matches!(told, Told::Comment | Told::Steps) { Told::Nothing } else { *told };
                out.comment(&self.program.remark(*origin, told).map(|text| clean(&text)).unwrap_or_default());
                let declares = self.locals.with(block, place, *target);
                self.assign(out, declares, *target, *value);
            }
            Statement::Divide(division) => {
                self.about(out, division.target, division.dividend);
                self.divide(out, self.locals.with(block, place, division.target), division);
            }
            Statement::CallTimer { timer, input, .. } => self.call_timer(out, *timer, *input),
            Statement::Case { of, arms } => {
                let inside = |out: &mut Writer, place: usize| self.statements(out, &arms[place].body);
                self.arms(out, *of, &arms.iter().collect::<Vec<_>>(), inside);
            }
            Statement::If(choice) => self.branch(out, &choice.branches, &choice.otherwise),
        }
        out.origin(outer);
    }

    /// What an assignment is about, beside what it comes from.
    fn about(&self, out: &mut Writer, target: VarId, value: FormulaId) {
        if let Some(origins) = &self.places.origins {
            out.also(origins.written(&self.program.pool, target, value));
        }
    }

    /// The left side of an assignment, with its `let`.
    fn target(&self, declares: Option<bool>, target: VarId, typed: bool) -> EcoString {
        let name = self.places.read(target);
        let Some(written_again) = declares else { return name };
        let name = if self.locals.is_unread(target) { "_" } else { name.as_str() };
        let mutable = if written_again { "mut " } else { "" };
        let ty = self.program.variables[target].ty;
        let annotation = if typed { format!(": {}", type_name(ty)) } else { String::new() };
        eco_format!("let {mutable}{name}{annotation}")
    }

    fn assign(&self, out: &mut Writer, declares: Option<bool>, target: VarId, value: FormulaId) {
        let pool = &self.program.pool;
        if let Some(step) = self.places.packed(target) {
            let step = &self.names.steps[step];
            let width = step.len() + 2 + self.expressions.width(value);
            if width <= SMALL && out.indent() + "self.set();".len() + width <= WIDTH {
                out.start();
                out.text(&format!("self.set({step}, "));
                self.expressions.flat(out, value);
                out.text(");");
                out.end();
            } else {
                self.expressions.statement(out, "let active", value);
                out.line(&format!("self.set({step}, active);"));
            }
            return;
        }
        if let Some(constant) = pool.as_constant(value) {
            let ty = pool.ty(value);
            let typed = self.places.state(target).is_none() && ty != Type::Bool;
            let value = self.places.value(target, constant, ty);
            return out.line(&format!("{} = {value};", self.target(declares, target, typed)));
        }
        // `a = a + b` has a form of its own.
        if let Formula::Arithmetic(op, [a, b]) = pool.get(value)
            && declares.is_none()
            && *pool.get(*a) == Formula::Variable(target)
            && let Some(sign) = compound(*op, pool.ty(value))
        {
            out.start();
            out.text(&format!("{} {sign} ", self.places.read(target)));
            self.expressions.flat(out, *b);
            out.text(";");
            return out.end();
        }
        self.expressions.statement(out, &self.target(declares, target, false), value);
    }

    /// A division; the functions of the run-time support have the guards.
    fn divide(&self, out: &mut Writer, declares: Option<bool>, division: &Division) {
        let Division { target, modulo, dividend, divisor, flag, .. } = *division;
        let pool = &self.program.pool;
        let ty = self.program.variables[target].ty;
        let function = if modulo { "remainder" } else { "divide" };
        let operand = |id: FormulaId| {
            let mut text = out.apart();
            self.expressions.flat(&mut text, id);
            let text = text.finish();
            match pool.as_constant(id) {
                None if ty == Type::Time && pool.ty(id) != Type::Time => format!("i64::from({text})"),
                _ => text,
            }
        };
        let flag = format!("&mut {}", self.places.read(flag));
        let arguments = [operand(dividend), operand(divisor), flag];
        let head = format!("{} = {function}(", self.target(declares, target, true));
        let flat = arguments.join(", ");
        if flat.len() <= SMALL && out.indent() + head.len() + flat.len() + 2 <= WIDTH {
            return out.line(&format!("{head}{flat});"));
        }
        out.open(&head);
        for argument in arguments {
            out.line(&format!("{argument},"));
        }
        out.close(");");
    }

    fn call_timer(&self, out: &mut Writer, timer: TimerId, input: FormulaId) {
        let timer = self.places.timer(timer);
        let width = self.expressions.width(input) + ", now".len();
        let chain = timer.len() + ".call()".len() + width;
        if chain <= SMALL.max(timer.len() + 1) && out.indent() + chain < WIDTH {
            out.start();
            out.text(&format!("{timer}.call("));
            self.expressions.flat(out, input);
            out.text(", now);");
            return out.end();
        }
        self.expressions.statement(out, "let input", input);
        out.line(&format!("{timer}.call(input, now);"));
    }

    /// An arm a value, under what the value stands for; a single arm is an `if`.
    pub(super) fn arms(&self, out: &mut Writer, of: VarId, arms: &[&Arm], inside: impl Fn(&mut Writer, usize)) {
        let remark = |arm: &Arm| self.program.remark(arm.origin, arm.told).map(|text| clean(&text)).unwrap_or_default();
        let label = |arm: &Arm| self.places.variant(of, arm.value).unwrap_or_else(|| eco_format!("{}", arm.value));
        if let [arm] = arms {
            let outer = out.inner_origin(arm.origin);
            out.comment(&remark(arm));
            out.open(&format!("if {} == {} {{", self.places.read(of), label(arm)));
            inside(out, 0);
            out.close("}");
            out.origin(outer);
            return;
        }
        out.open(&format!("match {} {{", self.places.read(of)));
        for (place, arm) in arms.iter().enumerate() {
            let outer = out.inner_origin(arm.origin);
            out.comment(&remark(arm));
            out.open(&format!("{} => {{", label(arm)));
            inside(out, place);
            out.close("}");
            out.origin(outer);
        }
        if self.places.state(of).is_none_or(|state| state.variants.len() > arms.len()) {
            out.line("_ => {}");
        }
        out.close("}");
    }

    fn branch(&self, out: &mut Writer, branches: &[(FormulaId, Vec<Statement>)], otherwise: &[Statement]) {
        let words = Words { first: "if", next: "} else if", otherwise: "} else {", end: "}" };
        let head = |out: &mut Writer, word: &str, condition| self.expressions.condition(out, word, condition);
        write_branches(out, words, (branches, otherwise), head, |out, body| self.statements(out, body));
        if is_empty(otherwise) {
            // It is counted all the same.
            self.block();
        }
    }
}

/// The sign of `a = a op b` where whole numbers need no method to wrap around.
fn compound(op: Arithmetic, ty: Type) -> Option<&'static str> {
    let real = matches!(ty, Type::Real | Type::Lreal);
    match op {
        Arithmetic::Add if real => Some("+="),
        Arithmetic::Subtract if real => Some("-="),
        Arithmetic::Multiply if real => Some("*="),
        Arithmetic::Divide => Some("/="),
        Arithmetic::Modulo => Some("%="),
        Arithmetic::Add | Arithmetic::Subtract | Arithmetic::Multiply => None,
    }
}
