//! C as a target.

use super::Options;
pub(crate) use crate::choice::none::{CHOICES, options, spelled};
use crate::output::{Output, Source};
use grafc_diagnostics::Diagnostics;

pub(crate) const NAME: &str = "c";
pub(crate) const TITLE: &str = "C99, without library and heap, with a header beside it";
pub(crate) const EXTENSION: &str = "c";
pub(crate) const BESIDE: &[(&str, &str)] = &[("c", "h")];
pub(crate) const MAPPED: bool = true;

pub(crate) fn emit(source: &mut dyn Source, options: &Options) -> Result<Output, Diagnostics> {
    let wants_map = source.wants_map();
    let program = source.saved_program()?;
    let (written, header) = super::write(program, options, wants_map)?;
    let mut output = Output::mapped(program, wants_map, written);
    output.beside = header;
    Ok(output)
}
