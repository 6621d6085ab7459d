//! What is said of tests while they run and at their end, as cargo says it.

use super::run::{Done, Ending, Loaded};
use crate::Exit;
use crate::report::{Failure, Format, Messages, is_coloured};
use grafc::files::print;
use grafc_diagnostics::{Diagnostics, Severity, SourceMap, render};
use std::io::IsTerminal;

/// What is said.
pub struct Told {
    count: usize,
    messages: Messages,
}

impl Told {
    /// Of so many tests.
    pub fn new(count: usize, messages: Messages) -> Told {
        Told { count, messages }
    }

    /// Tests begin.
    pub fn begin(&self) -> Result<(), Failure> {
        let tests = if self.count == 1 { "test" } else { "tests" };
        Ok(print(&format!("\nrunning {} {tests}\n", self.count))?)
    }

    /// A test is over. Who wants to hear of errors alone is not told of others.
    pub fn test(&self, test: &Done) -> Result<(), Failure> {
        let has_failed = test.ending == Ending::Failed;
        if self.messages.quiet && !has_failed {
            return Ok(());
        }
        Ok(print(&format!("test {} ... {}\n", test.name, if has_failed { "FAILED" } else { "ok" }))?)
    }

    /// All are over: what was wrong with them, and how many they were. Says how the command is to end.
    pub fn end(
        &self,
        suites: &[(&Loaded, Vec<Done>)],
        left_out: usize,
        faulty: usize,
        sources: &SourceMap,
    ) -> Result<Exit, Failure> {
        let all = || suites.iter().flat_map(|(_, tests)| tests);
        let failed: Vec<&Done> = all().filter(|test| test.ending == Ending::Failed).collect();
        let mut text = String::new();
        let is_terminal = std::io::stdout().is_terminal();
        let rendered = |said: &Diagnostics| match self.messages.format {
            Format::Human => render::human(sources, &self.wanted(said), is_coloured(is_terminal)),
            Format::Json => render::json(sources, &self.wanted(said)),
            Format::Sarif => render::sarif(sources, &self.wanted(said), env!("CARGO_PKG_VERSION")),
        };
        // What is to be said of tests that did not fail.
        for test in all().filter(|test| test.ending != Ending::Failed) {
            let said = rendered(&test.said);
            if !self.wanted(&test.said).is_empty() {
                text.push_str(&format!("\n---- {} ----\n{said}", test.name));
            }
        }
        if !failed.is_empty() {
            text.push_str("\nfailures:\n");
            for test in &failed {
                text.push_str(&format!("\n---- {} ----\n{}", test.name, rendered(&test.said)));
            }
            text.push_str("\nfailures:\n");
            failed.iter().for_each(|test| text.push_str(&format!("    {}\n", test.name)));
        }
        let ended = |ending: Ending| all().filter(|test| test.ending == ending).count();
        let (passed, failures, not_run) = (ended(Ending::Passed), failed.len(), ended(Ending::NotRun));
        let (result, exit) = match (failures + faulty, not_run) {
            (0, 0) => ("ok", Exit::Done),
            (0, _) => ("INTERRUPTED", Exit::Open),
            _ => ("FAILED", Exit::ChartErrors),
        };
        text.push_str(&format!("\ntest result: {result}. {passed} passed; {failures} failed; {left_out} filtered out"));
        if not_run > 0 {
            text.push_str(&format!("; {not_run} not run"));
        }
        match faulty {
            0 => {}
            1 => text.push_str("; 1 file has errors"),
            _ => text.push_str(&format!("; {faulty} files have errors")),
        }
        text.push('\n');
        print(&text)?;
        Ok(exit)
    }

    fn wanted(&self, said: &Diagnostics) -> Diagnostics {
        let mut said = said.clone();
        if self.messages.quiet {
            said.retain(|one| one.severity() == Severity::Error);
        }
        said
    }
}
