//! JavaScript as a target.

use super::Options;
pub(crate) use crate::choice::none::{CHOICES, options, spelled};
use crate::output::{Output, Source};
use grafc_diagnostics::Diagnostics;

pub(crate) const NAME: &str = "js";
pub(crate) const TITLE: &str = "An ECMAScript module, with the types of TypeScript beside it";
pub(crate) const EXTENSION: &str = "js";
pub(crate) const BESIDE: &[(&str, &str)] = &[("js", "d.ts"), ("mjs", "d.mts")];
pub(crate) const MAPPED: bool = true;

pub(crate) fn emit(source: &mut dyn Source, options: &Options) -> Result<Output, Diagnostics> {
    let wants_map = source.wants_map();
    let program = source.observed_program(options.shown())?;
    let (written, types) = super::write(program, options, wants_map)?;
    let mut output = Output::mapped(program, wants_map, written);
    output.beside = Some(types);
    Ok(output)
}
