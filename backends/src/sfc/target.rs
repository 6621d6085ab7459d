//! Sequential function charts in text as a target.

use super::Options;
use crate::choice::{Choice, Chosen, Refusal};
use crate::iec::choices::{self, POU, TASK_INTERVAL};
use crate::output::{Output, Source};
use grafc_diagnostics::Diagnostics;

pub(crate) const NAME: &str = "sfc";
pub(crate) const TITLE: &str = "An IEC 61131-3 sequential function chart in text, if the chart can be one";
pub(crate) const EXTENSION: &str = "sfc";
pub(crate) const BESIDE: &[(&str, &str)] = &[];
pub(crate) const MAPPED: bool = false;
pub(crate) const CHOICES: &[&Choice] = &[&POU, &TASK_INTERVAL];

pub(crate) fn options(chosen: &Chosen) -> Result<Options, Refusal> {
    choices::options(chosen)
}

pub(crate) fn spelled(options: &Options) -> String {
    choices::spelled(options)
}

pub(crate) fn emit(source: &mut dyn Source, options: &Options) -> Result<Output, Diagnostics> {
    super::emit(source.sequence()?, options).map(Output::from)
}
