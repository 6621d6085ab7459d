//! C99: a source and its header, without library, heap or recursion. Numbers wrap around by unsigned arithmetic, so that
//! nothing is undefined.
//!
//! ```text
//! lamp.h   Lamp_inputs, Lamp_outputs …, Lamp      what a program around the chart sees       header
//! lamp.c   add_int, delay_run …                   what it needs at run time                  runtime
//!          Lamp_init, Lamp_is_active …            what can be done with a chart              chart
//!          Lamp_scan                              the statements of the scan program         scan, statements, expressions
//!          Lamp_save, Lamp_restore                its memory as bytes                        saved
//! ```
//!
//! `names` and `places` say what everything is called and where it lies.

mod chart;
mod expressions;
mod header;
mod literals;
mod names;
mod places;
mod runtime;
mod saved;
mod scan;
mod statements;
pub(crate) mod target;
mod text;

use crate::limits;
use crate::lines::Lines;
use crate::writer::{self, Writer};
use expressions::Expressions;
use grafc_diagnostics::Diagnostics;
use grafc_logic::scan::Program;
pub use literals::type_name;
pub use names::CNames;
use places::Places;
use text::comment;

/// What the caller may choose.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Options {
    /// The first lines of the file, as a comment: which chart, which version, which options.
    pub header: Vec<String>,
    /// The name of the header, as the source includes it; without one there is no header, and the source holds all.
    pub include: Option<String>,
}

/// Writes a program, which saves its memory, as a source, and its header if that has a name.
///
/// An error is a fault of grafc: the program breaks a promise of [`Program`] or is too deeply nested to be written.
pub fn emit(program: &Program, options: &Options) -> Result<(String, Option<String>), Diagnostics> {
    write(program, options, false).map(|((source, _), header)| (source, header))
}

/// The names that its code gives to what a program declares.
pub fn names(program: &Program) -> CNames {
    CNames::new(program)
}

/// The same, and which lines of the source come from what, if that is wanted.
fn write(program: &Program, options: &Options, traced: bool) -> Result<((String, Lines), Option<String>), Diagnostics> {
    limits::check(program)?;
    let names = CNames::new(program);
    let mut places = Places::new(program, &names);
    places.origins = traced.then(|| program.origins());
    let expressions = Expressions::new(&places);
    let writer = || Writer::new(&writer::C).traced(traced);
    let mut interface = writer();
    head(&mut interface, program, options);
    header::write(&mut interface, program, &names);
    let mut body = writer();
    scan::write(&mut body, &places, &expressions);
    chart::write(&mut body, program, &places, &expressions);
    saved::write(&mut body, program, &places);
    let mut source = writer();
    let header = match &options.include {
        Some(name) => {
            head(&mut source, program, options);
            source.line(&format!("#include \"{name}\""));
            Some(interface.finish())
        }
        None => {
            source.append(interface);
            None
        }
    };
    runtime::write(&mut source, body.written(), &names);
    source.blank();
    source.append(body);
    Ok((source.finish_traced(), header))
}

fn head(out: &mut Writer, program: &Program, options: &Options) {
    let about = program.comment.as_deref().map(comment).filter(|text| !text.is_empty());
    let name = comment(&program.name);
    let about = about.map_or(name.clone(), |about| format!("{name}: {about}"));
    out.block_comment(std::iter::once(about).chain(options.header.iter().map(|line| comment(line))));
    out.blank();
}
