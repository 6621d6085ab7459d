//! A directory with charts, and grafc run in it.
#![allow(dead_code, reason = "each test file uses a part of it")]

use std::path::{Path, PathBuf};
use std::process::Output;
use tempfile::TempDir;

/// One valve, opened by `a` and closed by `b`.
pub const VALVE: &str = "\
chart Valve \"one valve\"

input  a, b : bool
output V : bool

grafcet G1 {
  initial step 1
  step 2 { V }

  transition (1) 1 -> 2 : a
  transition (2) 2 -> 1 : b
}

allow W0424 \"no one asks for both at once\"
";

/// The same with a name that is not declared.
pub const FAULTY: &str = "\
input  a : bool
output V : bool
initial step 1
step 2 { V }
transition (1) 1 -> 2 : a
transition (2) 2 -> 1 : nowhere
";

/// A negated edge is true nearly always: a warning.
pub const DUBIOUS: &str = "\
input  a : bool
output V : bool
initial step 1
step 2 { V }
transition (1) 1 -> 2 : a
transition (2) 2 -> 1 : not rise a
";

pub struct Folder {
    directory: TempDir,
}

impl Folder {
    pub fn new(files: &[(&str, &str)]) -> Self {
        let folder = Folder { directory: TempDir::new().unwrap() };
        for (name, text) in files {
            std::fs::write(folder.path(name), text).unwrap();
        }
        folder
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.directory.path().join(name)
    }

    pub fn read(&self, name: &str) -> String {
        std::fs::read_to_string(self.path(name)).unwrap()
    }

    /// The names in the directory, sorted; hidden ones too.
    pub fn names(&self) -> Vec<String> {
        Folder::names_in(self.directory.path())
    }

    /// The names in a directory, sorted; hidden ones too.
    pub fn names_in(directory: &Path) -> Vec<String> {
        let entries = std::fs::read_dir(directory).unwrap();
        let mut names: Vec<String> = entries.map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    pub fn run(&self, arguments: &[&str]) -> Run {
        self.run_with(arguments, "")
    }

    pub fn run_with(&self, arguments: &[&str], input: impl AsRef<[u8]>) -> Run {
        let mut command = assert_cmd::cargo::cargo_bin_cmd!("grafc");
        let output = command.current_dir(self.directory.path()).args(arguments).write_stdin(input.as_ref()).output();
        Run::of(output.unwrap())
    }
}

pub struct Run {
    pub code: i32,
    pub out: String,
    pub err: String,
}

impl Run {
    pub fn of(output: Output) -> Run {
        Run {
            code: output.status.code().unwrap(),
            out: String::from_utf8(output.stdout).unwrap(),
            err: String::from_utf8(output.stderr).unwrap(),
        }
    }

    /// Ended with this code, and said this.
    #[track_caller]
    pub fn ends(&self, code: i32, in_err: &str) -> &Run {
        assert_eq!(self.code, code, "stdout: {}\nstderr: {}", self.out, self.err);
        assert!(self.err.contains(in_err), "stderr: {}", self.err);
        self
    }

    /// Ended well, and printed nothing.
    #[track_caller]
    pub fn is_done(&self) -> &Run {
        assert_eq!((self.code, self.err.as_str()), (0, ""), "stdout: {}", self.out);
        self
    }
}
