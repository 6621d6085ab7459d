//! One run of the suite, or of as much of it as a fault can touch.

use super::workspace::{Suite, TestProgram};
use super::{Fault, VARIABLE};
use std::fs::File;
use std::io;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// A test program that takes longer has not come to an end: a fault may make a loop endless.
const LONGEST: Duration = Duration::from_secs(900);

const fn suite(package: &'static str, folder: &'static str, test: Option<&'static str>) -> Suite {
    Suite { package, folder, test }
}

/// The tests that faults of the compiler should not pass, the quick ones first. Those that compare whole texts are left
/// out: they notice every change and judge none.
const COMPILER: &[Suite] = &[
    suite("grafc-testsuite", "testsuite", Some("vectors")),
    suite("grafc-net", "compiler/net", Some("passes")),
    suite("grafc-net", "compiler/net", Some("verify")),
    suite("grafc-logic", "compiler/logic", None),
    suite("grafc-logic", "compiler/logic", Some("programs")),
    suite("grafc-logic", "compiler/logic", Some("formulas")),
    suite("grafc-testsuite", "testsuite", Some("textbook")),
    suite("grafc-testsuite", "testsuite", Some("charts")),
    suite("grafc-testsuite", "testsuite", Some("net")),
    suite("grafc-testsuite", "testsuite", Some("transient")),
    suite("grafc-testsuite", "testsuite", Some("random")),
    suite("grafc-testsuite", "testsuite", Some("micro_steps")),
];
const STRUCTURED_TEXT: &[Suite] = &[suite("grafc-testsuite", "testsuite", Some("matiec"))];
const RUST: &[Suite] = &[suite("grafc-testsuite", "testsuite", Some("rust"))];

/// What has to catch a fault.
pub fn suites(fault: &Fault) -> &'static [Suite] {
    if fault.file.starts_with("backends/src/st/") {
        STRUCTURED_TEXT
    } else if fault.file.starts_with("backends/") {
        RUST
    } else {
        COMPILER
    }
}

/// Runs a test program with a fault, or with none; whether it passes. What it prints goes into a file.
pub fn passes(test: &TestProgram, fault: Option<&Fault>, log: &Path) -> io::Result<bool> {
    let log = File::create(log)?;
    let mut command = Command::new(&test.program);
    command.current_dir(&test.folder).env_remove(VARIABLE).env("RUST_BACKTRACE", "0");
    if let Some(fault) = fault {
        command.env(VARIABLE, fault.name);
    }
    let mut child = command.stdin(Stdio::null()).stdout(log.try_clone()?).stderr(log).spawn()?;
    let start = Instant::now();
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok(status.success());
        }
        if start.elapsed() > LONGEST {
            child.kill()?;
            child.wait()?;
            return Ok(false);
        }
        sleep(Duration::from_millis(50));
    }
}
