//! Measures how many scans a second the scan program of a chart does for 64 scenarios at once, beside one at a time.
//!
//! ```text
//! cargo run --release -p grafc-testsuite --bin lanes_cost -- testsuite/charts/weigh_mix_b4.gct
//! ```
//!
//! Both are given the same random inputs, which change in a third of the scans, a second apart. They take turns; a figure is
//! the median of their turns, and the ratio the median of the ratios of turns side by side.

#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a command")]

use clap::Parser;
use grafc_lanes::{LANES, Lanes};
use grafc_logic::scan::Program;
use grafc_logic::scan::evaluate::Evaluator;
use grafc_logic::{Encoding, Options as Lowering};
use grafc_model::reaction::Stimulus;
use grafc_testsuite::charts::check;
use grafc_testsuite::random::trace;
use grafc_testsuite::runs::compile;
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Instant;

/// Scans a second for 64 scenarios at once, beside one at a time
#[derive(Parser, Debug)]
struct Options {
    /// Charts
    #[arg(value_name = "CHART", required = true)]
    charts: Vec<PathBuf>,
    /// Turns in which both are timed once
    #[arg(long, value_name = "N", default_value = "21")]
    turns: usize,
    /// Scans of each scenario in a turn
    #[arg(long, value_name = "N", default_value = "200")]
    scans: usize,
}

fn main() -> ExitCode {
    let options = Options::parse();
    for path in &options.charts {
        if let Err(fault) = measure(path, &options) {
            eprintln!("{fault}");
            return ExitCode::FAILURE;
        }
    }
    ExitCode::SUCCESS
}

fn measure(path: &std::path::Path, options: &Options) -> Result<(), String> {
    let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let text = std::fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))?;
    let chart = check(&name, &text)?;
    let traces: Vec<Vec<Stimulus>> = (0..LANES as u64).map(|seed| trace(seed, &chart, options.scans)).collect();
    for encoding in Encoding::ALL.into_iter().filter(|encoding| !encoding.overlaps()) {
        let program = compile(&chart, &Lowering { encoding, ..Lowering::default() })?;
        let scans = (LANES * options.scans) as f64;
        let mut figures: Vec<[f64; 3]> = Vec::new();
        for _ in 0..options.turns.max(1) {
            let (one, all) = (scans / alone(&program, &traces), scans / at_once(&program, &traces));
            figures.push([one, all, all / one]);
        }
        let median = |place: usize| {
            let mut sorted: Vec<f64> = figures.iter().map(|figure| figure[place]).collect();
            sorted.sort_by(f64::total_cmp);
            sorted[sorted.len() / 2]
        };
        println!(
            "{name} {:<13} {:>12.0} scans/s alone {:>13.0} scans/s at once   {:>6.1} times",
            encoding.name(),
            median(0),
            median(1),
            median(2)
        );
    }
    Ok(())
}

/// Seconds for all traces one after the other.
fn alone(program: &Program, traces: &[Vec<Stimulus>]) -> f64 {
    let began = Instant::now();
    for trace in traces {
        let mut evaluator = Evaluator::new(program);
        for stimulus in trace {
            std::hint::black_box(evaluator.react(stimulus));
        }
    }
    began.elapsed().as_secs_f64()
}

/// Seconds for all traces at once.
fn at_once(program: &Program, traces: &[Vec<Stimulus>]) -> f64 {
    let began = Instant::now();
    let mut lanes = Lanes::new(program);
    for row in 0..traces[0].len() {
        let stimuli: Vec<&Stimulus> = traces.iter().map(|trace| &trace[row]).collect();
        lanes.react(&stimuli);
        std::hint::black_box(lanes.situation());
    }
    began.elapsed().as_secs_f64()
}
