//! A C compiler.

use crate::programs::call;
use crate::tools::{Tool, or_skip};
use std::path::{Path, PathBuf};
use std::process::Command;

/// What generated C promises: C99, and nothing that a compiler warns of.
pub const STRICT: [&str; 7] = ["-std=c99", "-pedantic", "-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-Werror"];

/// A compiler, if it can be called.
pub struct Tools {
    cc: PathBuf,
}

impl Tools {
    /// The compiler that `CC` names, else `gcc` on the search path; the error says what is missing.
    pub fn find() -> Result<Tools, String> {
        let cc = PathBuf::from(std::env::var_os("CC").unwrap_or_else(|| "gcc".into()));
        Tools::named(cc)
    }

    /// A compiler of this name.
    pub fn named(cc: impl Into<PathBuf>) -> Result<Tools, String> {
        let cc = cc.into();
        match call(Command::new(&cc).arg("--version")) {
            Ok(_) => Ok(Tools { cc }),
            Err(_) => Err(format!("{} cannot be called", cc.display())),
        }
    }

    /// The compiler, or nothing and a line on standard error that says why the test that wants it does nothing.
    pub fn find_or_skip() -> Option<Tools> {
        or_skip(Tool::Cc, Tools::find())
    }

    /// Compiles sources of a folder to `main`, with checks for what is undefined and for memory, if that is asked for.
    ///
    /// # Errors
    /// What the compiler says.
    pub fn build(&self, folder: &Path, sources: &[String], is_checked: bool) -> Result<(), String> {
        let checks = ["-fsanitize=address,undefined", "-fno-sanitize-recover=all"];
        let checks = if is_checked { &checks[..] } else { &[] };
        let mut command = Command::new(&self.cc);
        call(command.args(STRICT).args(checks).args(["-o", "main"]).args(sources).arg("-lm").current_dir(folder))
            .map(|_| ())
    }

    /// Compiles a source of a folder to an object, with more options.
    ///
    /// # Errors
    /// What the compiler says.
    pub fn object(&self, folder: &Path, source: &str, more: &[&str]) -> Result<(), String> {
        let mut command = Command::new(&self.cc);
        call(command.args(STRICT).args(more).args(["-c", "-o", "object.o", source]).current_dir(folder)).map(|_| ())
    }

    /// The compiler, with all warnings that there must not be.
    pub(crate) fn command(&self) -> Command {
        let mut command = Command::new(&self.cc);
        command.args(STRICT);
        command
    }

    /// Calls it as somebody would by hand, with all warnings that there must not be.
    ///
    /// # Errors
    /// What the compiler says.
    pub fn compile(&self, folder: &Path, arguments: &[&str]) -> Result<(), String> {
        call(Command::new(&self.cc).args(STRICT).args(arguments).current_dir(folder)).map(|_| ())
    }

    /// Runs what was compiled.
    ///
    /// # Errors
    /// What it says, if it fails.
    pub fn play(&self, folder: &Path, program: &str) -> Result<String, String> {
        call(&mut Command::new(folder.join(program)))
    }
}
