//! A program organisation unit of TwinCAT as a target.

use super::Options;
pub(crate) use crate::choice::none::{CHOICES, options, spelled};
use crate::output::{Output, Source};
use grafc_diagnostics::Diagnostics;

pub(crate) const NAME: &str = "tcpou";
pub(crate) const TITLE: &str = "A TwinCAT 3 program organisation unit";
pub(crate) const EXTENSION: &str = "TcPOU";
pub(crate) const BESIDE: &[(&str, &str)] = &[];
pub(crate) const MAPPED: bool = false;

pub(crate) fn emit(source: &mut dyn Source, options: &Options) -> Result<Output, Diagnostics> {
    super::emit(source.program()?, options).map(Output::from)
}
