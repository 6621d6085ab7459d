//! The long differential run: random charts through all executors.
//!
//! ```text
//! cargo run --release -p grafc-testsuite --bin differential -- --charts 1000 --rows 30 [--seed S] [--matiec N] [--kind KIND]
//! ```
//!
//! The charts are those of the seeds S, S + 1, …, of the kind `hierarchical`, `flat` or `plain`; each runs in every encoding,
//! and the first N of them also as Structured Text and as an instruction list under MATIEC. The encodings whose steps overlap are only asked for
//! the stable situations, and only of charts for which there is no warning. Each mismatch is shrunk and shown with its
//! seed. The exit code is 1 if there was one.

#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a command")]

use grafc_logic::{Encoding, Options as Lowering};
use grafc_model::chart::Chart;
use grafc_model::reaction::{Profile, Response, Stimulus};
use grafc_testsuite::charts;
use grafc_testsuite::differential::coverage::Coverage;
use grafc_testsuite::differential::shrink::{NamedTrace, shrink};
use grafc_testsuite::differential::{
    caught, compile, evaluate, exact, first_difference, first_other_situation, profile, report, simulate,
    stable_situations,
};
use grafc_testsuite::matiec::{self, Job, Language, Tools};
use grafc_testsuite::random::{Drawn, Kind, checked, trace};
use std::process::ExitCode;

struct Options {
    charts: u64,
    rows: usize,
    seed: u64,
    matiec: u64,
    kind: Kind,
}

fn options() -> Result<Options, String> {
    let mut options = Options { charts: 1000, rows: 30, seed: 0, matiec: 0, kind: Kind::Hierarchical };
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        if word == "--kind" {
            options.kind = match words.next().as_deref() {
                Some("hierarchical") => Kind::Hierarchical,
                Some("flat") => Kind::Flat,
                Some("plain") => Kind::Plain,
                Some(_) | None => return Err("`--kind` wants hierarchical, flat or plain".to_owned()),
            };
            continue;
        }
        if !["--charts", "--rows", "--seed", "--matiec"].contains(&word.as_str()) {
            return Err("usage: differential [--charts N] [--rows N] [--seed S] [--matiec N] [--kind KIND]".to_owned());
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
    let mut batch: Vec<(Drawn, Lowering, Job)> = Vec::new();
    let kind = options.kind;
    let mut without_warning = 0;
    for seed in options.seed..options.seed + options.charts {
        let drawn = checked(seed, kind);
        rejected += drawn.rejected;
        let profile = profile(seed);
        let stimuli = trace(seed, &drawn.chart, options.rows);
        let expected = simulate(&drawn.chart, profile, &stimuli);
        coverage.count(&drawn.chart, profile, &expected);
        for (way, lowering) in exact(profile) {
            let actual = caught(|| evaluate(&drawn.chart, &lowering, &stimuli));
            if disagrees(&expected, &actual) {
                mismatches += 1;
                show(&drawn, profile, &stimuli, (&way, 3000), |chart, stimuli| {
                    caught(|| evaluate(chart, &lowering, stimuli))
                });
            }
        }
        for encoding in Encoding::ALL.into_iter().filter(|encoding| encoding.overlaps()) {
            let lowering = Lowering { profile, encoding, simplify: true };
            match caught(|| stable_situations(&drawn.chart, &lowering, &stimuli)) {
                Ok(None) => {}
                Ok(Some(situations)) => {
                    without_warning += 1;
                    if let Some(row) = first_other_situation(&expected, &situations) {
                        mismatches += 1;
                        println!("--- seed {seed}: {} ends elsewhere in row {row}\n{}", encoding.name(), drawn.text);
                    }
                }
                Err(fault) => {
                    mismatches += 1;
                    println!("--- seed {seed}: {}: {fault}\n{}", encoding.name(), drawn.text);
                }
            }
        }
        if let Some(tools) = &tools
            && seed - options.seed < options.matiec
        {
            let ways = exact(profile);
            let lowering = ways[seed as usize % ways.len()].1;
            if !matiec::misreckons(&drawn.chart)
                && let Ok(program) = caught(|| compile(&drawn.chart, &lowering))
            {
                batch.push((drawn, lowering, Job { program, stimuli }));
            }
            if batch.len() == 40 || seed + 1 - options.seed == options.matiec.min(options.charts) {
                under_matiec += batch.len();
                mismatches += run_batch(tools, &mut batch);
            }
        }
    }
    print!("{coverage}");
    println!("{rejected} texts with errors were passed over; {under_matiec} charts ran under MATIEC");
    println!("{without_warning} runs with overlapping steps, of charts for which there is no warning");
    println!("{} charts, {} reactions, {mismatches} mismatches", coverage.charts, coverage.reactions);
    if mismatches == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

fn disagrees(expected: &[Response], actual: &Result<Vec<Response>, String>) -> bool {
    actual.as_ref().map_or(true, |actual| first_difference(expected, actual).is_some())
}

/// Runs what was gathered under MATIEC; how many disagree.
fn run_batch(tools: &Tools, batch: &mut Vec<(Drawn, Lowering, Job)>) -> u64 {
    let (charts, jobs): (Vec<_>, Vec<_>) =
        batch.drain(..).map(|(drawn, lowering, job)| ((drawn, lowering), job)).unzip();
    let mut mismatches = 0;
    for language in Language::ALL {
        for (((drawn, lowering), job), actual) in charts.iter().zip(&jobs).zip(matiec::run(tools, language, &jobs)) {
            if disagrees(&simulate(&drawn.chart, lowering.profile, &job.stimuli), &actual) {
                mismatches += 1;
                let who = format!("MATIEC, {language:?}");
                show(drawn, lowering.profile, &job.stimuli, (&who, 60), |chart, stimuli| {
                    let program = caught(|| compile(chart, lowering))?;
                    let job = Job { program, stimuli: stimuli.to_vec() };
                    matiec::run(tools, language, &[job]).pop().unwrap_or_else(|| Err("no result".into()))
                });
            }
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
    println!("--- seed {}: {who} disagrees; shrunk:\n{text}", drawn.seed);
    let Ok(chart) = charts::check("shrunk", &text) else { return };
    let stimuli = named.stimuli(&chart);
    match run(&chart, &stimuli) {
        Err(fault) => println!("{fault}"),
        Ok(actual) => println!("{}", report(&chart, profile, &stimuli, &simulate(&chart, profile, &stimuli), &actual)),
    }
}
