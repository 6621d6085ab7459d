//! Programs that tests write by hand, variable by variable.

use super::{Arm, Elements, Origin, Program, Role, Statement, TimerId, Told, VarId, Variable};
use grafc_formula::{FormulaId, Pool, Type};
use index_vec::IndexVec;

/// A program that does nothing.
pub(crate) fn empty() -> Program {
    Program {
        name: "P".to_owned(),
        comment: None,
        variables: IndexVec::new(),
        timers: IndexVec::new(),
        pool: Pool::default(),
        steps: IndexVec::new(),
        states: Vec::new(),
        elements: Elements::default(),
        first: Vec::new(),
        started: None,
        before: Vec::new(),
        micro_step: Vec::new(),
        repeat: None,
        most: 1,
        after: Vec::new(),
        restoring: None,
        observing: None,
        claims: Vec::new(),
        assertion: None,
    }
}

/// A variable without a name.
pub(crate) fn variable(program: &mut Program, role: Role, ty: Type) -> VarId {
    program.variables.push(Variable::new(role, "", ty))
}

/// A Boolean variable, and the formula that reads it.
pub(crate) fn bit(program: &mut Program, role: Role) -> (VarId, FormulaId) {
    let v = variable(program, role, Type::Bool);
    (v, program.pool.variable(v, Type::Bool))
}

/// `target := value`.
pub(crate) fn assign(target: VarId, value: FormulaId) -> Statement {
    Statement::assign(Origin::Chart, target, value)
}

/// What is done at a value, with nothing beside it.
pub(crate) fn arm(value: i64, body: Vec<Statement>) -> Arm {
    Arm { value, origin: Origin::Chart, told: Told::Nothing, body }
}

/// Brings a timer up to date.
pub(crate) fn call(timer: TimerId, input: FormulaId) -> Statement {
    Statement::CallTimer { timer, input, origin: Origin::Chart }
}
