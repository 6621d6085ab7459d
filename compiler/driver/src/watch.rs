//! `--watch`: the work of a command, done again whenever one of its files has changed.
//!
//! What is watched is the folder of each file: an editor that saves by putting a new file in the place of the old one
//! would take a watch on the file away with it. What counts is whether the contents differ, so that events about other
//! files, those that the work itself writes among them, do nothing.

use crate::Exit;
use crate::report::{Failure, Format, Messages, to_stderr};
use crate::stream::Stream;
use notify::{RecommendedWatcher, RecursiveMode, Watcher, recommended_watcher};
use std::io::IsTerminal;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::Duration;

/// How often the files are looked at where nothing tells of a change: on network drives, or beyond a limit of the system.
const LOOK: Duration = Duration::from_secs(1);
/// A save is several events; what is the same after so long is saved.
const PAUSE: Duration = Duration::from_millis(50);
/// Pauses that a save may take. A program that writes without end does not keep us waiting.
const PAUSES: usize = 20;

/// Clears a screen and begins at its top.
const CLEAR: &str = "\x1b[2J\x1b[H";

type Event = notify::Result<notify::Event>;

/// Does the work, and again after each change of one of its files; ends with the process.
pub fn run<'a>(
    inputs: impl IntoIterator<Item = &'a Stream>,
    messages: Messages,
    mut work: impl FnMut() -> Result<Exit, Failure>,
) -> Result<Exit, Failure> {
    let mut files = Vec::new();
    for input in inputs {
        match input {
            Stream::File(path) => files.push(path.as_path()),
            Stream::Standard => {
                let what = "standard input cannot be watched".to_string();
                return Err(Failure::WrongUse(what, "name a file".to_string()));
            }
        }
    }
    let (sender, events) = channel();
    // Kept while it is to watch. Its sender must not be the last, since a closed channel would not wait.
    let _watcher = watch(&files, sender.clone());
    let _open = sender;
    loop {
        // Read before the work: what changes while it is done is seen as a change.
        let seen = contents(&files);
        to_stderr(clear(std::io::stderr().is_terminal()));
        let done = match files.iter().find(|file| is_no_file(file)) {
            None => work(),
            Some(file) => {
                let what = format!("`{}` is not a file, and cannot be watched", file.display());
                Err(Failure::WrongUse(what, "put a file there".to_string()))
            }
        };
        let exit = done.unwrap_or_else(|failure| {
            to_stderr(&failure.to_string());
            failure.exit()
        });
        if messages.format == Format::Human && !messages.quiet {
            to_stderr(&waiting(exit, &files));
        }
        wait_for_change(&files, &seen, &events);
    }
}

/// A watcher of the folders that the files are in, and of those that links lead to; as far as the system allows it.
fn watch(files: &[&Path], sender: Sender<Event>) -> Option<RecommendedWatcher> {
    let mut watcher = recommended_watcher(sender).ok()?;
    let mut folders: Vec<PathBuf> = files.iter().flat_map(|file| folders(file)).collect();
    folders.sort();
    folders.dedup();
    for folder in folders {
        // Where this fails, the files are looked at all the same.
        let _ = watcher.watch(&folder, RecursiveMode::NonRecursive);
    }
    Some(watcher)
}

fn folders(file: &Path) -> Vec<PathBuf> {
    let of = |path: &Path| match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder.to_path_buf(),
        Some(_) | None => PathBuf::from("."),
    };
    let target = std::fs::canonicalize(file).ok();
    [of(file)].into_iter().chain(target.as_deref().map(of)).collect()
}

/// Returns when the contents are others than those seen, and rest.
fn wait_for_change(files: &[&Path], seen: &[Option<Vec<u8>>], events: &Receiver<Event>) {
    loop {
        let _ = events.recv_timeout(LOOK);
        pause(events);
        let mut now = contents(files);
        if now == seen {
            continue;
        }
        for _ in 0..PAUSES {
            pause(events);
            let later = contents(files);
            // While it is being saved, a file may be away or empty for a moment.
            let half_saved = later.iter().any(|content| content.as_ref().is_none_or(Vec::is_empty));
            let rests = later == now && !half_saved;
            now = later;
            if rests {
                break;
            }
        }
        if now != seen {
            return;
        }
    }
}

/// Lets a moment pass, and forgets the events of it: what they are about is looked at after it.
fn pause(events: &Receiver<Event>) {
    std::thread::sleep(PAUSE);
    while events.try_recv().is_ok() {}
}

/// What is in each file; nothing if it cannot be read.
fn contents(files: &[&Path]) -> Vec<Option<Vec<u8>>> {
    files.iter().map(|file| if is_no_file(file) { None } else { std::fs::read(file).ok() }).collect()
}

/// Whether something is there that is no file: a pipe would have us wait for somebody who writes.
fn is_no_file(path: &Path) -> bool {
    std::fs::metadata(path).is_ok_and(|metadata| !metadata.is_file())
}

/// What comes before the messages of each run: they stand at the top of a screen, and pile up in a file.
fn clear(is_terminal: bool) -> &'static str {
    if is_terminal { CLEAR } else { "" }
}

fn waiting(exit: Exit, files: &[&Path]) -> String {
    let done = match exit {
        Exit::Done => "done",
        Exit::ChartErrors | Exit::WrongUse | Exit::FilesRefused | Exit::Open => "what was made before stays as it is",
    };
    match files {
        [file] => format!("{done}; waiting for a change of `{}`, Ctrl-C ends\n", file.display()),
        _ => format!("{done}; waiting for a change of {} files, Ctrl-C ends\n", files.len()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_screen_is_cleared_and_a_file_is_not() {
        assert_eq!((clear(true), clear(false)), ("\x1b[2J\x1b[H", ""));
    }

    #[test]
    fn a_file_is_watched_in_its_folder() {
        assert_eq!(folders(Path::new("no/such/file.gct")), [PathBuf::from("no/such")]);
        assert_eq!(folders(Path::new("nothing.gct")), [PathBuf::from(".")]);
    }

    #[test]
    fn what_is_waited_for_is_named() {
        let one = [Path::new("a.gct")];
        assert_eq!(waiting(Exit::Done, &one), "done; waiting for a change of `a.gct`, Ctrl-C ends\n");
        let failed = waiting(Exit::ChartErrors, &[Path::new("a.gct"), Path::new("b.gct")]);
        assert!(failed.starts_with("what was made before stays as it is; waiting for a change of 2 files"));
    }
}
