//! Reading and writing: files, and `-` for the standard streams.
//!
//! A file is written whole or not at all: into a temporary file beside it, which then takes its place. Who reads the
//! file meanwhile sees the old text or the new one.

use std::ffi::OsString;
use std::fmt;
use std::fs::{self, File, Permissions};
use std::io::{self, ErrorKind, Read, Write};
use std::path::{Path, PathBuf};

/// What a file name on the command line stands for.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Place {
    /// `-`: standard input or standard output.
    Standard,
    /// Any other name.
    File(PathBuf),
}

impl From<OsString> for Place {
    fn from(name: OsString) -> Self {
        if name == "-" { Place::Standard } else { Place::File(name.into()) }
    }
}

impl Place {
    /// What messages call it when it is read.
    pub fn input_name(&self) -> String {
        match self {
            Place::Standard => "<stdin>".to_string(),
            Place::File(path) => path.display().to_string(),
        }
    }

    /// The name of a chart that does not give itself one.
    pub fn chart_name(&self) -> String {
        let stem = match self {
            Place::Standard => None,
            Place::File(path) => path.file_stem().map(|stem| stem.to_string_lossy().into_owned()),
        };
        stem.unwrap_or_else(|| "chart".to_string())
    }

    /// Whether both name one existing file, by whatever paths.
    pub fn is_same_file(&self, other: &Place) -> bool {
        match (self, other) {
            (Place::File(a), Place::File(b)) => is_same_file(a, b),
            (Place::Standard, _) | (_, Place::Standard) => false,
        }
    }

    /// Everything that is there.
    pub fn read(&self) -> Result<Vec<u8>, Refusal> {
        let mut bytes = Vec::new();
        let result = match self {
            Place::Standard => io::stdin().lock().read_to_end(&mut bytes),
            Place::File(path) => File::open(path).and_then(|mut file| file.read_to_end(&mut bytes)),
        };
        result.map_err(|error| Refusal { action: "read", name: self.input_name(), error })?;
        Ok(bytes)
    }

    /// Puts a text there, whole or not at all.
    pub fn write(&self, text: &str) -> Result<(), Refusal> {
        match self {
            Place::Standard => print(text),
            Place::File(path) => write_file(path, text).map_err(|error| Refusal {
                action: "write",
                name: path.display().to_string(),
                error,
            }),
        }
    }
}

/// Prints to standard output. Whoever closed it early has read enough.
pub fn print(text: &str) -> Result<(), Refusal> {
    let mut out = io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(Refusal { action: "write", name: "<stdout>".to_string(), error })
        }
        Ok(()) | Err(_) => Ok(()),
    }
}

fn write_file(path: &Path, text: &str) -> io::Result<()> {
    // Follow links, so that the file is replaced and not the link to it.
    let path = &fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf());
    let existing = match fs::metadata(path) {
        Ok(metadata) => Some(metadata),
        Err(error) if error.kind() == ErrorKind::NotFound => None,
        Err(error) => return Err(error),
    };
    if let Some(metadata) = &existing {
        if metadata.is_dir() {
            return Err(ErrorKind::IsADirectory.into());
        }
        if !metadata.is_file() {
            // A device or a pipe cannot be replaced, and nobody finds half a text in it later.
            return File::options().write(true).open(path)?.write_all(text.as_bytes());
        }
        if metadata.permissions().readonly() {
            return Err(ErrorKind::PermissionDenied.into());
        }
    }
    let directory = match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        Some(_) | None => Path::new("."),
    };
    let mut builder = tempfile::Builder::new();
    builder.prefix(".grafc-");
    let permissions = existing.map(|metadata| metadata.permissions());
    let of_new_files = permissions_of_new_files();
    if let Some(permissions) = permissions.clone().or(of_new_files) {
        builder.permissions(permissions);
    }
    // Asked first, because the temporary file's own name would only puzzle in a message.
    fs::metadata(directory)?;
    let mut file = builder.tempfile_in(directory).map_err(|error| io::Error::from(error.kind()))?;
    file.as_file_mut().write_all(text.as_bytes())?;
    if let Some(permissions) = permissions {
        // Said again, because the umask applied when the file was made.
        file.as_file().set_permissions(permissions)?;
    }
    file.as_file().sync_all()?;
    file.persist(path).map_err(|error| error.error)?;
    Ok(())
}

/// What the umask leaves of reading and writing for all.
#[cfg(unix)]
fn permissions_of_new_files() -> Option<Permissions> {
    use std::os::unix::fs::PermissionsExt;
    Some(Permissions::from_mode(0o666))
}

#[cfg(not(unix))]
fn permissions_of_new_files() -> Option<Permissions> {
    None
}

#[cfg(unix)]
fn is_same_file(a: &Path, b: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    match (fs::metadata(a), fs::metadata(b)) {
        (Ok(a), Ok(b)) => a.is_file() && (a.dev(), a.ino()) == (b.dev(), b.ino()),
        (Err(_), _) | (_, Err(_)) => false,
    }
}

#[cfg(not(unix))]
fn is_same_file(a: &Path, b: &Path) -> bool {
    match (fs::canonicalize(a), fs::canonicalize(b)) {
        (Ok(a), Ok(b)) => a.is_file() && a == b,
        (Err(_), _) | (_, Err(_)) => false,
    }
}

/// The file system said no.
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
    fn advice(&self) -> &'static str {
        match (self.error.kind(), self.action) {
            (ErrorKind::NotFound, "read") => "check the path; `-` reads standard input",
            (ErrorKind::NotFound, _) => "make the directory first; `-` writes to standard output",
            (ErrorKind::PermissionDenied, "read") => "ask for the right to read it",
            (ErrorKind::PermissionDenied, _) => "choose another place, or ask for the right to write there",
            (ErrorKind::IsADirectory, _) => "name a file in it",
            (ErrorKind::NotADirectory, _) => "check the path: a part of it is a file, not a directory",
            (ErrorKind::StorageFull | ErrorKind::QuotaExceeded, _) => "make room, or choose another place",
            (ErrorKind::ReadOnlyFilesystem, _) => "choose another place",
            (_, "read") => "check that it is a file that can be read",
            (_, _) => "check that the place can be written to",
        }
    }
}
