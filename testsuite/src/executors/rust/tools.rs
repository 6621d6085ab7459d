//! rustc.

use crate::binary::root;
use crate::programs::call;
use crate::tools::{Tool, or_skip};
use std::path::{Path, PathBuf};
use std::process::Command;

/// What a test compiles has all checks that rustc can put in.
const CHECKED: [&str; 4] = ["--edition", "2024", "-C", "debug-assertions=on"];

/// rustc, if it can be called.
pub struct Tools {
    rustc: PathBuf,
    version: String,
}

impl Tools {
    /// The rustc that `RUSTC` names, else that on the search path; the error says what is missing.
    pub fn find() -> Result<Tools, String> {
        let rustc = PathBuf::from(std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into()));
        match Command::new(&rustc).arg("--version").output() {
            Ok(output) if output.status.success() => {
                let version = String::from_utf8_lossy(&output.stdout).trim().to_owned();
                Ok(Tools { rustc, version })
            }
            Ok(_) | Err(_) => Err("rustc cannot be called".to_string()),
        }
    }

    /// rustc, or nothing and a line on standard error that says why the test that wants it does nothing.
    pub fn find_or_skip() -> Option<Tools> {
        or_skip(Tool::Rustc, Tools::find())
    }

    /// What rustc says of itself.
    pub fn version(&self) -> &str {
        &self.version
    }

    /// Compiles `main.rs` with all checks that rustc can put in. It may use the run-time crate.
    pub(super) fn rustc(&self, folder: &Path) -> Result<(), String> {
        let with = ["--extern", "grafc_runtime=libgrafc_runtime.rlib"];
        self.call(folder, &[&CHECKED[..], &with, &["-o", "main", "main.rs"]].concat()).map(|_| ())
    }

    /// Compiles the run-time crate, as it is without its features.
    pub(super) fn runtime(&self, folder: &Path) -> Result<(), String> {
        let crate_type = ["--crate-name", "grafc_runtime", "--crate-type", "rlib"];
        let library = root().join("runtime-support/src/lib.rs");
        let library = library.to_str().ok_or("a path that is no text")?;
        self.call(folder, &[&CHECKED[..], &crate_type, &[library]].concat()).map(|_| ())
    }

    /// Compiles `main.rs` and the run-time crate that it uses.
    ///
    /// # Errors
    /// What rustc says.
    pub fn build(&self, folder: &Path) -> Result<(), String> {
        self.runtime(folder)?;
        self.rustc(folder)
    }

    /// A call of rustc, still without arguments.
    pub fn command(&self) -> Command {
        Command::new(&self.rustc)
    }

    /// Calls rustc in a folder; what it prints, or its complaint.
    pub fn call(&self, folder: &Path, arguments: &[&str]) -> Result<String, String> {
        call(self.command().args(arguments).current_dir(folder))
    }

    /// Whether programs for this target can be compiled: whether there is a `core` for it.
    pub fn has_target(&self, target: &str) -> bool {
        let printed = call(self.command().args(["--print", "target-libdir", "--target", target]));
        let entries = printed.ok().and_then(|folder| std::fs::read_dir(folder.trim()).ok());
        entries.into_iter().flatten().flatten().any(|entry| entry.file_name().to_string_lossy().starts_with("libcore-"))
    }

    /// Runs what was compiled.
    pub fn play(&self, folder: &Path) -> Result<String, String> {
        call(&mut Command::new(folder.join("main")))
    }
}
