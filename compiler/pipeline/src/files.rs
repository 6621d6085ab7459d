//! Reading and writing: files, and standard output.
//!
//! A file is written whole or not at all: into a temporary file beside it, which then takes its place. A reader
//! sees meanwhile the old text or the new one.

use std::fmt;
use std::fs::{self, File, OpenOptions, Permissions};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

/// Everything that is in a file.
pub fn read(path: &Path) -> Result<Vec<u8>, Refusal> {
    fs::read(path).map_err(|error| Refusal::to_read(path.display().to_string(), error))
}

/// Puts a text into a file, whole or not at all.
pub fn write(path: &Path, text: impl AsRef<[u8]>) -> Result<(), Refusal> {
    stage(path, text)?.put()
}

/// Makes a folder, and those around it, if they are not there.
pub fn make_folder(path: &Path) -> Result<(), Refusal> {
    fs::create_dir_all(path).map_err(|error| Refusal::to_write(path.display().to_string(), error))
}

/// A text beside its place. Of several texts, none need be put before all are known to fit; dropped, it is gone.
#[derive(Debug)]
pub struct Staged {
    name: String,
    place: PathBuf,
    text: StagedText,
}

#[derive(Debug)]
enum StagedText {
    /// In a file beside the place.
    Temporary(PathBuf),
    /// For a device or a pipe, which cannot be replaced, and where nobody finds half a text later.
    Device(Vec<u8>),
    /// Where it belongs.
    Put,
}

/// Writes a text beside the place where it is to be.
pub fn stage(path: &Path, text: impl AsRef<[u8]>) -> Result<Staged, Refusal> {
    let name = path.display().to_string();
    match stage_file(path, text.as_ref()) {
        Ok((place, text)) => Ok(Staged { name, place, text }),
        Err(error) => Err(Refusal::to_write(name, error)),
    }
}

impl Staged {
    /// Puts the text into its place.
    pub fn put(mut self) -> Result<(), Refusal> {
        let put = match &self.text {
            StagedText::Temporary(temporary) => fs::rename(temporary, &self.place),
            StagedText::Device(text) => {
                File::options().write(true).open(&self.place).and_then(|mut file| file.write_all(text))
            }
            StagedText::Put => Ok(()),
        };
        if put.is_ok() {
            self.text = StagedText::Put;
        }
        put.map_err(|error| Refusal::to_write(self.name.clone(), error))
    }
}

impl Drop for Staged {
    fn drop(&mut self) {
        if let StagedText::Temporary(temporary) = &self.text {
            // What was wrong before is what is worth saying.
            let _ = fs::remove_file(temporary);
        }
    }
}

/// Prints to standard output. If it was closed early, the reader has seen enough.
pub fn print(text: &str) -> Result<(), Refusal> {
    print_bytes(text.as_bytes())
}

/// The same for what need not be a text.
pub fn print_bytes(bytes: &[u8]) -> Result<(), Refusal> {
    let mut out = io::stdout().lock();
    match out.write_all(bytes).and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(Refusal::to_write("<stdout>", error)),
        Ok(()) | Err(_) => Ok(()),
    }
}

fn stage_file(path: &Path, text: &[u8]) -> io::Result<(PathBuf, StagedText)> {
    let path = behind_links(path);
    let existing = match fs::metadata(&path) {
        Ok(metadata) => Some(metadata),
        Err(error) if error.kind() == ErrorKind::NotFound => None,
        Err(error) => return Err(error),
    };
    if let Some(metadata) = &existing {
        if metadata.is_dir() {
            return Err(ErrorKind::IsADirectory.into());
        }
        if !metadata.is_file() {
            return Ok((path, StagedText::Device(text.to_vec())));
        }
        if metadata.permissions().readonly() {
            return Err(ErrorKind::PermissionDenied.into());
        }
    }
    let directory = match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        Some(_) | None => Path::new("."),
    };
    // Asked first, because the temporary file's own name would only puzzle in a message.
    fs::metadata(directory)?;
    let permissions = existing.map(|metadata| metadata.permissions());
    let (temporary, file) = temporary_file(directory, permissions.as_ref())?;
    match fill(file, text, permissions) {
        Ok(()) => Ok((path, StagedText::Temporary(temporary))),
        Err(error) => {
            // What was wrong before is what is worth saying.
            let _ = fs::remove_file(&temporary);
            Err(error)
        }
    }
}

/// What a path names in the end, so that a file is replaced and not the link to it, whether or not it is there yet.
fn behind_links(path: &Path) -> PathBuf {
    /// A path with more links is a circle for the system, too, which then says so.
    const LINKS: u32 = 40;
    if let Ok(file) = fs::canonicalize(path) {
        return file;
    }
    let mut path = path.to_path_buf();
    // What is behind `/dev/stdout` may be there and have no path.
    if fs::metadata(&path).is_ok() {
        return path;
    }
    for _ in 0..LINKS {
        let Ok(target) = fs::read_link(&path) else { break };
        path = match path.parent() {
            Some(folder) => folder.join(target),
            None => target,
        };
    }
    path
}

/// A new file in a directory, that nobody can open who cannot open the one that it will replace.
fn temporary_file(directory: &Path, permissions: Option<&Permissions>) -> io::Result<(PathBuf, File)> {
    /// Names that are taken are left over from processes that were killed.
    const TRIES: u32 = 1000;
    let mut options = OpenOptions::new();
    options.write(true).create_new(true);
    restrict(&mut options, permissions);
    let mut refused = io::Error::from(ErrorKind::AlreadyExists);
    for number in 0..TRIES {
        let path = directory.join(format!(".grafc-{}-{number}", std::process::id()));
        match options.open(&path) {
            Ok(file) => return Ok((path, file)),
            Err(error) if error.kind() == ErrorKind::AlreadyExists => refused = error,
            Err(error) => return Err(error),
        }
    }
    Err(refused)
}

fn fill(mut file: File, text: &[u8], permissions: Option<Permissions>) -> io::Result<()> {
    file.write_all(text)?;
    if let Some(permissions) = permissions {
        // Said again, because the umask applied when the file was made.
        file.set_permissions(permissions)?;
    }
    file.sync_all()
}

#[cfg(unix)]
fn restrict(options: &mut OpenOptions, permissions: Option<&Permissions>) {
    use std::os::unix::fs::{OpenOptionsExt, PermissionsExt};
    if let Some(permissions) = permissions {
        options.mode(permissions.mode());
    }
}

#[cfg(not(unix))]
fn restrict(_: &mut OpenOptions, _: Option<&Permissions>) {}

/// Whether both are one file that is there, by whatever paths.
pub fn is_same_file(a: &Path, b: &Path) -> bool {
    identity(a).is_some_and(|a| Some(a) == identity(b))
}

/// What a file is, whatever paths lead to it.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct FileIdentity(Inner);

#[cfg(unix)]
type Inner = (u64, u64);
#[cfg(not(unix))]
type Inner = PathBuf;

/// The identity of a file that is there.
#[cfg(unix)]
pub fn identity(path: &Path) -> Option<FileIdentity> {
    use std::os::unix::fs::MetadataExt;
    let metadata = fs::metadata(path).ok().filter(fs::Metadata::is_file)?;
    Some(FileIdentity((metadata.dev(), metadata.ino())))
}

/// The identity of a file that is there.
#[cfg(not(unix))]
pub fn identity(path: &Path) -> Option<FileIdentity> {
    fs::canonicalize(path).ok().filter(|path| path.is_file()).map(FileIdentity)
}

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
