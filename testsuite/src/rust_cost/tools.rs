//! Builds the program of one spelling: the chart as a crate of its own, whose compilation is timed, and a program
//! around it.
//!
//! Both with `-C opt-level=3`, and otherwise as rustc does by default. What is written by hand gets a larger stack for
//! rustc, which overflows on `PartialEq` for a struct of 10,000 fields: an engineer would do as its message says.

use crate::executors::rust::Tools;
use crate::programs::call;
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// How often it is asked whether rustc has come to its end.
const PAUSE: Duration = Duration::from_millis(5);

const RUSTC: [&str; 4] = ["--edition", "2024", "-C", "opt-level=3"];

/// The stack for rustc, in bytes, where it is to have more than usual.
const STACK: &str = "1000000000";

/// How rustc is called for a chart.
#[derive(Clone, Copy)]
pub(super) struct Call {
    /// How long it may take.
    pub(super) limit: Duration,
    /// Whether it has a larger stack than usual.
    pub(super) more_stack: bool,
}

/// What came of a chart.
pub(super) enum Built {
    /// A program, and the seconds of rustc for the chart's crate, if it was rustc.
    Program(PathBuf, Option<f64>),
    /// rustc did not come to an end: why.
    Without(String),
}

/// Builds in a folder of its own, unless the program is there already.
pub(super) fn build(tools: &Tools, folder: &Path, chart: &str, main: &str, with: Call) -> Result<Built, String> {
    let place = |name: &str| folder.join(name);
    let failed = |path: &Path, e: std::io::Error| format!("{}: {e}", path.display());
    let program = place("main");
    let same = |name: &str, text: &str| fs::read_to_string(place(name)).is_ok_and(|old| old == text);
    if same("chart.rs", chart) && same("main.rs", main) && program.is_file() {
        let seconds = fs::read_to_string(place("seconds")).ok().and_then(|text| text.parse().ok());
        if seconds.is_some() {
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
    if with.more_stack {
        rustc.env("RUST_MIN_STACK", STACK);
    }
    let seconds = match timed(rustc, &place("said"), with.limit)? {
        Ok(seconds) => seconds,
        Err(why) => return Ok(Built::Without(why)),
    };
    fs::write(place("seconds"), seconds.to_string()).map_err(|e| failed(&place("seconds"), e))?;
    let mut rustc = tools.command();
    rustc.args(RUSTC).args(["--extern", "chart=libchart.rlib", "-o", "main", "main.rs"]).current_dir(folder);
    call(&mut rustc)?;
    Ok(Built::Program(program, Some(seconds)))
}

/// The seconds that a compiler takes, or why it did not come to an end. What it says goes into a file: nobody reads a pipe.
pub(super) fn timed(mut compiler: Command, said: &Path, limit: Duration) -> Result<Result<f64, String>, String> {
    let name = compiler.get_program().to_string_lossy().into_owned();
    let name = name.rsplit('/').next().unwrap_or_default();
    let failed = |e: std::io::Error| format!("{name}: {e}");
    let file = File::create(said).map_err(failed)?;
    let begin = Instant::now();
    let mut child = compiler.stdout(Stdio::null()).stderr(file).spawn().map_err(failed)?;
    loop {
        if let Some(status) = child.try_wait().map_err(failed)? {
            let taken = begin.elapsed().as_secs_f64();
            return match status.code() {
                Some(0) => Ok(Ok(taken)),
                Some(_) => Err(format!("{name}: {status}\n{}", fs::read_to_string(said).unwrap_or_default())),
                // A signal: its stack or the machine's memory was not enough.
                None => Ok(Err(format!("{name} broke down after {taken:.0} s: {status}"))),
            };
        }
        if begin.elapsed() >= limit {
            child.kill().map_err(failed)?;
            child.wait().map_err(failed)?;
            return Ok(Err(format!("{name} was stopped after {} s", limit.as_secs())));
        }
        sleep(PAUSE);
    }
}
