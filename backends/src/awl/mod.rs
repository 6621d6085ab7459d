//! Siemens STL (AWL), the statement list of STEP 7 for S7-300 and S7-400, as a source file.
//!
//! What both STEP 7 and awlsim import: blocks by number, so that no symbol table has to exist before; one declaration a
//! line; names of at most 24 letters, digits and single underscores, none of them a word of the language; labels of four
//! characters; ASCII. The function block keeps its state in an instance data block, whose variables are to be seen in
//! any variable table; `OB 1` calls it with the variables at addresses.
//!
//! Conditions are chains of the one-bit accumulator, with at most seven open parentheses: what is deeper goes through a
//! variable first (`conditions`). Numbers are computed at 16 or 32 bits (`numbers`); `uint` is a WORD and `udint` a DWORD.
//! There is no double precision, and a time has 32 bits: what does not fit is an error (`fit`).
//!
//! Time comes from outside, as the input `NOW`, and is computed with 32 bits (`timers`). S5 timers are few, numbered by
//! hand, coarse, and run on within a cycle; SFB 4 reads the clock at each call, so that two micro-steps of one call would
//! not see the same time, and is not in every CPU. A difference of `NOW` is right for the clock of SFC 64, which wraps
//! around after 31 bits, as well as for one of 32.
//!
//! Data blocks keep their values when the power fails. The input `RESTART` puts them back to the start (`restart`).
//!
//! Jumps lead forward, except that of the stability loop.

mod blocks;
mod code;
mod conditions;
mod division;
mod fit;
mod mnemonics;
mod numbers;
mod restart;
mod statements;
pub(crate) mod target;
#[cfg(test)]
mod tests;
mod timers;

use crate::iec::names::Names;
use crate::keywords::Family;
use crate::limits;
use crate::lines::Lines;
use crate::namer::Namer;
use crate::transliterate::ascii;
use crate::writer::{self, Writer};
use code::Code;
use ecow::{EcoString, eco_format};
use grafc_diagnostics::Diagnostics;
use grafc_formula::{FormulaId, Type};
use grafc_logic::scan::{Program, TimerId, VarId};
use index_vec::IndexVec;
pub use mnemonics::Mnemonics;

/// What the caller may choose.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Options {
    /// Whether `OB 1` is written as well, which calls the function block.
    pub organization_block: bool,
    /// The number of the function block and of its data block.
    pub number: u16,
    /// The words of instructions.
    pub mnemonics: Mnemonics,
    /// The first lines of the file, as a comment: which chart, which version, which options.
    pub header: Vec<String>,
}

impl Default for Options {
    fn default() -> Self {
        Options { organization_block: false, number: 1, mnemonics: Mnemonics::default(), header: Vec::new() }
    }
}

/// Writes a program as a source file.
///
/// An error is a type that S7-300 and S7-400 do not have, a time or a block that is too long for them, or a fault of
/// grafc.
pub fn emit(program: &Program, options: &Options) -> Result<String, Diagnostics> {
    write(program, options, false).map(|(text, _)| text)
}

/// The same, and which lines come from what, if that is wanted.
fn write(program: &Program, options: &Options, traced: bool) -> Result<(String, Lines), Diagnostics> {
    let (names, code) = body(program, options.mnemonics, traced)?;
    let mut out = Writer::new(&writer::STL).traced(traced);
    blocks::write(&mut out, program, options, &names, code);
    let (text, lines) = out.finish_traced();
    Ok((ascii(&text), lines))
}

/// How many instructions the function block of [`emit`] has.
pub fn instructions(program: &Program) -> Result<u64, Diagnostics> {
    Ok(body(program, Mnemonics::default(), false)?.1.count)
}

/// The names that [`emit`] gives to the variables of a program.
pub fn names(program: &Program) -> IndexVec<VarId, EcoString> {
    Names::new(program, Family::StatementList).variables
}

/// The name of the input that is given the time in milliseconds, if the program measures any.
pub fn clock_input(program: &Program) -> Option<EcoString> {
    AwlNames::new(program).clock.map(|clock| clock.now)
}

/// The name of the input that puts the chart back to its start.
pub fn restart_input(program: &Program) -> EcoString {
    AwlNames::new(program).restart
}

fn body(program: &Program, mnemonics: Mnemonics, traced: bool) -> Result<(AwlNames, Code), Diagnostics> {
    limits::check(program)?;
    fit::check(program)?;
    let mut names = AwlNames::new(program);
    let code = statements::body(program, &mut names, mnemonics, traced);
    fit::check_length(program, &code)?;
    Ok((names, code))
}

/// All names of the function block, without the mark of local names.
struct AwlNames {
    variables: IndexVec<VarId, EcoString>,
    timers: IndexVec<TimerId, timers::TimerNames>,
    block: EcoString,
    /// The input that restarts the chart.
    restart: EcoString,
    /// What measures time, if anything does.
    clock: Option<timers::Clock>,
    /// Gives further names.
    namer: Namer,
}

impl AwlNames {
    fn new(program: &Program) -> Self {
        let Names { variables, timers, block, mut namer, .. } = Names::new(program, Family::StatementList);
        let reads = program.reads_of_timers();
        let timers =
            timers.into_iter_enumerated().map(|(id, name)| timers::TimerNames::new(reads[id], name, &mut namer));
        let timers: IndexVec<TimerId, timers::TimerNames> = timers.collect();
        let clock = (!timers.is_empty()).then(|| timers::Clock::new(&mut namer));
        AwlNames { variables, timers, block, restart: namer.name("RESTART"), clock, namer }
    }

    /// The operand of a variable of the block.
    fn variable(&self, id: VarId) -> EcoString {
        local(&self.variables[id])
    }
}

/// A name as an operand: the mark tells it from words of the language and global symbols.
fn local(name: &str) -> EcoString {
    eco_format!("#{name}")
}

/// A variable of ours that holds a value within one call.
struct Local {
    name: EcoString,
    ty: Type,
}

/// A constant that is in the accumulator.
type Known = Option<FormulaId>;
