//! Structured Text: IEC 61131-3 edition 2, and of it only what MATIEC, IronPLC, STruC++ and the vendors' tools all take.
//!
//! So: keywords in upper case, flat comments, no VAR_TEMP, no empty block or body, no implicit conversion, time literals
//! of one unit, located variables in a block of their own. `names` fixes all names first, `limits` refuses what
//! could not be written well, then each part is written in one walk.

pub(crate) mod declarations;
mod expressions;
mod frame;
pub(crate) mod literals;
mod names;
mod statements;
#[cfg(test)]
mod tests;

use crate::comment::clean;
use crate::limits;
use crate::writer::{self, Comments, Writer};
use declarations::Block;
use expressions::Expressions;
use grafc_diagnostics::Diagnostics;
use grafc_logic::formula::FormulaId;
use grafc_logic::scan::{Program, VarId};
use index_vec::IndexVec;
use names::Names;
use rustc_hash::FxHashMap;

/// What is written around the function block.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Pou {
    /// The function block alone.
    #[default]
    FunctionBlock,
    /// And a program that holds an instance of it and the variables at addresses.
    Program,
    /// And a configuration with a task that runs the program.
    Configuration,
}

/// What the caller may choose.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Options {
    /// What is written around the function block.
    pub pou: Pou,
    /// The first lines of the file, as a comment: which chart, which version, which options.
    pub header: Vec<String>,
    /// The interval of the task, in milliseconds.
    pub interval_ms: u32,
}

impl Default for Options {
    fn default() -> Self {
        Options { pou: Pou::default(), header: Vec::new(), interval_ms: 20 }
    }
}

/// Writes a program as Structured Text.
///
/// An error is a fault of grafc: the program breaks a promise of [`Program`] or is too deeply nested to be written.
pub fn emit(program: &Program, options: &Options) -> Result<String, Diagnostics> {
    limits::check(program)?;
    let names = Names::new(program);
    let expressions = Expressions::new(program, &names);
    let mut out = Writer::new(&writer::IEC);
    out.block_comment(options.header.iter().map(|line| clean(line)));
    function_block(&mut out, program, &names, &expressions);
    match options.pou {
        Pou::FunctionBlock => {}
        Pou::Program => frame::program(&mut out, program, &names),
        Pou::Configuration => {
            frame::program(&mut out, program, &names);
            frame::configuration(&mut out, &names, options.interval_ms);
        }
    }
    Ok(out.finish())
}

/// The names that [`emit`] gives to the variables of a program.
pub fn names(program: &Program) -> IndexVec<VarId, String> {
    Names::new(program).variables
}

/// A function block and the program around it in parts, for targets that have a place for each.
pub(crate) struct Parts {
    /// The name of the function block.
    pub block: String,
    /// What it is, clean.
    pub description: Option<String>,
    /// Its variables.
    pub interface: Vec<Block>,
    /// Its statements.
    pub body: String,
    /// The name of the program.
    pub program: String,
    /// The variables of the program.
    pub program_variables: Vec<Block>,
    /// The statements of the program.
    pub program_body: String,
    /// Names for what runs the program.
    pub configuration: String,
    pub resource: String,
    pub task: String,
    pub program_instance: String,
}

/// What differs in the statements of a function block from dialect to dialect.
#[derive(Clone, Copy)]
pub(crate) struct Style {
    /// What stands before each variable and timer.
    pub mark: &'static str,
    /// What stands around comments.
    pub comments: &'static Comments,
}

impl Default for Style {
    fn default() -> Self {
        Style { mark: "", comments: &writer::IEC }
    }
}

/// The parts of a program.
pub(crate) fn parts(program: &Program, style: Style) -> Result<Parts, Diagnostics> {
    limits::check(program)?;
    let names = Names::new(program);
    let marked = names.marked(style.mark);
    let mut body = Writer::new(style.comments);
    statements::write(&mut body, program, &marked, &Expressions::new(program, &marked));
    let mut program_body = Writer::new(&writer::IEC);
    frame::body(&mut program_body, program, &names);
    Ok(Parts {
        description: names::remark(&program.name, &names.block, program.comment.as_deref()),
        interface: declarations::interface(program, &names),
        body: body.finish(),
        program_variables: frame::variables(program, &names),
        program_body: program_body.finish(),
        block: names.block,
        program: names.program,
        configuration: names.configuration,
        resource: names.resource,
        task: names.task,
        program_instance: names.program_instance,
    })
}

/// Formulas on a line each, some variables spelt otherwise than they are named.
pub(crate) fn spell(program: &Program, spelt: &FxHashMap<VarId, String>, formulas: &[FormulaId]) -> Vec<String> {
    let mut names = Names::new(program);
    for (variable, text) in spelt {
        names.variables[*variable].clone_from(text);
    }
    let expressions = Expressions::new(program, &names);
    let text = |id: &FormulaId| {
        let mut out = Writer::new(&writer::IEC);
        expressions.flat(&mut out, *id);
        out.finish()
    };
    formulas.iter().map(text).collect()
}

fn function_block(out: &mut Writer, program: &Program, names: &Names, expressions: &Expressions) {
    out.blank();
    out.comment(&names::remark(&program.name, &names.block, program.comment.as_deref()).unwrap_or_default());
    out.line(&format!("FUNCTION_BLOCK {}", names.block));
    out.blank();
    declarations::write(out, &declarations::interface(program, names));
    statements::write(out, program, names, expressions);
    out.blank();
    out.line("END_FUNCTION_BLOCK");
}
