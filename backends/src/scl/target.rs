//! Siemens SCL as a target.

use super::Options;
pub(crate) use crate::choice::none::{CHOICES, options, spelled};
use crate::output::{Output, Source};
use grafc_diagnostics::Diagnostics;

pub(crate) const NAME: &str = "scl";
pub(crate) const TITLE: &str = "Siemens SCL, a source file for TIA Portal";
pub(crate) const EXTENSION: &str = "scl";
pub(crate) const BESIDE: &[(&str, &str)] = &[];
pub(crate) const MAPPED: bool = true;

pub(crate) fn emit(source: &mut dyn Source, options: &Options) -> Result<Output, Diagnostics> {
    let wants_map = source.wants_map();
    let program = source.program()?;
    super::write(program, options, wants_map).map(|written| Output::mapped(program, wants_map, written))
}
