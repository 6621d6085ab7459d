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
//! `names` and `places` say what everything is called and where it lies, `floats` what real numbers need of a compiler. In a
//! sketch of Arduino (`sketch`) all of it is one file, with the pins of the board around it (`pins`, `wiring`).

mod chart;
mod expressions;
mod floats;
mod header;
mod literals;
mod names;
mod pins;
mod places;
mod runtime;
mod saved;
mod scan;
mod sketch;
mod statements;
pub(crate) mod target;
mod text;
mod wiring;

use crate::limits;
use crate::lines::Lines;
use crate::writer::{self, Writer};
use expressions::Expressions;
use grafc_diagnostics::Diagnostics;
use grafc_logic::scan::Program;
pub use literals::type_name;
pub use names::CNames;
pub use pins::{Pin, Pins};
use places::Places;
use sketch::Sketch;
use text::comment;

/// What the caller may choose.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Options {
    /// The first lines of the file, as a comment: which chart, which version, which options.
    pub header: Vec<String>,
    /// Which files there are.
    pub files: Files,
    /// The name of the header, as the source includes it; without one there is no header, and the source holds all.
    pub include: Option<String>,
}

/// The files that are written.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub enum Files {
    /// A source and its header, if that has a name.
    #[default]
    Two,
    /// One.
    One,
    /// A sketch of Arduino, with the pins that are not those of addresses.
    Sketch(Pins),
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
    let sketch = match &options.files {
        Files::Sketch(pins) => Some(Sketch::new(program, &names, pins)?),
        Files::Two | Files::One => None,
    };
    let [places, given_back] = [false, true].map(|restoring| {
        let mut places = Places::new(program, &names, restoring);
        places.origins = traced.then(|| program.origins());
        places
    });
    let expressions = Expressions::new(&places, false);
    let restoring = Expressions::new(&given_back, true);
    let kept = scan::kept(program, &restoring);
    let writer = || Writer::new(&writer::C).traced(traced);
    let mut interface = writer();
    header::write(&mut interface, program, &names, &kept);
    let mut body = writer();
    scan::write(&mut body, &places, &expressions, &kept);
    scan::write_restoring(&mut body, &given_back, &restoring);
    chart::write(&mut body, program, &places, &expressions, &kept);
    saved::write(&mut body, &given_back, &kept);
    let mut source = writer();
    head(&mut source, program, options);
    let include = options.include.as_ref().filter(|_| options.files == Files::Two);
    let header = match include {
        Some(name) => {
            let mut header = writer();
            head(&mut header, program, options);
            header.append(interface);
            source.line(&format!("#include \"{name}\""));
            Some(header.finish())
        }
        None => {
            if let Some(sketch) = &sketch {
                sketch.head(&mut source);
                source.blank();
            }
            source.append(interface);
            None
        }
    };
    floats::write(&mut source, program);
    runtime::write(&mut source, body.written(), &names);
    source.blank();
    source.append(body);
    if let Some(sketch) = &sketch {
        sketch.tail(&mut source);
    }
    Ok((source.finish_traced(), header))
}

fn head(out: &mut Writer, program: &Program, options: &Options) {
    let about = program.comment.as_deref().map(comment).filter(|text| !text.is_empty());
    let name = comment(&program.name);
    let about = about.map_or(name.clone(), |about| format!("{name}: {about}"));
    out.block_comment(std::iter::once(about).chain(options.header.iter().map(|line| comment(line))));
    out.blank();
}
