//! Arduino's core for AVR, which sketches are compiled with.

use crate::programs::{call, on_path};
use crate::tools::{Tool, or_skip};
use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The core, and the compilers.
pub struct Arduino {
    core: PathBuf,
    variant: PathBuf,
    gcc: PathBuf,
    gxx: PathBuf,
}

/// What headers of old compilers do not define in C++.
const DIGITS: &str = "-DDECIMAL_DIG=__DECIMAL_DIG__";

/// An Arduino Mega.
const BOARD: [&str; 7] = [
    "-mmcu=atmega2560",
    "-DF_CPU=16000000L",
    "-DARDUINO=10808",
    "-DARDUINO_ARCH_AVR",
    "-Os",
    "-ffunction-sections",
    "-fdata-sections",
];

impl Arduino {
    /// The core that `ARDUINO_AVR` names, else Debian's; or nothing and a line that says why a test does nothing.
    pub fn find_or_skip() -> Option<Arduino> {
        let folder = env::var_os("ARDUINO_AVR").unwrap_or_else(|| "/usr/share/arduino/hardware/arduino/avr".into());
        or_skip(Tool::Arduino, Arduino::find(Path::new(&folder)))
    }

    fn find(folder: &Path) -> Result<Arduino, String> {
        let (core, variant) = (folder.join("cores/arduino"), folder.join("variants/mega"));
        if !core.join("Arduino.h").is_file() {
            return Err(format!("{} is not Arduino's core for AVR; ARDUINO_AVR names it", folder.display()));
        }
        let compiler = |name: &str| on_path(name).ok_or_else(|| format!("{name} is not on PATH"));
        Ok(Arduino { core, variant, gcc: compiler("avr-gcc")?, gxx: compiler("avr-g++")? })
    }

    fn command(&self, compiler: &Path) -> Command {
        let mut command = Command::new(compiler);
        command.args(BOARD).arg("-I").arg(&self.core).arg("-I").arg(&self.variant);
        command
    }

    /// Compiles a sketch of a folder as Arduino does, with its header before it; a warning is a fault.
    ///
    /// # Errors
    /// What the compiler says.
    pub fn compile(&self, folder: &Path, sketch: &str) -> Result<(), String> {
        let mut command = self.command(&self.gxx);
        command.args(["-std=gnu++11", "-Wall", "-Wextra", "-Werror", "-include", "Arduino.h", "-x", "c++"]);
        call(command.args(["-c", "-o", "sketch.o", sketch]).current_dir(folder)).map(|_| ())
    }

    /// Compiles the core, and links what was compiled of a sketch with it.
    ///
    /// # Errors
    /// What the compilers say.
    pub fn link(&self, folder: &Path) -> Result<(), String> {
        let mut sources: Vec<PathBuf> = Vec::new();
        for entry in fs::read_dir(&self.core).map_err(|e| e.to_string())? {
            sources.push(entry.map_err(|e| e.to_string())?.path());
        }
        let of = |ending: &str| -> Vec<&PathBuf> {
            sources.iter().filter(|path| path.extension().is_some_and(|own| own == ending)).collect()
        };
        let (c, cpp) = (of("c"), of("cpp"));
        call(self.command(&self.gcc).args(["-w", "-std=gnu11", "-c"]).args(c).current_dir(folder))?;
        call(
            self.command(&self.gxx)
                .args(["-w", "-std=gnu++11", "-fno-exceptions", "-fno-threadsafe-statics", DIGITS, "-c"])
                .args(cpp)
                .current_dir(folder),
        )?;
        let mut objects: Vec<PathBuf> = Vec::new();
        for entry in fs::read_dir(folder).map_err(|e| e.to_string())? {
            objects.push(entry.map_err(|e| e.to_string())?.path());
        }
        objects.retain(|path| path.extension().is_some_and(|ending| ending == "o"));
        let mut command = self.command(&self.gcc);
        call(command.args(["-Wl,--gc-sections", "-o", "sketch.elf"]).args(objects).arg("-lm").current_dir(folder))
            .map(|_| ())
    }
}
