//! The body of the function block.
//!
//! What is known of the accumulator saves loads: after a condition was asked, it is that condition's value; a constant
//! stays in it while it is stored.

use super::code::{Code, Known};
use super::expressions::Expressions;
use crate::comment::clean;
use crate::iec::literals::{operand, zero};
use crate::iec::names::Names;
use crate::writer::{self, Writer};
use ecow::EcoString;
use grafc_formula::{FormulaId, Value};
use grafc_logic::scan::{
    Arm, ByMinusOne, Division, Guard, Limit, Origin, Origins, Program, Repeat, Statement, TimerId, VarId, is_empty,
    origin_of, origin_of_end,
};

/// So many arms of a choice are tried one after the other; of more, a jump passes over half.
const FEW_ARMS: usize = 8;

/// The instructions of one call.
pub(super) fn body(program: &Program, names: &mut Names, traced: bool) -> Code {
    let code = Code::new(Writer::new(&writer::IEC).traced(traced));
    let (what, origins) = (EcoString::new(), traced.then(|| program.origins()));
    let mut body = IlStatements { program, names, expressions: Expressions::new(program), code, what, origins };
    body.block(&program.first, None);
    body.block(&program.before, None);
    match program.repeat {
        Some(repeat) => body.repeat(repeat),
        None => body.block(&program.micro_step, None),
    }
    body.block(&program.after, None);
    if let Some(variable) = program.idle_variable() {
        body.code.remark(Some("nothing ever changes"));
        body.code.operation("LD", &body.names.variables[variable]);
        body.store("ST", variable);
    }
    body.code
}

struct IlStatements<'p, 'n> {
    program: &'p Program,
    names: &'n mut Names,
    expressions: Expressions<'p>,
    code: Code,
    /// What is written now: labels within it are called after that, and not by how many came before.
    what: EcoString,
    /// Where variables come from, if somebody asks.
    origins: Option<Origins>,
}

impl IlStatements<'_, '_> {
    /// What an assignment is about, beside what it comes from.
    fn about(&mut self, target: VarId, value: FormulaId) {
        if let Some(origins) = &self.origins {
            self.code.out.also(origins.written(&self.program.pool, target, value));
        }
    }

    fn name(&self, id: VarId) -> EcoString {
        self.names.variables[id].clone()
    }

    fn load(&mut self, id: FormulaId) {
        self.expressions.load(&mut self.code, self.names, id);
    }

    fn store(&mut self, operator: &str, target: VarId) {
        self.code.instruction(operator, &self.names.variables[target]);
    }

    /// A label that nothing else is called like.
    fn new_label(&mut self, wanted: &str) -> EcoString {
        let wanted = if self.what.is_empty() { wanted.to_owned() } else { format!("{wanted}_{}", self.what) };
        self.names.namer.name(&wanted)
    }

    /// The stability loop; where it has a limit, the flag when it was cut off.
    fn repeat(&mut self, repeat: Repeat) {
        self.what.clear();
        let start = self.new_label("micro_step");
        let again = self.name(repeat.again);
        let count = repeat.limit.map(|limit| self.name(limit.count));
        if let Some(count) = &count {
            self.code.operation("LD", "0");
            self.code.instruction("ST", count);
        }
        self.code.out.blank();
        self.code.label(&start);
        if let Some(count) = &count {
            self.code.operation("LD", count);
            self.code.operation("ADD", "1");
            self.code.instruction("ST", count);
        }
        self.block(&self.program.micro_step, None);
        let Some(Limit { count, bound, flag }) = repeat.limit else {
            self.code.operation("LD", &again);
            self.code.jump_if(&start);
            return self.code.out.blank();
        };
        self.code.operation("LD", &self.name(count));
        self.code.operation("LT", &bound.to_string());
        self.code.operation("AND", &again);
        self.code.jump_if(&start);
        self.code.operation("LD", &again);
        self.code.operation("OR", &self.names.variables[flag]);
        self.store("ST", flag);
        self.code.out.blank();
    }

    /// Statements in order. If a label is given, what comes after them is a jump to it or the label itself, so that the
    /// last of them may jump there.
    fn block(&mut self, statements: &[Statement], after: Option<&str>) {
        for (place, statement) in statements.iter().enumerate() {
            let after = after.filter(|_| place + 1 == statements.len());
            let outer = self.code.out.inner_origin(statement.origin());
            match statement {
                Statement::Heading(_) | Statement::Assign { .. } | Statement::CallTimer { .. } => {}
                Statement::Divide(_) | Statement::Case { .. } | Statement::If(_) => {
                    self.what = self.program.word(statement);
                }
            }
            match statement {
                Statement::Heading(heading) => self.code.heading(&clean(&self.program.heading(*heading))),
                Statement::Assign { target, value, origin, told } => {
                    self.about(*target, *value);
                    self.code.remark(self.program.remark(*origin, *told).as_deref());
                    self.assign(*target, *value);
                }
                Statement::Divide(division) => {
                    self.about(division.target, division.dividend);
                    self.divide(division);
                }
                Statement::CallTimer { timer, input, .. } => self.call_timer(*timer, *input),
                Statement::Case { of, arms } => self.case(*of, arms, after),
                Statement::If(choice) => self.branch(&choice.branches, &choice.otherwise, after),
            }
            self.code.out.origin(outer);
        }
    }

    fn assign(&mut self, target: VarId, value: FormulaId) {
        let constant = match self.program.pool.as_constant(value) {
            None => {
                self.load(value);
                return self.store("ST", target);
            }
            Some(Value::Bool(truth)) => Known::Truth(truth),
            Some(Value::Int(_) | Value::Real(_) | Value::Time(_)) => Known::Constant(value),
        };
        match (self.code.known, constant) {
            (Some(Known::Truth(known)), Known::Truth(truth)) => {
                self.store(if known == truth { "ST" } else { "STN" }, target);
            }
            (known, _) => {
                if known != Some(constant) {
                    self.load(value);
                    self.code.known = Some(constant);
                }
                self.store("ST", target);
            }
        }
    }

    /// A division under the guards that it needs.
    fn divide(&mut self, division: &Division) {
        let Division { target, modulo, dividend: a, divisor: b, flag, .. } = *division;
        let (ty, result) = (self.program.pool.ty(b), self.program.variables[target].ty);
        let guard = self.program.guard(division);
        if guard == Guard::Never {
            self.code.operation("LD", &zero(result));
            self.store("ST", target);
            self.code.operation("LD", "TRUE");
            return self.store("ST", flag);
        }
        let (divide, store) = (self.new_label("divide"), self.new_label("quotient"));
        self.load(b);
        self.code.operation("EQ", &zero(ty));
        self.code.jump_unless(&divide);
        self.store("ST", flag);
        self.code.operation("LD", &zero(result));
        self.code.instruction("JMP", &store);
        self.code.label(&divide);
        if let Some(quotient) = guard.by_minus_one() {
            let divide = self.new_label("divide");
            self.load(b);
            self.code.operation("EQ", &operand(Value::Int(-1), ty));
            self.code.jump_unless(&divide);
            match quotient {
                ByMinusOne::Zero => self.code.operation("LD", "0"),
                // MATIEC computes with constants, and refuses the difference.
                ByMinusOne::Dividend => self.load(a),
                ByMinusOne::Negative => {
                    self.code.operation("LD", "0");
                    self.expressions.apply(&mut self.code, self.names, "SUB", a);
                }
            }
            self.code.instruction("JMP", &store);
            self.code.label(&divide);
        }
        self.load(a);
        self.expressions.apply(&mut self.code, self.names, if modulo { "MOD" } else { "DIV" }, b);
        self.code.label(&store);
        self.store("ST", target);
    }

    /// A timer's inputs are stored one by one.
    fn call_timer(&mut self, timer: TimerId, input: FormulaId) {
        let name = self.names.timers[timer].clone();
        let preset = self.names.preset(self.program.timers[timer].given_preset());
        self.load(input);
        self.code.instruction("ST", &format!("{name}.IN"));
        self.code.operation("LD", &preset);
        self.code.instruction("ST", &format!("{name}.PT"));
        self.code.operation("CAL", &name);
    }

    /// An arm a value, with what the value stands for beside it.
    fn case(&mut self, of: VarId, arms: &[Arm], after: Option<&str>) {
        let done = after.map_or_else(|| self.new_label("done"), EcoString::from);
        let mut arms: Vec<&Arm> = arms.iter().collect();
        if arms.len() > FEW_ARMS {
            arms.sort_by_key(|arm| arm.value);
        }
        self.arms(of, &arms, &done, true);
        if after.is_none() {
            self.code.label(&done);
        }
    }

    /// Tries arms; recursion is as deep as they can be halved. After the last of all there is no need to jump.
    fn arms(&mut self, of: VarId, arms: &[&Arm], done: &str, last: bool) {
        if arms.len() > FEW_ARMS {
            let (low, high) = arms.split_at(arms.len() / 2);
            let upper = self.new_label("upper");
            self.code.operation("LD", &self.names.variables[of]);
            self.code.operation("GE", &high[0].value.to_string());
            self.code.jump_if(&upper);
            self.arms(of, low, done, false);
            self.code.label(&upper);
            return self.arms(of, high, done, last);
        }
        for (place, arm) in arms.iter().enumerate() {
            let is_last = place + 1 == arms.len();
            if let Origin::Step(s) = arm.origin {
                self.what = self.program.label(s).into();
            }
            let next = if is_last { done.into() } else { self.new_label("next") };
            let outer = self.code.out.inner_origin(arm.origin);
            self.code.remark(self.program.remark(arm.origin, arm.told).as_deref());
            self.code.operation("LD", &self.names.variables[of]);
            self.code.operation("EQ", &arm.value.to_string());
            self.code.jump_unless(&next);
            self.block(&arm.body, Some(done));
            if !(is_last && last) {
                self.code.instruction("JMP", done);
            }
            if !is_last {
                self.code.label(&next);
            }
            self.code.out.origin(outer);
        }
    }

    /// The first branch whose condition is true.
    fn branch(&mut self, branches: &[(FormulaId, Vec<Statement>)], otherwise: &[Statement], after: Option<&str>) {
        if branches.is_empty() {
            return self.block(otherwise, after);
        }
        let done = after.map_or_else(|| self.new_label("done"), EcoString::from);
        for (place, (condition, body)) in branches.iter().enumerate() {
            let outer = self.code.out.inner_origin(origin_of(body));
            let is_last = place + 1 == branches.len() && is_empty(otherwise);
            if let Some(first) = body.iter().find(|first| !matches!(first, Statement::Heading(_))) {
                self.what = self.program.word(first);
            }
            let next = if is_last { done.clone() } else { self.new_label("next") };
            self.load(*condition);
            self.code.jump_unless(&next);
            self.block(body, Some(&done));
            if !is_last {
                self.code.instruction("JMP", &done);
                self.code.label(&next);
                self.code.known = Some(Known::Truth(false));
            }
            self.code.out.origin(outer);
        }
        self.block(otherwise, Some(&done));
        if after.is_none() {
            let outer = self.code.out.inner_origin(origin_of_end(branches, otherwise));
            self.code.label(&done);
            self.code.out.origin(outer);
        }
    }
}
