//! Measures what a scan of a ring costs, in the spellings of grafc and in those by hand, under MATIEC and `gcc -O2`.
//!
//! ```text
//! cargo run --release -p grafc-testsuite --bin scan_cost -- [--sizes 10,100,1000] [--repetitions 21] [--sfc]
//!     [--folder DIR] [--with FILE]…
//! ```
//!
//! Needs `iec2c` and `gcc` on PATH; without them it says so, and the exit code is 2. `--sfc` measures MATIEC's own SFC
//! above 100 steps as well. `--folder` keeps texts, C and programs, and does not build again what is there. `--with`
//! measures a text beside the others: a function block with the inputs `x_0`, `x_1`, … and the outputs `w_0`, `w_1`, …
//! of the one size asked for.

#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a command")]

use grafc_testsuite::scan_cost::{Figure, Job, Library, measure};
use std::fs;
use std::path::PathBuf;
use std::process::ExitCode;

const USAGE: &str = "usage: scan_cost [--sizes N,N,…] [--repetitions N] [--sfc] [--folder DIR] [--with FILE]…";

struct Options {
    sizes: Vec<usize>,
    repetitions: usize,
    sfc: bool,
    folder: Option<PathBuf>,
    others: Vec<(String, String)>,
}

fn options() -> Result<Options, String> {
    let mut options =
        Options { sizes: vec![10, 100, 1000], repetitions: 21, sfc: false, folder: None, others: Vec::new() };
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        if word == "--sfc" {
            options.sfc = true;
            continue;
        }
        if !["--sizes", "--repetitions", "--folder", "--with"].contains(&word.as_str()) {
            return Err(USAGE.to_owned());
        }
        let value = words.next().ok_or_else(|| format!("`{word}` wants a value"))?;
        let number = |text: &str, least: usize| match text.parse() {
            Ok(n) if n >= least => Ok(n),
            Ok(_) | Err(_) => Err(format!("`{text}` is not a number from {least} on")),
        };
        match word.as_str() {
            "--sizes" => options.sizes = value.split(',').map(|text| number(text, 2)).collect::<Result<_, _>>()?,
            "--repetitions" => options.repetitions = number(&value, 1)?,
            "--folder" => options.folder = Some(PathBuf::from(value)),
            _ => {
                let text = fs::read_to_string(&value).map_err(|e| format!("{value}: {e}"))?;
                options.others.push((value, text));
            }
        }
    }
    Ok(options)
}

fn main() -> ExitCode {
    let (options, library) = match options().and_then(|options| Ok((options, Library::find()?))) {
        Ok(found) => found,
        Err(fault) => {
            eprintln!("{fault}");
            return ExitCode::from(2);
        }
    };
    match run(options, &library) {
        Ok(()) => ExitCode::SUCCESS,
        Err(fault) => {
            eprintln!("{fault}");
            ExitCode::FAILURE
        }
    }
}

fn run(options: Options, library: &Library) -> Result<(), String> {
    let scratch = tempfile::tempdir().map_err(|e| e.to_string())?;
    let folder = options.folder.unwrap_or_else(|| scratch.path().to_path_buf());
    for steps in options.sizes {
        let Options { repetitions, sfc, .. } = options;
        let job = Job { steps, repetitions, sfc, others: options.others.clone() };
        let all = measure(library, &folder, &job)?;
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
