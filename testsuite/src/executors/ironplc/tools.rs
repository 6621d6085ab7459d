//! Finds and calls `ironplcc` and `ironplcvm`.

use crate::programs::{call, on_path};
use crate::tools::{Tool, or_skip};
use std::path::{Path, PathBuf};
use std::process::Command;

/// The tools, found.
pub struct Tools {
    compiler: PathBuf,
    machine: PathBuf,
}

impl Tools {
    /// The tools on PATH, or what is missing.
    pub fn find() -> Result<Tools, String> {
        let compiler = on_path("ironplcc").ok_or("ironplcc is not on PATH")?;
        let machine = on_path("ironplcvm").ok_or("ironplcvm is not on PATH")?;
        Ok(Tools { compiler, machine })
    }

    /// The tools, or nothing and a line that says why the test that wants them does nothing.
    pub fn find_or_skip() -> Option<Tools> {
        or_skip(Tool::Ironplc, Tools::find())
    }

    /// Checks a text.
    pub(super) fn check(&self, text: &Path) -> Result<(), String> {
        call(Command::new(&self.compiler).arg("check").arg(text)).map(|_| ())
    }

    /// Compiles a text to code of the machine.
    pub(super) fn compile(&self, text: &Path, code: &Path) -> Result<(), String> {
        call(Command::new(&self.compiler).arg("compile").arg(text).arg("-o").arg(code)).map(|_| ())
    }

    /// Runs so many scans; prints the variables as they are then, a line each.
    pub(super) fn run(&self, code: &Path, scans: usize) -> Result<String, String> {
        call(Command::new(&self.machine).arg("run").arg(code).args(["--dump-vars", "--scans", &scans.to_string()]))
    }
}
