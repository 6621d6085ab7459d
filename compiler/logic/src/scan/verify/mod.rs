//! Checks the invariants of [`super`]. A violation is a fault of grafc, never of the chart.

mod tables;

use super::{Choice, Division, Flag, Program, Role, State, Statement, VarId, is_empty};
use grafc_formula::number::is_zero;
use grafc_formula::{Formula, FormulaId, Type, Value};
use rustc_hash::{FxHashMap, FxHashSet};

/// Says which invariant of the program does not hold, if one does not.
pub fn verify(program: &Program) -> Result<(), String> {
    operands(program)?;
    tables::verify(program)?;
    let (set, checked) = (FxHashSet::default(), FxHashSet::default());
    let mut walk = Walk { program, set, checked, state_of: program.state_of(), values: state_values(program) };
    walk.statements(&program.first)?;
    walk.statements(&program.before)?;
    walk.statements(&program.micro_step)?;
    if let Some(repeat) = program.repeat {
        walk.reads_variable(repeat.again)?;
        if repeat.limit.is_none() && is_empty(&program.micro_step) {
            return Err("the stability loop is empty".to_owned());
        }
    }
    walk.statements(&program.after)?;
    let Some(restoring) = &program.restoring else { return Ok(()) };
    // Nothing of a call is known when memory has been given back.
    walk.set.clear();
    walk.checked.clear();
    walk.statements(&restoring.statements)
}

/// The values of each state.
fn state_values(program: &Program) -> FxHashSet<(usize, i64)> {
    let of = |(index, state): (usize, &State)| {
        state.idle.into_iter().chain(state.values.iter().map(|(_, value)| *value)).map(move |n| (index, n)).collect()
    };
    program.states.iter().enumerate().flat_map(|state| -> Vec<(usize, i64)> { of(state) }).collect()
}

/// Operators have operands of the types that they need, and arithmetic stands alone.
fn operands(program: &Program) -> Result<(), String> {
    let pool = &program.pool;
    for id in pool.ids() {
        for operand in pool.operands(id) {
            if operand >= id {
                return Err(format!("operand {operand} does not come before {id}"));
            }
            let nested = matches!(pool.get(operand), Formula::Arithmetic(..) | Formula::Negate(_));
            if nested {
                return Err(format!("{id} holds the intermediate result {operand}, which nothing wraps around"));
            }
        }
        let boolean = |f: &FormulaId| pool.ty(*f) == Type::Bool;
        let fits = match pool.get(id) {
            Formula::Not(a) => boolean(a),
            Formula::And(list) | Formula::Or(list) => {
                let list = pool.list(*list);
                list.len() > 1 && list.iter().all(boolean)
            }
            Formula::Xor([a, b]) => boolean(a) && boolean(b),
            Formula::Compare(_, [a, b]) => pool.ty(*a) == pool.ty(*b),
            Formula::Constant(_)
            | Formula::Variable(_)
            | Formula::TimerDone(_)
            | Formula::TimerElapsed(_)
            | Formula::Arithmetic(..)
            | Formula::Negate(_)
            | Formula::Widen(_) => true,
        };
        if !fits {
            return Err(format!("the operands of {id} do not fit it"));
        }
    }
    Ok(())
}

/// Which temporaries hold a value of this call so far.
struct Walk<'p> {
    program: &'p Program,
    set: FxHashSet<VarId>,
    /// Formulas all of whose variables were found to hold a value.
    checked: FxHashSet<FormulaId>,
    state_of: FxHashMap<VarId, usize>,
    values: FxHashSet<(usize, i64)>,
}

impl Walk<'_> {
    fn statements(&mut self, statements: &[Statement]) -> Result<(), String> {
        for statement in statements {
            match statement {
                Statement::Heading(_) => {}
                Statement::Assign { target, value, .. } => {
                    self.reads(*value)?;
                    let (to, from) = (self.program.variables[*target].ty, self.program.pool.ty(*value));
                    if to != from {
                        return Err(format!("{target} of type {to:?} is given a {from:?}"));
                    }
                    self.keeps_to_its_state(*target, *value)?;
                    self.set.insert(*target);
                }
                Statement::Divide(division) => self.divides(division)?,
                Statement::CallTimer { input, .. } => self.reads(*input)?,
                Statement::Case { of, arms } => {
                    self.reads_variable(*of)?;
                    let mut values: Vec<i64> = arms.iter().map(|arm| arm.value).collect();
                    values.sort_unstable();
                    values.dedup();
                    if arms.is_empty() || values.len() != arms.len() || arms.iter().any(|arm| arm.body.is_empty()) {
                        return Err(format!("the arms of {of} are empty or repeat a value"));
                    }
                    for arm in arms {
                        self.statements(&arm.body)?;
                    }
                }
                Statement::If(choice) => {
                    let Choice { branches, otherwise } = &**choice;
                    for (when, _) in branches {
                        self.reads(*when)?;
                    }
                    // A temporary set in a branch counts as set from there on: it is read under the same guard.
                    for body in branches.iter().map(|(_, body)| body.as_slice()).chain([otherwise.as_slice()]) {
                        self.statements(body)?;
                    }
                }
            }
        }
        Ok(())
    }

    /// A division has operands without operators, divides by no constant but 0, and raises DIV0.
    fn divides(&mut self, division: &Division) -> Result<(), String> {
        let Division { target, dividend, divisor, flag, .. } = *division;
        self.reads(dividend)?;
        self.reads(divisor)?;
        let pool = &self.program.pool;
        let simple = |id: FormulaId| match pool.get(id) {
            Formula::Widen(a) => pool.is_leaf(*a),
            _ => pool.is_leaf(id),
        };
        if !simple(dividend) || !simple(divisor) || pool.as_constant(divisor).is_some_and(|value| !is_zero(value)) {
            return Err(format!("{target} is given a division of {dividend} by {divisor}, which stands in no formula"));
        }
        if self.program.variables[flag].role != Role::Flag(Flag::Div0) {
            return Err(format!("the division for {target} raises {flag}"));
        }
        self.set.insert(target);
        Ok(())
    }

    /// A state or a copy of one takes only values of the state.
    fn keeps_to_its_state(&self, target: VarId, value: FormulaId) -> Result<(), String> {
        let Some(index) = self.state_of.get(&target) else { return Ok(()) };
        let fits = match self.program.pool.get(value) {
            Formula::Variable(v) => self.state_of.get(v) == Some(index),
            Formula::Constant(Value::Int(n)) => self.values.contains(&(*index, *n)),
            _ => false,
        };
        if fits { Ok(()) } else { Err(format!("{target} takes the value {value}, which is none of its state")) }
    }

    fn reads(&mut self, root: FormulaId) -> Result<(), String> {
        let mut stack = vec![root];
        while let Some(id) = stack.pop() {
            if !self.checked.insert(id) {
                continue;
            }
            if let Formula::Variable(v) = self.program.pool.get(id) {
                self.reads_variable(*v)?;
            }
            stack.extend(self.program.pool.operands(id));
        }
        Ok(())
    }

    fn reads_variable(&self, v: VarId) -> Result<(), String> {
        let variable = &self.program.variables[v];
        if variable.role == Role::Temporary && !self.set.contains(&v) {
            return Err(format!("`{}` is read before it has a value", variable.name));
        }
        Ok(())
    }
}
