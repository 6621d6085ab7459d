//! Generated Structured Text, as MATIEC compiles it and a C compiler runs it.
//!
//! The function blocks of many charts go into one file for `iec2c`, what it writes and a driver of ours (`driver`)
//! into one program for `gcc`, which plays each chart's trace and prints what came out. The time is fixed throughout a
//! call, as the PLC's cycle fixes it. If a file of many charts is refused, each is tried alone, so that a fault is
//! reported with its chart.

mod driver;
mod tools;

use grafc_backends::st;
use grafc_logic::scan::Program;
use grafc_model::chart::{Arithmetic, Chart, ExprKind, Type};
use grafc_model::reaction::{Response, Stimulus};
use std::fs;
pub use tools::Tools;

/// A program and what it is given.
pub struct Job {
    /// The scan program; its name is replaced by one that is unique among the jobs.
    pub program: Program,
    /// The calls.
    pub stimuli: Vec<Stimulus>,
}

/// A job as the tools take it.
struct Unit {
    /// The Structured Text of its function block.
    text: String,
    /// The C code that runs it.
    driver: String,
}

/// Runs all jobs, in one batch if possible. A job's fault is what a tool said.
pub fn run(tools: &Tools, jobs: &[Job]) -> Vec<Result<Vec<Response>, String>> {
    let units: Vec<Result<Unit, String>> = jobs.iter().enumerate().map(|(index, job)| unit(index, job)).collect();
    let good: Vec<usize> = (0..jobs.len()).filter(|&i| units[i].is_ok()).collect();
    let mut results: Vec<Result<Vec<Response>, String>> = units
        .iter()
        .map(|unit| match unit {
            Ok(_) => Err("was not run".to_string()),
            Err(fault) => Err(fault.clone()),
        })
        .collect();
    let mut open = vec![good];
    while let Some(batch) = open.pop() {
        let chosen: Vec<&Unit> = batch.iter().filter_map(|&i| units[i].as_ref().ok()).collect();
        if chosen.is_empty() {
            continue;
        }
        match build_and_play(tools, &batch, &chosen) {
            Ok(printed) => {
                for &index in &batch {
                    results[index] = driver::read(&jobs[index], index, &printed);
                }
            }
            Err(fault) if batch.len() == 1 => results[batch[0]] = Err(fault),
            Err(_) => {
                let (left, right) = batch.split_at(batch.len() / 2);
                open.push(left.to_vec());
                open.push(right.to_vec());
            }
        }
    }
    results
}

fn unit(index: usize, job: &Job) -> Result<Unit, String> {
    let mut program = job.program.clone();
    program.name = format!("Job_{index}");
    // A function block has no addresses.
    for variable in &mut program.variables {
        variable.address = None;
    }
    let text = st::emit(&program, &st::Options::default()).map_err(|said| format!("{said:#?}"))?;
    let names = st::names(&program);
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
