//! `grafc-testsuite diff` and `grafc-testsuite executors`.

use super::long_run::{self, Draft, Plan};
use super::{mismatch, table};
use crate::executors::{self, Executor};
use crate::random::ChartKind;
use clap::Args;
use std::io::{IsTerminal, Write};
use std::num::NonZero;
use std::path::PathBuf;
use std::process::ExitCode;

/// From so many charts of all kinds on, each production and each rule must have been met.
const ENOUGH: u64 = 2000;

/// So many mismatches of an executor are shrunk and shown; of the others only the seeds are.
const SHOWN: usize = 3;

/// Random charts and traces through many executors: all must do what the simulator does
#[derive(Args, Debug)]
pub struct Arguments {
    /// How many charts
    #[arg(long, default_value_t = 1000, value_name = "N")]
    charts: u64,
    /// The seed of the first; the others have those that follow
    #[arg(long, default_value_t = 0, value_name = "S")]
    seed: u64,
    /// How large they are: with 1 up to 5 grafcets of up to 8 steps, growing in both
    #[arg(long, default_value_t = 1, value_name = "L", value_parser = clap::value_parser!(u8).range(1..=20))]
    size: u8,
    /// All of them of a kind [default: plain, flat and hierarchical ones]
    #[arg(long, value_enum)]
    kind: Option<ChartKind>,
    /// Calls of each chart
    #[arg(long, default_value_t = 50, value_name = "N")]
    scans: usize,
    /// Executors, by name or group; see `grafc-testsuite executors`
    #[arg(long, default_value = "built-in", value_name = "A,B,…")]
    executors: String,
    /// Threads [default: one a processor]
    #[arg(long, value_name = "N")]
    threads: Option<NonZero<usize>>,
    /// Where to put the figures as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Where to keep mismatches, shrunk, as charts with a trace and an expectation
    #[arg(long, value_name = "DIR")]
    save: Option<PathBuf>,
}

/// Runs the charts. The exit code is 1 if there was a mismatch, or something was not covered that should be.
pub fn run(arguments: &Arguments) -> Result<ExitCode, String> {
    // The simulator is the reference and always runs.
    let mut executors = executors::select(&arguments.executors)?;
    executors.retain(|executor| executor.name() != "simulator");
    let plan = Plan {
        charts: arguments.charts,
        seed: arguments.seed,
        size: usize::from(arguments.size),
        kind: arguments.kind,
        scans: arguments.scans,
        threads: arguments.threads,
    };
    // A panic of a stage is caught and reported with its chart.
    std::panic::set_hook(Box::new(|_| {}));
    let mut told = 0;
    let summary = long_run::run(&plan, &executors, |charts, mismatches| progress(&plan, charts, mismatches, &mut told));
    clear_progress();
    let mut out = String::new();
    for seed in &summary.tallies[0].mismatches {
        out.push_str(&format!("--- seed {seed}: the simulator panicked\n"));
    }
    for (executor, tally) in executors.iter().zip(&summary.tallies[1..]) {
        for seed in tally.mismatches.iter().take(SHOWN) {
            let mismatch = mismatch::of(executor.as_ref(), &Draft::of(*seed, &plan));
            out.push_str(&mismatch.show(executor.name()));
            if let Some(folder) = &arguments.save {
                let path = mismatch.save(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
                out.push_str(&format!("kept as {}\n", path.display()));
            }
            out.push('\n');
        }
        if let Some(others) = tally.mismatches.get(SHOWN..).filter(|others| !others.is_empty()) {
            out.push_str(&format!("--- {} disagrees on the seeds {others:?}, too\n\n", executor.name()));
        }
    }
    out.push_str(&table::table(&executors, &summary));
    let uncovered =
        if plan.charts >= ENOUGH && plan.kind.is_none() { summary.coverage.uncovered() } else { Vec::new() };
    for what in &uncovered {
        out.push_str(&format!("not covered by any chart: {what}\n"));
    }
    print(&out)?;
    if let Some(path) = &arguments.json {
        let json = table::json(&plan, &executors, &summary).map_err(|error| error.to_string())?;
        std::fs::write(path, json + "\n").map_err(|error| format!("{}: {error}", path.display()))?;
    }
    let good = summary.mismatches() == 0 && uncovered.is_empty();
    Ok(if good { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Says of each executor what it is, what it lacks here, and what it cannot run.
pub fn list() -> Result<ExitCode, String> {
    let all = executors::all();
    let width = all.iter().map(|executor| executor.name().len()).max().unwrap_or_default();
    let line = |executor: &dyn Executor| {
        let state = executor.missing().map_or("here".to_string(), |missing| format!("not here: {missing}"));
        format!("{:width$}  {}; limits: {}; {state}\n", executor.name(), executor.about(), executor.limits())
    };
    print(&all.iter().map(|executor| line(executor.as_ref())).collect::<String>())?;
    Ok(ExitCode::SUCCESS)
}

fn print(text: &str) -> Result<(), String> {
    std::io::stdout().lock().write_all(text.as_bytes()).map_err(|error| error.to_string())
}

/// A line on a terminal that is written over and over; elsewhere one line for each twentieth of the charts.
fn progress(plan: &Plan, charts: u64, mismatches: usize, told: &mut u64) {
    let mut err = std::io::stderr().lock();
    let line = format!("{charts} of {} charts, {mismatches} mismatches", plan.charts);
    let part = charts * 20 / plan.charts.max(1);
    if err.is_terminal() {
        let filled = (charts * 30 / plan.charts.max(1)) as usize;
        let bar = "#".repeat(filled) + &".".repeat(30_usize.saturating_sub(filled));
        let _ = write!(err, "\r[{bar}] {line}");
        let _ = err.flush();
    } else if std::mem::replace(told, part) < part {
        let _ = writeln!(err, "{line}");
    }
}

fn clear_progress() {
    let mut err = std::io::stderr().lock();
    if err.is_terminal() {
        let _ = write!(err, "\r\x1b[K");
    }
}
