//! C as a target.

use super::{Files, Options, Pins};
use crate::choice::{Choice, Chosen, Refusal, Values};
use crate::output::{Output, Source};
use grafc_diagnostics::Diagnostics;

pub(crate) const NAME: &str = "c";
pub(crate) const TITLE: &str = "C99, without library and heap, with a header beside it";
pub(crate) const EXTENSION: &str = "c";
pub(crate) const BESIDE: &[(&str, &str)] = &[("c", "h")];
pub(crate) const MAPPED: bool = true;
pub(crate) const CHOICES: &[&Choice] = &[&SINGLE, &ARDUINO, &PINS];

static SINGLE: Choice = Choice {
    name: "single",
    formerly: None,
    placeholder: "",
    about: "one file, which needs no header",
    default: "",
    values: Values::Flag,
};

static ARDUINO: Choice = Choice {
    name: "arduino",
    formerly: None,
    placeholder: "",
    about: "one file, which is a sketch of Arduino: NAME/NAME.ino",
    default: "",
    values: Values::Flag,
};

static PINS: Choice = Choice {
    name: "pins",
    formerly: None,
    placeholder: "FILE",
    about: "with `--arduino`: the pin of each variable, lines `lamp = 13`; else those of their addresses",
    default: "",
    values: Values::File,
};

pub(crate) fn options(chosen: &Chosen) -> Result<Options, Refusal> {
    let pins = match chosen.file(&PINS) {
        Some((file, text)) => Some(Pins::parse(file, text).map_err(|said| {
            Refusal::new(
                format!("the pins in `{file}` cannot be read: {said}"),
                "a line says `lamp = 13`, with `pullup` and `inverted` behind it where that is so",
            )
        })?),
        None => None,
    };
    let files = match (chosen.is_set(&ARDUINO), pins) {
        (true, pins) => Files::Sketch(pins.unwrap_or_default()),
        (false, Some(_)) => {
            return Err(Refusal::new("`--pins` is of no effect without `--arduino`", "add `--arduino`"));
        }
        (false, None) if chosen.is_set(&SINGLE) => Files::One,
        (false, None) => Files::Two,
    };
    Ok(Options { files, ..Options::default() })
}

pub(crate) fn spelled(options: &Options) -> String {
    match &options.files {
        Files::Two => String::new(),
        Files::One => "--single".to_owned(),
        Files::Sketch(pins) if pins.file.is_empty() => "--single --arduino".to_owned(),
        Files::Sketch(pins) => format!("--single --arduino --pins {}", pins.file),
    }
}

pub(crate) fn emit(source: &mut dyn Source, options: &Options) -> Result<Output, Diagnostics> {
    let wants_map = source.wants_map();
    let program = source.saved_program()?;
    let (written, header) = super::write(program, options, wants_map)?;
    let mut output = Output::mapped(program, wants_map, written);
    output.beside = header;
    Ok(output)
}
