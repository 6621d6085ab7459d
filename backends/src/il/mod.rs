//! Instruction lists: IEC 61131-3 edition 2, clause 3.2, and of it what MATIEC takes.
//!
//! MATIEC takes no parenthesis within a parenthesis, so what would need one goes through a variable first
//! (`expressions`). It writes C code that does not compile where a function block is called with literals, and where
//! a value is loaded that nothing reads: inputs of timers are stored one by one before `CAL`, and no instruction is out
//! of reach. Words of the language cannot be names, so a name such as `S` or `IN` is changed here while it stays in
//! Structured Text. It takes or refuses `S` and `R` unpredictably, since it asks a pointer that nothing has
//! set (2024): so there are none. After `JMPCN` the accumulator is true, and `ST` and `STN` write `TRUE` and `FALSE`.
//!
//! MATIEC takes a body for Structured Text or for instructions by what comes first: a semicolon, or the end of the body or
//! what begins like one. It holds in its buffer what it has to read for that, and gives up on bodies of some 60 kB: a long
//! body therefore begins with a label that has such a beginning in it.
//!
//! Jumps lead forward, except that of the stability loop.

mod code;
mod expressions;
mod statements;
pub(crate) mod target;
#[cfg(test)]
mod tests;

use crate::comment::clean;
use crate::iec::pou_parts::{Language, PouParts};
pub use crate::iec::{Options, Pou};
use crate::iec::{declarations, frame, names};
use crate::keywords::Family;
use crate::limits;
use crate::lines::Lines;
use crate::writer::{self, Writer};
use code::Code;
use declarations::Entry;
use ecow::EcoString;
use grafc_diagnostics::Diagnostics;
use grafc_formula::Type;
use grafc_logic::scan::{Program, VarId};
use index_vec::IndexVec;
use names::Names;

/// From so many bytes on a body is long. A fraction of what MATIEC was seen to hold.
const LONG: usize = 16_000;

/// Writes a program as an instruction list.
///
/// An error is a fault of grafc: the program breaks a promise of [`Program`] or is too deeply nested to be written.
pub fn emit(program: &Program, options: &Options) -> Result<String, Diagnostics> {
    write(program, options, false).map(|(text, _)| text)
}

/// The same, and which lines come from what, if that is wanted.
fn write(program: &Program, options: &Options, traced: bool) -> Result<(String, Lines), Diagnostics> {
    limits::check(program)?;
    let mut names = Names::new(program, Family::InstructionList);
    let (body, parts) = self::body(program, &mut names, traced);
    let mut out = Writer::new(&writer::IEC).traced(traced);
    out.block_comment(options.header.iter().map(|line| clean(line)));
    out.blank();
    out.comment(&names::remark(&program.name, &names.block, program.comment.as_deref()).unwrap_or_default());
    out.line(&format!("FUNCTION_BLOCK {}", names.block));
    out.blank();
    let origins = traced.then(|| program.origins());
    declarations::write(
        &mut out,
        declarations::interface_from(program, &names, origins.as_ref(), parts),
        declarations::RETAIN,
    );
    out.blank();
    out.append(body);
    out.blank();
    out.line("END_FUNCTION_BLOCK");
    frame::write(&mut out, program, &names, options, |out, inputs, published| {
        let body = call(out.apart(), &names.instance, inputs, published);
        out.append(body);
    });
    Ok(out.finish_traced())
}

/// The parts of a program.
pub(crate) fn parts(program: &Program) -> Result<PouParts, Diagnostics> {
    limits::check(program)?;
    let mut names = Names::new(program, Family::InstructionList);
    let (body, parts) = self::body(program, &mut names, false);
    let (inputs, published) = frame::wired(program, &names);
    let program_body = call(Writer::new(&writer::IEC), &names.instance, &inputs, &published);
    Ok(PouParts::new(program, names, Language::Il, parts, body.finish(), program_body.finish()))
}

/// The instructions of the function block, and the declarations of what holds parts of formulas.
fn body(program: &Program, names: &mut Names, traced: bool) -> (Writer, Vec<Entry>) {
    let body = statements::body(program, names, traced);
    let mut out = Writer::new(&writer::IEC).traced(traced);
    if body.out.len() > LONG {
        out.comment("this label tells MATIEC that a long instruction list begins");
        // No name of the chart is the same: none has `end_action` within it.
        out.line("no_end_action:");
        out.blank();
    }
    out.append(body.out);
    (out, body.parts.into_iter().map(|name| Entry::plain(name, Type::Bool)).collect())
}

/// The instructions of the program around the function block.
fn call(out: Writer, instance: &str, inputs: &[&str], published: &[&str]) -> Writer {
    let mut code = Code::new(out);
    for name in inputs {
        code.instruction("LD", name);
        code.instruction("ST", &format!("{instance}.{name}"));
    }
    code.instruction("CAL", instance);
    for name in published {
        code.instruction("LD", &format!("{instance}.{name}"));
        code.instruction("ST", name);
    }
    code.out
}

/// How many instructions the function block of [`emit`] has.
pub fn instructions(program: &Program) -> Result<u64, Diagnostics> {
    limits::check(program)?;
    Ok(statements::body(program, &mut Names::new(program, Family::InstructionList), false).count)
}

/// The names that [`emit`] gives to the variables of a program.
pub fn names(program: &Program) -> IndexVec<VarId, EcoString> {
    Names::new(program, Family::InstructionList).variables
}
