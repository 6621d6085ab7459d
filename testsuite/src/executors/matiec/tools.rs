//! Finds and calls `iec2c` and `gcc`.

use crate::programs::{call, on_path};
use crate::tools::{Tool, or_skip};
use std::collections::BTreeSet;
use std::env;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The tools, found.
pub struct Tools {
    iec2c: PathBuf,
    library: PathBuf,
    gcc: PathBuf,
}

impl Tools {
    /// The tools on PATH, or what is missing.
    ///
    /// MATIEC's library is where the variable MATIEC_LIB says, else in the usual places beside the binary.
    pub fn find() -> Result<Tools, String> {
        let iec2c = on_path("iec2c").ok_or("iec2c is not on PATH")?;
        let gcc = on_path("gcc").ok_or("gcc is not on PATH")?;
        let library = match env::var_os("MATIEC_LIB") {
            Some(folder) => PathBuf::from(folder),
            None => {
                let real = iec2c.canonicalize().map_err(|e| format!("{}: {e}", iec2c.display()))?;
                let beside = real.parent().unwrap_or(Path::new("/"));
                ["lib", "../lib", "../lib/matiec", "../share/matiec/lib", "../share/matiec"]
                    .iter()
                    .map(|place| beside.join(place))
                    .find(|folder| folder.join("ieclib.txt").is_file())
                    .ok_or_else(|| format!("no library of MATIEC beside {}; MATIEC_LIB names it", real.display()))?
            }
        };
        if !library.join("ieclib.txt").is_file() || !library.join("C/iec_std_lib.h").is_file() {
            return Err(format!("{} is not the library of MATIEC", library.display()));
        }
        Ok(Tools { iec2c, library, gcc })
    }

    /// The tools, or nothing and a line that says why the test that wants them does nothing.
    pub fn find_or_skip() -> Option<Tools> {
        or_skip(Tool::Matiec, Tools::find())
    }

    /// Compiles `charts.st` in a folder to C.
    pub(crate) fn iec2c(&self, folder: &Path) -> Result<(), String> {
        let mut command = Command::new(&self.iec2c);
        command.arg("-I").arg(&self.library).arg("-T").arg(folder).arg(folder.join("charts.st"));
        call(&mut command).map(|_| ())
    }

    /// Compiles `charts.st` in a folder to C as Beremiz does, which needs no order of program organisation units.
    pub fn iec2c_in_any_order(&self, folder: &Path) -> Result<(), String> {
        let mut command = Command::new(&self.iec2c);
        command.args(["-f", "-l", "-p", "-I"]).arg(&self.library).arg("-T").arg(folder).arg(folder.join("charts.st"));
        call(&mut command).map(|_| ())
    }

    /// The names that MATIEC's own library gives to functions, function blocks, and what belongs to these.
    pub fn library_names(&self) -> Result<Vec<String>, String> {
        let mut found = BTreeSet::new();
        for file in std::fs::read_dir(&self.library).map_err(|error| error.to_string())?.flatten() {
            let is_text = file.path().extension().is_some_and(|ending| ending == "txt");
            if let Some(text) = is_text.then(|| std::fs::read_to_string(file.path()).ok()).flatten() {
                let word = |c: char| !(c.is_ascii_alphanumeric() || c == '_');
                let names = text.split(word).filter(|name| name.starts_with(|c: char| c.is_ascii_alphabetic()));
                found.extend(names.map(str::to_ascii_uppercase));
            }
        }
        Ok(found.into_iter().collect())
    }

    /// Builds `main` of `main.c` in a folder, which includes what `iec2c` wrote, with an option for the optimization.
    /// Signed overflow wraps around, as on a PLC.
    pub(crate) fn gcc(&self, folder: &Path, optimization: &str) -> Result<(), String> {
        let mut command = Command::new(&self.gcc);
        command
            .args([optimization, "-w", "-fwrapv", "-o"])
            .arg(folder.join("main"))
            .arg("-I")
            .arg(self.library.join("C"));
        command.arg("-I").arg(folder).arg(folder.join("main.c")).arg("-lm");
        call(&mut command).map(|_| ())
    }

    /// Runs what was built.
    pub(super) fn play(&self, folder: &Path) -> Result<String, String> {
        call(&mut Command::new(folder.join("main")))
    }
}
