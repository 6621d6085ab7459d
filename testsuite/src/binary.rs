//! The `grafc` binary, for tests that run it as a user does.

use std::path::PathBuf;
use std::process::Command;
use std::sync::OnceLock;

/// The path of the binary, built now if it is not up to date.
///
/// Cargo builds the binary of another package for a test only by chance, so this asks for it.
pub fn grafc() -> PathBuf {
    static BINARY: OnceLock<PathBuf> = OnceLock::new();
    BINARY.get_or_init(build).clone()
}

fn build() -> PathBuf {
    // The test lies in `target/PROFILE/deps`, the binary belongs into `target/PROFILE`.
    let test = std::env::current_exe().expect("the path of the test");
    let folder = test.ancestors().nth(2).expect("a test lies in `target/PROFILE/deps`");
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    cargo.args(["build", "--quiet", "--package", "grafc-cli", "--bin", "grafc"]);
    cargo.current_dir(root());
    if folder.file_name().is_some_and(|name| name == "release") {
        cargo.arg("--release");
    }
    if let Some(target) = folder.parent() {
        cargo.arg("--target-dir").arg(target);
    }
    let status = cargo.status().expect("cargo can be run");
    assert!(status.success(), "the binary cannot be built");
    folder.join(format!("grafc{}", std::env::consts::EXE_SUFFIX))
}

/// The root of the workspace.
pub fn root() -> PathBuf {
    let here = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    here.parent().expect("the testsuite lies in the workspace").to_path_buf()
}
