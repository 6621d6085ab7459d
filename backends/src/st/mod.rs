//! Structured Text: of IEC 61131-3 edition 2 only what MATIEC, IronPLC, STruC++ and the vendors' tools all take.
//!
//! So, beside what `crate::iec` says: no empty body, no implicit conversion. `names` fixes all names first, `limits`
//! refuses what could not be written well, then each part is written in one walk.

pub(crate) mod call;
mod expressions;
mod statements;
pub(crate) mod target;
#[cfg(test)]
pub(crate) mod tests;

use crate::comment::clean;
use crate::iec::pou_parts::{Language, PouParts};
pub use crate::iec::{Options, Pou};
use crate::iec::{declarations, frame, names};
use crate::keywords::Family;
use crate::limits;
use crate::lines::Lines;
use crate::writer::{self, Comments, Writer};
use ecow::EcoString;
use expressions::Expressions;
use grafc_diagnostics::Diagnostics;
use grafc_formula::FormulaId;
use grafc_logic::scan::{Program, VarId};
use index_vec::IndexVec;
use names::Names;
use rustc_hash::FxHashMap;

/// So many bytes of text a variable are usual.
const TEXT: usize = 80;

/// Writes a program as Structured Text.
///
/// An error is a fault of grafc: the program breaks a promise of [`Program`] or is too deeply nested to be written.
pub fn emit(program: &Program, options: &Options) -> Result<String, Diagnostics> {
    write(program, options, false).map(|(text, _)| text)
}

/// The same, and which lines come from what, if that is wanted.
fn write(program: &Program, options: &Options, traced: bool) -> Result<(String, Lines), Diagnostics> {
    limits::check(program)?;
    let mut names = Names::new(program, Family::Iec);
    names.namer.close();
    let expressions = Expressions::new(program, &names);
    let mut out = Writer::new(&writer::IEC).with_room(TEXT * program.variables.len()).traced(traced);
    out.block_comment(options.header.iter().map(|line| clean(line)));
    function_block(&mut out, program, &names, &expressions);
    frame::write(&mut out, program, &names, options, |out, inputs, published| {
        call::write(out, &names.instance, inputs, published);
    });
    Ok(out.finish_traced())
}

/// The names that [`emit`] gives to the variables of a program.
pub fn names(program: &Program) -> IndexVec<VarId, EcoString> {
    Names::new(program, Family::Iec).variables
}

/// What differs in the statements of a function block from dialect to dialect.
#[derive(Clone, Copy)]
pub(crate) struct Style {
    /// What stands before each variable and timer.
    pub mark: &'static str,
    /// What stands around comments.
    pub comments: &'static Comments,
    /// Whether somebody asks which lines come from what.
    pub traced: bool,
}

impl Default for Style {
    fn default() -> Self {
        Style { mark: "", comments: &writer::IEC, traced: false }
    }
}

/// The parts of a program.
pub(crate) fn parts(program: &Program, style: Style) -> Result<PouParts, Diagnostics> {
    limits::check(program)?;
    let names = Names::new(program, Family::Iec);
    let marked = names.marked(style.mark);
    let mut body = Writer::new(style.comments).traced(style.traced);
    statements::write(&mut body, program, &marked, &Expressions::new(program, &marked));
    let (body, lines) = body.finish_traced();
    let call = self::call(program, &names);
    let origins = style.traced.then(|| program.origins());
    let interface = declarations::interface_from(program, &names, origins.as_ref(), Vec::new()).collect();
    Ok(PouParts { interface, lines, ..PouParts::new(program, names, Language::St, Vec::new(), body, call) })
}

/// The statements that come first and before a micro-step.
pub(crate) fn before(program: &Program, names: &Names) -> Writer {
    let mut out = Writer::new(&writer::IEC);
    statements::before(&mut out, program, names, &Expressions::new(program, names));
    out
}

/// The statements that come last.
pub(crate) fn after(program: &Program, names: &Names) -> Writer {
    let mut out = Writer::new(&writer::IEC);
    statements::after(&mut out, program, names, &Expressions::new(program, names));
    out
}

/// The statements of the program around the function block.
pub(crate) fn call(program: &Program, names: &Names) -> String {
    let mut out = Writer::new(&writer::IEC);
    let (inputs, published) = frame::wired(program, names);
    call::write(&mut out, &names.instance, &inputs, &published);
    out.finish()
}

/// Formulas on a line each, some variables spelt otherwise than they are named.
pub(crate) fn spell(program: &Program, spelt: &FxHashMap<VarId, EcoString>, formulas: &[FormulaId]) -> Vec<String> {
    let mut names = Names::new(program, Family::Iec);
    for (variable, text) in spelt {
        names.variables[*variable] = text.clone();
    }
    let texts = Texts::new(program, &names);
    formulas.iter().map(|id| texts.of(*id)).collect()
}

/// The formulas of a program as texts.
pub(crate) struct Texts<'p>(Expressions<'p>);

impl<'p> Texts<'p> {
    /// Measures all formulas.
    pub fn new(program: &'p Program, names: &'p Names) -> Self {
        Texts(Expressions::new(program, names))
    }

    /// A formula on one line.
    pub fn of(&self, id: FormulaId) -> String {
        let mut out = Writer::new(&writer::IEC);
        self.0.flat(&mut out, id);
        out.finish()
    }
}

fn function_block(out: &mut Writer, program: &Program, names: &Names, expressions: &Expressions) {
    out.blank();
    out.comment(&names::remark(&program.name, &names.block, program.comment.as_deref()).unwrap_or_default());
    out.line(&format!("FUNCTION_BLOCK {}", names.block));
    out.blank();
    let origins = out.is_traced().then(|| program.origins());
    declarations::write(
        out,
        declarations::interface_from(program, names, origins.as_ref(), Vec::new()),
        declarations::RETAIN,
    );
    statements::write(out, program, names, expressions);
    out.blank();
    out.line("END_FUNCTION_BLOCK");
}
