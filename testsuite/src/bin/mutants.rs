//! Tries deliberate faults of the compiler: the suite must notice each.
//!
//! ```text
//! cargo run --release -p grafc-testsuite --bin mutants -- --only switch
//! ```
//!
//! Builds a copy of the workspace in `target/mutants` that has all faults of `testsuite/src/mutants`, runs the tests of
//! it without any, and then once for each fault, as far as the first test program that fails. Tests that need MATIEC,
//! Beremiz or awlsim are left out where these are missing: a fault that the others do not notice is then undecided. The
//! end says how many were noticed, and lists those that were not and those that are undecided. The exit code is 1 if a
//! fault was not noticed.

#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a command")]

use clap::Parser;
use grafc_testsuite::binary::root;
use grafc_testsuite::executors;
use grafc_testsuite::mutants::run::{Ended, ended, patience, suites};
use grafc_testsuite::mutants::workspace::{Suite, TestProgram, build, copy};
use grafc_testsuite::mutants::{Fault, Places, all, places};
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::{Duration, Instant};

/// Deliberate faults of the compiler: the suite must notice each
#[derive(Parser, Debug)]
struct Options {
    /// Only faults whose names have this part; several may be given
    #[arg(long, value_name = "PART")]
    only: Vec<String>,
    /// List the faults, where they are and what they break
    #[arg(long)]
    list: bool,
}

fn main() -> ExitCode {
    match tried(&Options::parse()) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(fault) => {
            eprintln!("{fault}");
            ExitCode::from(2)
        }
    }
}

/// The test programs available, and how long each may take.
struct Bench {
    programs: Vec<(TestProgram, Duration)>,
    /// Those that lack a tool, and what is missing.
    lacking: Vec<(Suite, String)>,
    log: PathBuf,
}

/// What came of a fault.
enum Outcome {
    Noticed(Suite),
    /// Noticed by the time that it took.
    Endless(Suite),
    Unnoticed,
    /// Not noticed by what could be run; what the others lack.
    Undecided(String),
}

impl Bench {
    /// Builds what some faults need, and sees it pass without any.
    fn new(faults: &[&Fault]) -> Result<Bench, String> {
        let workshop = root().join("target/mutants");
        copy(&root(), &workshop)?;
        let mut bench = Bench { programs: Vec::new(), lacking: Vec::new(), log: workshop.join("target/log.txt") };
        let mut wanted: Vec<Suite> = Vec::new();
        for suite in faults.iter().flat_map(|fault| suites(fault)) {
            if !wanted.contains(suite) {
                wanted.push(*suite);
            }
        }
        for suite in wanted {
            match suite.needs.and_then(executors::missing) {
                Some(missing) => bench.lacking.push((suite, missing)),
                None => bench.programs.push((build(&workshop, suite)?, Duration::MAX)),
            }
        }
        for (program, longest) in &mut bench.programs {
            let name = program.suite.name();
            let taken = match ended(program, None, Duration::MAX, &bench.log).map_err(|error| error.to_string())? {
                Ended::Passed(taken) => taken,
                Ended::Failed | Ended::Stopped => {
                    return Err(format!("{name} fails without any fault: see {}", bench.log.display()));
                }
            };
            println!("{name} passes without any fault in {:.1} s", taken.as_secs_f32());
            *longest = patience(taken);
        }
        Ok(bench)
    }

    /// Runs what should notice a fault, up to the first that does.
    fn outcome(&self, fault: &Fault) -> Result<Outcome, String> {
        let mut missing = None;
        for suite in suites(fault) {
            if let Some((_, lacks)) = self.lacking.iter().find(|(lacking, _)| lacking == suite) {
                missing = Some(format!("{}: {lacks}", suite.name()));
            }
            let Some((program, longest)) = self.programs.iter().find(|(program, _)| program.suite == *suite) else {
                continue;
            };
            match ended(program, Some(fault), *longest, &self.log).map_err(|error| error.to_string())? {
                Ended::Passed(_) => {}
                Ended::Failed => return Ok(Outcome::Noticed(*suite)),
                Ended::Stopped => return Ok(Outcome::Endless(*suite)),
            }
        }
        Ok(missing.map_or(Outcome::Unnoticed, Outcome::Undecided))
    }
}

/// Whether no fault went unnoticed.
fn tried(options: &Options) -> Result<bool, String> {
    let asked = |fault: &Fault| options.only.is_empty() || options.only.iter().any(|part| fault.name.contains(part));
    let faults: Vec<&Fault> = all().filter(|fault| asked(fault)).collect();
    if options.list {
        let Places { found, complaints } = places(&root())?;
        for (fault, place) in found.iter().filter(|(fault, _)| asked(fault)) {
            println!("{}: {}: {}", place.file, fault.name, fault.breaks);
        }
        return if complaints.is_empty() { Ok(true) } else { Err(complaints.join("\n")) };
    }
    let start = Instant::now();
    let bench = Bench::new(&faults)?;
    for (suite, missing) in &bench.lacking {
        println!("{} is left out: {missing}", suite.name());
    }
    let (mut unnoticed, mut undecided) = (Vec::new(), Vec::new());
    for fault in &faults {
        let said = match bench.outcome(fault)? {
            Outcome::Noticed(suite) => format!("noticed by {}", suite.name()),
            Outcome::Endless(suite) => format!("noticed by {}, which found no end", suite.name()),
            Outcome::Unnoticed => {
                unnoticed.push(format!("{} ({:?}): {}", fault.name, fault.at.part, fault.breaks));
                "NOT NOTICED".to_owned()
            }
            Outcome::Undecided(missing) => {
                undecided.push(format!("{} ({missing})", fault.name));
                "undecided".to_owned()
            }
        };
        println!("{}: {said}", fault.name);
    }
    let noticed = faults.len() - unnoticed.len() - undecided.len();
    println!("{noticed} of {} noticed, in {} s", faults.len(), start.elapsed().as_secs());
    for (heading, list) in [("not noticed", &unnoticed), ("undecided, because a tool is missing", &undecided)] {
        if !list.is_empty() {
            println!("{} {heading}:\n  {}", list.len(), list.join("\n  "));
        }
    }
    Ok(unnoticed.is_empty())
}
