//! What the textual languages of IEC 61131-3 leave to choose.

use super::{Options, Pou};
use crate::choice::{Choice, Chosen, Named, Refusal, Values, names};

/// What is written around the function block.
pub(crate) static POU: Choice = Choice {
    name: "pou",
    formerly: None,
    placeholder: "KIND",
    about: "the kind of program organisation unit to make",
    default: "function-block",
    values: Values::Names(names::<Pou>),
};

/// How often the task of a configuration runs.
pub(crate) static TASK_INTERVAL: Choice = Choice {
    name: "task-interval",
    formerly: Some("interval"),
    placeholder: "DURATION",
    about: "how often the task of the configuration runs, such as 20ms or 1s",
    default: "20ms",
    values: Values::Interval,
};

impl Named for Pou {
    const ALL: &'static [Pou] = &[Pou::FunctionBlock, Pou::Program, Pou::Configuration];

    fn name(self) -> &'static str {
        match self {
            Pou::FunctionBlock => "function-block",
            Pou::Program => "program",
            Pou::Configuration => "configuration",
        }
    }

    fn about(self) -> &'static str {
        match self {
            Pou::FunctionBlock => "A function block to be called from a program",
            Pou::Program => "A program",
            Pou::Configuration => "A program with a configuration and a task to run it",
        }
    }
}

/// The options of a language that stands for itself.
pub(crate) fn options(chosen: &Chosen) -> Result<Options, Refusal> {
    let usual = Options::default();
    let pou = chosen.named(&POU).unwrap_or(usual.pou);
    let interval = chosen.number(&TASK_INTERVAL);
    if interval.is_some() && pou != Pou::Configuration {
        return Err(Refusal::new(
            "`--task-interval` is the interval of a configuration's task",
            "add `--pou configuration`, or leave it out",
        ));
    }
    Ok(Options { pou, interval_ms: interval.unwrap_or(usual.interval_ms), ..usual })
}

/// The options as a command line would say them.
pub(crate) fn spelled(options: &Options) -> String {
    let pou = options.pou.name();
    match options.pou {
        Pou::FunctionBlock | Pou::Program => format!("--pou {pou}"),
        Pou::Configuration => format!("--pou {pou} --task-interval {}ms", options.interval_ms),
    }
}
