//! A file that cannot be read or written, in words.

use std::fmt;
use std::io::{self, ErrorKind};

/// A file cannot be read or written.
#[derive(Debug)]
pub struct Refusal {
    action: &'static str,
    name: String,
    error: io::Error,
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Refusal { action, name, error } = self;
        writeln!(f, "error: cannot {action} `{name}`: {}", reason(error))?;
        writeln!(f, "  = help: {}", self.advice())
    }
}

fn reason(error: &io::Error) -> String {
    let text = error.to_string();
    match text.split_once(" (os error ") {
        Some((reason, _)) => reason.to_lowercase(),
        None => text,
    }
}

impl Refusal {
    /// What has this name could not be read.
    pub fn to_read(name: impl Into<String>, error: io::Error) -> Self {
        Refusal { action: "read", name: name.into(), error }
    }

    /// What has this name could not be written.
    pub fn to_write(name: impl Into<String>, error: io::Error) -> Self {
        Refusal { action: "write", name: name.into(), error }
    }

    fn advice(&self) -> &'static str {
        match (self.error.kind(), self.action) {
            (ErrorKind::NotFound, "read") => "check the path; `-` reads standard input",
            (ErrorKind::NotFound, _) => "make the directory first; `-` writes to standard output",
            (ErrorKind::PermissionDenied, "read") => "ask for permission to read it",
            (ErrorKind::PermissionDenied, _) => "choose another place, or ask for permission to write there",
            (ErrorKind::IsADirectory, _) => "name a file in it",
            (ErrorKind::AlreadyExists, _) => "choose another name; nothing that is there is overwritten",
            (ErrorKind::NotADirectory, _) => "check the path: a part of it is a file, not a directory",
            (ErrorKind::FileTooLarge, _) => "raise the limit on the size of files, or choose another place",
            (ErrorKind::StorageFull | ErrorKind::QuotaExceeded, _) => "free some space, or choose another place",
            (ErrorKind::ReadOnlyFilesystem, _) => "choose another place",
            (_, "read") => "check that it is a file that can be read",
            (_, _) => "check that the place can be written to",
        }
    }
}
