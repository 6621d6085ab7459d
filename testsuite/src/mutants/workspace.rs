//! The copy of the workspace that has all faults, each behind its choice, and the test programs built from it.

use super::faulty_files;
use crate::tools::Tool;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Folders that no build needs.
const LEFT_OUT: [&str; 3] = ["target", ".git", "fuzz"];

/// Copies the workspace, with all faults put in. A file is written only if it has changed, so that a second run builds
/// no more than it must; what the workspace no longer has is deleted.
pub fn copy(root: &Path, to: &Path) -> Result<(), String> {
    let told = |path: &Path, error: io::Error| format!("{}: {error}", path.display());
    let mut faulty = faulty_files(root)?;
    let mut folders = vec![PathBuf::new()];
    while let Some(folder) = folders.pop() {
        let from = root.join(&folder);
        fs::create_dir_all(to.join(&folder)).map_err(|error| told(&to.join(&folder), error))?;
        for entry in fs::read_dir(to.join(&folder)).map_err(|error| told(&to.join(&folder), error))? {
            let entry = entry.map_err(|error| told(&to.join(&folder), error))?;
            let gone = !from.join(entry.file_name()).exists();
            if gone && !LEFT_OUT.iter().any(|folder| *entry.file_name() == **folder) {
                let path = entry.path();
                let removed = if path.is_dir() { fs::remove_dir_all(&path) } else { fs::remove_file(&path) };
                removed.map_err(|error| told(&path, error))?;
            }
        }
        for entry in fs::read_dir(&from).map_err(|error| told(&from, error))? {
            let entry = entry.map_err(|error| told(&from, error))?;
            let name = entry.file_name();
            let path = folder.join(&name);
            if entry.path().is_dir() {
                if !LEFT_OUT.iter().any(|folder| *name == **folder) {
                    folders.push(path);
                }
                continue;
            }
            let mut content = fs::read(entry.path()).map_err(|error| told(&entry.path(), error))?;
            if let Some(text) = path.to_str().and_then(|file| faulty.remove(file)) {
                content = text.into_bytes();
            }
            let copy = to.join(&path);
            if fs::read(&copy).ok().as_ref() != Some(&content) {
                fs::write(&copy, content).map_err(|error| told(&copy, error))?;
            }
        }
    }
    Ok(())
}

/// A test program, and the folder that it runs in.
#[derive(Clone, Debug)]
pub struct TestProgram {
    /// What was asked for.
    pub suite: Suite,
    /// The program.
    pub program: PathBuf,
    /// The folder of its package.
    pub folder: PathBuf,
    /// The tests of it to run.
    pub tests: Vec<String>,
}

/// Tests of one crate.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Suite {
    /// The crate.
    pub package: &'static str,
    /// Its folder in the workspace.
    pub folder: &'static str,
    /// The test program; without it the tests beside the code.
    pub test: Option<&'static str>,
    /// The file of the test program, where it has several.
    pub file: Option<&'static str>,
    /// Only tests whose names have this part.
    pub only: Option<&'static str>,
    /// What the tests need.
    pub needs: Option<Tool>,
}

impl Suite {
    /// What it is called in the report.
    pub fn name(self) -> String {
        let file = self.file.or(self.test);
        let file = file.map_or_else(|| format!("{} (unit tests)", self.package), str::to_owned);
        self.only.map_or(file.clone(), |only| format!("{file} ({only})"))
    }
}

/// Builds one test program of the copy.
pub fn build(copy: &Path, suite: Suite) -> Result<TestProgram, String> {
    let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.args(["test", "--no-run", "--message-format=json-render-diagnostics", "-p", suite.package]);
    match suite.test {
        Some(test) => command.args(["--test", test]),
        None => command.arg("--lib"),
    };
    // The texts beside each other are not what one would write by hand, so warnings say nothing.
    command.env("CARGO_TARGET_DIR", copy.join("target")).current_dir(copy);
    let output = command.output().map_err(|error| error.to_string())?;
    if !output.status.success() {
        let said = String::from_utf8_lossy(&output.stderr);
        let errors: Vec<&str> = said.split("\n\n").filter(|part| part.contains("error")).collect();
        return Err(format!("{}\nthe copy with all faults does not build: {}", errors.join("\n\n"), suite.name()));
    }
    let messages = String::from_utf8_lossy(&output.stdout);
    let program = messages.lines().filter_map(executable).next_back();
    let program = program.ok_or_else(|| format!("cargo names no program for {}", suite.name()))?;
    let tests = listed(&program, suite)?;
    Ok(TestProgram { suite, program, folder: copy.join(suite.folder), tests })
}

/// The tests of a program that a suite has.
fn listed(program: &Path, suite: Suite) -> Result<Vec<String>, String> {
    let output = Command::new(program).args(["--list", "--format", "terse"]).output();
    let output = output.map_err(|error| format!("{}: {error}", program.display()))?;
    let all = String::from_utf8_lossy(&output.stdout);
    let is_of = |name: &&str| {
        let in_file = suite.file.is_none_or(|file| name.split_once("::").is_some_and(|(begin, _)| begin == file));
        in_file && suite.only.is_none_or(|part| name.contains(part))
    };
    let names: Vec<String> =
        all.lines().filter_map(|line| line.strip_suffix(": test")).filter(is_of).map(str::to_owned).collect();
    if names.is_empty() { Err(format!("there is no test in {}", suite.name())) } else { Ok(names) }
}

/// The test program that a message of cargo tells of.
fn executable(line: &str) -> Option<PathBuf> {
    let message: serde_json::Value = serde_json::from_str(line).ok()?;
    let is_test = message["profile"]["test"].as_bool() == Some(true);
    message["executable"].as_str().filter(|_| is_test).map(PathBuf::from)
}
