//! What a module needs at run time, each piece where something uses it.

use super::places::Places;
use super::tables::list;
use super::text::quoted;
use crate::writer::Writer;
use ecow::EcoString;
use grafc_formula::{Arithmetic, Formula, Type};
use grafc_logic::scan::{Program, Role, Statement, VarId};

/// A delay: an on-delay in the sense of TON, over a clock that wraps around.
const DELAYS: &str = include_str!("runtime/delays.js");
/// Inputs that are given.
const INPUTS: &str = include_str!("runtime/inputs.js");
/// Saving, and going on with what was saved.
const SAVED: &str = include_str!("runtime/saved.js");

/// The functions that make a number one of its type.
const NUMBERS: [(Type, &str); 6] = [
    (Type::Int, "const int = (number) => (number << 16) >> 16;"),
    (Type::Dint, "const dint = (number) => number | 0;"),
    (Type::Uint, "const uint = (number) => number & 0xffff;"),
    (Type::Udint, "const udint = (number) => number >>> 0;"),
    (Type::Real, "const real = Math.fround;"),
    (Type::Time, "const time = (number) => BigInt.asIntN(64, number);"),
];

/// Writes what a program needs.
pub(super) fn write(out: &mut Writer, program: &Program, places: &Places) {
    let used = computed(program);
    let functions: Vec<&str> = NUMBERS.iter().filter(|(ty, _)| used.contains(ty)).map(|(_, text)| *text).collect();
    if !functions.is_empty() {
        out.blank();
        out.comment("numbers wrap around at the width of their type");
        functions.iter().for_each(|function| out.line(function));
    }
    if !program.timers.is_empty() {
        piece(out, DELAYS);
    }
    piece(out, INPUTS);
    out.blank();
    out.comment("which program saved data belong to: another chart, or encoding, has another");
    out.line(&format!("const PROGRAM = \"{:016x}\";", program.fingerprint()));
    out.line(&format!("const CHART = {};", quoted(&program.name)));
    following(out, program, places);
    piece(out, SAVED);
}

/// What need not be saved: outputs and internal variables that the situation decides on.
fn following(out: &mut Writer, program: &Program, places: &Places) {
    let group = |role: Role| match role {
        Role::Output => "outputs",
        Role::Internal => "variables",
        Role::Flag(_) => "flags",
        Role::Input | Role::Constant | Role::Step | Role::State | Role::Memory | Role::Temporary | Role::Observed => {
            "m"
        }
    };
    let of = |v: VarId| quoted(&format!("{}.{}", group(program.variables[v].role), places.names.variables[v]));
    let items: Vec<EcoString> = program.derived().into_iter().map(of).collect();
    out.comment("what follows from the rest of the memory");
    list(out, "const FOLLOWING = new Set(", &items, ");");
}

fn piece(out: &mut Writer, text: &str) {
    out.blank();
    for line in text.lines() {
        if line.is_empty() { out.blank() } else { out.line(line) }
    }
}

/// The types that something is computed in.
fn computed(program: &Program) -> Vec<Type> {
    let mut types = Vec::new();
    for id in program.pool.ids() {
        match program.pool.get(id) {
            // A product of 32 bits with a sign needs no other function.
            Formula::Arithmetic(Arithmetic::Multiply, ..) if program.pool.ty(id) == Type::Dint => {}
            Formula::Arithmetic(..) => types.push(program.pool.ty(id)),
            Formula::Negate(_) if !matches!(program.pool.ty(id), Type::Real | Type::Lreal) => {
                types.push(program.pool.ty(id));
            }
            _ => {}
        }
    }
    types.extend(program.statements().filter_map(|statement| match statement {
        Statement::Divide(division) => Some(program.variables[division.target].ty),
        Statement::Heading(_)
        | Statement::Assign { .. }
        | Statement::CallTimer { .. }
        | Statement::Case { .. }
        | Statement::If(_) => None,
    }));
    types
}
