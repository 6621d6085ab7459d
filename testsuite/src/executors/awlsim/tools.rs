//! Finds and calls a Python that has awlsim.

use crate::programs::call;
use crate::tools::{Tool, or_skip};
use serde_json::{Value as Json, json};
use std::fs;
use std::process::Command;

/// What plays charts in awlsim.
const PLAY: &str = include_str!("play.py");

/// A Python that has awlsim, found.
pub struct Tools {
    python: String,
}

impl Tools {
    /// The Python, or what it lacks.
    pub fn find() -> Result<Tools, String> {
        let python = std::env::var("AWLSIM_PYTHON").unwrap_or_else(|_| "python3".to_string());
        let output = Command::new(&python).args(["-c", "import awlsim.core.main"]).output();
        match output {
            Err(fault) => Err(format!("{python}: {fault}; AWLSIM_PYTHON names a Python that has awlsim")),
            Ok(output) if output.status.success() => Ok(Tools { python }),
            Ok(_) => Err(format!("{python} has no awlsim; AWLSIM_PYTHON names a Python that has")),
        }
    }

    /// The Python, or nothing and a line that says why the test that wants it does nothing.
    pub fn find_or_skip() -> Option<Tools> {
        or_skip(Tool::Awlsim, Tools::find())
    }

    /// Plays units, one after another; what that prints.
    pub(super) fn play(&self, units: &[&Json]) -> Result<String, String> {
        let folder = tempfile::tempdir().map_err(|e| e.to_string())?;
        let (script, file) = (folder.path().join("play.py"), folder.path().join("jobs.json"));
        fs::write(&script, PLAY).map_err(|e| e.to_string())?;
        fs::write(&file, json!(units).to_string()).map_err(|e| e.to_string())?;
        call(Command::new(&self.python).arg(&script).arg(&file))
            .map_err(|said| format!("{said}\n{}", units.first().map_or("", |unit| unit["text"].as_str().unwrap_or(""))))
    }
}
