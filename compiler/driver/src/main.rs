//! The `grafc` binary; everything is in the library.

use grafc_cli::Exit;
use grafc_cli::command_line::CommandLine;
use grafc_cli::signals;
use grafc_cli::stream::answered;
use std::io::Write;
use std::process::ExitCode;

fn main() -> ExitCode {
    grafc_cli::memory::give_back_large_tables();
    let command_line = match CommandLine::from_arguments(std::env::args_os()) {
        Ok(command_line) => command_line,
        Err(answer) => {
            // Help, version or wrong use; that it cannot be told is worth telling, if that can be.
            return match answered(answer.print()) {
                Ok(()) => ExitCode::from(answer.exit_code() as u8),
                Err(refusal) => {
                    let _ = std::io::stderr().write_all(refusal.to_string().as_bytes());
                    ExitCode::from(Exit::FilesRefused as u8)
                }
            };
        }
    };
    signals::keep_running_at_the_limit_of_files();
    signals::clear_up();
    match grafc::fault::guard(|| grafc_cli::run(command_line)) {
        Ok(exit) => ExitCode::from(exit as u8),
        Err(message) => {
            let _ = std::io::stderr().write_all(message.as_bytes());
            ExitCode::from(grafc::fault::EXIT_CODE)
        }
    }
}
