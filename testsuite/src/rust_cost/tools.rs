//! Builds the program of one spelling: the chart as a crate of its own, whose compilation is timed, and a program
//! around it.
//!
//! Both with `-C opt-level=3`, and otherwise as rustc does by default.

use crate::matiec::call;
use crate::rust::Tools;
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// How often it is asked whether rustc has come to its end.
const PAUSE: Duration = Duration::from_millis(5);

const RUSTC: [&str; 4] = ["--edition", "2024", "-C", "opt-level=3"];

/// What came of a chart.
pub(super) enum Built {
    /// A program, and the seconds that rustc took for the chart's crate.
    Program(PathBuf, f64),
    /// rustc was stopped.
    OverLimit,
}

/// Builds in a folder of its own, unless the program is there already.
pub(super) fn build(tools: &Tools, folder: &Path, chart: &str, main: &str, limit: Duration) -> Result<Built, String> {
    let place = |name: &str| folder.join(name);
    let failed = |path: &Path, e: std::io::Error| format!("{}: {e}", path.display());
    let program = place("main");
    let same = |name: &str, text: &str| fs::read_to_string(place(name)).is_ok_and(|old| old == text);
    if same("chart.rs", chart) && same("main.rs", main) && program.is_file() {
        let seconds = fs::read_to_string(place("seconds")).ok().and_then(|text| text.parse().ok());
        if let Some(seconds) = seconds {
            return Ok(Built::Program(program, seconds));
        }
    }
    fs::create_dir_all(folder).map_err(|e| failed(folder, e))?;
    if program.is_file() {
        fs::remove_file(&program).map_err(|e| failed(&program, e))?;
    }
    for (name, text) in [("chart.rs", chart), ("main.rs", main)] {
        fs::write(place(name), text).map_err(|e| failed(&place(name), e))?;
    }
    let mut rustc = tools.command();
    rustc.args(RUSTC).args(["--crate-type", "rlib", "--crate-name", "chart", "chart.rs"]).current_dir(folder);
    let Some(seconds) = timed(rustc, &place("said"), limit)? else { return Ok(Built::OverLimit) };
    fs::write(place("seconds"), seconds.to_string()).map_err(|e| failed(&place("seconds"), e))?;
    let mut rustc = tools.command();
    rustc.args(RUSTC).args(["--extern", "chart=libchart.rlib", "-o", "main", "main.rs"]).current_dir(folder);
    call(&mut rustc)?;
    Ok(Built::Program(program, seconds))
}

/// The seconds that a command takes, or none if it was stopped. What it says goes into a file: nobody reads a pipe.
fn timed(mut command: Command, said: &Path, limit: Duration) -> Result<Option<f64>, String> {
    let failed = |e: std::io::Error| format!("rustc: {e}");
    let file = File::create(said).map_err(failed)?;
    let begin = Instant::now();
    let mut child = command.stdout(Stdio::null()).stderr(file).spawn().map_err(failed)?;
    loop {
        if let Some(status) = child.try_wait().map_err(failed)? {
            if status.success() {
                return Ok(Some(begin.elapsed().as_secs_f64()));
            }
            return Err(format!("rustc: {status}\n{}", fs::read_to_string(said).unwrap_or_default()));
        }
        if begin.elapsed() >= limit {
            child.kill().map_err(failed)?;
            child.wait().map_err(failed)?;
            return Ok(None);
        }
        sleep(PAUSE);
    }
}
