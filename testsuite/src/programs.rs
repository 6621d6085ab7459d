//! Programs from outside: where they are, and what they say.

use std::env;
use std::io::Write as _;
use std::path::PathBuf;
use std::process::Command;

/// The file of a program on PATH.
pub(crate) fn on_path(name: &str) -> Option<PathBuf> {
    let path = env::var_os("PATH")?;
    env::split_paths(&path).map(|folder| folder.join(name)).find(|file| file.is_file())
}

/// What a program prints; what it complains of, if it fails.
pub(crate) fn call(command: &mut Command) -> Result<String, String> {
    let output = command.output().map_err(|e| format!("{command:?}: {e}"))?;
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    if output.status.success() {
        Ok(text(&output.stdout))
    } else {
        Err(format!("{command:?}: {}\n{}{}", output.status, text(&output.stdout), text(&output.stderr)))
    }
}

/// Tools, or nothing and a line that says why the test that wants them does nothing.
///
/// The line goes to the process's own standard error, because a passing test's output is not shown.
pub fn or_skip<T>(found: Result<T, String>) -> Option<T> {
    found.map_err(|missing| writeln!(std::io::stderr(), "skipped: {missing}")).ok()
}
