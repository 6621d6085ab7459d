//! Rust as a target.

use super::{Options, Runtime};
use crate::choice::{Choice, Chosen, Named, Refusal, Values, names};
use crate::output::{Output, Source};
use grafc_diagnostics::Diagnostics;

pub(crate) const NAME: &str = "rust";
pub(crate) const TITLE: &str = "A Rust module, without std and allocation";
pub(crate) const EXTENSION: &str = "rs";
pub(crate) const BESIDE: &[(&str, &str)] = &[];
pub(crate) const MAPPED: bool = true;
pub(crate) const CHOICES: &[&Choice] = &[&RUNTIME];

static RUNTIME: Choice = Choice {
    name: "runtime",
    formerly: None,
    placeholder: "RUNTIME",
    about: "where the code gets what it needs at run time",
    default: "inline",
    values: Values::Names(names::<Runtime>),
};

impl Named for Runtime {
    const ALL: &'static [Runtime] = &[Runtime::Inline, Runtime::Crate];

    fn name(self) -> &'static str {
        match self {
            Runtime::Inline => "inline",
            Runtime::Crate => "crate",
        }
    }

    fn about(self) -> &'static str {
        match self {
            Runtime::Inline => "From itself: the module stands alone",
            Runtime::Crate => "From the crate `grafc-runtime`, whose trait `Chart` it implements",
        }
    }
}

pub(crate) fn options(chosen: &Chosen) -> Result<Options, Refusal> {
    let usual = Options::default();
    Ok(Options { runtime: chosen.named(&RUNTIME).unwrap_or(usual.runtime), ..usual })
}

pub(crate) fn spelled(options: &Options) -> String {
    format!("--runtime {}", options.runtime.name())
}

pub(crate) fn emit(source: &mut dyn Source, options: &Options) -> Result<Output, Diagnostics> {
    let wants_map = source.wants_map();
    let program = source.saved_program()?;
    super::write(program, options, wants_map).map(|written| Output::mapped(program, wants_map, written))
}
