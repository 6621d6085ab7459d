//! What a long run came to: for people as a table, for programs as JSON.

use super::long_run::{Plan, Summary, Tally};
use crate::executors::Executor;
use serde::Serialize;
use std::collections::BTreeMap;
use std::fmt::Write as _;

/// Names and tallies, the simulator first.
fn rows<'a>(executors: &'a [Box<dyn Executor>], summary: &'a Summary) -> impl Iterator<Item = (&'a str, &'a Tally)> {
    let names = std::iter::once("simulator").chain(executors.iter().map(|executor| executor.name()));
    names.zip(&summary.tallies)
}

fn rate(count: u64, seconds: f64) -> f64 {
    if seconds > 0.0 { count as f64 / seconds } else { 0.0 }
}

/// The table: what was covered, then the executors, then all together.
pub fn table(executors: &[Box<dyn Executor>], summary: &Summary) -> String {
    let coverage = &summary.coverage;
    let mut out = String::new();
    let mut list = |heading: &str, entries: &mut dyn Iterator<Item = (&'static str, u64)>| {
        let _ = writeln!(out, "charts  {heading}");
        for (what, count) in entries {
            let _ = writeln!(out, "{count:6}  {what}");
        }
        out.push('\n');
    };
    list("with this production of the language", &mut coverage.productions());
    list("that showed this rule", &mut coverage.rules());
    list("that held or did this besides", &mut coverage.others());
    let width = rows(executors, summary).map(|(name, _)| name.len()).max().unwrap_or_default();
    let _ = writeln!(
        out,
        "{:width$} {:>8} {:>9} {:>12} {:>11} {:>10} {:>9}",
        "executor", "charts", "scans", "passed over", "mismatches", "seconds", "charts/s"
    );
    for (name, tally) in rows(executors, summary) {
        let seconds = tally.time.as_secs_f64();
        let _ = writeln!(
            out,
            "{name:width$} {:8} {:9} {:12} {:11} {seconds:10.1} {:9.0}",
            tally.charts,
            tally.scans,
            tally.passed_over.values().sum::<u64>(),
            tally.mismatches.len(),
            rate(tally.charts, seconds)
        );
    }
    let mut reasons: BTreeMap<&str, u64> = BTreeMap::new();
    for (reason, count) in summary.tallies.iter().flat_map(|tally| &tally.passed_over) {
        *reasons.entry(reason).or_default() += count;
    }
    for (reason, count) in reasons {
        let _ = writeln!(out, "passed over {count} times: {reason}");
    }
    let seconds = summary.time.as_secs_f64();
    let _ = writeln!(
        out,
        "{} charts, {} scans, {} executors beside the simulator, {} mismatches; {seconds:.1} s, {:.1} charts a second; \
         {} texts with errors were drawn again",
        coverage.charts,
        coverage.reactions,
        executors.len(),
        summary.mismatches(),
        rate(coverage.charts, seconds),
        summary.rejected
    );
    out
}

#[derive(Serialize)]
struct Json<'a> {
    charts: u64,
    scans: u64,
    seed: u64,
    size: usize,
    seconds: f64,
    charts_a_second: f64,
    texts_drawn_again: u64,
    mismatches: usize,
    executors: Vec<ExecutorRow<'a>>,
    productions: BTreeMap<&'static str, u64>,
    rules: BTreeMap<&'static str, u64>,
    others: BTreeMap<&'static str, u64>,
    uncovered: Vec<&'static str>,
}

#[derive(Serialize)]
struct ExecutorRow<'a> {
    name: &'a str,
    charts: u64,
    scans: u64,
    passed_over: &'a BTreeMap<&'static str, u64>,
    mismatches: &'a [u64],
    seconds: f64,
    charts_a_second: f64,
}

impl<'a> ExecutorRow<'a> {
    fn of(name: &'a str, tally: &'a Tally) -> Self {
        ExecutorRow {
            name,
            charts: tally.charts,
            scans: tally.scans,
            passed_over: &tally.passed_over,
            mismatches: &tally.mismatches,
            seconds: tally.time.as_secs_f64(),
            charts_a_second: rate(tally.charts, tally.time.as_secs_f64()),
        }
    }
}

/// The same as JSON.
pub fn json(plan: &Plan, executors: &[Box<dyn Executor>], summary: &Summary) -> Result<String, serde_json::Error> {
    let coverage = &summary.coverage;
    serde_json::to_string_pretty(&Json {
        charts: coverage.charts,
        scans: coverage.reactions,
        seed: plan.seed,
        size: plan.size,
        seconds: summary.time.as_secs_f64(),
        charts_a_second: rate(coverage.charts, summary.time.as_secs_f64()),
        texts_drawn_again: summary.rejected,
        mismatches: summary.mismatches(),
        executors: rows(executors, summary).map(|(name, tally)| ExecutorRow::of(name, tally)).collect(),
        productions: coverage.productions().collect(),
        rules: coverage.rules().collect(),
        others: coverage.others().collect(),
        uncovered: coverage.uncovered(),
    })
}
