//! What is computed for those who look on alone raises no flag.

use crate::lower::Lowering;
use crate::scan::{Flag, Origin, Role, Statement};
use grafc_formula::Type;

/// The statements, and DIV0 as it was before them.
pub(crate) fn without_flag(lowering: &mut Lowering, statements: Vec<Statement>) -> Vec<Statement> {
    if !statements.iter().any(|statement| matches!(statement, Statement::Divide(_))) {
        return statements;
    }
    let flag = lowering.symbols.flag(Flag::Div0);
    let before = lowering.symbols.fresh(Role::Temporary, "div0_before", Type::Bool, None);
    let raised = lowering.symbols.read(&mut lowering.pool, flag);
    let mut out = vec![Statement::assign(Origin::Chart, before, raised)];
    out.extend(statements);
    let kept = lowering.symbols.read(&mut lowering.pool, before);
    out.push(Statement::assign(Origin::Chart, flag, kept));
    out
}
