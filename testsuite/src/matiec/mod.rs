//! Generated Structured Text and instruction lists, as MATIEC compiles them and a C compiler runs them.
//!
//! The function blocks of many charts go into one file for `iec2c`, what it writes and a driver of ours (`driver`)
//! into one program for `gcc`, which plays each chart's trace and prints what came out. The time is fixed throughout a
//! call, as the PLC's cycle fixes it.

mod driver;
mod tools;

use crate::jobs;
pub use crate::jobs::Job;
use grafc_backends::{il, st};
use grafc_model::chart::{Arithmetic, Chart, ExprKind, Type};
use grafc_model::reaction::Response;
use std::fs;
pub use tools::Tools;
pub(crate) use tools::call;

/// The language of the code.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Language {
    /// Structured Text.
    St,
    /// Instruction list.
    Il,
}

impl Language {
    /// Both.
    pub const ALL: [Language; 2] = [Language::St, Language::Il];
}

/// A job as the tools take it.
struct Unit {
    /// The text of its function block.
    text: String,
    /// The C code that runs it.
    driver: String,
}

/// Runs all jobs, in one batch if possible. A job's fault is what a tool said.
pub fn run(tools: &Tools, language: Language, jobs: &[Job]) -> Vec<Result<Vec<Response>, String>> {
    let units = jobs.iter().enumerate().map(|(index, job)| unit(language, index, job)).collect();
    jobs::run(jobs, units, |batch, units: &[&Unit]| build_and_play(tools, batch, units))
}

fn unit(language: Language, index: usize, job: &Job) -> Result<Unit, String> {
    let mut program = job.program.clone();
    program.name = format!("Job_{index}");
    // A function block has no addresses.
    for variable in &mut program.variables {
        variable.address = None;
    }
    let (text, names) = match language {
        Language::St => (st::emit(&program, &st::Options::default()), st::names(&program)),
        Language::Il => (il::emit(&program, &il::Options::default()), il::names(&program)),
    };
    let text = text.map_err(|said| format!("{said:#?}"))?;
    let block = text
        .lines()
        .find_map(|line| line.trim().strip_prefix("FUNCTION_BLOCK "))
        .ok_or("the text has no function block")?
        .trim()
        .to_string();
    let driver = driver::write(index, &program, &names, &block, &job.stimuli)?;
    Ok(Unit { text, driver })
}

fn build_and_play(tools: &Tools, batch: &[usize], units: &[&Unit]) -> Result<String, String> {
    let folder = tempfile::tempdir().map_err(|e| e.to_string())?;
    let source: String = units.iter().map(|u| u.text.as_str()).collect::<Vec<_>>().join("\n");
    fs::write(folder.path().join("charts.st"), &source).map_err(|e| e.to_string())?;
    tools.iec2c(folder.path()).map_err(|said| format!("{said}\n{source}"))?;
    let mut main = driver::HEAD.to_string();
    for unit in units {
        main.push_str(&unit.driver);
    }
    main.push_str(&driver::main(batch));
    fs::write(folder.path().join("main.c"), &main).map_err(|e| e.to_string())?;
    tools.gcc(folder.path()).map_err(|said| format!("{said}\n{source}"))?;
    tools.play(folder.path()).map_err(|said| format!("{said}\n{source}"))
}

/// Whether MATIEC reckons something in a chart wrongly, so that a comparison would test MATIEC and not grafc.
///
/// It multiplies the nanoseconds of a time as 32 bits (`T#250ms * 10` is negative), and divides a time into fractions
/// of a millisecond, of which `.gct` has none.
pub fn misreckons(chart: &Chart) -> bool {
    chart.exprs.iter().any(|expr| match expr.kind {
        ExprKind::Arithmetic(Arithmetic::Multiply | Arithmetic::Divide, _, _) => expr.ty == Type::Time,
        _ => false,
    })
}

/// Whether `iec2c` takes a text.
pub fn accepts(tools: &Tools, text: &str) -> Result<(), String> {
    let folder = tempfile::tempdir().map_err(|e| e.to_string())?;
    fs::write(folder.path().join("charts.st"), text).map_err(|e| e.to_string())?;
    tools.iec2c(folder.path())
}
