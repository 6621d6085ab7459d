//! One run of the suite, or of as much of it as a fault can touch.

use super::workspace::{Suite, TestProgram};
use super::{Fault, VARIABLE};
use std::fs::File;
use std::io;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// What a test program may take beyond what it takes without a fault, and how many times as long: a fault may make a
/// loop endless, and that is noticed by the time.
const PATIENCE: (Duration, u32) = (Duration::from_secs(20), 5);

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

/// The unit tests judge the statements that no chart leads to.
const STRUCTURED_TEXT: &[Suite] =
    &[suite("grafc-testsuite", "testsuite", Some("matiec")), suite("grafc-backends", "backends", None)];
const STATEMENT_LIST: &[Suite] =
    &[suite("grafc-testsuite", "testsuite", Some("awl")), suite("grafc-backends", "backends", None)];
const RUST: &[Suite] = &[suite("grafc-testsuite", "testsuite", Some("rust"))];

/// What has to catch a fault.
pub fn suites(fault: &Fault) -> &'static [Suite] {
    if fault.file.starts_with("backends/src/st/") {
        STRUCTURED_TEXT
    } else if fault.file.starts_with("backends/src/awl/") {
        STATEMENT_LIST
    } else if fault.file.starts_with("backends/") {
        RUST
    } else {
        COMPILER
    }
}

/// How long a test program may take that has taken so long without a fault.
pub fn patience(without_fault: Duration) -> Duration {
    PATIENCE.0 + without_fault * PATIENCE.1
}

/// Runs a test program with a fault, or with none; how long it took to pass, if it did and was not too long at it. What
/// it prints goes into a file.
pub fn passes(
    test: &TestProgram,
    fault: Option<&Fault>,
    longest: Duration,
    log: &Path,
) -> io::Result<Option<Duration>> {
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
            return Ok(status.success().then(|| start.elapsed()));
        }
        if start.elapsed() > longest {
            child.kill()?;
            child.wait()?;
            return Ok(None);
        }
        sleep(Duration::from_millis(50));
    }
}
