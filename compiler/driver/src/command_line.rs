//! What can be asked of grafc.

use crate::commands::{check, compile, completions, explain, fmt, import, man, sim, stats};
use clap::error::ErrorKind;
use clap::{CommandFactory, Parser, Subcommand};
use std::ffi::OsString;
use std::path::Path;

const AFTER_HELP: &str = "\
Example:
  grafc valve.gct --target st -o valve.st
  grafc valve.gct --emit net

Exit codes: 0 done, 1 the chart has errors, 2 wrong use, 3 a file cannot be read or written.
A chart that is named like a command is given as `./check`; `-` is standard input or output.";

/// Compile GRAFCET charts (IEC 60848) to IEC 61131-3 code
#[derive(Parser, Debug)]
#[command(name = "grafc", version, after_help = AFTER_HELP)]
#[command(args_conflicts_with_subcommands = true, subcommand_negates_reqs = true, arg_required_else_help = true)]
pub struct CommandLine {
    /// A command other than to compile.
    #[command(subcommand)]
    pub command: Option<Command>,
    /// Without a command: compile.
    #[command(flatten)]
    pub compile: compile::Arguments,
}

impl CommandLine {
    /// What was asked for; the error is help, the version, or what is wrong with the arguments.
    pub fn from_arguments(arguments: impl IntoIterator<Item = OsString>) -> Result<CommandLine, clap::Error> {
        let arguments: Vec<OsString> = arguments.into_iter().collect();
        CommandLine::try_parse_from(&arguments).map_err(|error| match error.kind() {
            ErrorKind::ArgumentConflict | ErrorKind::MissingRequiredArgument => {
                misspelt_command(&arguments).unwrap_or(error)
            }
            _ => error,
        })
    }
}

/// A misspelt command looks like a chart; if there is no such chart, say what was probably meant.
fn misspelt_command(arguments: &[OsString]) -> Option<clap::Error> {
    let mut root = CommandLine::command();
    let first = arguments.get(1)?.to_str()?;
    let near = root.get_subcommands().map(|command| command.get_name().to_string());
    let near = near.filter(|name| name != first).find(|name| strsim::jaro_winkler(name, first) > 0.85)?;
    if Path::new(first).exists() {
        return None;
    }
    let message = format!("unrecognized command '{first}'\n\n  tip: a similar command exists: '{near}'");
    Some(root.error(ErrorKind::InvalidSubcommand, message))
}

/// The commands other than to compile.
#[derive(Subcommand, Debug)]
pub enum Command {
    /// Report all errors and warnings of charts
    Check(check::Arguments),
    /// Run a chart over a trace of its inputs with the reference simulator
    Sim(sim::Arguments),
    /// Measure what a chart takes in each encoding
    Stats(stats::Arguments),
    /// Bring charts into the canonical format
    Fmt(fmt::Arguments),
    /// Convert another tool's file to a chart, and report what was changed or lost
    Import(import::Arguments),
    /// Print the page on a diagnostic code
    Explain(explain::Arguments),
    /// Print a completion script for a shell
    Completions(completions::Arguments),
    /// Print the manual page in roff
    Man(man::Arguments),
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_command_line_is_consistent() {
        CommandLine::command().debug_assert();
    }

    #[test]
    fn every_command_has_an_example_and_one_sentence() {
        let mut root = CommandLine::command();
        root.build();
        for command in std::iter::once(&root).chain(root.get_subcommands()).filter(|c| c.get_name() != "help") {
            let name = command.get_name();
            let about = command.get_about().map(ToString::to_string).unwrap_or_default();
            assert!(!about.is_empty() && !about.contains(". ") && !about.ends_with('.'), "{name}: {about}");
            let after = command.get_after_help().map(ToString::to_string).unwrap_or_default();
            assert!(after.contains("Example:\n  grafc"), "{name}: {after}");
        }
    }
}
