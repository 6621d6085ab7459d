//! JavaScript: an ECMAScript module for a chart, without dependencies, and its types for TypeScript.
//!
//! ```text
//! const constants, TRANSITIONS …        what never changes                                        tables
//! function fresh() { … }                all that a chart keeps, in groups by what it is for       memory
//! function begin, microStep, end        the statements of the scan program                        scan, statements,
//! function restoring, situation         what follows from the memory                              expressions
//! int, delay, accepted, seal …          what it needs at run time                                 runtime
//! export class Chart { … }              what can be done with a chart                             class
//! ```
//!
//! `names` and `places` say what everything is called and where it lies, `text` makes texts of the user's harmless, `types`
//! writes the declarations. A variable of the chart is a property of its exact name.

mod class;
mod expressions;
mod memory;
mod names;
mod places;
mod runtime;
mod scan;
mod statements;
mod tables;
pub(crate) mod target;
mod text;
mod types;

use crate::limits;
use crate::lines::Lines;
use crate::writer::{self, Writer};
use expressions::Expressions;
use grafc_diagnostics::Diagnostics;
use grafc_logic::scan::{Observed, Program};
use names::Names;
use places::Places;
use text::comment;

/// What the caller may choose.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Options {
    /// The first lines of the file, as a comment: which chart, which version, which options.
    pub header: Vec<String>,
    /// Whether a program is asked for that shows all that is to be seen of a chart that runs, as a page does that draws it.
    pub observed: bool,
}

impl Options {
    /// How much the program has to show.
    pub(crate) fn shown(&self) -> Observed {
        if self.observed { Observed::All } else { Observed::Transitions }
    }
}

/// Writes a program, which shows its transitions, as a module and its declarations.
///
/// An error is a fault of grafc: the program breaks a promise of [`Program`] or is too deeply nested to be written.
pub fn emit(program: &Program, options: &Options) -> Result<(String, String), Diagnostics> {
    write(program, options, false).map(|((module, _), types)| (module, types))
}

/// The same, and which lines of the module come from what, if that is wanted.
fn write(program: &Program, options: &Options, traced: bool) -> Result<((String, Lines), String), Diagnostics> {
    limits::check(program)?;
    let names = Names::new(program);
    let mut places = Places::new(program, &names);
    places.origins = traced.then(|| program.origins());
    let expressions = Expressions::new(&places);
    let mut out = Writer::new(&writer::JS).traced(traced);
    head(&mut out, program, options);
    tables::write(&mut out, program, &places);
    memory::write(&mut out, program, &places);
    scan::write(&mut out, program, &places, &expressions);
    runtime::write(&mut out, program, &places);
    class::write(&mut out, program, &names, &places);
    Ok((out.finish_traced(), types::write(program, &names, options)))
}

/// Whether a program shows all that is to be seen of it.
fn shows_all(program: &Program) -> bool {
    program.observing.as_ref().is_some_and(|observing| observing.observed == Observed::All)
}

fn head(out: &mut Writer, program: &Program, options: &Options) {
    let about = program.comment.as_deref().map(comment).filter(|text| !text.is_empty());
    let name = comment(&program.name);
    out.comment(&about.map_or(name.clone(), |about| format!("{name}: {about}")));
    if !options.header.is_empty() {
        out.line("//");
    }
    for line in &options.header {
        out.comment(&comment(line));
    }
    out.blank();
}
