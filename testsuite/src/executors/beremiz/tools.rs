//! Finds Beremiz and calls its generator.

use crate::executors::matiec;
use crate::programs::{call, python, runs};
use crate::tools::{Tool, or_skip};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

const GENERATE: &str = include_str!("generate.py");

/// The tools, found.
pub struct Tools {
    folder: PathBuf,
    pub(super) matiec: matiec::Tools,
}

impl Tools {
    /// The tools, or what is missing.
    pub fn find() -> Result<Tools, String> {
        let folder = std::env::var_os("BEREMIZ").ok_or("BEREMIZ does not name the folder of Beremiz")?;
        let folder = PathBuf::from(folder);
        if !folder.join("PLCGenerator.py").is_file() {
            return Err(format!("BEREMIZ names {}, where there is no PLCGenerator.py", folder.display()));
        }
        if !runs(&python(), &["-c", "import lxml.etree"]) {
            return Err(format!("{} has no lxml; PYTHON names another Python", python()));
        }
        Ok(Tools { folder, matiec: matiec::Tools::find()? })
    }

    /// The tools, or nothing and a line that says why the test that wants them does nothing.
    pub fn find_or_skip() -> Option<Tools> {
        or_skip(Tool::Beremiz, Tools::find())
    }

    /// What the generator makes of each project.
    pub(super) fn generate(&self, projects: &[String]) -> Result<Vec<Result<String, String>>, String> {
        let folder = tempfile::tempdir().map_err(|e| e.to_string())?;
        let file = |name: &str| folder.path().join(name);
        fs::write(file("generate.py"), GENERATE).map_err(|e| e.to_string())?;
        let mut command = Command::new(python());
        command.arg(file("generate.py")).arg(&self.folder);
        for (index, project) in projects.iter().enumerate() {
            fs::write(file(&format!("{index}.xml")), project).map_err(|e| e.to_string())?;
            command.arg(file(&format!("{index}.xml")));
        }
        call(&mut command)?;
        Ok((0..projects.len()).map(|index| generated(folder.path(), index, &projects[index])).collect())
    }
}

/// What was made of one project.
fn generated(folder: &Path, index: usize, project: &str) -> Result<String, String> {
    match fs::read_to_string(folder.join(format!("{index}.err"))) {
        Ok(said) => Err(format!("Beremiz: {said}\n{project}")),
        Err(_) => fs::read_to_string(folder.join(format!("{index}.st"))).map_err(|e| format!("nothing generated: {e}")),
    }
}
