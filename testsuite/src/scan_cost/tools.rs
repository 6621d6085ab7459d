//! Builds and runs the program of one spelling, with the optimization that a vendor would choose.
//!
//! The tests build with `-O0`, where compiling is what takes the time; here it is running.

use super::driver;
use crate::matiec::Tools;
use crate::programs::call;
use crate::rings::Rings;
use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// MATIEC's library, where its tools look for it.
pub struct Library(PathBuf);

impl Library {
    /// The library of the tools on PATH, or what is missing.
    pub fn find() -> Result<Library, String> {
        // Says which tool is missing, and that the library is in one of these places.
        Tools::find()?;
        if let Some(folder) = env::var_os("MATIEC_LIB") {
            return Ok(Library(PathBuf::from(folder)));
        }
        let path = env::var_os("PATH").unwrap_or_default();
        env::split_paths(&path)
            .filter_map(|folder| folder.join("iec2c").canonicalize().ok())
            .flat_map(|real| {
                ["lib", "../lib", "../lib/matiec", "../share/matiec/lib", "../share/matiec"]
                    .map(|place| real.parent().unwrap_or(Path::new("/")).join(place))
            })
            .find(|folder| folder.join("ieclib.txt").is_file())
            .map(Library)
            .ok_or_else(|| "no library of MATIEC beside iec2c; MATIEC_LIB names it".to_owned())
    }

    /// Builds the program of a text in a folder of its own, unless it is there already.
    pub(crate) fn build(&self, folder: &Path, text: &str, rings: Rings) -> Result<PathBuf, String> {
        let block = text
            .lines()
            .find_map(|line| line.trim().strip_prefix("FUNCTION_BLOCK "))
            .ok_or("the text has no function block")?
            .trim();
        let main = driver::write(block, rings);
        let program = folder.join("main");
        let same = |name: &str, text: &str| fs::read_to_string(folder.join(name)).is_ok_and(|old| old == text);
        if program.is_file() && same("charts.st", text) && same("main.c", &main) {
            return Ok(program);
        }
        let failed = |path: &Path, e: std::io::Error| format!("{}: {e}", path.display());
        fs::create_dir_all(folder).map_err(|e| failed(folder, e))?;
        if program.is_file() {
            fs::remove_file(&program).map_err(|e| failed(&program, e))?;
        }
        for (name, text) in [("charts.st", text), ("main.c", &main)] {
            fs::write(folder.join(name), text).map_err(|e| failed(&folder.join(name), e))?;
        }
        let mut iec2c = Command::new("iec2c");
        iec2c.arg("-I").arg(&self.0).arg("-T").arg(folder).arg(folder.join("charts.st"));
        call(&mut iec2c)?;
        let mut gcc = Command::new("gcc");
        gcc.args(["-O2", "-w", "-fwrapv", "-o"]).arg(&program).arg("-I").arg(self.0.join("C"));
        gcc.arg("-I").arg(folder).arg(folder.join("main.c")).arg("-lm");
        call(&mut gcc)?;
        Ok(program)
    }
}
