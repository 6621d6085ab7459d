//! PLCopen XML (TC6, version 2.01): a whole project that holds the chart as a function block, a program that calls it
//! with its variables at their addresses, and a configuration with a task that runs the program.
//!
//! The readers do not agree on one file, so there are two dialects (see [`Dialect`]). Elements stand in the order of the
//! schema: `addData` before `documentation`, `type` before `initialValue`. Nothing in a file depends on the day or the
//! machine: the dates that the schema demands are fixed.
//!
//! `project` writes the frame, `interface` the variables, and each kind of [`Body`] has a file of its own.

mod dialect;
mod drawing;
mod interface;
pub mod ld;
mod project;
pub mod sfc;
pub(crate) mod target;

pub use dialect::Dialect;

use crate::iec::declarations::with_temporaries;
use crate::il;
use crate::st::{self, Style};
use grafc_diagnostics::Diagnostics;
use grafc_logic::scan::Program;

/// What the function block holds.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Body {
    /// Structured Text.
    #[default]
    St,
    /// An instruction list, which [`emit_il`] writes.
    Il,
    /// A ladder diagram, which [`ld::emit`] writes.
    Ld,
    /// A sequential function chart, which [`sfc::emit`] writes.
    Sfc,
}

/// What the caller may choose.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Options {
    /// Which tools read it.
    pub dialect: Dialect,
    /// What the function block holds.
    pub body: Body,
    /// Which chart, which version, which options.
    pub header: Vec<String>,
    /// The interval of the task, in milliseconds; if none, as the dialect has it.
    pub interval_ms: Option<u32>,
}

/// Writes a program as a project, with a body in Structured Text.
///
/// An error is a fault of grafc: the program breaks a promise of [`Program`] or is too deeply nested to be written.
pub fn emit(program: &Program, options: &Options) -> Result<String, Diagnostics> {
    let mut parts = st::parts(program, Style::default())?;
    if options.dialect == Dialect::Codesys {
        parts.interface = with_temporaries(parts.interface);
    }
    Ok(project::write(&parts, options, &[], |xml, dialect| dialect.body(xml, "ST", &parts.body)))
}

/// Writes a program as a project, with bodies of instructions, those of [`il::emit`].
///
/// An error is a fault of grafc, as with [`emit`].
pub fn emit_il(program: &Program, options: &Options) -> Result<String, Diagnostics> {
    let parts = il::parts(program)?;
    Ok(project::write(&parts, options, &[], |xml, dialect| dialect.body(xml, "IL", &parts.body)))
}
