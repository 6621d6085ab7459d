//! `grafc man`: the manual page.

use crate::Exit;
use crate::report::Failure;
use clap::{Args, Command};
use clap_mangen::Man;
use grafc::files::print_bytes;

const AFTER_HELP: &str = "\
Example:
  grafc man > grafc.1

`grafc man check` prints the page of a command, grafc-check(1).";

/// Arguments of `grafc man`.
#[derive(Args, Debug)]
#[command(after_help = AFTER_HELP)]
pub struct Arguments {
    /// A command, for its own page
    #[arg(value_name = "COMMAND")]
    command: Option<String>,
}

/// Prints the page of a command line, or of one of its commands.
pub fn run(args: Arguments, root: Command) -> Result<Exit, Failure> {
    let mut root = root.disable_help_subcommand(true);
    root.build();
    let command = match &args.command {
        None => root,
        Some(name) => match root.find_subcommand(name) {
            Some(command) => command.clone(),
            None => {
                return Err(Failure::WrongUse(
                    format!("grafc has no command `{name}`"),
                    "see `grafc --help`".to_string(),
                ));
            }
        },
    };
    let mut page = Vec::new();
    // Writing to memory cannot fail.
    let _ =
        Man::new(command).source(concat!("grafc ", env!("CARGO_PKG_VERSION"))).manual("grafc manual").render(&mut page);
    print_bytes(&page)?;
    Ok(Exit::Done)
}
