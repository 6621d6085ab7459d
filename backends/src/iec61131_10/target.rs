//! The exchange format of IEC 61131-10 as a target.

use super::Options;
pub(crate) use crate::choice::none::{CHOICES, options, spelled};
use crate::output::{Output, Source};
use grafc_diagnostics::Diagnostics;

pub(crate) const NAME: &str = "iec61131-10";
pub(crate) const TITLE: &str = "The function block in the XML of IEC 61131-10";
pub(crate) const EXTENSION: &str = "xml";
pub(crate) const BESIDE: &[(&str, &str)] = &[];
pub(crate) const MAPPED: bool = false;

pub(crate) fn emit(source: &mut dyn Source, options: &Options) -> Result<Output, Diagnostics> {
    super::emit(source.program()?, options).map(Output::from)
}
