//! The `grafc` binary, for tests that run it as a user does.

#[cfg(unix)]
use std::os::unix::process::CommandExt as _;
use std::path::PathBuf;
use std::process::Command;

/// A call of the binary, still without arguments.
///
/// It is a binary of this package, so that cargo has built it before the test; its name, which messages show, is the
/// true one.
pub fn grafc() -> Command {
    // The test lies in `target/PROFILE/deps`, the binary in `target/PROFILE`.
    let test = std::env::current_exe().expect("the path of the test");
    let folder = test.ancestors().nth(2).expect("a test lies in `target/PROFILE/deps`");
    #[allow(unused_mut, reason = "elsewhere it keeps its name")]
    let mut command = Command::new(folder.join(format!("grafc-under-test{}", std::env::consts::EXE_SUFFIX)));
    #[cfg(unix)]
    command.arg0("grafc");
    command
}

/// The root of the workspace.
pub fn root() -> PathBuf {
    let here = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    here.parent().expect("the testsuite lies in the workspace").to_path_buf()
}
