//! `grafc completions`: scripts that let a shell complete grafc's command line.

use crate::Exit;
use crate::report::Failure;
use clap::{Args, Command};
use clap_complete::{Shell, generate};
use grafc::files::print_bytes;

const AFTER_HELP: &str = "\
Example:
  grafc completions bash > ~/.local/share/bash-completion/completions/grafc";

/// Arguments of `grafc completions`.
#[derive(Args, Debug)]
#[command(after_help = AFTER_HELP)]
pub struct Arguments {
    /// The shell
    #[arg(value_enum, value_name = "SHELL")]
    shell: Shell,
}

/// Prints the script for a command line.
pub fn run(args: Arguments, mut command: Command) -> Result<Exit, Failure> {
    let mut script = Vec::new();
    generate(args.shell, &mut command, "grafc", &mut script);
    print_bytes(&script)?;
    Ok(Exit::Done)
}
