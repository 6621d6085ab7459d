//! Runs a scan program as it stands: the meaning that every backend has to keep.
//!
//! Shares nothing with the reference simulator. Formulas are walked with a stack of our own, each shared part once, so
//! that no evaluation recurses and a scan costs what the program holds.

use crate::scan::{Choice, Division, Flag, Program, Role, Statement, TimerId, VarId, Variable};
use grafc_formula::number::{arithmetic, compare, divide, negate};
use grafc_formula::{Formula, FormulaId, Type, Value};
use grafc_model::chart::StepId;
use grafc_model::reaction::{Flags, Response, Stimulus};
use index_vec::IndexVec;

/// A program that is being run.
pub struct Evaluator<'p> {
    program: &'p Program,
    values: IndexVec<VarId, Value>,
    timers: IndexVec<TimerId, Timer>,
    inputs: Vec<VarId>,
    outputs: Vec<VarId>,
    now: i64,
    /// The values of formulas, valid while their mark is the current one.
    memo: Vec<(u64, Value)>,
    mark: u64,
    stack: Vec<(FormulaId, bool)>,
}

/// The state of a timer.
#[derive(Clone, Copy, Default)]
struct Timer {
    since: Option<i64>,
    at: i64,
}

impl<'p> Evaluator<'p> {
    /// A program before its first call.
    pub fn new(program: &'p Program) -> Self {
        let of = |role: Role| program.of_role(role).map(|(id, _)| id).collect();
        Evaluator {
            program,
            values: program.variables.iter().map(|v| v.initial()).collect(),
            timers: program.timers.iter().map(|_| Timer::default()).collect(),
            inputs: of(Role::Input),
            outputs: of(Role::Output),
            now: 0,
            memo: vec![(0, Value::Bool(false)); program.pool.len()],
            mark: 0,
            stack: Vec::new(),
        }
    }

    /// One call.
    pub fn react(&mut self, stimulus: &Stimulus) -> Response {
        self.react_observed(stimulus, |_| ())
    }

    /// One call; `observe` sees the state that the first micro-step starts from, and that after each micro-step.
    pub fn react_observed(&mut self, stimulus: &Stimulus, mut observe: impl FnMut(&mut Self)) -> Response {
        let program = self.program;
        self.now = stimulus.t_ms;
        if stimulus.restart {
            self.restart();
        }
        for index in 0..self.inputs.len() {
            self.values[self.inputs[index]] = stimulus.inputs[index];
        }
        self.run(&program.first);
        self.run(&program.before);
        observe(self);
        match program.repeat {
            None => {
                self.run(&program.micro_step);
                observe(self);
            }
            Some(repeat) => {
                let mut again = true;
                let mut count = 0;
                while again && repeat.limit.is_none_or(|limit| count < limit.bound) {
                    count += 1;
                    self.run(&program.micro_step);
                    observe(self);
                    again = self.values[repeat.again] == Value::Bool(true);
                }
                if let Some(limit) = repeat.limit.filter(|_| again) {
                    self.values[limit.flag] = Value::Bool(true);
                }
            }
        }
        self.run(&program.after);
        Response {
            outputs: self.outputs.iter().map(|v| self.values[*v]).collect(),
            situation: self.situation(),
            flags: self.flags(),
        }
    }

    /// From here on somebody looks at what the program shows.
    pub fn look_on(&mut self) {
        if let Some(wanted) = self.program.observing.as_ref().and_then(|observing| observing.wanted) {
            self.values[wanted] = Value::Bool(true);
        }
    }

    /// What a restart of the controller leaves: the variables that are retained.
    fn restart(&mut self) {
        let goes = |variable: &Variable| !variable.retain && variable.role != Role::Observed;
        for (id, variable) in self.program.variables.iter_enumerated().filter(|(_, variable)| goes(variable)) {
            self.values[id] = variable.initial();
        }
        self.timers.iter_mut().for_each(|timer| *timer = Timer::default());
    }

    /// The active steps, in order of declaration.
    pub fn situation(&mut self) -> Vec<StepId> {
        let program = self.program;
        program.steps.iter_enumerated().filter(|(_, step)| self.truth(step.active)).map(|(s, _)| s).collect()
    }

    /// The values of variables that stored actions write, and of all others, in order of declaration.
    pub fn value_of(&self, variable: VarId) -> Value {
        self.values[variable]
    }

    /// The flags raised so far.
    pub fn flags(&self) -> Flags {
        let mut flags = Flags::default();
        for (id, variable) in self.program.variables.iter_enumerated() {
            let raised = self.values[id] == Value::Bool(true);
            match variable.role {
                Role::Flag(Flag::Livelock) => flags.livelock = raised,
                Role::Flag(Flag::AllocConflict) => flags.alloc_conflict = raised,
                Role::Flag(Flag::ForceConflict) => flags.force_conflict = raised,
                Role::Flag(Flag::Div0) => flags.div0 = raised,
                Role::Input
                | Role::Output
                | Role::Internal
                | Role::Constant
                | Role::Step
                | Role::State
                | Role::Memory
                | Role::Temporary
                | Role::Observed => {}
            }
        }
        flags
    }

    /// Statements nest no deeper than lowering nests them, whatever the chart.
    fn run(&mut self, statements: &[Statement]) {
        for statement in statements {
            match statement {
                Statement::Heading(_) => {}
                Statement::Assign { target, value, .. } => {
                    let value = self.value(*value);
                    self.values[*target] = value;
                }
                Statement::Divide(Division { target, modulo, dividend, divisor, flag, .. }) => {
                    let (a, b) = (self.value(*dividend), self.value(*divisor));
                    let ty = self.program.variables[*target].ty;
                    let quotient = divide(ty, *modulo, a, b);
                    if quotient.is_none() {
                        self.values[*flag] = Value::Bool(true);
                    }
                    self.values[*target] = quotient.unwrap_or_else(|| grafc_formula::number::zero(ty));
                }
                Statement::CallTimer { timer, input, .. } => {
                    let input = self.truth(*input);
                    let state = &mut self.timers[*timer];
                    state.since = if input { state.since.or(Some(self.now)) } else { None };
                    state.at = self.now;
                }
                Statement::Case { of, arms } => {
                    let at = self.values[*of];
                    if let Some(arm) = arms.iter().find(|arm| Value::Int(arm.value) == at) {
                        self.run(&arm.body);
                    }
                }
                Statement::If(choice) => {
                    let Choice { branches, otherwise } = &**choice;
                    let taken = branches.iter().find(|(when, _)| self.truth(*when));
                    match taken {
                        Some((_, body)) => self.run(body),
                        None => self.run(otherwise),
                    }
                }
            }
        }
    }

    fn truth(&mut self, formula: FormulaId) -> bool {
        self.value(formula) == Value::Bool(true)
    }

    fn value(&mut self, root: FormulaId) -> Value {
        self.mark += 1;
        self.stack.push((root, false));
        while let Some((id, ready)) = self.stack.pop() {
            if self.memo[id.index()].0 == self.mark {
                continue;
            }
            if ready {
                self.memo[id.index()] = (self.mark, self.apply(id));
            } else {
                self.stack.push((id, true));
                self.stack.extend(self.program.pool.operands(id).map(|o| (o, false)));
            }
        }
        self.memo[root.index()].1
    }

    /// The value of a formula whose operands have theirs.
    fn apply(&self, id: FormulaId) -> Value {
        let pool = &self.program.pool;
        let known = |f: &FormulaId| self.memo[f.index()].1;
        let holds = |f: &FormulaId| known(f) == Value::Bool(true);
        match pool.get(id) {
            Formula::Constant(value) => *value,
            Formula::Variable(v) => self.values[*v],
            Formula::TimerDone(t) => {
                let preset = self.program.timers[*t].preset.map_or(i64::MAX, |p| p.ms);
                Value::Bool(self.timers[*t].since.is_some_and(|since| self.timers[*t].at - since >= preset))
            }
            Formula::TimerElapsed(t) => {
                Value::Time(self.timers[*t].since.map_or(0, |since| self.timers[*t].at - since))
            }
            Formula::Not(a) => Value::Bool(!holds(a)),
            Formula::And(list) => Value::Bool(pool.list(*list).iter().all(holds)),
            Formula::Or(list) => Value::Bool(pool.list(*list).iter().any(holds)),
            Formula::Xor([a, b]) => Value::Bool(holds(a) != holds(b)),
            Formula::Compare(op, [a, b]) => Value::Bool(compare(*op, known(a), known(b))),
            Formula::Arithmetic(op, [a, b]) => arithmetic(*op, pool.ty(id), known(a), known(b)),
            Formula::Negate(a) => negate(pool.ty(id), known(a)),
            Formula::Widen(a) => match (known(a), pool.ty(id)) {
                (Value::Int(n), Type::Real | Type::Lreal) => Value::Real(n as f64),
                (value, _) => value,
            },
        }
    }
}
