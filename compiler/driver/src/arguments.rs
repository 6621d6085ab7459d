//! Arguments that several commands have.

use crate::report::{Format, Messages};
use clap::{Args, ValueEnum};
use grafc_model::reaction::{Evolution, Profile};

/// How messages are told.
#[derive(Args, Debug)]
pub struct MessageArguments {
    /// The form of messages
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
    #[command(flatten)]
    quiet: QuietArgument,
}

impl MessageArguments {
    /// The choices as a report takes them.
    pub fn messages(&self) -> Messages {
        self.quiet.messages(self.format)
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

/// Choices that change what a chart means.
#[derive(Args, Debug)]
pub struct ProfileArguments {
    /// Evolve to a stable situation at each call, or by one step a scan as SFC does
    #[arg(long, value_enum, default_value_t = EvolutionName::Stable, value_name = "EVOLUTION")]
    evolution: EvolutionName,
    /// Whether initial steps do their actions on activation at the start
    #[arg(long, value_enum, default_value_t = Switch::On, value_name = "SWITCH")]
    initial_actions: Switch,
    /// Give up after so many evolutions in one call [default: the larger of 200 and steps + transitions + 1]
    #[arg(long, value_name = "K", value_parser = clap::value_parser!(u32).range(1..))]
    bound: Option<u32>,
}

impl ProfileArguments {
    /// The choices as the stages take them.
    pub fn profile(&self) -> Profile {
        Profile {
            evolution: match self.evolution {
                EvolutionName::Stable => Evolution::Stable,
                EvolutionName::Scan => Evolution::Scan,
            },
            initial_actions: match self.initial_actions {
                Switch::On => true,
                Switch::Off => false,
            },
            bound: self.bound,
        }
    }
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum EvolutionName {
    Stable,
    Scan,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum Switch {
    On,
    Off,
}

/// A choice as it would be written on the command line.
pub(crate) fn option(name: &str, value: impl ValueEnum) -> String {
    let value = value.to_possible_value();
    format!("--{name} {}", value.as_ref().map_or("", |value| value.get_name()))
}
