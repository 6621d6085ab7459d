//! One run of the suite, or of as much of it as a fault can touch.

use super::workspace::{Suite, TestProgram};
use super::{Fault, Part, VARIABLE};
use crate::share::THOROUGH;
use crate::tools::Tool;
use std::fs::File;
use std::io;
#[cfg(unix)]
use std::os::unix::process::CommandExt;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// What a test program may take beyond what it takes without a fault, and how many times as long: a fault may make a
/// loop endless, and that is noticed by the time.
const PATIENCE: (Duration, u32) = (Duration::from_secs(20), 5);

/// A file of the test suite.
const fn tests(file: &'static str) -> Suite {
    Suite { file: Some(file), ..suite("grafc-testsuite", "testsuite", Some("suite")) }
}

const fn suite(package: &'static str, folder: &'static str, test: Option<&'static str>) -> Suite {
    Suite { package, folder, test, file: None, only: None, needs: None }
}

/// Tests that need a tool, of a file of the test suite those whose names have a part.
const fn with(tool: Tool, test: &'static str, only: Option<&'static str>) -> Suite {
    Suite { only, needs: Some(tool), ..tests(test) }
}

/// The tests that faults of the compiler should not pass, the quick ones first. Those that compare whole texts are left
/// out: they notice every change and judge none.
const COMPILER: &[Suite] = &[
    tests("vectors"),
    suite("grafc-net", "compiler/net", Some("passes")),
    suite("grafc-net", "compiler/net", Some("verify")),
    suite("grafc-logic", "compiler/logic", None),
    suite("grafc-logic", "compiler/logic", Some("programs")),
    suite("grafc-logic", "compiler/logic", Some("formulas")),
    tests("textbook"),
    tests("charts"),
    tests("net"),
    tests("transient"),
    tests("random"),
    tests("micro_steps"),
    suite("grafc-logic", "compiler/logic", Some("warnings")),
    tests("cases"),
    tests("controls"),
    tests("livelock"),
    tests("warnings"),
    tests("observed"),
];

/// The unit tests judge what charts seldom lead to.
const PROVER: &[Suite] = &[suite("grafc-verify", "compiler/verify", None), tests("circuit"), tests("verify")];

const AUTOMATA: &[Suite] = &[tests("vectors"), suite("grafc-automata", "compiler/automata", None), tests("automata")];
const LANES: &[Suite] = &[tests("lanes"), tests("batch")];

/// The unit tests judge the statements that no chart leads to, and what is right only for other tools.
const BACKENDS: Suite = suite("grafc-backends", "backends", None);
const STRUCTURED_TEXT: &[Suite] = &[with(Tool::Matiec, "matiec", None), BACKENDS];
const INSTRUCTION_LIST: &[Suite] = &[
    Suite { only: Some("instruction_lists"), ..tests("controller") },
    with(Tool::Matiec, "matiec", Some("instruction_lists")),
    BACKENDS,
];
const STATEMENT_LIST: &[Suite] = &[with(Tool::Awlsim, "awl", None), BACKENDS];
const LADDER: &[Suite] = &[
    Suite { only: Some("ladders"), ..tests("controller") },
    with(Tool::Beremiz, "beremiz", Some("ladders")),
    tests("plcopen_ld"),
    BACKENDS,
];
const CHART: &[Suite] =
    &[tests("plcopen_sfc"), tests("sfc"), with(Tool::Beremiz, "beremiz", Some("sequential_function_charts")), BACKENDS];
const RUST: &[Suite] = &[
    Suite { only: Some("overlapping"), ..tests("rust") },
    tests("saved"),
    Suite { only: Some("vectors"), ..tests("rust") },
    tests("rust"),
];
const JAVASCRIPT: &[Suite] = &[
    with(Tool::Node, "js", None),
    with(Tool::Node, "observed", Some("modules")),
    with(Tool::Node, "edges_of_types", None),
    BACKENDS,
];

const C: &[Suite] = &[
    with(Tool::Cc, "c", Some("vectors")),
    with(Tool::Cc, "c", None),
    tests("c_projects"),
    with(Tool::Cc, "c_elsewhere", Some("less_exact")),
    with(Tool::Arduino, "c_projects", None),
    BACKENDS,
];

/// What has to catch a fault.
pub fn suites(fault: &Fault) -> &'static [Suite] {
    match fault.at.part {
        Part::Compiler => COMPILER,
        Part::Prover => PROVER,
        Part::Automata => AUTOMATA,
        Part::Lanes => LANES,
        Part::StructuredText => STRUCTURED_TEXT,
        Part::InstructionList => INSTRUCTION_LIST,
        Part::StatementList => STATEMENT_LIST,
        Part::Ladder => LADDER,
        Part::Chart => CHART,
        Part::JavaScript | Part::Braces => JAVASCRIPT,
        Part::C => C,
        Part::Restoring | Part::Rust | Part::Shared => RUST,
    }
}

/// How long a test program may take that has taken so long without a fault.
pub fn patience(without_fault: Duration) -> Duration {
    PATIENCE.0 + without_fault * PATIENCE.1
}

/// Stops a test program, and with it the programs that it has started: an endless one would never stop.
fn stop(child: &mut Child) -> io::Result<()> {
    if cfg!(unix) {
        // The group has the number of its first process. Without the command `kill` the others stay.
        let _ = Command::new("kill").args(["-KILL", "--", &format!("-{}", child.id())]).stderr(Stdio::null()).status();
    }
    child.kill()?;
    child.wait()?;
    Ok(())
}

/// How a test program ended.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Ended {
    /// It passed, in this time.
    Passed(Duration),
    /// A test failed.
    Failed,
    /// It was stopped: a fault may make a loop endless. On a busy machine this tells less than a failure.
    Stopped,
}

/// Runs a test program with a fault, or with none, for so long at most. What it prints goes into a file.
pub fn ended(test: &TestProgram, fault: Option<&Fault>, longest: Duration, log: &Path) -> io::Result<Ended> {
    let log = File::create(log)?;
    let mut command = Command::new(&test.program);
    command
        .args(&test.tests)
        .arg("--exact")
        .current_dir(&test.folder)
        .env_remove(VARIABLE)
        .env("RUST_BACKTRACE", "0")
        .env(THOROUGH, "1");
    if let Some(fault) = fault {
        command.env(VARIABLE, fault.name);
    }
    #[cfg(unix)]
    command.process_group(0);
    let mut child = command.stdin(Stdio::null()).stdout(log.try_clone()?).stderr(log).spawn()?;
    let start = Instant::now();
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok(if status.success() { Ended::Passed(start.elapsed()) } else { Ended::Failed });
        }
        if start.elapsed() > longest {
            stop(&mut child)?;
            return Ok(Ended::Stopped);
        }
        sleep(Duration::from_millis(50));
    }
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn what_a_test_program_started_ends_with_it() {
        let folder = tempfile::tempdir().expect("a folder");
        let marks = folder.path().join("marks");
        let mut shell = Command::new("sh");
        shell.arg("-c").arg(format!("(while :; do echo >> '{}'; sleep 0.01; done) & wait", marks.display()));
        let mut child = shell.process_group(0).spawn().expect("a shell");
        let written = || fs::metadata(&marks).map_or(0, |file| file.len());
        while written() == 0 {
            sleep(Duration::from_millis(10));
        }
        stop(&mut child).expect("it is stopped");
        let at_the_end = written();
        sleep(Duration::from_millis(500));
        assert_eq!(written(), at_the_end, "what it started still writes");
    }
}
