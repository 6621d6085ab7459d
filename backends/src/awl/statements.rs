//! The instructions of one call.

use super::code::Code;
use super::conditions::Conditions;
use super::numbers::{Numbers, literal};
use super::{AwlNames, Mnemonics, restart, timers};
use grafc_formula::{FormulaId, Type, Value};
use grafc_logic::scan::{Arm, Origin, Origins, Program, Repeat, Statement, VarId, is_empty, origin_of};

/// So many arms of a choice are tried one after the other; of more, a jump passes over half.
const FEW_ARMS: usize = 8;

/// The instructions of one call.
pub(super) fn body(program: &Program, names: &mut AwlNames, mnemonics: Mnemonics, traced: bool) -> Code {
    let (conditions, numbers) = (Conditions::new(program), Numbers::new(program));
    let origins = traced.then(|| program.origins());
    let code = Code::new(mnemonics, traced);
    let mut body = AwlStatements { program, names, conditions, numbers, code, depth: 0, origins };
    if let Some(clock) = &body.names.clock {
        clock.update(&mut body.code);
    }
    restart::write(&mut body.code, program, body.names);
    body.code.network("one call");
    body.block(&program.first, None);
    body.block(&program.before, None);
    match program.repeat {
        Some(repeat) => body.repeat(repeat),
        None => body.block(&program.micro_step, None),
    }
    body.block(&program.after, None);
    body.code.instruct_label();
    body.code.instruction("BE", "");
    body.code
}

/// The statements of a call, and what it takes to spell them.
struct AwlStatements<'p, 'n> {
    program: &'p Program,
    names: &'n mut AwlNames,
    conditions: Conditions<'p>,
    numbers: Numbers<'p>,
    code: Code,
    /// How many statements stand around.
    depth: usize,
    /// Where variables come from, if somebody asks.
    origins: Option<Origins>,
}

impl AwlStatements<'_, '_> {
    /// What an assignment is about, beside what it comes from.
    fn about(&mut self, target: VarId, value: FormulaId) {
        if let Some(origins) = &self.origins {
            self.code.out.also(origins.written(&self.program.pool, target, value));
        }
    }

    fn condition(&mut self, id: FormulaId) {
        match self.program.pool.as_truth(id) {
            Some(truth) => self.code.truth(truth),
            None => self.conditions.load(&mut self.code, self.names, id),
        }
    }

    /// A comparison of a variable, a whole number, with a constant.
    fn compare(&mut self, variable: VarId, operator: &str, value: i64) {
        let ty = self.program.variables[variable].ty;
        self.code.number("L", &self.names.variable(variable));
        self.code.number("L", &literal(Value::Int(value), ty));
        self.code.comparison(&format!("{operator}{}", if ty == Type::Int { "I" } else { "D" }));
    }

    /// The stability loop; where it has a limit, the flag when it was cut off.
    fn repeat(&mut self, repeat: Repeat) {
        self.code.about("micro-step");
        let start = self.code.new_label();
        let again = self.names.variable(repeat.again);
        if let Some(limit) = repeat.limit {
            self.code.number("L", "0");
            self.code.instruction("T", &self.names.variable(limit.count));
        }
        self.code.label(start.clone());
        if let Some(limit) = repeat.limit {
            let (count, ty) = (self.names.variable(limit.count), self.program.variables[limit.count].ty);
            let is_short = matches!(ty, Type::Int | Type::Uint);
            self.code.remark(Some("one micro-step"));
            self.code.number("L", &count);
            self.code.number("L", if is_short { "1" } else { "L#1" });
            self.code.number(if is_short { "+I" } else { "+D" }, "");
            self.code.instruction("T", &count);
        }
        self.block(&self.program.micro_step, None);
        self.code.network("another micro-step, until the situation is stable");
        let Some(limit) = repeat.limit else {
            self.code.bit("A", &again);
            return self.code.jump_if(&start);
        };
        self.compare(limit.count, "<", i64::from(limit.bound));
        self.code.bit("A", &again);
        self.code.jump_if(&start);
        self.code.bit("A", &again);
        self.code.instruction("S", &self.names.variable(limit.flag));
    }

    /// Statements in order. If a label is given, what comes after them is a jump to it or the label itself, so that the
    /// last of them may jump there.
    fn block(&mut self, statements: &[Statement], after: Option<&str>) {
        for (place, statement) in statements.iter().enumerate() {
            let after = after.filter(|_| place + 1 == statements.len());
            let outer = self.code.out.inner_origin(statement.origin());
            match statement {
                Statement::Heading(_) => {}
                Statement::Assign { .. }
                | Statement::CallTimer { .. }
                | Statement::Divide(_)
                | Statement::Case { .. }
                | Statement::If(_) => self.code.about(&self.program.word(statement)),
            }
            match statement {
                Statement::Heading(heading) if self.depth == 0 => self.code.network(&self.program.heading(*heading)),
                Statement::Heading(heading) => self.code.heading(&self.program.heading(*heading)),
                Statement::Assign { target, value, origin, told } => {
                    self.about(*target, *value);
                    self.code.remark(self.program.remark(*origin, *told).as_deref());
                    self.assign(*target, *value);
                }
                Statement::Divide(division) => {
                    self.about(division.target, division.dividend);
                    self.numbers.divide(&mut self.code, self.names, division);
                }
                Statement::CallTimer { timer, input, .. } => {
                    let timer_of = &self.program.timers[*timer];
                    self.code.remark(timer_of.comment.as_deref());
                    self.condition(*input);
                    timers::call(&mut self.code, self.names, *timer, timer_of.given_preset());
                }
                Statement::Case { of, arms } => self.case(*of, arms, after),
                Statement::If(choice) => self.branch(&choice.branches, &choice.otherwise, after),
            }
            self.code.out.origin(outer);
        }
    }

    fn inner(&mut self, statements: &[Statement], after: &str) {
        self.depth += 1;
        self.block(statements, Some(after));
        self.depth -= 1;
    }

    fn assign(&mut self, target: VarId, value: FormulaId) {
        if self.program.pool.ty(value) != Type::Bool {
            return self.numbers.assign(&mut self.code, self.names, target, value);
        }
        let operand = self.names.variable(target);
        match (self.program.pool.as_truth(value), self.code.rlo) {
            (Some(truth), Some(true)) => self.code.instruction(if truth { "S" } else { "R" }, &operand),
            (Some(truth), _) => {
                self.code.truth(truth);
                self.code.assign(&operand);
            }
            (None, _) => {
                self.condition(value);
                self.code.assign(&operand);
            }
        }
    }

    /// An arm a value, with what the value stands for beside it.
    fn case(&mut self, of: VarId, arms: &[Arm], after: Option<&str>) {
        let done = after.map_or_else(|| self.code.new_label(), str::to_owned);
        let mut arms: Vec<&Arm> = arms.iter().collect();
        if arms.len() > FEW_ARMS {
            arms.sort_by_key(|arm| arm.value);
        }
        self.arms(of, &arms, &done, true);
        if after.is_none() {
            self.code.label(done);
        }
    }

    /// Tries arms; recursion is as deep as they can be halved. After the last of all there is no need to jump.
    fn arms(&mut self, of: VarId, arms: &[&Arm], done: &str, last: bool) {
        if arms.len() > FEW_ARMS {
            let (low, high) = arms.split_at(arms.len() / 2);
            let upper = self.code.new_label();
            self.compare(of, ">=", high[0].value);
            self.code.jump_if(&upper);
            self.arms(of, low, done, false);
            self.code.label(upper);
            return self.arms(of, high, done, last);
        }
        for (place, arm) in arms.iter().enumerate() {
            let is_last = place + 1 == arms.len();
            if let Origin::Step(s) = arm.origin {
                self.code.about(self.program.label(s));
            }
            let next = if is_last { done.to_owned() } else { self.code.new_label() };
            let outer = self.code.out.inner_origin(arm.origin);
            self.code.remark(self.program.remark(arm.origin, arm.told).as_deref());
            self.compare(of, "==", arm.value);
            self.code.jump_unless(&next);
            self.inner(&arm.body, done);
            if !(is_last && last) {
                self.code.jump(done);
            }
            if !is_last {
                self.code.label(next);
            }
            self.code.out.origin(outer);
        }
    }

    /// The first branch whose condition is true.
    fn branch(&mut self, branches: &[(FormulaId, Vec<Statement>)], otherwise: &[Statement], after: Option<&str>) {
        if branches.is_empty() {
            return self.block(otherwise, after);
        }
        if let [(condition, body)] = branches
            && is_empty(otherwise)
            && let Some(bits) = self.bits(body)
        {
            let outer = self.code.out.inner_origin(origin_of(body));
            self.condition(*condition);
            self.code.rlo = None;
            for (statement, target, value, truth) in bits {
                self.code.out.origin(statement.origin().or(outer));
                self.about(target, value);
                self.code.remark(self.remark(statement).as_deref());
                self.code.instruction(if truth { "S" } else { "R" }, &self.names.variable(target));
            }
            self.code.out.origin(outer);
            return;
        }
        let done = after.map_or_else(|| self.code.new_label(), str::to_owned);
        for (place, (condition, body)) in branches.iter().enumerate() {
            let outer = self.code.out.inner_origin(origin_of(body));
            let is_last = place + 1 == branches.len() && is_empty(otherwise);
            if let Some(first) = body.iter().find(|first| !matches!(first, Statement::Heading(_))) {
                self.code.about(&self.program.word(first));
            }
            let next = if is_last { done.clone() } else { self.code.new_label() };
            self.condition(*condition);
            self.code.jump_unless(&next);
            self.inner(body, &done);
            if !is_last {
                self.code.jump(&done);
                self.code.label(next);
            }
            self.code.out.origin(outer);
        }
        self.inner(otherwise, &done);
        if after.is_none() {
            self.code.label(done);
        }
    }

    /// What a body sets and resets, if it does nothing else: then there is no need to jump.
    fn bits<'s>(&self, body: &'s [Statement]) -> Option<Vec<(&'s Statement, VarId, FormulaId, bool)>> {
        let bit = |statement: &'s Statement| match statement {
            Statement::Assign { target, value, .. } => {
                Some((statement, *target, *value, self.program.pool.as_truth(*value)?))
            }
            Statement::Heading(_)
            | Statement::Divide(_)
            | Statement::CallTimer { .. }
            | Statement::Case { .. }
            | Statement::If(_) => None,
        };
        body.iter().map(bit).collect()
    }

    /// What is said beside an assignment.
    fn remark(&self, statement: &Statement) -> Option<String> {
        match statement {
            Statement::Assign { origin, told, .. } => self.program.remark(*origin, *told),
            Statement::Heading(_)
            | Statement::Divide(_)
            | Statement::CallTimer { .. }
            | Statement::Case { .. }
            | Statement::If(_) => None,
        }
    }
}
