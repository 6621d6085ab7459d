//! Builds the program of one spelling, with the optimization that a vendor would choose.
//!
//! The tests build with `-O0`, where compiling is what takes the time; here it is running.

use super::driver;
use crate::executors::matiec::Tools;
use crate::rings::Rings;
use std::fs;
use std::path::{Path, PathBuf};

/// Builds the program of a text in a folder of its own, unless it is there already.
pub(crate) fn build(tools: &Tools, folder: &Path, text: &str, rings: Rings) -> Result<PathBuf, String> {
    let block = text
        .lines()
        .find_map(|line| line.trim().strip_prefix("FUNCTION_BLOCK "))
        .ok_or("the text has no function block")?
        .trim();
    let main = driver::write(block, rings);
    let program = folder.join("main");
    let same = |name: &str, text: &str| fs::read_to_string(folder.join(name)).is_ok_and(|old| old == text);
    if program.is_file() && same("charts.st", text) && same("main.c", &main) {
        return Ok(program);
    }
    let failed = |path: &Path, e: std::io::Error| format!("{}: {e}", path.display());
    fs::create_dir_all(folder).map_err(|e| failed(folder, e))?;
    if program.is_file() {
        fs::remove_file(&program).map_err(|e| failed(&program, e))?;
    }
    for (name, text) in [("charts.st", text), ("main.c", &main)] {
        fs::write(folder.join(name), text).map_err(|e| failed(&folder.join(name), e))?;
    }
    tools.iec2c(folder)?;
    tools.gcc(folder, "-O2")?;
    Ok(program)
}
