//! A number that tells programs apart: saved memory belongs to the program that saved it, and to no other.
//!
//! All that decides what a program does is taken in: variables with their types and initial values, timers, steps, states,
//! and every statement with its formulas. What is only said of them is not: comments, headings, and where they come from.

use super::{Choice, Division, Flag, Held, Program, Role, Statement, VarId};
use grafc_formula::{Formula, FormulaId, Value};

/// The form of the memory that a program of this fingerprint saves; a new one where the same program saves otherwise.
const FORM: u64 = 2;

impl Program {
    /// The fingerprint: 64 bits of FNV-1a.
    pub fn fingerprint(&self) -> u64 {
        let mut print =
            Printing { program: self, print: Fingerprint::default(), numbers: vec![0; self.pool.len()], last: 0 };
        print.all();
        print.print.value()
    }
}

/// FNV-1a, fed piece by piece.
#[derive(Clone, Copy, Debug)]
pub struct Fingerprint(u64);

impl Default for Fingerprint {
    fn default() -> Self {
        Fingerprint(0xcbf2_9ce4_8422_2325)
    }
}

impl Fingerprint {
    /// That of all that was added.
    pub fn value(self) -> u64 {
        self.0
    }

    /// Adds a number.
    pub fn number(&mut self, number: u64) {
        self.bytes(&number.to_le_bytes());
    }

    /// Adds a text, told from one that is parted otherwise.
    pub fn text(&mut self, text: &str) {
        self.number(text.len() as u64);
        self.bytes(text.as_bytes());
    }

    fn bytes(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.0 = (self.0 ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }
}

struct Printing<'p> {
    program: &'p Program,
    print: Fingerprint,
    /// The formulas that were met, numbered from 1 on: a number stands for what was said of it. The pool has others too,
    /// which decide nothing.
    numbers: Vec<u64>,
    last: u64,
}

impl Printing<'_> {
    fn all(&mut self) {
        let program = self.program;
        self.add(FORM);
        self.print.text(&program.name);
        self.add(program.variables.len() as u64);
        for variable in &program.variables {
            let (role, flag) = role(variable.role);
            self.list(&[role, flag, variable.ty as u64, u64::from(variable.retain)]);
            self.value(variable.initial());
            self.print.text(&variable.name);
            self.print.text(variable.address.as_deref().unwrap_or_default());
        }
        self.add(program.timers.len() as u64);
        for timer in &program.timers {
            self.print.text(&timer.name);
            self.add(timer.preset.map_or(0, |preset| preset.ms as u64));
            self.optional(timer.preset.and_then(|preset| preset.constant));
        }
        self.add(program.steps.len() as u64);
        for step in &program.steps {
            self.print.text(&step.label);
            match step.held {
                Held::Bit(v) => self.list(&[0, number(v)]),
                Held::State(state, value) => self.list(&[1, state as u64, value as u64]),
            }
            self.formula(step.active);
        }
        self.add(program.states.len() as u64);
        for state in &program.states {
            self.add(number(state.variable));
            self.list(&state.idle.map_or([0, 0], |idle| [1, idle as u64]));
            self.add(state.values.len() as u64);
            state.values.iter().for_each(|(s, value)| self.list(&[s.index() as u64, *value as u64]));
            self.add(state.copies.len() as u64);
            state.copies.iter().for_each(|v| self.add(number(*v)));
        }
        self.optional(program.started);
        program.sections().into_iter().for_each(|section| self.statements(section));
        match program.repeat {
            None => self.add(0),
            Some(repeat) => {
                self.list(&[1, number(repeat.again)]);
                match repeat.limit {
                    None => self.add(0),
                    Some(limit) => self.list(&[1, number(limit.count), limit.bound.into(), number(limit.flag)]),
                }
            }
        }
    }

    fn add(&mut self, number: u64) {
        self.print.number(number);
    }

    fn list(&mut self, numbers: &[u64]) {
        numbers.iter().for_each(|number| self.add(*number));
    }

    fn optional(&mut self, variable: Option<VarId>) {
        self.add(variable.map_or(0, |v| number(v) + 1));
    }

    fn value(&mut self, value: Value) {
        self.list(&match value {
            Value::Bool(truth) => [0, u64::from(truth)],
            Value::Int(n) => [1, n as u64],
            Value::Real(x) => [2, x.to_bits()],
            Value::Time(ms) => [3, ms as u64],
        });
    }

    /// Statements nest no deeper than lowering nests them.
    fn statements(&mut self, statements: &[Statement]) {
        let doing = statements.iter().filter(|statement| !matches!(statement, Statement::Heading(_)));
        self.add(doing.count() as u64);
        for statement in statements {
            match statement {
                Statement::Heading(_) => {}
                Statement::Assign { target, value, .. } => {
                    self.list(&[0, number(*target)]);
                    self.formula(*value);
                }
                Statement::Divide(Division { target, modulo, dividend, divisor, flag, origin: _ }) => {
                    self.list(&[1, number(*target), u64::from(*modulo), number(*flag)]);
                    self.formula(*dividend);
                    self.formula(*divisor);
                }
                Statement::CallTimer { timer, input, .. } => {
                    self.list(&[2, timer.index() as u64]);
                    self.formula(*input);
                }
                Statement::Case { of, arms } => {
                    self.list(&[3, number(*of), arms.len() as u64]);
                    for arm in arms {
                        self.add(arm.value as u64);
                        self.statements(&arm.body);
                    }
                }
                Statement::If(choice) => {
                    let Choice { branches, otherwise } = &**choice;
                    self.list(&[4, branches.len() as u64]);
                    for (when, body) in branches {
                        self.formula(*when);
                        self.statements(body);
                    }
                    self.statements(otherwise);
                }
            }
        }
    }

    /// A formula by its number, after those below it that are new; a walk with a stack of our own.
    fn formula(&mut self, root: FormulaId) {
        let pool = &self.program.pool;
        let mut open = vec![(root, false)];
        while let Some((id, ready)) = open.pop() {
            if self.numbers[id.index()] > 0 {
                continue;
            }
            if !ready {
                open.push((id, true));
                open.extend(pool.operands(id).map(|operand| (operand, false)));
                continue;
            }
            self.last += 1;
            self.numbers[id.index()] = self.last;
            self.add(pool.ty(id) as u64);
            match pool.get(id) {
                Formula::Constant(value) => {
                    self.add(0);
                    self.value(*value);
                }
                Formula::Variable(v) => self.list(&[1, number(*v)]),
                Formula::TimerDone(timer) => self.list(&[2, timer.index() as u64]),
                Formula::TimerElapsed(timer) => self.list(&[3, timer.index() as u64]),
                Formula::Not(_) => self.add(4),
                Formula::And(list) => self.list(&[5, pool.list(*list).len() as u64]),
                Formula::Or(list) => self.list(&[6, pool.list(*list).len() as u64]),
                Formula::Xor(..) => self.add(7),
                Formula::Compare(op, ..) => self.list(&[8, *op as u64]),
                Formula::Arithmetic(op, ..) => self.list(&[9, *op as u64]),
                Formula::Negate(_) => self.add(10),
                Formula::Widen(_) => self.add(11),
            }
            for operand in pool.operands(id) {
                self.add(self.numbers[operand.index()]);
            }
        }
        self.add(self.numbers[root.index()]);
    }
}

fn number(v: VarId) -> u64 {
    v.index() as u64
}

/// A role, and the flag if it is one.
fn role(role: Role) -> (u64, u64) {
    match role {
        Role::Input => (0, 0),
        Role::Output => (1, 0),
        Role::Internal => (2, 0),
        Role::Constant => (3, 0),
        Role::Step => (4, 0),
        Role::State => (5, 0),
        Role::Flag(Flag::Livelock) => (6, 0),
        Role::Flag(Flag::AllocConflict) => (6, 1),
        Role::Flag(Flag::ForceConflict) => (6, 2),
        Role::Flag(Flag::Div0) => (6, 3),
        Role::Memory => (7, 0),
        Role::Temporary => (8, 0),
        Role::Observed => (9, 0),
    }
}
