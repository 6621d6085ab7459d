//! Finds and calls `strucpp` and `g++`.

use crate::programs::{call, on_path};
use crate::tools::{Tool, or_skip};
use std::env;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The tools, found.
pub struct Tools {
    strucpp: PathBuf,
    runtime: PathBuf,
    cpp: PathBuf,
}

impl Tools {
    /// The tools on PATH, or what is missing.
    ///
    /// The headers of the runtime are where the variable STRUCPP_RUNTIME says, else in the package around the command.
    pub fn find() -> Result<Tools, String> {
        let strucpp = on_path("strucpp").ok_or("strucpp is not on PATH")?;
        let cpp = on_path("g++").ok_or("g++ is not on PATH")?;
        let runtime = match env::var_os("STRUCPP_RUNTIME") {
            Some(folder) => PathBuf::from(folder),
            None => {
                let real = strucpp.canonicalize().map_err(|e| format!("{}: {e}", strucpp.display()))?;
                let package = real.ancestors().map(|folder| folder.join("src/runtime/include"));
                package.into_iter().find(|folder| folder.is_dir()).ok_or_else(|| {
                    format!("no runtime of STruC++ around {}; STRUCPP_RUNTIME names it", real.display())
                })?
            }
        };
        if !runtime.join("iec_std_lib.hpp").is_file() {
            return Err(format!("{} is not the runtime of STruC++", runtime.display()));
        }
        Ok(Tools { strucpp, runtime, cpp })
    }

    /// The tools, or nothing and a line that says why the test that wants them does nothing.
    pub fn find_or_skip() -> Option<Tools> {
        or_skip(Tool::Strucpp, Tools::find())
    }

    /// Compiles `charts.st` in a folder to C++.
    pub(super) fn strucpp(&self, folder: &Path) -> Result<(), String> {
        let mut command = Command::new(&self.strucpp);
        command.arg(folder.join("charts.st")).arg("-o").arg(folder.join("charts.cpp"));
        call(&mut command).map(|_| ())
    }

    /// Builds `main.cpp` in a folder, which includes what STruC++ wrote. Signed overflow wraps around, as on a PLC.
    pub(super) fn cpp(&self, folder: &Path) -> Result<(), String> {
        let mut command = Command::new(&self.cpp);
        command
            .args(["-std=c++17", "-O0", "-w", "-fwrapv", "-o"])
            .arg(folder.join("main"))
            .arg("-I")
            .arg(&self.runtime);
        command.arg("-I").arg(folder).arg(folder.join("main.cpp"));
        call(&mut command).map(|_| ())
    }

    /// Runs what was built.
    pub(super) fn play(&self, folder: &Path) -> Result<String, String> {
        call(&mut Command::new(folder.join("main")))
    }
}
