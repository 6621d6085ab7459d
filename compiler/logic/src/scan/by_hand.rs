//! Programs that tests write by hand, variable by variable.

use super::{Program, Role, Statement, VarId, Variable};
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
        first: Vec::new(),
        started: None,
        before: Vec::new(),
        micro_step: Vec::new(),
        repeat: None,
        after: Vec::new(),
    }
}

/// A variable without a name.
pub(crate) fn variable(program: &mut Program, role: Role, ty: Type) -> VarId {
    let initial = grafc_formula::number::zero(ty);
    let name = String::new();
    program.variables.push(Variable { role, name, ty, initial, comment: None, address: None, span: None })
}

/// A Boolean variable, and the formula that reads it.
pub(crate) fn bit(program: &mut Program, role: Role) -> (VarId, FormulaId) {
    let v = variable(program, role, Type::Bool);
    (v, program.pool.variable(v, Type::Bool))
}

/// `target := value`.
pub(crate) fn assign(target: VarId, value: FormulaId) -> Statement {
    Statement::Assign { target, value, remark: None }
}
