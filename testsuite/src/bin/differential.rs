//! The long differential run: random charts through all executors.
//!
//! ```text
//! cargo run --release -p grafc-testsuite --bin differential -- --charts 1000 --rows 30 [--seed S] [--matiec N]
//! ```
//!
//! The charts are those of the seeds S, S + 1, …; the first N of them also run as Structured Text under MATIEC. Each
//! mismatch is shrunk and shown with its seed. The exit code is 1 if there was one.

#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a command")]

use grafc_model::chart::Chart;
use grafc_model::reaction::{Profile, Response, Stimulus};
use grafc_testsuite::charts;
use grafc_testsuite::differential::coverage::Coverage;
use grafc_testsuite::differential::shrink::{NamedTrace, shrink};
use grafc_testsuite::differential::{caught, compile, evaluate, first_difference, profile, report, simulate};
use grafc_testsuite::matiec::{self, Job, Tools};
use grafc_testsuite::random::{Drawn, Kind, checked, trace};
use std::process::ExitCode;

struct Options {
    charts: u64,
    rows: usize,
    seed: u64,
    matiec: u64,
}

fn options() -> Result<Options, String> {
    let mut options = Options { charts: 1000, rows: 30, seed: 0, matiec: 0 };
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        if !["--charts", "--rows", "--seed", "--matiec"].contains(&word.as_str()) {
            return Err("usage: differential [--charts N] [--rows N] [--seed S] [--matiec N]".to_owned());
        }
        let value = words.next().ok_or_else(|| format!("`{word}` wants a number"))?;
        let number: u64 = value.parse().map_err(|_| format!("`{value}` is not a number"))?;
        match word.as_str() {
            "--charts" => options.charts = number,
            "--rows" => options.rows = usize::try_from(number).map_err(|e| e.to_string())?,
            "--seed" => options.seed = number,
            _ => options.matiec = number,
        }
    }
    Ok(options)
}

fn main() -> ExitCode {
    let options = match options() {
        Ok(options) => options,
        Err(fault) => {
            eprintln!("{fault}");
            return ExitCode::from(2);
        }
    };
    let tools = if options.matiec == 0 {
        None
    } else {
        match Tools::find() {
            Ok(tools) => Some(tools),
            Err(missing) => {
                eprintln!("{missing}");
                return ExitCode::from(2);
            }
        }
    };
    std::panic::set_hook(Box::new(|_| {}));
    let mut coverage = Coverage::default();
    let (mut rejected, mut mismatches, mut under_matiec) = (0, 0, 0);
    let mut batch: Vec<(Drawn, Profile, Job)> = Vec::new();
    for seed in options.seed..options.seed + options.charts {
        let drawn = checked(seed, Kind::Flat);
        rejected += drawn.rejected;
        let profile = profile(seed);
        let stimuli = trace(seed, &drawn.chart, options.rows);
        let expected = simulate(&drawn.chart, profile, &stimuli);
        coverage.count(&drawn.chart, profile, &expected);
        let actual = caught(|| evaluate(&drawn.chart, profile, &stimuli));
        if disagrees(&expected, &actual) {
            mismatches += 1;
            show(&drawn, profile, &stimuli, ("scan program", 3000), |chart, stimuli| {
                caught(|| evaluate(chart, profile, stimuli))
            });
        }
        if let Some(tools) = &tools
            && seed - options.seed < options.matiec
        {
            if !matiec::misreckons(&drawn.chart)
                && let Ok(program) = caught(|| compile(&drawn.chart, profile))
            {
                batch.push((drawn, profile, Job { program, stimuli }));
            }
            if batch.len() == 40 || seed + 1 - options.seed == options.matiec.min(options.charts) {
                under_matiec += batch.len();
                mismatches += run_batch(tools, &mut batch);
            }
        }
    }
    print!("{coverage}");
    println!("{rejected} texts with errors were passed over; {under_matiec} charts ran under MATIEC");
    println!("{} charts, {} reactions, {mismatches} mismatches", coverage.charts, coverage.reactions);
    if mismatches == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

fn disagrees(expected: &[Response], actual: &Result<Vec<Response>, String>) -> bool {
    actual.as_ref().map_or(true, |actual| first_difference(expected, actual).is_some())
}

/// Runs what was gathered under MATIEC; how many disagree.
fn run_batch(tools: &Tools, batch: &mut Vec<(Drawn, Profile, Job)>) -> u64 {
    let (charts, jobs): (Vec<_>, Vec<_>) = batch.drain(..).map(|(drawn, profile, job)| ((drawn, profile), job)).unzip();
    let mut mismatches = 0;
    for (((drawn, profile), job), actual) in charts.iter().zip(&jobs).zip(matiec::run(tools, &jobs)) {
        if disagrees(&simulate(&drawn.chart, *profile, &job.stimuli), &actual) {
            mismatches += 1;
            show(drawn, *profile, &job.stimuli, ("MATIEC", 60), |chart, stimuli| {
                let program = caught(|| compile(chart, *profile))?;
                let job = Job { program, stimuli: stimuli.to_vec() };
                matiec::run(tools, &[job]).pop().unwrap_or_else(|| Err("no result".into()))
            });
        }
    }
    mismatches
}

/// Shrinks a mismatch and shows it.
fn show(
    drawn: &Drawn,
    profile: Profile,
    stimuli: &[Stimulus],
    (who, tries): (&str, u32),
    mut run: impl FnMut(&Chart, &[Stimulus]) -> Result<Vec<Response>, String>,
) {
    let was_error = run(&drawn.chart, stimuli).is_err();
    let named = NamedTrace::of(&drawn.chart, stimuli);
    let (text, named) = shrink(&drawn.text, &named, tries, |text, named| {
        let Ok(Ok(chart)) = caught(|| Ok(charts::check("shrunk", text))) else { return false };
        let stimuli = named.stimuli(&chart);
        let actual = run(&chart, &stimuli);
        // A wrong result must not shrink into a refusal, nor the other way round.
        actual.is_err() == was_error && disagrees(&simulate(&chart, profile, &stimuli), &actual)
    });
    println!("--- seed {}: the {who} disagrees; shrunk:\n{text}", drawn.seed);
    let Ok(chart) = charts::check("shrunk", &text) else { return };
    let stimuli = named.stimuli(&chart);
    match run(&chart, &stimuli) {
        Err(fault) => println!("{fault}"),
        Ok(actual) => println!("{}", report(&chart, profile, &stimuli, &simulate(&chart, profile, &stimuli), &actual)),
    }
}
