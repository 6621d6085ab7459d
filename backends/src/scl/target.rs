//! Siemens SCL as a target.

use super::Options;
use crate::choice::{Choice, Chosen, Refusal};
use crate::output::{Output, Source};
use grafc_diagnostics::Diagnostics;

pub(crate) const NAME: &str = "scl";
pub(crate) const TITLE: &str = "Siemens SCL, a source file for TIA Portal";
pub(crate) const EXTENSION: &str = "scl";
pub(crate) const BESIDE: &[(&str, &str)] = &[];
pub(crate) const MAPPED: bool = true;
/// The form leaves no choice.
pub(crate) const CHOICES: &[&Choice] = &[];

pub(crate) fn options(_: &Chosen) -> Result<Options, Refusal> {
    Ok(Options::default())
}

pub(crate) fn spelled(_: &Options) -> String {
    String::new()
}

pub(crate) fn emit(source: &mut dyn Source, options: &Options) -> Result<Output, Diagnostics> {
    let wants_map = source.wants_map();
    let program = source.program()?;
    super::write(program, options, wants_map).map(|written| Output::mapped(program, wants_map, written))
}
