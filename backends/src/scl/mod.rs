//! Siemens SCL for S7-1200 and S7-1500, as an external source file of TIA Portal: the function block and an instance
//! data block of it.
//!
//! The statements are those of the Structured Text. What differs: a block's name stands in quotes, each of its own
//! variables has a `#`, timers are `TON_TIME` and say which instruction they are, comments go to the end of the line,
//! and the file is ASCII. There are no programs and no addresses: an organisation block calls the instance.

pub(crate) mod target;

use crate::comment::clean;
use crate::iec::declarations::{Entry, EntryType, RETAIN, VarBlock, VarKind, VarList, with_temporaries};
use crate::iec::pou_parts::PouParts;
use crate::lines::Lines;
use crate::s7;
use crate::st::{self, Style};
use crate::transliterate::ascii;
use crate::writer::{self, Writer};
use grafc_diagnostics::Diagnostics;
use grafc_formula::Type;
use grafc_logic::scan::{Origin, Program};

/// What the caller may choose.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Options {
    /// Which chart, which version, which options.
    pub header: Vec<String>,
}

/// Writes a program as a source file.
///
/// An error is a time that is too long for S7, or a fault of grafc: the program breaks a promise of [`Program`] or is too
/// deeply nested to be written.
pub fn emit(program: &Program, options: &Options) -> Result<String, Diagnostics> {
    write(program, options, false).map(|(text, _)| text)
}

/// The same, and which lines come from what, if that is wanted.
fn write(program: &Program, options: &Options, traced: bool) -> Result<(String, Lines), Diagnostics> {
    let long = s7::long_times(program, "S7-1200 and S7-1500");
    if long.has_errors() {
        return Err(long);
    }
    let parts = st::parts(program, Style { mark: "#", comments: &writer::SCL, traced })?;
    let mut out = Writer::new(&writer::SCL).traced(traced);
    let parts = PouParts { interface: with_temporaries(parts.interface), ..parts };
    function_block(&mut out, &parts, &options.header);
    out.blank();
    out.line(&format!("DATA_BLOCK \"{0}_DB\" \"{0}\"", parts.block));
    out.line("BEGIN");
    out.line("END_DATA_BLOCK");
    let (text, lines) = out.finish_traced();
    Ok((ascii(&text), lines))
}

fn function_block(out: &mut Writer, parts: &PouParts, header: &[String]) {
    out.line(&format!("FUNCTION_BLOCK \"{}\"", parts.block));
    out.line("{ S7_Optimized_Access := 'TRUE' }");
    out.line("VERSION : 0.1");
    // Constants stand last, as the editor itself writes them.
    let (constants, others): (Vec<&VarBlock>, Vec<&VarBlock>) =
        parts.interface.iter().partition(|block| block.kind == VarKind::Constant);
    for block in others.into_iter().chain(constants) {
        block.lists().for_each(|list| declarations(out, &list));
    }
    out.line("BEGIN");
    out.enter();
    out.block_comment(header.iter().map(|line| clean(line)));
    out.comment(parts.description.as_deref().unwrap_or_default());
    out.blank();
    let origins = parts.lines.by_line(if out.is_traced() { parts.body.lines().count() } else { 0 });
    let mut origins = origins.into_iter();
    for line in parts.body.lines() {
        out.origin(Origin::Chart);
        origins.next().unwrap_or_default().into_iter().for_each(|origin| out.also(origin));
        match line {
            "" => out.blank(),
            line => out.line(line),
        }
    }
    out.origin(Origin::Chart);
    out.leave();
    out.line("END_FUNCTION_BLOCK");
}

fn declarations(out: &mut Writer, list: &VarList) {
    out.open(&list.keyword(RETAIN));
    for (heading, entries) in &list.sections {
        out.origin(Origin::Chart);
        out.comment(heading);
        for entry in entries {
            let text = declaration(entry);
            out.origin(entry.origin);
            out.start();
            out.text(&text);
            if let Some(comment) = &entry.comment {
                out.trailing_comment(0, 0, comment);
            }
            out.end();
        }
    }
    out.origin(Origin::Chart);
    out.close("END_VAR");
}

fn declaration(entry: &Entry) -> String {
    let initial = entry.initial.iter().map(|initial| format!(" := {initial}")).collect::<String>();
    let (instruction, ty) = match &entry.ty {
        EntryType::Elementary(ty) => ("", type_name(*ty)),
        EntryType::Timer => (" {InstructionName := 'TON_TIME'; LibVersion := '1.0'}", "TON_TIME"),
        EntryType::Block(name) => ("", &**name),
    };
    format!("{}{instruction} : {ty}{initial};", entry.name)
}

/// The types as TIA Portal spells them.
fn type_name(ty: Type) -> &'static str {
    match ty {
        Type::Bool => "Bool",
        Type::Int => "Int",
        Type::Dint => "DInt",
        Type::Uint => "UInt",
        Type::Udint => "UDInt",
        Type::Real => "Real",
        Type::Lreal => "LReal",
        Type::Time => "Time",
    }
}
