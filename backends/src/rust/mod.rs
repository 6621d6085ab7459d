//! Rust: one module for a chart, without `std`, allocation or `unsafe`, laid out as rustfmt does it.
//!
//! ```text
//! constants · Inputs · Outputs · Variables     what a program around the chart sees      interface
//! Step, and an enum for each state             the situation                             steps
//! struct Chart { … }                           its memory and what can be done with it   chart, situation,
//!                                                                                        saved, retained, record
//!     fn scan(&mut self, inputs, now)          the statements of the scan program        scan, split, uses, locals,
//!                                                                                        expressions
//! mod runtime { … }                            what it needs at run time                 runtime
//! ```
//!
//! `names` and `places` say what everything is called and where it lies; [`size_of`] how large the chart is in memory.

mod chart;
mod code;
mod expressions;
mod interface;
mod items;
mod literals;
mod locals;
mod memory;
mod names;
mod places;
mod record;
mod retained;
mod runtime;
mod saved;
mod scan;
mod situation;
mod size;
mod split;
mod steps;
pub(crate) mod target;
mod uses;

use crate::comment::clean;
use crate::limits;
use crate::lines::Lines;
use crate::writer::{self, Writer};
use grafc_diagnostics::Diagnostics;
use grafc_logic::scan::Program;
use items::escaped;
pub use names::RustNames;
use places::Places;
pub use size::size_of;
use split::Split;

/// Where generated code has what it needs at run time from.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Runtime {
    /// From a module of its own: the code stands alone.
    #[default]
    Inline,
    /// From the crate `grafc-runtime`; then the chart also implements its trait `Chart`.
    Crate,
}

/// What the caller may choose.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Options {
    /// Where the run-time support comes from.
    pub runtime: Runtime,
    /// The first lines of the file, as a comment: which chart, which version, which options.
    pub header: Vec<String>,
    /// The name of a module to put everything into: for a file that is included, which cannot begin with attributes of
    /// its own. Without it the file is the module.
    pub module: Option<String>,
    /// How many statements a function should have at most, about; at least one. rustc takes a time for a function that
    /// grows with the square of its length, so the scan of a large chart is several functions.
    pub longest_function: usize,
}

impl Default for Options {
    fn default() -> Self {
        Options { runtime: Runtime::default(), header: Vec::new(), module: None, longest_function: 200 }
    }
}

/// Lints that depend on what the author of a chart writes, and on which parts of the code a program uses.
const LINTS: &str = "\
#![allow(dead_code, reason = \"a program need not use all of it\")]
#![allow(
    clippy::collapsible_if,
    clippy::collapsible_match,
    clippy::let_and_return,
    reason = \"an arm for each step, an `if` for each transition, a name for each value\"
)]
#![allow(
    unused_comparisons,
    clippy::absurd_extreme_comparisons,
    clippy::eq_op,
    clippy::if_same_then_else,
    clippy::manual_range_contains,
    clippy::neg_cmp_op_on_partial_ord,
    clippy::nonminimal_bool,
    clippy::overly_complex_bool_expr,
    reason = \"conditions are those of the chart\"
)]";

/// Writes a program as a module of Rust.
///
/// An error is a fault of grafc: the program breaks a promise of [`Program`] or is too deeply nested to be written.
pub fn emit(program: &Program, options: &Options) -> Result<String, Diagnostics> {
    write(program, options, false).map(|(text, _)| text)
}

/// So many bytes of text a variable are usual.
const TEXT: usize = 160;

/// The same, and which lines come from what, if that is wanted.
fn write(program: &Program, options: &Options, traced: bool) -> Result<(String, Lines), Diagnostics> {
    limits::check(program)?;
    let names = RustNames::new(program);
    let mut places = Places::new(program, &names);
    places.origins = traced.then(|| program.origins());
    let split = Split::new(program, &places, options.longest_function.max(1));
    places.share(&split.shared);
    let needs = runtime::Needs::of(program);
    let mut out = Writer::new(&writer::RUST).with_room(TEXT * program.variables.len()).traced(traced);
    if let Some(module) = &options.module {
        out.open(&format!("pub mod {} {{", names::module(module)));
    }
    head(&mut out, program, options);
    runtime::imports(&mut out, options.runtime, needs);
    interface::constants(&mut out, program, &names);
    interface::structs(&mut out, program, &names);
    steps::steps(&mut out, program, &names);
    steps::states(&mut out, program, &names);
    chart::write(&mut out, program, &names, &places, &split);
    match options.runtime {
        Runtime::Inline => runtime::module(&mut out, needs),
        Runtime::Crate => runtime::implementation(&mut out, &names),
    }
    if options.module.is_some() {
        out.close("}");
    }
    Ok(out.finish_traced())
}

/// The names that [`emit`] gives.
pub fn names(program: &Program) -> RustNames {
    RustNames::new(program)
}

fn head(out: &mut Writer, program: &Program, options: &Options) {
    let comment = program.comment.as_deref().map(clean).filter(|text| !text.is_empty());
    let title = comment.map_or(clean(&program.name), |comment| format!("{}: {comment}", clean(&program.name)));
    out.line(&format!("//! {}", escaped(&title)));
    if !options.header.is_empty() {
        out.line("//!");
    }
    for line in &options.header {
        out.line(&format!("//! {}", escaped(&clean(line))));
    }
    out.blank();
    out.line("#![forbid(unsafe_code)]");
    for line in LINTS.lines() {
        out.line(line);
    }
    out.blank();
}
