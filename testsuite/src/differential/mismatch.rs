//! A mismatch made small: shrunk, shown with both runs side by side, kept as a regression chart.

use super::long_run::{Draft, is_wrong};
use super::shrink::shrink;
use crate::charts;
use crate::executors::{Executor, Outcome, Task};
use crate::named_trace::NamedTrace;
use crate::runs::{caught, simulate};
use grafc_model::chart::Chart;
use grafc_model::reaction::{Profile, Response, Stimulus};
use std::fmt::Write as _;
use std::io;
use std::path::{Path, PathBuf};

/// Runs that may be spent on shrinking.
const TRIES: u32 = 4000;

/// The same, where each costs a call of a compiler from outside.
const TRIES_OUTSIDE: u32 = 100;

/// The smallest chart and trace found on which an executor is still wrong.
pub struct Mismatch {
    /// A name for its files.
    pub name: String,
    /// The chart, with the profile in its first line.
    pub text: String,
    /// What is done to it.
    pub trace: String,
    /// What it must do.
    pub expected: String,
    /// What it does instead: a result, or what was said.
    pub actual: Result<String, String>,
    /// The first row that differs, in order of the trace.
    pub row: usize,
}

/// Shrinks what an executor did wrong.
pub fn of(executor: &dyn Executor, draft: &Draft) -> Mismatch {
    let profile = draft.profile;
    let run = |chart: &Chart, stimuli: &[Stimulus]| -> Outcome {
        let task = Task { chart, profile, stimuli, turn: draft.turn };
        executor.run(&[task]).pop().unwrap_or_else(|| Outcome::Failed("no result".into()))
    };
    let failed = matches!(run(&draft.drawn.chart, &draft.stimuli), Outcome::Failed(_));
    let named = NamedTrace::of(&draft.drawn.chart, &draft.stimuli);
    let tries = if executor.is_external() { TRIES_OUTSIDE } else { TRIES };
    let (text, named) = shrink(&draft.drawn.text, &named, tries, |text, named| {
        let Ok(Ok(chart)) = caught(|| Ok(charts::check("shrunk", text))) else { return false };
        let stimuli = named.stimuli(&chart);
        // Tools from outside take no empty lists, and a trace without a call shows nothing.
        if stimuli.is_empty() {
            return false;
        }
        let Ok(expected) = caught(|| Ok(simulate(&chart, profile, &stimuli))) else { return false };
        let outcome = run(&chart, &stimuli);
        // A wrong result must not shrink into a refusal, nor the other way round.
        matches!(outcome, Outcome::Failed(_)) == failed && is_wrong(executor, &expected, &outcome)
    });
    let name = format!("{}_{}", executor.name().replace([':', '-'], "_"), draft.seed);
    match charts::check(&name, &text) {
        Ok(chart) => {
            let stimuli = named.stimuli(&chart);
            let expected = simulate(&chart, profile, &stimuli);
            let outcome = run(&chart, &stimuli);
            describe(executor, name, &text, profile, (&chart, &stimuli), (&expected, outcome))
        }
        // Only a text that was checked is ever taken; the one drawn was.
        Err(fault) => {
            Mismatch { name, text, trace: named.to_csv(), expected: String::new(), actual: Err(fault), row: 0 }
        }
    }
}

fn describe(
    executor: &dyn Executor,
    name: String,
    text: &str,
    profile: Profile,
    (chart, stimuli): (&Chart, &[Stimulus]),
    (expected, outcome): (&[Response], Outcome),
) -> Mismatch {
    let (actual, row) = match outcome {
        Outcome::Ran(actual) => {
            let row = executor.difference(expected, &actual).unwrap_or_default();
            (Ok(charts::spell(chart, stimuli, &actual)), row)
        }
        Outcome::PassedOver(reason) => (Err(reason.to_string()), 0),
        Outcome::Failed(fault) => (Err(fault), 0),
    };
    Mismatch {
        name,
        text: format!("{}\n{}", charts::profile_line(profile), tidy(text)),
        trace: NamedTrace::of(chart, stimuli).to_csv(),
        expected: charts::spell(chart, stimuli, expected),
        actual,
        row,
    }
}

/// A text without the holes that shrinking leaves, in the canonical format.
fn tidy(text: &str) -> String {
    let (tree, diagnostics) = grafc_syntax::parse(grafc_diagnostics::FileId::default(), text);
    if diagnostics.has_errors() { text.to_string() } else { grafc_syntax::format(text, &tree) }
}

impl Mismatch {
    /// The chart, and the trace beside what the simulator and the executor make of it.
    pub fn show(&self, executor: &str) -> String {
        let mut out = format!("--- {}: {executor} disagrees\n{}\n", self.name, self.text.trim_end());
        let actual = match &self.actual {
            Ok(actual) => actual.as_str(),
            Err(fault) => {
                let _ = writeln!(out, "\n{}\n{}", self.trace.trim_end(), fault.trim_end());
                return out;
            }
        };
        let without_time = |line: &str| line.split_once(',').map_or(String::new(), |(_, rest)| rest.to_string());
        let rows = self
            .trace
            .lines()
            .zip(self.expected.lines())
            .zip(actual.lines())
            .map(|((trace, expected), actual)| [trace.to_string(), without_time(expected), without_time(actual)]);
        let head = ["trace".to_string(), "simulator".to_string(), executor.to_string()];
        let rows: Vec<[String; 3]> = std::iter::once(head).chain(rows).collect();
        let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or_default();
        let (first, second) = (width(0), width(1));
        out.push('\n');
        for (index, [trace, expected, actual]) in rows.iter().enumerate() {
            // Two lines of headings stand above the rows.
            let mark = if index == self.row + 2 { "  <" } else { "" };
            let _ = writeln!(out, "{trace:first$} | {expected:second$} | {actual}{mark}");
        }
        out
    }

    /// Keeps it as a vector: NAME.gct, NAME.trace.csv, NAME.expected.csv. The expectation is the simulator's and wants
    /// to be worked out by hand before it is trusted.
    pub fn save(&self, folder: &Path) -> io::Result<PathBuf> {
        std::fs::create_dir_all(folder)?;
        let path = |end: &str| folder.join(format!("{}{end}", self.name));
        std::fs::write(path(".trace.csv"), &self.trace)?;
        std::fs::write(path(".expected.csv"), &self.expected)?;
        std::fs::write(path(".gct"), &self.text)?;
        Ok(path(".gct"))
    }
}
