//! Arguments that several commands have.

use crate::report::{Failure, Format, Messages};
use clap::{Args, ValueEnum};
use grafc_diagnostics::{Code, Policy, Severity};
use grafc_model::chart::ControlNames;
use grafc_model::reaction::{Asked, Evolution, LivelockOutputs, Profile};

/// How messages are told.
#[derive(Args, Debug)]
pub struct MessageArguments {
    /// The form of messages
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
    #[command(flatten)]
    quiet: QuietArgument,
    #[command(flatten)]
    warnings: WarningArguments,
}

impl MessageArguments {
    /// The choices as a report takes them.
    pub fn messages(&self) -> Messages {
        self.quiet.messages(self.format)
    }

    /// What is done with warnings.
    pub fn policy(&self) -> Result<Policy, Failure> {
        self.warnings.policy()
    }
}

/// Whether warnings are told, of a command that has a form of its own.
#[derive(Args, Debug)]
pub struct QuietArgument {
    /// Tell errors alone: no warnings, no counts, nothing of what was done
    #[arg(short, long)]
    pub quiet: bool,
}

impl QuietArgument {
    /// Messages of a form, all of them or errors alone.
    pub fn messages(&self, format: Format) -> Messages {
        Messages { format, quiet: self.quiet }
    }
}

/// Asked that change what a chart means.
#[derive(Args, Debug)]
pub struct ProfileArguments {
    /// Evolve to a stable situation at each call, or by one step a scan as SFC does [default: as the chart's heading says, else stable]
    #[arg(long, value_enum, value_name = "EVOLUTION")]
    evolution: Option<EvolutionName>,
    /// Whether initial steps do their actions on activation at the start [default: as the chart's heading says, else on]
    #[arg(long, value_enum, value_name = "SWITCH")]
    initial_actions: Option<Switch>,
    /// Give up after so many evolutions in one call; `auto`: after as many as are known to be enough [default: as the chart's heading says, else the larger of 200 and steps + transitions + 1]
    #[arg(long, value_name = "K|auto", value_parser = bound)]
    bound: Option<Bound>,
    /// What outputs of steps do in a call that was given up [default: computed]
    #[arg(long, value_enum, value_name = "OUTPUTS")]
    livelock_outputs: Option<LivelockOutputsName>,
}

/// A bound on micro-steps.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Bound {
    /// So many.
    Number(u32),
    /// As many as are known to be enough.
    Auto,
}

fn bound(text: &str) -> Result<Bound, String> {
    if text == "auto" {
        return Ok(Bound::Auto);
    }
    let number = text.parse().ok().filter(|number| (1..=Profile::LARGEST_BOUND).contains(number));
    number.map(Bound::Number).ok_or_else(|| format!("`auto`, or a number from 1 to {}", Profile::LARGEST_BOUND))
}

impl ProfileArguments {
    /// What is asked for; the rest is as the chart says.
    ///
    /// # Errors
    /// A choice about calls that are given up, where each call is one evolution and none is.
    pub fn asked(&self) -> Result<Asked, Failure> {
        let given_up = [("bound", self.bound.is_some()), ("livelock-outputs", self.livelock_outputs.is_some())];
        if self.evolution == Some(EvolutionName::Scan)
            && let Some((name, _)) = given_up.into_iter().find(|(_, is_chosen)| *is_chosen)
        {
            let what = format!("with `--evolution scan` no call is given up, so `--{name}` would do nothing");
            return Err(Failure::WrongUse(what, "leave one of the two out".to_string()));
        }
        Ok(Asked {
            evolution: self.evolution.map(|evolution| match evolution {
                EvolutionName::Stable => Evolution::Stable,
                EvolutionName::Scan => Evolution::Scan,
            }),
            initial_actions: self.initial_actions.map(|switch| match switch {
                Switch::On => true,
                Switch::Off => false,
            }),
            bound: match self.bound {
                Some(Bound::Number(number)) => Some(number),
                Some(Bound::Auto) | None => None,
            },
            bound_as_known: self.bound_as_known(),
            livelock_outputs: self.livelock_outputs.map(|outputs| match outputs {
                LivelockOutputsName::Computed => LivelockOutputs::Computed,
                LivelockOutputsName::Hold => LivelockOutputs::Hold,
                LivelockOutputsName::Off => LivelockOutputs::Off,
            }),
        })
    }

    /// Whether the bound is the one that is known to be enough.
    pub fn bound_as_known(&self) -> bool {
        self.bound == Some(Bound::Auto)
    }
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum EvolutionName {
    Stable,
    Scan,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum LivelockOutputsName {
    /// What the situation says that was reached
    Computed,
    /// What they did after the call before
    Hold,
    /// They are off
    Off,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum Switch {
    On,
    Off,
}

/// Inputs that act on the chart as a whole.
#[derive(Args, Debug)]
pub struct ControlArguments {
    /// An input of this name beside those of the chart: while it is true, the chart starts anew
    #[arg(long, value_name = "NAME", value_parser = control_name)]
    reset_input: Option<String>,
    /// Such a reset leaves retained variables as they are
    #[arg(long, requires = "reset_input")]
    reset_keeps_retained: bool,
    /// An input of this name beside those of the chart: while it is true, flags are lowered
    #[arg(long, value_name = "NAME", value_parser = control_name)]
    clear_flags_input: Option<String>,
    /// An output `ASSERTION` beside those of the chart: the number of the first assertion that was false
    #[arg(long)]
    check_assertions: bool,
}

impl ControlArguments {
    /// The names as the stages take them.
    pub fn names(&self) -> ControlNames {
        ControlNames {
            reset: self.reset_input.as_deref().map(Into::into),
            reset_keeps_retained: self.reset_keeps_retained,
            clear_flags: self.clear_flags_input.as_deref().map(Into::into),
            check_assertions: self.check_assertions,
        }
    }
}

/// A name as a chart could declare it, with or without backquotes.
fn control_name(text: &str) -> Result<String, String> {
    let bare = text.strip_prefix('`').and_then(|rest| rest.strip_suffix('`')).unwrap_or(text);
    if bare.trim() != bare || bare.is_empty() || bare.contains(|c: char| c == '`' || c.is_control()) {
        return Err("this is no name that a chart could declare".to_string());
    }
    Ok(bare.to_string())
}

/// What is done with warnings.
#[derive(Args, Debug)]
struct WarningArguments {
    /// Take a warning for an error: a code such as W0409, or `warnings` for all
    #[arg(short = 'D', long, value_name = "CODE", value_delimiter = ',')]
    deny: Vec<String>,
    /// Do not tell a warning, and do not take it for an error
    #[arg(long, value_name = "CODE", value_delimiter = ',')]
    allow: Vec<String>,
}

impl WarningArguments {
    fn policy(&self) -> Result<Policy, Failure> {
        let mut policy = Policy::default();
        for asked in &self.deny {
            match asked.as_str() {
                "warnings" => policy.deny_all = true,
                asked => _ = policy.deny.insert(warning(asked)?),
            }
        }
        for asked in &self.allow {
            policy.allow.insert(warning(asked)?);
        }
        match policy.allow.intersection(&policy.deny).next() {
            None => Ok(policy),
            Some(code) => Err(Failure::WrongUse(
                format!("`{}` is both denied and allowed", code.as_str()),
                "leave one of the two out".to_string(),
            )),
        }
    }
}

/// The warning of a code or name.
fn warning(asked: &str) -> Result<Code, Failure> {
    let what = match Code::find(asked.trim()) {
        Some(code) if code.severity() == Severity::Warning => return Ok(code),
        Some(code) => format!("`{}` is an error in any case", code.as_str()),
        None => format!("no warning has the code `{asked}`"),
    };
    Err(Failure::WrongUse(what, "name a warning, as messages show it: `W0409`; `-D warnings` means all".to_string()))
}

/// Milliseconds between two calls.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Period(pub i64);

/// `20ms`, `0.5s`, `1min`.
pub fn period(text: &str) -> Result<Period, String> {
    let digits = text.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(text.len());
    let (number, unit) = text.split_at(digits);
    let factor = match unit {
        "ms" => 1.0,
        "s" => 1_000.0,
        "min" | "m" => 60_000.0,
        "h" => 3_600_000.0,
        _ => return Err("a period has a unit: `20ms`, `1s`".into()),
    };
    let ms = number.parse::<f64>().map_err(|_| "a period begins with a number: `20ms`")? * factor;
    if ms > f64::from(i32::MAX) {
        Err(format!("a period is at most {}ms", i32::MAX))
    } else if ms >= 1.0 && ms.fract() == 0.0 {
        Ok(Period(ms as i64))
    } else {
        Err("a period is whole milliseconds, at least 1ms".into())
    }
}

/// A choice as it would be written on the command line.
pub(crate) fn option(name: &str, value: impl ValueEnum) -> String {
    let value = value.to_possible_value();
    format!("--{name} {}", value.as_ref().map_or("", |value| value.get_name()))
}
