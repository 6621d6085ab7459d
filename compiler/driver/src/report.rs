//! What a run says about charts, and where it says it.

use crate::Exit;
use crate::stream::Stream;
use clap::ValueEnum;
use grafc::Document;
use grafc::files::{Refusal, print};
use grafc_diagnostics::{Code, Diagnostics, FileId, Policy, Severity, SourceMap, render};
use std::fmt;
use std::io::{IsTerminal, Write};

/// The form of messages.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub enum Format {
    /// For people
    Human,
    /// One JSON object a line
    Json,
    /// A SARIF 2.1.0 log
    Sarif,
}

/// Which messages are told, and how.
#[derive(Clone, Copy, Debug)]
pub struct Messages {
    /// Their form.
    pub format: Format,
    /// Errors alone, and no counts.
    pub quiet: bool,
}

impl Messages {
    /// Whether somebody reads them who wants to hear more than errors.
    pub fn is_for_people(self) -> bool {
        self.format == Format::Human && !self.quiet
    }
}

/// Why a command could not do its work.
#[derive(Debug)]
pub enum Failure {
    /// The command was called in a way that makes no sense: what, and what to do.
    WrongUse(String, String),
    /// A file cannot be read or written.
    Files(Refusal),
    /// What was asked cannot be decided: why, and what to do.
    Open(String, String),
    /// The chart contradicts itself, which showed only now: how, and what to do.
    Contradiction(String, String),
}

impl Failure {
    /// The exit code.
    pub fn exit(&self) -> Exit {
        match self {
            Failure::WrongUse(..) => Exit::WrongUse,
            Failure::Files(_) => Exit::FilesRefused,
            Failure::Open(..) => Exit::Open,
            Failure::Contradiction(..) => Exit::ChartErrors,
        }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Failure::WrongUse(what, help) | Failure::Contradiction(what, help) => {
                write!(f, "error: {what}\n  = help: {help}\n")
            }
            Failure::Files(refusal) => refusal.fmt(f),
            Failure::Open(what, help) => write!(f, "open: {what}\n  = help: {help}\n"),
        }
    }
}

impl From<Refusal> for Failure {
    fn from(refusal: Refusal) -> Self {
        Failure::Files(refusal)
    }
}

/// The texts of a run and all messages about them.
#[derive(Default)]
pub struct Report {
    /// The texts.
    pub sources: SourceMap,
    /// The messages, in any order.
    pub diagnostics: Diagnostics,
    /// Which warnings are errors, and which are not wanted.
    pub policy: Policy,
}

impl Report {
    /// Nothing has been said yet.
    pub fn new(policy: Policy) -> Self {
        Report { policy, ..Report::default() }
    }

    /// Reads a text; none if it is not UTF-8, which is an error at its first bad byte.
    pub fn load(&mut self, stream: &Stream) -> Result<Option<FileId>, Refusal> {
        let added = grafc::add(&mut self.sources, stream.input_name(), stream.read()?);
        Ok(added.map_err(|diagnostic| self.diagnostics.push(diagnostic)).ok())
    }

    /// Reads a chart; none if it is not UTF-8. It is the only text of the report, so places in it are the same in the
    /// document.
    pub fn document(&mut self, chart: &Stream) -> Result<Option<Document>, Refusal> {
        let Some(file) = self.load(chart)? else { return Ok(None) };
        let source = self.sources.file(file);
        Ok(Some(Document::new(&source.name, &source.text).named(chart.chart_name())))
    }

    /// A text that is read as it comes, and not kept.
    pub fn name(&mut self, stream: &Stream) -> FileId {
        self.sources.add(stream.input_name(), "")
    }

    /// Whether one of the texts has an error, or a warning that is taken for one.
    pub fn is_refused(&mut self) -> bool {
        self.policy.apply(&mut self.diagnostics);
        self.has_errors()
    }

    /// Whether one of the texts has an error: that an assertion came out false is none.
    pub fn is_faulty(&mut self) -> bool {
        self.policy.apply(&mut self.diagnostics);
        let mut errors = self.diagnostics.iter().filter(|found| found.severity() == Severity::Error);
        errors.any(|error| error.code != Code::E0609)
    }

    /// Whether one of the texts has an error.
    pub fn has_errors(&self) -> bool {
        self.diagnostics.has_errors()
    }

    /// Says everything on standard error; for people with a last line that counts.
    pub fn tell(&mut self, messages: Messages) -> Exit {
        to_stderr(&self.render(messages, wants_colour()));
        self.exit()
    }

    /// Says everything where a command whose product is messages says it: tools find theirs on standard output.
    pub fn publish(&mut self, messages: Messages) -> Result<Exit, Refusal> {
        match messages.format {
            Format::Human => Ok(self.tell(messages)),
            Format::Json | Format::Sarif => {
                print(&self.render(messages, false))?;
                Ok(self.exit())
            }
        }
    }

    fn exit(&self) -> Exit {
        if self.has_errors() { Exit::ChartErrors } else { Exit::Done }
    }

    /// All messages, for people with a last line that counts.
    pub fn render(&mut self, messages: Messages, colour: bool) -> String {
        self.policy.apply(&mut self.diagnostics);
        self.diagnostics.sort_by_place();
        if messages.quiet {
            self.diagnostics.retain(|diagnostic| diagnostic.severity() == Severity::Error);
        }
        match messages.format {
            Format::Human => {
                let mut text = render::human(&self.sources, &self.diagnostics, colour);
                if !messages.quiet {
                    text.push_str(&render::summary(&self.diagnostics));
                }
                text
            }
            Format::Json => render::json(&self.sources, &self.diagnostics),
            Format::Sarif => render::sarif(&self.sources, &self.diagnostics, env!("CARGO_PKG_VERSION")),
        }
    }
}

/// Prints to standard error; if that fails there is nowhere left to say so.
pub fn to_stderr(text: &str) {
    let _ = std::io::stderr().lock().write_all(text.as_bytes());
}

/// Colour is for terminals, unless the user said no (<https://no-color.org>).
fn wants_colour() -> bool {
    is_coloured(std::io::stderr().is_terminal())
}

/// Whether what goes there is coloured, to a terminal or elsewhere.
pub fn is_coloured(is_terminal: bool) -> bool {
    std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty()) && is_terminal
}
