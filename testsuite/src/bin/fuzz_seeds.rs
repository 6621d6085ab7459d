//! Writes the texts that the fuzz targets begin with into `testsuite/fuzz/corpus`.
//!
//! ```text
//! cargo run -p grafc-testsuite --bin fuzz_seeds
//! ```

#![allow(clippy::print_stdout, reason = "a command")]

use grafc_testsuite::fuzzing::{TARGETS, seeds};
use std::path::Path;

fn main() -> std::io::Result<()> {
    let corpus = Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz/corpus");
    for target in TARGETS {
        let folder = corpus.join(target);
        std::fs::create_dir_all(&folder)?;
        let seeds = seeds(target);
        for (name, text) in &seeds {
            std::fs::write(folder.join(format!("seed-{name}")), text)?;
        }
        println!("{target}: {} seeds", seeds.len());
    }
    Ok(())
}
