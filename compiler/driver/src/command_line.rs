//! What can be asked of grafc.

use crate::choices;
use crate::commands::{
    automata, check, compile, completions, draw, explain, fmt, generate_tests, graph, import, man, new, page, serve,
    sim, stats, test, verify,
};
use crate::meant;
use crate::stream::Stream;
use clap::error::ErrorKind;
use clap::{CommandFactory, Parser, Subcommand};
use std::ffi::OsString;

/// Examples, endings, exit codes.
fn after_help() -> String {
    AFTER_HELP.replace("ENDINGS", &choices::endings())
}

const AFTER_HELP: &str = "\
Example:
  grafc valve.gct -o valve.st
  grafc charts/*.gct -t rust -o src/ --watch
  grafc valve.gct -o valve.mjs
  grafc valve.gct --emit net

The ending of FILE says what to make, unless `--target` does: ENDINGS.
Exit codes: 0 done, 1 a chart has errors, 2 wrong use, 3 a file cannot be read or written, 4 not decided, 101 a fault of grafc.
A chart that is named like a command is given as `./check`; `-` is standard input or output.";

/// Compile GRAFCET charts (IEC 60848) to code for PLCs, or to Rust, C or JavaScript
#[derive(Parser, Debug)]
#[command(name = "grafc", version, after_help = after_help())]
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
        let parsed = CommandLine::try_parse_from(&arguments);
        let mut root = CommandLine::command();
        let is_command = |word: &&str| root.get_subcommands().any(|command| command.get_name() == *word);
        // A command that there is not looks like a chart.
        let words: Vec<&str> = match &parsed {
            Ok(CommandLine { command: Some(_), .. }) => Vec::new(),
            Ok(CommandLine { command: None, compile }) => compile.charts.iter().filter_map(Stream::as_word).collect(),
            Err(error) if error.use_stderr() => arguments
                .get(1)
                .and_then(|first| first.to_str())
                .filter(|first| !is_command(first))
                .into_iter()
                .collect(),
            Err(_) => Vec::new(),
        };
        match meant::command(&words, &root) {
            Some(message) => Err(root.error(ErrorKind::InvalidSubcommand, message)),
            None => parsed,
        }
    }
}

/// The commands other than to compile.
#[derive(Subcommand, Debug)]
pub enum Command {
    /// Begin a chart: a folder with a chart that works, a trace, and what to do with them
    New(new::Arguments),
    /// Report all errors and warnings of charts
    Check(check::Arguments),
    /// Run a chart over a trace of its inputs with the reference simulator
    Sim(sim::Arguments),
    /// Run the tests of charts, tables and scenarios, and measure what they cover
    Test(test::Arguments),
    /// Make tests that cover what a chart can come to, with what the rules make of them
    GenerateTests(generate_tests::Arguments),
    /// Draw a chart by the symbols of the standard, as SVG, PDF or PNG
    Draw(draw::Arguments),
    /// Make a page of a chart on which it runs: one HTML file that needs nothing else
    Page(page::Arguments),
    /// Show the page of a chart in a browser, made again at each save
    Serve(serve::Arguments),
    /// Find all situations that a chart can come to, and what leads from one to another
    Graph(graph::Arguments),
    /// Show the transition graphs that a chart is, or convert it to an automaton
    Automata(automata::Arguments),
    /// Prove what a chart never does, or show it by a trace
    Verify(verify::Arguments),
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
