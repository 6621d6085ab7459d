//! Files beside the place of others, which they take once they are whole. None is left behind: not where the work fails,
//! and not where the process is ended from outside, if it says so (`abandon`).

use std::collections::BTreeSet;
use std::fs::{self, File, OpenOptions, Permissions};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Those that are there.
static THERE: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

fn there() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    // A set is whole whatever its users do.
    THERE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Removes the temporary files of this process, which is about to end: none can be begun, put or removed after this.
pub fn abandon() {
    let there = there();
    for path in there.iter() {
        // Nobody is left to be told.
        let _ = fs::remove_file(path);
    }
    std::mem::forget(there);
}

/// A file that is gone when it is dropped.
#[derive(Debug)]
pub struct Temporary(PathBuf);

impl Temporary {
    /// A new file in a directory, that nobody can open who cannot open the one that it will replace.
    pub fn begin(directory: &Path, permissions: Option<&Permissions>) -> io::Result<(Self, File)> {
        /// Names that are taken are left over from processes that were killed.
        const TRIES: u32 = 1000;
        let mut options = OpenOptions::new();
        options.write(true).create_new(true);
        restrict(&mut options, permissions);
        let mut refused = io::Error::from(ErrorKind::AlreadyExists);
        let mut there = there();
        for number in 0..TRIES {
            let path = directory.join(format!(".grafc-{}-{number}", std::process::id()));
            match options.open(&path) {
                Ok(file) => {
                    there.insert(path.clone());
                    return Ok((Temporary(path), file));
                }
                Err(error) if error.kind() == ErrorKind::AlreadyExists => refused = error,
                Err(error) => return Err(error),
            }
        }
        Err(refused)
    }

    /// Puts it into the place of another file, or where none is yet.
    pub fn put(self, place: &Path) -> io::Result<()> {
        let mut there = there();
        fs::rename(&self.0, place)?;
        there.remove(&self.0);
        drop(there);
        std::mem::forget(self);
        Ok(())
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        there().remove(&self.0);
        // What was wrong before is what is worth saying.
        let _ = fs::remove_file(&self.0);
    }
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
