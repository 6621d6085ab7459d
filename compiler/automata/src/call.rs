//! One call of a scan program for all inputs at once: a Boolean variable is the set of inputs with which it is true.

use crate::machine::{Alphabet, Set};
use grafc_formula::{Formula, FormulaId, Type, Value};
use grafc_logic::scan::{Choice, Program, Role, Statement, VarId};
use index_vec::IndexVec;
use rustc_hash::FxHashMap;
use std::fmt;

/// Why a chart is no machine with Boolean inputs.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Beyond {
    /// A variable is a number.
    Number(String),
    /// It waits for time to pass.
    Delay(String),
    /// It has more states than so many.
    States(usize),
    /// Its table has more rows than so many.
    Rows(usize),
}

impl fmt::Display for Beyond {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Beyond::Number(name) => write!(f, "`{name}` is a number, and an automaton has none"),
            Beyond::Delay(name) => write!(f, "the chart measures time (`{name}`), and an automaton does not"),
            Beyond::States(most) => write!(f, "the chart has more than {most} states"),
            Beyond::Rows(most) => write!(f, "the table has more than {most} rows"),
        }
    }
}

/// A program, ready to be called.
pub(crate) struct Caller<'p> {
    program: &'p Program,
    pub(crate) alphabet: Alphabet,
    values: IndexVec<VarId, Set>,
    /// With which inputs each step was active before the first micro-step of the call.
    pub(crate) begun: Vec<Set>,
    /// What the formulas of the statement at hand came to.
    known: FxHashMap<FormulaId, Set>,
    stack: Vec<(FormulaId, bool)>,
}

/// The inputs, or another role, of a program in order of declaration.
pub(crate) fn of_role(program: &Program, role: Role) -> Vec<VarId> {
    program.of_role(role).map(|(id, _)| id).collect()
}

impl<'p> Caller<'p> {
    /// A program that is Boolean and knows no time.
    pub(crate) fn new(program: &'p Program) -> Result<Caller<'p>, Beyond> {
        if let Some(timer) = program.timers.first() {
            return Err(Beyond::Delay(timer.name.clone()));
        }
        let is_of_the_chart = |role: Role| matches!(role, Role::Input | Role::Output | Role::Internal);
        let mut variables = program.variables.iter();
        if let Some(number) = variables.find(|variable| variable.ty != Type::Bool && is_of_the_chart(variable.role)) {
            return Err(Beyond::Number(number.name.to_string()));
        }
        let alphabet = Alphabet::new(of_role(program, Role::Input).len());
        let values = program.variables.iter().map(|_| alphabet.none.clone()).collect();
        Ok(Caller { program, alphabet, values, begun: Vec::new(), known: FxHashMap::default(), stack: Vec::new() })
    }

    /// The value of a variable after the call.
    pub(crate) fn value(&self, variable: VarId) -> &Set {
        &self.values[variable]
    }

    /// Calls it with what it keeps.
    pub(crate) fn call(&mut self, kept: &[VarId], state: &[bool]) -> Result<(), Beyond> {
        let program = self.program;
        for (id, variable) in program.variables.iter_enumerated() {
            let is_true = variable.initial() == Value::Bool(true);
            self.values[id] = if is_true { self.alphabet.all.clone() } else { self.alphabet.none.clone() };
        }
        for (place, input) in of_role(program, Role::Input).into_iter().enumerate() {
            self.values[input] = self.alphabet.variables[place].clone();
        }
        for (variable, value) in kept.iter().zip(state) {
            self.values[*variable] = if *value { self.alphabet.all.clone() } else { self.alphabet.none.clone() };
        }
        let all = self.alphabet.all.clone();
        self.run(&program.first, &all)?;
        self.begun = program.steps.iter().map(|step| self.truth(step.active)).collect::<Result<_, _>>()?;
        self.known.clear();
        self.run(&program.before, &all)?;
        match program.repeat {
            None => self.run(&program.micro_step, &all)?,
            Some(repeat) => {
                let (mut left, mut count) = (all.clone(), 0);
                while !left.is_false() && repeat.limit.is_none_or(|limit| count < limit.bound) {
                    count += 1;
                    self.run(&program.micro_step, &left)?;
                    left = left.and(&self.values[repeat.again]);
                }
                if let Some(limit) = repeat.limit {
                    self.values[limit.flag] = self.values[limit.flag].or(&left);
                }
            }
        }
        self.run(&program.after, &all)
    }

    /// Does what is to be done with the inputs of a set. Bodies nest no deeper than lowering nests them, whatever the chart.
    fn run(&mut self, body: &[Statement], within: &Set) -> Result<(), Beyond> {
        for statement in body {
            match statement {
                Statement::Heading(_) => {}
                Statement::Assign { target, value, .. } => {
                    let value = self.truth(*value)?;
                    let old = &self.values[*target];
                    self.values[*target] =
                        if within.is_true() { value } else { within.and(&value).or(&old.and_not(within)) };
                    self.known.clear();
                }
                Statement::If(choice) => {
                    let Choice { branches, otherwise } = &**choice;
                    let mut left = within.clone();
                    for (when, then) in branches {
                        let taken = left.and(&self.truth(*when)?);
                        if !taken.is_false() {
                            self.run(then, &taken)?;
                        }
                        left = left.and_not(&taken);
                        if left.is_false() {
                            break;
                        }
                    }
                    if !left.is_false() {
                        self.run(otherwise, &left)?;
                    }
                }
                Statement::Divide(division) => return Err(self.number(division.target)),
                Statement::Case { of, .. } => return Err(self.number(*of)),
                Statement::CallTimer { timer, .. } => {
                    return Err(Beyond::Delay(self.program.timers[*timer].name.clone()));
                }
            }
        }
        Ok(())
    }

    fn number(&self, variable: VarId) -> Beyond {
        Beyond::Number(self.program.variables[variable].name.to_string())
    }

    /// With which inputs a formula is true.
    fn truth(&mut self, root: FormulaId) -> Result<Set, Beyond> {
        let pool = &self.program.pool;
        self.stack.push((root, false));
        while let Some((id, ready)) = self.stack.pop() {
            if self.known.contains_key(&id) {
                continue;
            }
            if !ready {
                self.stack.push((id, true));
                self.stack.extend(pool.operands(id).map(|operand| (operand, false)));
                continue;
            }
            let of = |operand: &FormulaId| &self.known[operand];
            let set = match *pool.get(id) {
                Formula::Constant(Value::Bool(true)) => self.alphabet.all.clone(),
                Formula::Constant(Value::Bool(false)) => self.alphabet.none.clone(),
                Formula::Variable(v) if self.program.variables[v].ty == Type::Bool => self.values[v].clone(),
                Formula::Not(a) => of(&a).not(),
                Formula::Xor([a, b]) => of(&a).xor(of(&b)),
                Formula::And(list) => pool.list(list).iter().fold(self.alphabet.all.clone(), |set, a| set.and(of(a))),
                Formula::Or(list) => pool.list(list).iter().fold(self.alphabet.none.clone(), |set, a| set.or(of(a))),
                Formula::Variable(v) => return Err(self.number(v)),
                Formula::Constant(value @ (Value::Int(_) | Value::Real(_) | Value::Time(_))) => {
                    return Err(Beyond::Number(format!("{value:?}")));
                }
                Formula::TimerDone(timer) | Formula::TimerElapsed(timer) => {
                    return Err(Beyond::Delay(self.program.timers[timer].name.clone()));
                }
                Formula::Compare(..) | Formula::Arithmetic(..) | Formula::Negate(_) | Formula::Widen(_) => {
                    return Err(Beyond::Number("a comparison of numbers".to_owned()));
                }
            };
            self.known.insert(id, set);
        }
        Ok(self.known[&root].clone())
    }
}
