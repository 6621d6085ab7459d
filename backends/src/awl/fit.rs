//! What S7-300 and S7-400 cannot hold: numbers of double precision, times of more than 32 bits, longer blocks.

use super::code::Code;
use grafc_diagnostics::{Code as DiagnosticCode, Diagnostic, Diagnostics, Span};
use grafc_formula::{Formula, FormulaId, Type, Value};
use grafc_logic::scan::{Program, Role};

/// An instruction takes two bytes at least, and a block has 64 KB of them.
const MOST_INSTRUCTIONS: u64 = 32_768;
/// The longest time, some 24 days.
const LONGEST_MS: i64 = i32::MAX as i64;

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
    for variable in program.variables.iter().filter(|v| v.role == Role::Constant || v.role == Role::Input) {
        if let Value::Time(ms) = variable.initial
            && too_long(ms)
        {
            diagnostics.push(long_time(variable.span.unwrap_or_else(|| whole(program)), ms));
        }
    }
    let of_timers = program.timers.iter().filter_map(|timer| timer.preset.filter(|p| p.constant.is_none()));
    let constant = |id: FormulaId| match program.pool.get(id) {
        Formula::Constant(Value::Time(ms)) => Some(*ms),
        _ => None,
    };
    let all = of_timers.map(|preset| preset.ms).chain(program.pool.ids().filter_map(constant));
    let mut long: Vec<i64> = all.filter(|ms| too_long(*ms)).collect();
    long.sort_unstable();
    long.dedup();
    for ms in long {
        diagnostics.push(long_time(whole(program), ms));
    }
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

/// Where a program comes from as a whole: the beginning of its text.
fn whole(program: &Program) -> Span {
    let some = program.variables.iter().find_map(|variable| variable.span).unwrap_or_default();
    Span::new(some.file, 0, 0)
}

fn too_long(ms: i64) -> bool {
    !(i64::from(i32::MIN)..=LONGEST_MS).contains(&ms)
}

fn double_precision(span: Span, what: &str) -> Diagnostic {
    Diagnostic::new(DiagnosticCode::E0504, span, format!("{what}, which S7-300 and S7-400 do not have"))
        .note("their numbers have single precision")
        .help("make it a `real`; a `dint` or `udint` becomes an `lreal` where it meets a `real`, an `int` or `uint` does not")
}

fn long_time(span: Span, ms: i64) -> Diagnostic {
    Diagnostic::new(DiagnosticCode::E0505, span, format!("a time of {ms} ms is too long for S7-300 and S7-400"))
        .note("a TIME has 32 bits there: at most 24 days, 20 hours, 31 minutes and 23.647 seconds")
        .help("count shorter times in an `int`")
}
