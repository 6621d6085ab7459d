//! PLCopen XML as a target.

use super::{Body, Dialect, Options, ld, sfc};
use crate::choice::{Choice, Chosen, Named, Refusal, Values, names};
use crate::iec::choices::TASK_INTERVAL;
use crate::output::{Output, Source};
use grafc_diagnostics::Diagnostics;

pub(crate) const NAME: &str = "plcopen";
pub(crate) const TITLE: &str = "A PLCopen XML project: function block, program, configuration";
pub(crate) const EXTENSION: &str = "xml";
pub(crate) const BESIDE: &[(&str, &str)] = &[];
pub(crate) const MAPPED: bool = false;
pub(crate) const CHOICES: &[&Choice] = &[&TASK_INTERVAL, &DIALECT, &BODY];

static DIALECT: Choice = Choice {
    name: "dialect",
    formerly: None,
    placeholder: "DIALECT",
    about: "which tools the project is for",
    default: "neutral",
    values: Values::Names(names::<Dialect>),
};

static BODY: Choice = Choice {
    name: "body",
    formerly: None,
    placeholder: "LANGUAGE",
    about: "what the function block holds",
    default: "st",
    values: Values::Names(names::<Body>),
};

impl Named for Dialect {
    const ALL: &'static [Dialect] = &[Dialect::Neutral, Dialect::Codesys];

    fn name(self) -> &'static str {
        match self {
            Dialect::Neutral => "neutral",
            Dialect::Codesys => "codesys",
        }
    }

    fn about(self) -> &'static str {
        match self {
            Dialect::Neutral => "Beremiz and tools based on it",
            Dialect::Codesys => "CODESYS, TwinCAT and tools based on CODESYS",
        }
    }
}

impl Named for Body {
    const ALL: &'static [Body] = &[Body::St, Body::Il, Body::Ld, Body::Sfc];

    fn name(self) -> &'static str {
        match self {
            Body::St => "st",
            Body::Il => "il",
            Body::Ld => "ld",
            Body::Sfc => "sfc",
        }
    }

    fn about(self) -> &'static str {
        match self {
            Body::St => "Structured Text",
            Body::Il => "Instruction list",
            Body::Ld => "A ladder diagram, of the neutral dialect",
            Body::Sfc => "A sequential function chart, if the chart can be one",
        }
    }
}

pub(crate) fn options(chosen: &Chosen) -> Result<Options, Refusal> {
    let usual = Options::default();
    let dialect = chosen.named(&DIALECT).unwrap_or(usual.dialect);
    let body = chosen.named(&BODY).unwrap_or(usual.body);
    if body == Body::Ld && dialect == Dialect::Codesys {
        return Err(Refusal::new(
            "`--body ld` draws for the readers of `--dialect neutral` alone",
            "take `--body st`, which every dialect has, or leave out `--dialect codesys`",
        ));
    }
    Ok(Options { dialect, body, interval_ms: chosen.number(&TASK_INTERVAL), ..usual })
}

pub(crate) fn spelled(options: &Options) -> String {
    let interval = options.interval_ms.map_or(String::new(), |ms| format!(" --task-interval {ms}ms"));
    format!("--dialect {} --body {}{interval}", options.dialect.name(), options.body.name())
}

pub(crate) fn emit(source: &mut dyn Source, options: &Options) -> Result<Output, Diagnostics> {
    let text = match options.body {
        Body::St => super::emit(source.program()?, options),
        Body::Il => super::emit_il(source.program()?, options),
        Body::Ld => ld::emit(source.program()?, options),
        Body::Sfc => sfc::emit(source.sequence()?, options),
    };
    text.map(Output::from)
}
