//! The input `RESTART`: everything that keeps its value from call to call is as before the first call, except for what
//! the chart retains.
//!
//! An instance data block is retentive unless the CPU is told otherwise, so that a chart would go on after a power failure
//! where it stood, on a clock that has started again. `OB 1` gives a true `RESTART` in its first cycle; a chart that is
//! to go on is called without. The block's own clock goes on in any case: no timer runs that would notice.

use super::code::Code;
use super::numbers::literal;
use super::{AwlNames, local, timers};
use crate::iec::literals::is_zero;
use grafc_formula::{Type, Value};
use grafc_logic::scan::Program;

/// Writes what `RESTART` does.
pub(super) fn write(code: &mut Code, program: &Program, names: &AwlNames) {
    let kept = program.variables.iter_enumerated().filter(|(_, v)| v.role.is_kept() && !v.retain);
    let ours = names.timers.iter().flat_map(timers::TimerNames::kept).map(|kept| {
        let zero = if kept.ty == Type::Bool { Value::Bool(false) } else { Value::Time(0) };
        (local(&kept.name), kept.ty, zero)
    });
    let all = kept.map(|(id, v)| (names.variable(id), v.ty, v.initial())).chain(ours);
    let (bits, mut numbers): (Vec<_>, Vec<_>) = all.partition(|(_, ty, _)| *ty == Type::Bool);
    if bits.is_empty() && numbers.is_empty() {
        return;
    }
    let retained = program.variables.iter().any(|variable| variable.retain);
    let but = if retained { ", but for what is retained" } else { "" };
    code.network(&format!("restart: as before the first call{but}"));
    code.about("restart");
    let done = code.new_label();
    code.bit("A", &local(&names.restart));
    code.jump_unless(&done);
    for (operand, _, initial) in bits {
        code.instruction(if initial == Value::Bool(true) { "S" } else { "R" }, &operand);
    }
    // All zeros are one in 32 bits, of which an INT takes 16.
    let text = |ty: Type, value: Value| {
        if is_zero(value) { "L#0".into() } else { literal(value, ty) }
    };
    numbers.sort_by_key(|(_, _, initial)| !is_zero(*initial));
    let mut loaded = None;
    for (operand, ty, initial) in numbers {
        let wanted = text(ty, initial);
        if loaded.as_ref() != Some(&wanted) {
            code.number("L", &wanted);
            loaded = Some(wanted);
        }
        code.instruction("T", &operand);
    }
    code.label(done);
}
