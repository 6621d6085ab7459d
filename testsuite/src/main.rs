//! The commands of the test suite, for runs that are too long for `cargo test`.
//!
//! ```text
//! cargo run --release -p grafc-testsuite -- diff --charts 20000 --executors built-in
//! cargo run --release -p grafc-testsuite -- plants --scans 10000 --executors all
//! cargo run --release -p grafc-testsuite -- executors
//! ```

#![allow(clippy::print_stderr, reason = "a command")]

use clap::{Parser, Subcommand};
use grafc_testsuite::differential::command;
use grafc_testsuite::plants;
use std::process::ExitCode;

/// Long runs of the test suite of grafc
#[derive(Parser, Debug)]
#[command(name = "grafc-testsuite")]
struct CommandLine {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand, Debug)]
enum Command {
    Diff(command::Arguments),
    Plants(plants::command::Arguments),
    /// List the executors: what they run, what they cannot, and whether their tools are here
    Executors,
}

fn main() -> ExitCode {
    let result = match CommandLine::parse().command {
        Command::Diff(arguments) => command::run(&arguments),
        Command::Plants(arguments) => plants::command::run(&arguments),
        Command::Executors => command::list(),
    };
    result.unwrap_or_else(|fault| {
        eprintln!("error: {fault}");
        ExitCode::from(2)
    })
}
