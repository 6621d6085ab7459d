//! `--watch`: the command as it runs beside an editor.

mod common;

use common::{FAULTY, Folder, VALVE};
use std::io::Read;
use std::process::{Child, Command, Stdio};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

/// A command that watches, and what it has said; ended when it is dropped.
struct Watching {
    child: Child,
    said: Arc<Mutex<String>>,
}

impl Watching {
    fn start(folder: &Folder, arguments: &[&str]) -> Watching {
        let mut child = Command::new(assert_cmd::cargo::cargo_bin!("grafc"))
            .args(arguments)
            .current_dir(folder.path("."))
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let said = Arc::new(Mutex::new(String::new()));
        let (mut pipe, copy) = (child.stderr.take().unwrap(), said.clone());
        std::thread::spawn(move || {
            let mut buffer = [0; 4096];
            while let Ok(length @ 1..) = pipe.read(&mut buffer) {
                copy.lock().unwrap().push_str(&String::from_utf8_lossy(&buffer[..length]));
            }
        });
        Watching { child, said }
    }

    fn said(&self) -> String {
        self.said.lock().unwrap().clone()
    }

    /// Waits until it has said this so many times.
    #[track_caller]
    fn says(&self, text: &str, times: usize) {
        self.until(text, || self.said().matches(text).count() >= times);
    }

    #[track_caller]
    fn until(&self, what: &str, is_so: impl Fn() -> bool) {
        let start = Instant::now();
        while !is_so() {
            assert!(start.elapsed() < Duration::from_secs(60), "waited for {what}; it said:\n{}", self.said());
            std::thread::sleep(Duration::from_millis(20));
        }
    }
}

impl Drop for Watching {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

const DONE: &str = "done; waiting for a change of `valve.gct`, Ctrl-C ends\n";
const STAYS: &str = "what was made before stays as it is; waiting for a change of `valve.gct`";

/// As many editors do: a new file takes the place of the old one.
fn save_by_rename(folder: &Folder, text: &str) {
    std::fs::write(folder.path(".valve.gct.swp"), text).unwrap();
    std::fs::rename(folder.path(".valve.gct.swp"), folder.path("valve.gct")).unwrap();
}

#[test]
fn each_save_is_compiled_and_a_fault_keeps_the_last_good_code() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    let watching = Watching::start(&folder, &["valve.gct", "-o", "valve.st", "--watch"]);
    watching.says(DONE, 1);
    let good = folder.read("valve.st");
    assert!(good.contains("FUNCTION_BLOCK Valve"));

    std::fs::write(folder.path("valve.gct"), FAULTY).unwrap();
    watching.says(STAYS, 1);
    assert!(watching.said().contains("error[E0201]"), "{}", watching.said());
    assert_eq!(folder.read("valve.st"), good);

    save_by_rename(&folder, &VALVE.replace("chart Valve", "chart First"));
    watching.until("the first save by renaming", || folder.read("valve.st").contains("FUNCTION_BLOCK First"));
    // The new file is watched as the old one was.
    save_by_rename(&folder, &VALVE.replace("chart Valve", "chart Second"));
    watching.until("the second save by renaming", || folder.read("valve.st").contains("FUNCTION_BLOCK Second"));
    std::fs::write(folder.path("valve.gct"), VALVE).unwrap();
    watching.until("the save in place", || folder.read("valve.st") == good);
}

#[test]
fn a_chart_may_go_away_and_come_back() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    let watching = Watching::start(&folder, &["valve.gct", "-o", "out/", "-t", "rust", "--watch"]);
    watching.says(DONE, 1);
    std::fs::rename(folder.path("valve.gct"), folder.path("valve.gct~")).unwrap();
    watching.says("cannot read `valve.gct`", 1);
    std::fs::write(folder.path("valve.gct"), VALVE.replace("chart Valve", "chart Again")).unwrap();
    watching.until("the new chart", || folder.read("out/valve.rs").contains("pub struct Again"));
}

#[test]
fn what_is_no_change_starts_nothing() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    let watching = Watching::start(&folder, &["valve.gct", "-o", "valve.st", "--watch"]);
    watching.says(DONE, 1);
    // Neither a save of the same text, nor another file beside it, nor the code that was written there.
    std::fs::write(folder.path("valve.gct"), VALVE).unwrap();
    std::fs::write(folder.path("other.gct"), FAULTY).unwrap();
    std::thread::sleep(Duration::from_millis(1500));
    save_by_rename(&folder, FAULTY);
    watching.says(STAYS, 1);
    assert_eq!(watching.said().matches("waiting for").count(), 2, "{}", watching.said());
    assert!(!watching.said().contains('\x1b'), "no screen is cleared that is none");
}

/// A pipe would have us wait for somebody who writes.
#[cfg(unix)]
#[test]
fn a_pipe_in_the_place_of_a_chart_is_not_read() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    let watching = Watching::start(&folder, &["valve.gct", "-o", "valve.st", "--watch"]);
    watching.says(DONE, 1);
    let pipe = folder.path("pipe");
    assert!(std::process::Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    std::fs::rename(&pipe, folder.path("valve.gct")).unwrap();
    watching.says("`valve.gct` is not a file, and cannot be watched", 1);
    save_by_rename(&folder, &VALVE.replace("chart Valve", "chart Back"));
    watching.until("the new chart", || folder.read("valve.st").contains("FUNCTION_BLOCK Back"));
}

#[cfg(unix)]
#[test]
fn a_chart_behind_a_link_is_watched_where_it_is() {
    let folder = Folder::new(&[]);
    std::fs::create_dir(folder.path("real")).unwrap();
    std::fs::write(folder.path("real/chart.gct"), VALVE).unwrap();
    std::os::unix::fs::symlink("real/chart.gct", folder.path("valve.gct")).unwrap();
    let watching = Watching::start(&folder, &["valve.gct", "-o", "valve.st", "--watch"]);
    watching.says(DONE, 1);
    std::fs::write(folder.path("real/chart.gct"), VALVE.replace("chart Valve", "chart Linked")).unwrap();
    watching.until("the linked chart", || folder.read("valve.st").contains("FUNCTION_BLOCK Linked"));
}

#[test]
fn checks_can_watch_and_be_quiet() {
    let folder = Folder::new(&[("valve.gct", VALVE), ("other.gct", VALVE)]);
    let watching = Watching::start(&folder, &["check", "valve.gct", "other.gct", "--watch"]);
    watching.says("done; waiting for a change of 2 files", 1);
    let quiet = Watching::start(&folder, &["check", "-q", "valve.gct", "--watch"]);
    std::thread::sleep(Duration::from_millis(500));
    save_by_rename(&folder, FAULTY);
    watching.says("valve.gct:6:25", 1);
    quiet.says("valve.gct:6:25", 1);
    assert!(!quiet.said().contains("waiting"), "{}", quiet.said());
}

#[test]
fn what_cannot_be_watched_is_refused() {
    let folder = Folder::new(&[("valve.gct", VALVE)]);
    folder.run(&["valve.gct", "-t", "st", "--watch"]).ends(2, "`--watch` has no file to write to").ends(2, "`-o FILE`");
    folder.run(&["valve.gct", "-t", "st", "--watch", "-o", "-"]).ends(2, "no file to write to");
    folder.run(&["-", "-o", "valve.st", "--watch"]).ends(2, "standard input cannot be watched");
    folder.run(&["check", "-", "--watch"]).ends(2, "standard input cannot be watched");
    assert_eq!(folder.names(), ["valve.gct"]);
}
