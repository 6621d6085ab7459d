//! Microcontrollers: compilers for them, and emulators that run what they compile, without an operating system.
//!
//! An AVR is an ATmega2560 under simavr, which prints what is sent on its serial line. A Cortex-M is the board LM3S6965 under
//! QEMU. Programs play traces as those of this machine do (`bare`), one a run.

use super::bare;
use super::run::unit_of;
use super::tools::STRICT;
use crate::executors::jobs::{self, Job};
use crate::programs::{call, on_path};
use crate::tools::{Tool, or_skip};
use grafc_model::reaction::Response;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The seconds that a program may take.
const LIMIT: &str = "60";

/// A kind of microcontroller.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Board {
    /// 8 bits; an `int` has 16.
    Avr,
    /// 32 bits.
    CortexM,
}

impl Board {
    /// All of them.
    pub const ALL: [Board; 2] = [Board::Avr, Board::CortexM];

    /// What compiles for it.
    pub fn compiler(self) -> Tool {
        match self {
            Board::Avr => Tool::AvrGcc,
            Board::CortexM => Tool::ArmGcc,
        }
    }

    /// What runs programs for it.
    pub fn emulator(self) -> Tool {
        match self {
            Board::Avr => Tool::Simavr,
            Board::CortexM => Tool::QemuArm,
        }
    }

    fn options(self) -> &'static [&'static str] {
        match self {
            Board::Avr => &["-mmcu=atmega2560", "-Os", "-ffunction-sections", "-fdata-sections"],
            Board::CortexM => {
                &["-mcpu=cortex-m3", "-mthumb", "-ffreestanding", "-Os", "-ffunction-sections", "-fdata-sections"]
            }
        }
    }

    /// What a program calls.
    fn functions(self) -> &'static str {
        match self {
            Board::Avr => bare::AVR,
            Board::CortexM => bare::CORTEX_M,
        }
    }

    /// How a program is linked.
    fn linked(self) -> &'static [&'static str] {
        match self {
            Board::Avr => &["-Wl,--gc-sections", "main.c", "chart.o"],
            Board::CortexM => &[
                "-fno-tree-loop-distribute-patterns",
                "-nostdlib",
                "-Wl,--gc-sections",
                "-Wl,--build-id=none",
                "-T",
                "board.ld",
                "main.c",
                "chart.o",
                "-lgcc",
            ],
        }
    }

    fn emulate(self, emulator: &Path) -> Command {
        let mut command = Command::new("timeout");
        command.arg(LIMIT).arg(emulator);
        match self {
            Board::Avr => command.args(["-m", "atmega2560", "-f", "16000000", "main.elf"]),
            Board::CortexM => command
                .args(["-machine", "lm3s6965evb", "-display", "none", "-monitor", "none", "-serial", "stdio"])
                .args(["-semihosting-config", "enable=on,target=native", "-kernel", "main.elf"]),
        };
        command
    }
}

/// A compiler for a board.
pub struct Compiler {
    board: Board,
    file: PathBuf,
}

impl Compiler {
    /// The compiler, or nothing and a line that says why the test that wants it does nothing.
    pub fn find_or_skip(board: Board) -> Option<Compiler> {
        let found =
            on_path(board.compiler().name()).ok_or_else(|| format!("{} is not on PATH", board.compiler().name()));
        or_skip(board.compiler(), found).map(|file| Compiler { board, file })
    }

    /// Compiles a source of a folder to `chart.o`; whatever the compiler has to say is a fault.
    ///
    /// # Errors
    /// What it says.
    pub fn object(&self, folder: &Path, source: &str) -> Result<(), String> {
        let mut command = Command::new(&self.file);
        command.args(STRICT).args(self.board.options()).args(["-c", "-o", "chart.o", source]).current_dir(folder);
        call(&mut command).map(|_| ())
    }

    fn program(&self, folder: &Path) -> Result<(), String> {
        let mut command = Command::new(&self.file);
        command.args(self.board.options()).args(["-o", "main.elf"]).args(self.board.linked()).current_dir(folder);
        call(&mut command).map(|_| ())
    }
}

/// A compiler and an emulator.
pub struct Emulated {
    compiler: Compiler,
    emulator: PathBuf,
}

impl Emulated {
    /// Both, or nothing and a line that says what is missing.
    pub fn find_or_skip(board: Board) -> Option<Emulated> {
        let compiler = Compiler::find_or_skip(board)?;
        let found =
            on_path(board.emulator().name()).ok_or_else(|| format!("{} is not on PATH", board.emulator().name()));
        or_skip(board.emulator(), found).map(|emulator| Emulated { compiler, emulator })
    }

    /// Runs all jobs, one after the other.
    pub fn run(&self, jobs: &[Job]) -> Vec<Result<Vec<Response>, String>> {
        jobs.iter()
            .map(|job| {
                let printed = self.play(job)?;
                jobs::read(job, 0, &printed).map_err(|said| format!("{said}\n{printed}"))
            })
            .collect()
    }

    fn play(&self, job: &Job) -> Result<String, String> {
        let board = self.compiler.board;
        let (source, header, program) = unit_of(0, job)?;
        let folder = tempfile::tempdir().map_err(|e| e.to_string())?;
        let main = bare::write(&program, &job.stimuli, board.functions());
        let files =
            [("chart.c", &source), ("Job_0.h", &header), ("main.c", &main), ("board.ld", &bare::SECTIONS.to_owned())];
        for (name, text) in files {
            fs::write(folder.path().join(name), text).map_err(|e| e.to_string())?;
        }
        self.compiler.object(folder.path(), "chart.c")?;
        self.compiler.program(folder.path())?;
        let mut command = board.emulate(&self.emulator);
        let output = command.current_dir(folder.path()).output().map_err(|e| format!("{command:?}: {e}"))?;
        if !output.status.success() {
            return Err(format!("{command:?}: {}", output.status));
        }
        let printed = [output.stdout, output.stderr].concat();
        Ok(match board {
            Board::Avr => lines_of_simavr(&String::from_utf8_lossy(&printed)),
            Board::CortexM => String::from_utf8_lossy(&printed).into_owned(),
        })
    }
}

/// What was sent on the serial line: simavr prints each line in a colour, with a point for its end.
fn lines_of_simavr(printed: &str) -> String {
    let sent = printed.split("\u{1b}[32m").skip(1);
    sent.map(|line| format!("{}\n", line.split('.').next().unwrap_or_default())).collect()
}
