//! Measures what a scan of a ring costs, in the spellings of grafc and in those by hand, under MATIEC and `gcc -O2`.
//!
//! ```text
//! cargo run --release -p grafc-testsuite --bin scan_cost -- --sizes 10,100 --folder /tmp/cost
//! ```
//!
//! Needs `iec2c` and `gcc` on PATH; without them it says so, and the exit code is 2.

#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a command")]

use clap::Parser;
use grafc_testsuite::executors::matiec::Tools;
use grafc_testsuite::scan_cost::{Figure, Job, measure};
use std::fs;
use std::num::NonZero;
use std::path::PathBuf;
use std::process::ExitCode;

/// What a scan of generated Structured Text costs, beside the same by hand, under MATIEC and gcc -O2
#[derive(Parser, Debug)]
struct Options {
    /// Steps of the ring, 2 or more
    #[arg(long, value_name = "N,…", value_delimiter = ',', default_value = "10,100,1000")]
    #[arg(value_parser = clap::value_parser!(u32).range(2..))]
    sizes: Vec<u32>,
    /// Turns in which everything is timed once
    #[arg(long, value_name = "N", default_value = "21")]
    repetitions: NonZero<usize>,
    /// Measure MATIEC's own SFC above 100 steps as well
    #[arg(long)]
    sfc: bool,
    /// Where texts, C and programs are kept; what is there is not built again
    #[arg(long, value_name = "DIR")]
    folder: Option<PathBuf>,
    /// Measure a text beside the others: a function block with the inputs x_0, x_1, … and the outputs w_0, w_1, …
    #[arg(long, value_name = "FILE")]
    with: Vec<String>,
}

fn main() -> ExitCode {
    let options = Options::parse();
    let tools = match Tools::find() {
        Ok(tools) => tools,
        Err(missing) => {
            eprintln!("{missing}");
            return ExitCode::from(2);
        }
    };
    match run(options, &tools) {
        Ok(()) => ExitCode::SUCCESS,
        Err(fault) => {
            eprintln!("{fault}");
            ExitCode::FAILURE
        }
    }
}

fn run(options: Options, tools: &Tools) -> Result<(), String> {
    let scratch = tempfile::tempdir().map_err(|e| e.to_string())?;
    let folder = options.folder.unwrap_or_else(|| scratch.path().to_path_buf());
    let read = |path: &String| fs::read_to_string(path).map_err(|e| format!("{path}: {e}"));
    let others = options.with.iter().map(|path| Ok((path.clone(), read(path)?))).collect::<Result<Vec<_>, String>>()?;
    let (repetitions, sfc) = (options.repetitions.get(), options.sfc);
    for steps in options.sizes.into_iter().map(|steps| steps as usize) {
        let job = Job { steps, repetitions, sfc, others: others.clone() };
        let all = measure(tools, &folder, &job)?;
        println!("{steps} steps, ns a scan, median of {repetitions}");
        println!("{:30} {:>10} {:>7} {:>10} {:>7}  to", "", "idle", "ratio", "clearing", "ratio");
        for figures in &all {
            let against = figures.against.unwrap_or("");
            println!("{:30} {} {}  {against}", figures.name, spell(&figures.idle), spell(&figures.clearing));
        }
        println!();
    }
    Ok(())
}

fn spell(figure: &Figure) -> String {
    let ratio = figure.ratio.map_or(String::new(), |ratio| format!("{ratio:.2}"));
    format!("{:>10.1} {ratio:>7}", figure.nanoseconds)
}
