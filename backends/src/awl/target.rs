//! Siemens STL as a target.

use super::{Mnemonics, Options};
use crate::choice::{Choice, Chosen, Named, Refusal, Values, names};
use crate::iec::Pou;
use crate::iec::choices::POU;
use crate::output::{Output, Source};
use grafc_diagnostics::Diagnostics;

pub(crate) const NAME: &str = "awl";
pub(crate) const TITLE: &str = "Siemens STL (AWL), a source file for STEP 7: S7-300, S7-400";
pub(crate) const EXTENSION: &str = "awl";
pub(crate) const BESIDE: &[(&str, &str)] = &[];
pub(crate) const MAPPED: bool = true;
pub(crate) const CHOICES: &[&Choice] = &[&POU, &BLOCK_NUMBER, &MNEMONICS];

static BLOCK_NUMBER: Choice = Choice {
    name: "block-number",
    formerly: None,
    placeholder: "NUMBER",
    about: "the number of the function block and of its data block",
    default: "1",
    values: Values::Number(1, u16::MAX as u32),
};

static MNEMONICS: Choice = Choice {
    name: "mnemonics",
    formerly: None,
    placeholder: "LANGUAGE",
    about: "the language of the instructions",
    default: "english",
    values: Values::Names(names::<Mnemonics>),
};

impl Named for Mnemonics {
    const ALL: &'static [Mnemonics] = &[Mnemonics::English, Mnemonics::German];

    fn name(self) -> &'static str {
        match self {
            Mnemonics::English => "english",
            Mnemonics::German => "german",
        }
    }

    fn about(self) -> &'static str {
        match self {
            Mnemonics::English => "`A I 0.0`",
            Mnemonics::German => "`U E 0.0`",
        }
    }
}

pub(crate) fn options(chosen: &Chosen) -> Result<Options, Refusal> {
    let usual = Options::default();
    let organization_block = match chosen.named(&POU) {
        None => usual.organization_block,
        Some(Pou::FunctionBlock) => false,
        Some(Pou::Program) => true,
        Some(Pou::Configuration) => {
            return Err(Refusal::new(
                "STEP 7 has no configurations",
                "`--pou program` writes an OB 1, which the CPU runs in each cycle",
            ));
        }
    };
    let number = chosen.number(&BLOCK_NUMBER).and_then(|number| u16::try_from(number).ok()).unwrap_or(usual.number);
    let mnemonics = chosen.named(&MNEMONICS).unwrap_or(usual.mnemonics);
    Ok(Options { organization_block, number, mnemonics, ..usual })
}

pub(crate) fn spelled(options: &Options) -> String {
    let pou = if options.organization_block { Pou::Program } else { Pou::FunctionBlock }.name();
    format!("--pou {pou} --block-number {} --mnemonics {}", options.number, options.mnemonics.name())
}

pub(crate) fn emit(source: &mut dyn Source, options: &Options) -> Result<Output, Diagnostics> {
    let wants_map = source.wants_map();
    let program = source.program()?;
    super::write(program, options, wants_map).map(|written| Output::mapped(program, wants_map, written))
}
