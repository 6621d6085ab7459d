//! Reading and writing: files, and standard output.
//!
//! A file is written whole or not at all: into a temporary file beside it, which then takes its place. A reader
//! sees meanwhile the old text or the new one.

mod refusal;
mod temporary;

pub use refusal::Refusal;
pub use temporary::abandon;

use std::fs::{self, File, Permissions};
use std::io::{self, BufWriter, ErrorKind, Write};
use std::path::{Path, PathBuf};
use temporary::Temporary;

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
    Temporary(Temporary),
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

/// A text that is being written beside its place, piece by piece; dropped, it is gone. What is for a device or a pipe,
/// where nobody finds half a text later, goes there at once.
#[derive(Debug)]
pub struct Writing {
    file: BufWriter<File>,
    permissions: Option<Permissions>,
    staged: Staged,
}

/// Begins to write a text beside the place where it is to be.
pub fn begin(path: &Path) -> Result<Writing, Refusal> {
    let name = path.display().to_string();
    let begun = place_of(path).and_then(|(place, kind)| match kind {
        PlaceKind::Device => {
            let file = File::options().write(true).open(&place)?;
            Ok((place, file, None, StagedText::Put))
        }
        PlaceKind::File(permissions) => {
            let (temporary, file) = Temporary::begin(directory_of(&place), permissions.as_ref())?;
            Ok((place, file, permissions, StagedText::Temporary(temporary)))
        }
    });
    let (place, file, permissions, text) = begun.map_err(|error| Refusal::to_write(name.clone(), error))?;
    let file = BufWriter::with_capacity(1 << 16, file);
    Ok(Writing { file, permissions, staged: Staged { name, place, text } })
}

impl Writing {
    /// Puts what was written into its place.
    pub fn put(self) -> Result<(), Refusal> {
        let Writing { file, permissions, staged } = self;
        let written = file.into_inner().map_err(io::IntoInnerError::into_error).and_then(|file| match staged.text {
            StagedText::Temporary(_) => finish(&file, permissions),
            StagedText::Device(_) | StagedText::Put => Ok(()),
        });
        written.map_err(|error| Refusal::to_write(staged.name.clone(), error))?;
        staged.put()
    }
}

impl Write for Writing {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

impl Staged {
    /// Puts the text into its place.
    pub fn put(self) -> Result<(), Refusal> {
        let put = match self.text {
            StagedText::Temporary(temporary) => temporary.put(&self.place),
            StagedText::Device(text) => {
                File::options().write(true).open(&self.place).and_then(|mut file| file.write_all(&text))
            }
            StagedText::Put => Ok(()),
        };
        put.map_err(|error| Refusal::to_write(self.name, error))
    }
}

/// Puts texts into their places. Devices and pipes come first: what they refuse leaves the files as they were.
pub fn put_all(mut staged: Vec<Staged>) -> Result<(), Refusal> {
    staged.sort_by_key(|one| !matches!(one.text, StagedText::Device(_)));
    staged.into_iter().try_for_each(Staged::put)
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
    let (path, permissions) = match place_of(path)? {
        (path, PlaceKind::Device) => return Ok((path, StagedText::Device(text.to_vec()))),
        (path, PlaceKind::File(permissions)) => (path, permissions),
    };
    let (temporary, mut file) = Temporary::begin(directory_of(&path), permissions.as_ref())?;
    file.write_all(text).and_then(|()| finish(&file, permissions))?;
    Ok((path, StagedText::Temporary(temporary)))
}

/// What is at a place.
enum PlaceKind {
    /// A device or a pipe.
    Device,
    /// A file with these permissions, or none yet.
    File(Option<Permissions>),
}

/// The place that a path names, and what is there, if a file can be put there.
fn place_of(path: &Path) -> io::Result<(PathBuf, PlaceKind)> {
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
            return Ok((path, PlaceKind::Device));
        }
        if metadata.permissions().readonly() {
            return Err(ErrorKind::PermissionDenied.into());
        }
    }
    // Asked first, because the temporary file's own name would only puzzle in a message.
    fs::metadata(directory_of(&path))?;
    Ok((path, PlaceKind::File(existing.map(|metadata| metadata.permissions()))))
}

fn directory_of(path: &Path) -> &Path {
    match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        Some(_) | None => Path::new("."),
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

/// What remains to be done once a temporary file is written.
fn finish(file: &File, permissions: Option<Permissions>) -> io::Result<()> {
    if let Some(permissions) = permissions {
        // Said again, because the umask applied when the file was made.
        file.set_permissions(permissions)?;
    }
    file.sync_all()
}

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
