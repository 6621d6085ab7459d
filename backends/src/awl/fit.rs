//! What S7-300 and S7-400 cannot hold: numbers of double precision, times of more than 32 bits (`s7`), longer blocks.

use super::code::Code;
use crate::s7::{long_times, whole};
use grafc_diagnostics::{Code as DiagnosticCode, Diagnostic, Diagnostics, Span};
use grafc_formula::{FormulaId, Type};
use grafc_logic::scan::Program;

/// An instruction takes two bytes at least, and a block has 64 KB of them.
const MOST_INSTRUCTIONS: u64 = 32_768;

/// Says of each variable and constant that it does not fit.
pub(super) fn check(program: &Program) -> Result<(), Diagnostics> {
    let mut diagnostics = Diagnostics::new();
    for variable in program.variables.iter().filter(|v| v.ty == Type::Lreal) {
        if let Some(span) = variable.span {
            diagnostics.push(double_precision(span, &format!("`{}` is an `lreal`", variable.name)));
        }
    }
    let has_lreal = |id: FormulaId| program.pool.ty(id) == Type::Lreal;
    if diagnostics.is_empty()
        && (program.variables.iter().any(|v| v.ty == Type::Lreal) || program.pool.ids().any(has_lreal))
    {
        diagnostics.push(double_precision(whole(program), "an intermediate result is an `lreal`"));
    }
    diagnostics.append(long_times(program, "S7-300 and S7-400"));
    if diagnostics.has_errors() { Err(diagnostics) } else { Ok(()) }
}

/// Says that a block is too long, if it is.
pub(super) fn check_length(program: &Program, code: &Code) -> Result<(), Diagnostics> {
    if code.count <= MOST_INSTRUCTIONS && code.labels_suffice() {
        return Ok(());
    }
    let mut diagnostics = Diagnostics::new();
    let message = format!("the chart takes {} instructions, more than a block of STEP 7 can hold", code.count);
    diagnostics.push(
        Diagnostic::new(DiagnosticCode::E0506, whole(program), message)
            .note("a block has 65536 bytes at most, and an instruction two at least")
            .help("try another `--encoding`, or split it into several charts"),
    );
    Err(diagnostics)
}

fn double_precision(span: Span, what: &str) -> Diagnostic {
    Diagnostic::new(DiagnosticCode::E0504, span, format!("{what}, which S7-300 and S7-400 do not have"))
        .note("their numbers have single precision")
        .help("make it a `real`; a `dint` or `udint` becomes an `lreal` where it meets a `real`, an `int` or `uint` does not")
}
