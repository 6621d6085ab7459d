//! The command line of grafc.
//!
//! It reads and writes files, prints, and ends with an exit code; what it does is done by the library `grafc`.

mod arguments;
mod choices;
pub mod command_line;
mod commands;
mod map;
mod meant;
pub mod memory;
mod progress;
mod report;
mod results;
pub mod signals;
pub mod stream;
mod traces;
mod watch;
mod waveform;

use clap::CommandFactory;
use command_line::{Command, CommandLine};

/// How a run ended; its number is the exit code of the process.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Exit {
    /// All is done.
    Done = 0,
    /// A chart has errors, or is not as `--check` wants it.
    ChartErrors = 1,
    /// The command was called in a way that makes no sense.
    WrongUse = 2,
    /// A file cannot be read or written.
    FilesRefused = 3,
    /// What was asked is not decided: a limit was hit, or something cannot be followed.
    Open = 4,
}

/// Runs one command to its end.
pub fn run(command_line: CommandLine) -> Exit {
    let result = match command_line.command {
        None => commands::compile::run(command_line.compile),
        Some(Command::Check(args)) => commands::check::run(args),
        Some(Command::Sim(args)) => commands::sim::run(args),
        Some(Command::Test(args)) => commands::test::run(args),
        Some(Command::GenerateTests(args)) => commands::generate_tests::run(args),
        Some(Command::New(args)) => commands::new::run(args),
        Some(Command::Stats(args)) => commands::stats::run(args),
        Some(Command::Draw(args)) => commands::draw::run(args),
        Some(Command::Page(args)) => commands::page::run(args),
        Some(Command::Serve(args)) => commands::serve::run(args),
        Some(Command::Graph(args)) => commands::graph::run(args),
        Some(Command::Automata(args)) => commands::automata::run(args),
        Some(Command::Verify(args)) => commands::verify::run(args),
        Some(Command::Fmt(args)) => commands::fmt::run(args),
        Some(Command::Import(args)) => commands::import::run(args),
        Some(Command::Explain(args)) => commands::explain::run(args),
        Some(Command::Completions(args)) => commands::completions::run(args, CommandLine::command()),
        Some(Command::Man(args)) => commands::man::run(args, CommandLine::command()),
    };
    result.unwrap_or_else(|failure| {
        report::to_stderr(&failure.to_string());
        failure.exit()
    })
}
