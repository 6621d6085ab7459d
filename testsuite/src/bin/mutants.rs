//! Tries deliberate faults of the compiler: the suite must notice each.
//!
//! ```text
//! cargo run --release -p grafc-testsuite --bin mutants -- --only switch
//! ```
//!
//! Builds a copy of the workspace in `target/mutants` that has all faults of `testsuite/src/mutants`, runs the tests of
//! it without any, and then once for each fault, as far as the first test program that fails. Faults of Structured Text
//! and of the statement list are tried only if MATIEC and awlsim are there. The exit code is 1 if a fault was not noticed.

#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a command")]

use clap::Parser;
use grafc_testsuite::mutants::run::{passes, patience, suites};
use grafc_testsuite::mutants::workspace::{Suite, TestProgram, build, copy};
use grafc_testsuite::mutants::{Fault, all};
use grafc_testsuite::{awlsim, matiec};
use std::path::Path;
use std::process::ExitCode;
use std::time::Duration;

/// Deliberate faults of the compiler: the suite must notice each
#[derive(Parser, Debug)]
struct Options {
    /// Only faults whose names have this part; several may be given
    #[arg(long, value_name = "PART")]
    only: Vec<String>,
    /// List the faults and what they break
    #[arg(long)]
    list: bool,
}

fn main() -> ExitCode {
    match tried(&Options::parse()) {
        Ok(0) => ExitCode::SUCCESS,
        Ok(_) => ExitCode::FAILURE,
        Err(fault) => {
            eprintln!("{fault}");
            ExitCode::from(2)
        }
    }
}

/// How many faults were not noticed.
fn tried(options: &Options) -> Result<usize, String> {
    let asked = |fault: &&Fault| options.only.is_empty() || options.only.iter().any(|part| fault.name.contains(part));
    let mut faults: Vec<&Fault> = all().filter(asked).collect();
    if options.list {
        for fault in faults {
            println!("{}: {}", fault.name, fault.breaks);
        }
        return Ok(0);
    }
    let tools = [("backends/src/st/", matiec::Tools::find().err()), ("backends/src/awl/", awlsim::Tools::find().err())];
    for (folder, missing) in tools {
        let before = faults.len();
        faults.retain(|fault| missing.is_none() || !fault.file.starts_with(folder));
        if let Some(missing) = missing.filter(|_| faults.len() < before) {
            println!("{} faults of {folder} are skipped: {missing}", before - faults.len());
        }
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let workshop = root.join("target/mutants");
    copy(&root, &workshop)?;
    let log = workshop.join("target/log.txt");
    let mut programs: Vec<TestProgram> = Vec::new();
    for suite in faults.iter().flat_map(|fault| suites(fault)) {
        if !programs.iter().any(|program| program.suite == *suite) {
            programs.push(build(&workshop, *suite)?);
        }
    }
    let mut limits: Vec<Duration> = Vec::new();
    for program in &programs {
        let taken = passes(program, None, Duration::MAX, &log).map_err(|error| error.to_string())?;
        let name = program.suite.name();
        let taken = taken.ok_or_else(|| format!("{name} fails without any fault: see {}", log.display()))?;
        limits.push(patience(taken));
    }
    let notices = |suite: &Suite, fault: &Fault| -> Result<bool, String> {
        let mut known = programs.iter().zip(&limits);
        let Some((program, longest)) = known.find(|(program, _)| program.suite == *suite) else { return Ok(false) };
        passes(program, Some(fault), *longest, &log).map(|taken| taken.is_none()).map_err(|error| error.to_string())
    };
    println!("{} test programs pass without any fault", programs.len());
    let mut survivors = 0;
    for fault in &faults {
        let mut noticed = None;
        for suite in suites(fault) {
            if notices(suite, fault)? {
                noticed = Some(suite);
                break;
            }
        }
        match noticed {
            Some(suite) => println!("{}: noticed by {}", fault.name, suite.name()),
            None => {
                survivors += 1;
                println!("{}: NOT NOTICED ({}: {})", fault.name, fault.file, fault.breaks);
            }
        }
    }
    println!("{} faults, {} noticed, {survivors} not", faults.len(), faults.len() - survivors);
    Ok(survivors)
}
