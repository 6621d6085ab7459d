//! Structured Text: of IEC 61131-3 edition 2 only what MATIEC, IronPLC, STruC++ and the vendors' tools all take.
//!
//! So, beside what [`crate::iec`] says: no empty body, no implicit conversion. `names` fixes all names first, `limits`
//! refuses what could not be written well, then each part is written in one walk.

mod call;
mod expressions;
mod statements;
#[cfg(test)]
pub(crate) mod tests;

use crate::comment::clean;
pub use crate::iec::{Options, Pou};
use crate::iec::{declarations, frame, names};
use crate::keywords::Family;
use crate::limits;
use crate::writer::{self, Writer};
use expressions::Expressions;
use grafc_diagnostics::Diagnostics;
use grafc_logic::scan::{Program, VarId};
use index_vec::IndexVec;
use names::Names;

/// Writes a program as Structured Text.
///
/// An error is a fault of grafc: the program breaks a promise of [`Program`] or is too deeply nested to be written.
pub fn emit(program: &Program, options: &Options) -> Result<String, Diagnostics> {
    limits::check(program)?;
    let names = Names::new(program, Family::Iec);
    let expressions = Expressions::new(program, &names);
    let mut out = Writer::new(&writer::IEC);
    out.block_comment(options.header.iter().map(|line| clean(line)));
    function_block(&mut out, program, &names, &expressions);
    frame::write(&mut out, program, &names, options, |out, inputs, published| {
        call::write(out, &names.instance, inputs, published);
    });
    Ok(out.finish())
}

/// The names that [`emit`] gives to the variables of a program.
pub fn names(program: &Program) -> IndexVec<VarId, String> {
    Names::new(program, Family::Iec).variables
}

fn function_block(out: &mut Writer, program: &Program, names: &Names, expressions: &Expressions) {
    out.blank();
    out.comment(&names::remark(&program.name, &names.block, program.comment.as_deref()).unwrap_or_default());
    out.line(&format!("FUNCTION_BLOCK {}", names.block));
    out.blank();
    declarations::write(out, program, names, Vec::new());
    statements::write(out, program, names, expressions);
    out.blank();
    out.line("END_FUNCTION_BLOCK");
}
