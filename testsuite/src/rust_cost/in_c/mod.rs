//! The same in C: what grafc writes beside a `switch` by hand, each with a program around it that times itself.
//!
//! Both are compiled with `gcc -O2`, the chart as a unit of its own, so that no scan is inlined.

mod by_hand;
mod driver;

use super::tools::{Built, timed};
use crate::executors::c::Tools;
use crate::rings::Rings;
use grafc_backends::c::{self, Options};
use grafc_logic::Encoding;
use grafc_logic::scan::Program;
use grafc_model::reaction::Evolution;
use std::fs;
use std::path::Path;
use std::time::Duration;

const OPTIMIZED: &str = "-O2";

/// A source and its header.
pub(super) struct Unit {
    source: String,
    header: String,
}

/// What an encoding is called here.
pub(super) fn name(encoding: Encoding) -> &'static str {
    match encoding {
        Encoding::SinglePhase => "single-phase in C",
        Encoding::RTrigger => "r-trigger in C",
        Encoding::STrigger => "s-trigger in C",
        Encoding::Sequent => "sequent in C",
        Encoding::Switch => "switch in C",
    }
}

/// The rings by hand.
pub(super) fn by_hand(rings: Rings, evolution: Evolution) -> Unit {
    let (source, header) = by_hand::write(rings, evolution);
    Unit { source, header }
}

/// A chart as grafc writes it.
pub(super) fn by_grafc(program: &Program) -> Result<Unit, String> {
    let options = Options { include: Some("chart.h".to_owned()), ..Options::default() };
    let (source, header) = c::emit(program, &options).map_err(|diagnostics| format!("{diagnostics:#?}"))?;
    Ok(Unit { source, header: header.unwrap_or_default() })
}

/// Builds in a folder of its own, unless the program is there already.
pub(super) fn build(tools: &Tools, folder: &Path, unit: &Unit, rings: Rings, limit: Duration) -> Result<Built, String> {
    let program = folder.join("main");
    let main = driver::write(rings);
    let files = [("chart.c", &unit.source), ("chart.h", &unit.header), ("main.c", &main)];
    if program.is_file()
        && files.iter().all(|(name, text)| fs::read_to_string(folder.join(name)).is_ok_and(|old| old == **text))
    {
        return Ok(Built::Program(program, None));
    }
    let failed = |e: std::io::Error| format!("{}: {e}", folder.display());
    fs::create_dir_all(folder).map_err(failed)?;
    if program.is_file() {
        fs::remove_file(&program).map_err(failed)?;
    }
    for (name, text) in files {
        fs::write(folder.join(name), text).map_err(failed)?;
    }
    let mut chart = tools.command();
    chart.args([OPTIMIZED, "-c", "chart.c"]).current_dir(folder);
    if let Err(why) = timed(chart, &folder.join("said"), limit)? {
        return Ok(Built::Without(why));
    }
    tools.compile(folder, &[OPTIMIZED, "-o", "main", "main.c", "chart.o"])?;
    Ok(Built::Program(program, None))
}
