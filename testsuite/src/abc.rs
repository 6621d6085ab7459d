//! abc, which proves what holds of circuits.

use crate::programs::call;
use crate::tools::{Tool, or_skip};
use std::path::PathBuf;
use std::process::Command;
use std::{env, fs};

/// abc, if it can be called.
pub struct Abc(PathBuf);

impl Abc {
    /// The program that `ABC` names, else Debian's on the search path, or nothing and a line that says what is missing.
    pub fn find_or_skip() -> Option<Abc> {
        let abc = PathBuf::from(env::var_os("ABC").unwrap_or_else(|| "berkeley-abc".into()));
        let found = match call(Command::new(&abc).args(["-c", "version"])) {
            Ok(_) => Ok(Abc(abc)),
            Err(_) => Err("berkeley-abc cannot be called".to_string()),
        };
        or_skip(Tool::Abc, found)
    }

    /// Whether what must never hold of a circuit in AIGER never does; the error is what abc says.
    pub fn proves(&self, circuit: &[u8]) -> Result<bool, String> {
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        let path = folder.path().join("circuit.aig");
        fs::write(&path, circuit).map_err(|error| error.to_string())?;
        // Constraints are folded in, and all that is bad is made one thing, which is proved away or reached.
        let script = format!("read_aiger {}; fold; orpos; pdr", path.display());
        let said = call(Command::new(&self.0).args(["-c", &script]))?;
        match (said.contains("Property proved"), said.contains("was asserted in frame")) {
            (true, false) => Ok(true),
            (false, true) => Ok(false),
            (true, true) | (false, false) => Err(said),
        }
    }
}
