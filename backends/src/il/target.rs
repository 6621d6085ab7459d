//! Instruction lists as a target.

use super::Options;
use crate::choice::{Choice, Chosen, Refusal};
use crate::iec::choices::{self, POU, TASK_INTERVAL};
use crate::output::{Output, Source};
use grafc_diagnostics::Diagnostics;

pub(crate) const NAME: &str = "il";
pub(crate) const TITLE: &str = "IEC 61131-3 instruction list";
pub(crate) const EXTENSION: &str = "il";
pub(crate) const BESIDE: &[(&str, &str)] = &[];
pub(crate) const MAPPED: bool = true;
pub(crate) const CHOICES: &[&Choice] = &[&POU, &TASK_INTERVAL];

pub(crate) fn options(chosen: &Chosen) -> Result<Options, Refusal> {
    choices::options(chosen)
}

pub(crate) fn spelled(options: &Options) -> String {
    choices::spelled(options)
}

pub(crate) fn emit(source: &mut dyn Source, options: &Options) -> Result<Output, Diagnostics> {
    let wants_map = source.wants_map();
    let program = source.program()?;
    super::write(program, options, wants_map).map(|written| Output::mapped(program, wants_map, written))
}
