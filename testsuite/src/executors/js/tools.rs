//! node, and the compiler of TypeScript.

use crate::programs::call;
use crate::tools::{Tool, or_skip};
use std::path::{Path, PathBuf};
use std::process::Command;

/// What modules are written in came with this version.
const OLDEST: u32 = 18;

/// node, if it can be called.
pub struct Tools {
    node: PathBuf,
}

impl Tools {
    /// The node that `NODE` names, else that on the search path; the error says what is missing.
    pub fn find() -> Result<Tools, String> {
        let node = PathBuf::from(std::env::var_os("NODE").unwrap_or_else(|| "node".into()));
        let printed = call(Command::new(&node).arg("--version")).map_err(|_| "node cannot be called".to_string())?;
        let version: Option<u32> =
            printed.trim().trim_start_matches('v').split('.').next().and_then(|major| major.parse().ok());
        match version {
            Some(version) if version >= OLDEST => Ok(Tools { node }),
            Some(_) | None => Err(format!("node {} is older than {OLDEST}", printed.trim())),
        }
    }

    /// node, or nothing and a line on standard error that says why the test that wants it does nothing.
    pub fn find_or_skip() -> Option<Tools> {
        or_skip(Tool::Node, Tools::find())
    }

    /// Runs a script of a folder; what it prints, or its complaint.
    pub fn play(&self, folder: &Path, script: &str) -> Result<String, String> {
        call(Command::new(&self.node).arg(script).current_dir(folder))
    }
}

/// `tsc`, if it can be called.
pub struct Typescript {
    tsc: PathBuf,
}

impl Typescript {
    /// The `tsc` that `TSC` names, else that on the search path, or nothing and a line that says what is missing.
    pub fn find_or_skip() -> Option<Typescript> {
        let tsc = PathBuf::from(std::env::var_os("TSC").unwrap_or_else(|| "tsc".into()));
        let found = match call(Command::new(&tsc).arg("--version")) {
            Ok(_) => Ok(Typescript { tsc }),
            Err(_) => Err("tsc cannot be called".to_string()),
        };
        or_skip(Tool::Typescript, found)
    }

    /// Whether files of a folder are strictly right; the error is what the compiler says.
    pub fn check(&self, folder: &Path, files: &[&str]) -> Result<(), String> {
        let options = ["--noEmit", "--strict", "--target", "es2022", "--module", "nodenext"];
        call(Command::new(&self.tsc).args(options).args(files).current_dir(folder)).map(|_| ())
    }
}
