//! The `grafc` binary; everything is in the library.

use grafc_cli::command_line::CommandLine;
use std::io::Write;
use std::process::ExitCode;

fn main() -> ExitCode {
    let command_line = match CommandLine::from_arguments(std::env::args_os()) {
        Ok(command_line) => command_line,
        Err(answer) => {
            // Help, version or wrong use; that nobody reads it is no reason to fail.
            let _ = answer.print();
            return ExitCode::from(answer.exit_code() as u8);
        }
    };
    match grafc::fault::guard(|| grafc_cli::run(command_line)) {
        Ok(exit) => ExitCode::from(exit as u8),
        Err(message) => {
            let _ = std::io::stderr().write_all(message.as_bytes());
            ExitCode::from(grafc::fault::EXIT_CODE)
        }
    }
}
