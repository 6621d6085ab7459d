//! A C compiler.

use crate::programs::call;
use crate::tools::{Tool, or_skip};
use std::path::{Path, PathBuf};
use std::process::Command;

/// What generated C promises: C99, and nothing that a compiler warns of.
pub const STRICT: [&str; 7] = ["-std=c99", "-pedantic", "-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-Werror"];

/// What is looked for while a program runs.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Checks {
    /// Nothing.
    Nothing,
    /// What is undefined in C.
    Undefined,
    /// That, and reads and writes beside what there is; it takes twice as long again to compile.
    Memory,
}

impl Checks {
    fn options(self) -> &'static [&'static str] {
        match self {
            Checks::Nothing => &[],
            Checks::Undefined => &["-fsanitize=undefined", "-fno-sanitize-recover=all"],
            Checks::Memory => &["-fsanitize=address,undefined", "-fno-sanitize-recover=all"],
        }
    }
}

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

    /// Compiles sources of a folder to `main`.
    ///
    /// # Errors
    /// What the compiler says.
    pub fn build(&self, folder: &Path, sources: &[String], checks: Checks) -> Result<(), String> {
        let mut command = Command::new(&self.cc);
        command.args(STRICT).args(checks.options()).args(["-o", "main"]).args(sources).arg("-lm");
        call(command.current_dir(folder)).map(|_| ())
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
