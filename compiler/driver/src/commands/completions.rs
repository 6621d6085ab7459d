//! `grafc completions`: scripts that let a shell complete grafc's command line.

use crate::Exit;
use crate::command_line::CommandLine;
use crate::files::print;
use crate::report::Failure;
use clap::{Args, CommandFactory};
use clap_complete::{Shell, generate};

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

/// Prints the script.
pub fn run(args: Arguments) -> Result<Exit, Failure> {
    let mut script = Vec::new();
    generate(args.shell, &mut CommandLine::command(), "grafc", &mut script);
    print(&String::from_utf8_lossy(&script))?;
    Ok(Exit::Done)
}
