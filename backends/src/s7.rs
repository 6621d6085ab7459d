//! What all controllers of the S7 family have in common: a TIME of 32 bits.

use grafc_diagnostics::{Code, Diagnostic, Diagnostics, Span};
use grafc_formula::{Formula, FormulaId, Value};
use grafc_logic::scan::{Program, Role};

/// The longest time, some 24 days.
const LONGEST_MS: i64 = i32::MAX as i64;

/// Says of each time of a program that it is too long for some controllers.
pub(crate) fn long_times(program: &Program, controllers: &str) -> Diagnostics {
    let mut diagnostics = Diagnostics::new();
    for variable in program.variables.iter().filter(|v| v.role == Role::Constant || v.role == Role::Input) {
        if let Value::Time(ms) = variable.initial()
            && too_long(ms)
        {
            diagnostics.push(long_time(variable.span.unwrap_or_else(|| whole(program)), ms, controllers));
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
        diagnostics.push(long_time(whole(program), ms, controllers));
    }
    diagnostics
}

/// Where a program comes from as a whole: the beginning of its text.
pub(crate) fn whole(program: &Program) -> Span {
    let some = program.variables.iter().find_map(|variable| variable.span).unwrap_or_default();
    Span::new(some.file, 0, 0)
}

fn too_long(ms: i64) -> bool {
    !(i64::from(i32::MIN)..=LONGEST_MS).contains(&ms)
}

fn long_time(span: Span, ms: i64, controllers: &str) -> Diagnostic {
    Diagnostic::new(Code::E0505, span, format!("a time of {ms} ms is too long for {controllers}"))
        .note("a TIME has 32 bits there: at most 24 days, 20 hours, 31 minutes and 23.647 seconds")
        .help("count shorter times in an `int`")
}
